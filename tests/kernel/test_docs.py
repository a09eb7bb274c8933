# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation: its Python blocks run, and its links lead somewhere."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]

# Blocks marked "python freecad" need FreeCAD.
PYTHON_BLOCK = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LOCAL_LINK = re.compile(r"\]\((?!https?:)([^)#\s]+)")


def name(page):
    return str(page.relative_to(ROOT))


def blocks():
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for match in PYTHON_BLOCK.finditer(text):
            line = text.count("\n", 0, match.start(1)) + 1
            yield pytest.param(page, line, match[1], id=f"{name(page)}:{line}")


@pytest.mark.parametrize(("page", "line", "source"), blocks())
def test_python_block_runs(page, line, source):
    code = compile("\n" * (line - 1) + source, page, "exec")  # a failure names the line of the page
    exec(code, {"__name__": "__main__"})


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page):
    for target in LOCAL_LINK.findall(page.read_text(encoding="utf-8")):
        assert (page.parent / target).exists(), f"{name(page)} links to {target}"
