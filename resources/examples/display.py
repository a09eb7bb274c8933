# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the examples look in FreeCAD's window; without the window nothing happens."""

import FreeCAD


def show_only(*shown):
    """Hides all other objects of the document."""
    if FreeCAD.GuiUp:
        for obj in shown[0].Document.Objects:
            obj.ViewObject.Visibility = obj in shown


def paint(colour, *objects):
    """`colour` is red, green and blue between 0 and 1."""
    if FreeCAD.GuiUp:
        for obj in objects:
            obj.ViewObject.ShapeColor = colour
