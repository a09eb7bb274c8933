# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that the workbench shows: icons and forms."""

import pathlib

_RESOURCES = pathlib.Path(__file__).resolve().parents[2] / "resources"

ICONS = str(_RESOURCES / "icons")


def icon(name):
    """File name of the icon `name`."""
    return str(_RESOURCES / "icons" / f"{name}.svg")


def form(name):
    """File name of the Qt form `name`."""
    return str(_RESOURCES / "ui" / f"{name}.ui")
