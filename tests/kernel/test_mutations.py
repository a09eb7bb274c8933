# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formulas that scripts/mutations breaks are still where its list says."""

import json
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MUTATIONS = json.loads((ROOT / "tests/mutations/mutations.json").read_text())


@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda mutation: mutation["formula"])
def test_the_formula_is_there_once(mutation):
    assert (ROOT / mutation["file"]).read_text().count(mutation["text"]) == 1
    assert mutation["broken"] != mutation["text"]
