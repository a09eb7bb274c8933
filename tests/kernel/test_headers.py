# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every header of the C++ library has a test, a line in docs/headers.md, and names of its own."""

import collections
import pathlib
import re
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = ROOT / "cpp" / "pn"
HEADERS = sorted(LIBRARY.glob("**/*.hpp"))

sys.path.append(str(ROOT / "scripts"))
import list_headers  # noqa: E402

# Headers without a test of their name, and why.
TESTED_ELSEWHERE = {
    "section_source": "an interface; each source has a test",
    "rational_lattice": "a step of rational_conic_family, whose test takes all its cases",
    "section_segment": "what chain_net and conic_source have in common, tested with both",
    "segment_faces": "what chain_net and conic_source have in common, tested with both",
    "rational_patch": "plain data of rational_envelope and its test",
}


def name(header):
    return str(header.relative_to(LIBRARY))


@pytest.mark.parametrize("header", HEADERS, ids=name)
def test_header_has_its_test(header):
    has_test = (ROOT / "tests" / "cpp" / f"{header.stem}_test.cpp").is_file()
    assert has_test != (header.stem in TESTED_ELSEWHERE)


def test_exceptions_exist():
    assert TESTED_ELSEWHERE.keys() <= {header.stem for header in HEADERS}


@pytest.mark.parametrize("header", HEADERS, ids=name)
def test_header_is_listed(header):
    entry = f"- `{header.stem}`: {list_headers.opening_sentence(header)}\n"
    page = list_headers.PAGE.read_text(encoding="utf-8")
    assert entry in page, "run scripts/python scripts/list_headers.py"


def test_nothing_else_is_listed():
    assert list_headers.PAGE.read_text(encoding="utf-8") == list_headers.page()


def test_no_type_is_defined_twice():
    """Two of one name would be the same to the linker, and to a catch in another module."""
    definition = re.compile(r"^(?:enum )?(?:class|struct) (\w+)[^;]*\{", re.MULTILINE)
    names = collections.Counter(
        found for header in HEADERS for found in definition.findall(header.read_text("utf-8"))
    )
    assert names
    assert [name for name, count in names.items() if count > 1] == []
