# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that the workbench shows: icons, forms, examples, translations, pages, and its version."""

import pathlib
import re

_ROOT = pathlib.Path(__file__).resolve().parents[2]
_RESOURCES = _ROOT / "resources"

ICONS = str(_RESOURCES / "icons")


def icon(name):
    """File name of the icon `name`."""
    return str(_RESOURCES / "icons" / f"{name}.svg")


def form(name):
    """File name of the Qt form `name`."""
    return str(_RESOURCES / "ui" / f"{name}.ui")


EXAMPLES = str(_RESOURCES / "examples")

TRANSLATIONS = str(_RESOURCES / "translations")


def page(name):
    """File name of the page `name` of the documentation."""
    return str(_ROOT / "docs" / name)


def version():
    """The version of the workbench, as package.xml says."""
    package = (_ROOT / "package.xml").read_text(encoding="utf-8")
    return re.search("<version>(.*)</version>", package).group(1)
