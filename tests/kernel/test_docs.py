# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation: its Python blocks run, and its links lead somewhere."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PAGES = [*sorted(ROOT.glob("*.md")), *sorted(DOCS.glob("*.md"))]

# Blocks marked "python freecad" need FreeCAD.
PYTHON_BLOCK = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LOCAL_LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]+))?\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


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


def links(page):
    """(file, anchor or "") of every link to a file of the project."""
    for target, anchor in LOCAL_LINK.findall(page.read_text(encoding="utf-8")):
        yield (page.parent / target).resolve() if target else page, anchor


def anchors(page):
    """The names by which the headings of a page can be linked to."""
    headings = HEADING.findall(page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page):
    for target, anchor in links(page):
        assert target.exists(), f"{name(page)} links to {target}"
        assert not anchor or anchor in anchors(target), f"{name(page)} links to #{anchor}"


def test_every_page_and_picture_is_linked_to():
    linked = {target for page in PAGES for target, _ in links(page)}
    unlinked = {*DOCS.glob("*.md"), *(DOCS / "images").iterdir()} - linked
    assert {file.name for file in unlinked} == set()
