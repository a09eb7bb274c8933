# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes docs/headers.md, the list of all headers of the C++ library with their opening sentences.

Run it after a header was added or its first sentence changed: scripts/python scripts/list_headers.py.
"""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
LIBRARY = ROOT / "cpp" / "pn"
PAGE = ROOT / "docs" / "headers.md"
# As in architecture.md, from below.
LAYERS = ["algebra", "conics", "minkowski", "isotropic", "shapes", "bezier", "occt"]

HEADING = """# Headers of the C++ library

Every header opens with the theorem or the contract it rests on; here are the first sentences, made by
`scripts/list_headers.py`. The layers are those of [architecture.md](architecture.md), from below.
"""


def opening_sentence(header):
    """The first sentence of the comment with which a header opens, after the line of the licence."""
    lines = header.read_text(encoding="utf-8").split("\n")[1:]
    comment = []
    for line in lines:
        if not line.startswith("// "):
            break
        comment.append(line[3:].strip())
    text = re.sub(r" \([A-Z]\. .*", "", " ".join(comment))  # without the source in brackets
    return re.split(r"(?<=\.) (?=[A-Z])", text)[0].rstrip(":.") + "."


def page():
    """The text of the list."""
    parts = [HEADING]
    folders = [("", LIBRARY.glob("*.hpp"))]
    folders += [(layer, (LIBRARY / layer).glob("*.hpp")) for layer in LAYERS]
    for layer, headers in folders:
        if layer:
            parts.append(f"\n## {layer}\n")
        for header in sorted(headers):
            parts.append(f"\n- `{header.stem}`: {opening_sentence(header)}")
        parts.append("\n")
    return "".join(parts)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
