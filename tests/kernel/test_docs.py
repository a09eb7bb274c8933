# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation: its Python blocks run, its links lead somewhere, and every page is found."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = sorted((ROOT / "docs").rglob("*.md"))
PAGES = [*(ROOT / f"{name}.md" for name in ("README", "CONTRIBUTING", "CHANGELOG")), *DOCS]

# Blocks marked "python freecad" need FreeCAD.
PYTHON_BLOCK = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)
BLOCK = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)
LOCAL_LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]+))?\)")
HEADING = re.compile(r"^#+ +(.+)$", re.MULTILINE)


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
    """The local links of a page, pictures too: the file, and the anchor in it or the empty text."""
    text = BLOCK.sub("", page.read_text(encoding="utf-8"))
    for target, anchor in LOCAL_LINK.findall(text):
        yield (page.parent / target).resolve() if target else page, anchor


def anchors(page):
    """What headings are linked by: in small letters, without punctuation, a hyphen for each space."""
    headings = HEADING.findall(BLOCK.sub("", page.read_text(encoding="utf-8")))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page):
    for target, anchor in links(page):
        assert target.exists(), f"{name(page)} links to {target}"
        if anchor:
            assert anchor in anchors(target), f"{name(page)} links to #{anchor} of {name(target)}"


def test_every_page_is_reached_from_the_first():
    reached, ahead = set(), [ROOT / "docs" / "README.md"]
    while ahead:
        page = ahead.pop()
        if page not in reached and page in DOCS:
            reached.add(page)
            ahead += [target for target, _ in links(page)]
    assert [name(page) for page in DOCS if page not in reached] == []


def test_every_picture_is_shown():
    pictures = set((ROOT / "docs" / "images").iterdir())
    shown = {target for page in PAGES for target, _ in links(page)}
    assert sorted(map(name, pictures - shown)) == []
