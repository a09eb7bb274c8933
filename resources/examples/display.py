# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the examples look in FreeCAD's window; without the window nothing happens."""

import FreeCAD

# The section of a wall that is cut open, brighter than all else.
SECTION = (0.98, 0.78, 0.30)


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


def paint_faces(obj, *parts):
    """Paints the faces in their order: `parts` are pairs (number of faces, colour)."""
    if FreeCAD.GuiUp:
        obj.ViewObject.DiffuseColor = [colour for count, colour in parts for _ in range(count)]


def hide_edges(obj):
    """Leaves the edges of faces out."""
    if FreeCAD.GuiUp:
        obj.ViewObject.DisplayMode = "Shaded"


def paint_wall(wall, sides):
    """Paints the faces of a solid wall: the sides as the surfaces on which they lie, ends bright.

    `sides` are pairs (object of a surface, colour). The surfaces are painted, too.
    """
    for surface, colour in sides:
        paint(colour, surface)
    if FreeCAD.GuiUp:
        colours = {_mark(face): colour for surface, colour in sides for face in surface.Shape.Faces}
        wall.ViewObject.DiffuseColor = [colours.get(_mark(face), SECTION) for face in wall.Shape.Faces]


def cut_open(wall, corner, size):
    """A cut that takes a box out of a painted wall: what is left, with bright sections.

    `corner` is the least corner of the box and `size` its edges, in mm.
    """
    document = wall.Document
    box = document.addObject("Part::Box", "Opening")
    box.Length, box.Width, box.Height = size
    box.Placement.Base = FreeCAD.Vector(*corner)
    cutaway = document.addObject("Part::Cut", "Cutaway")
    cutaway.Base, cutaway.Tool = wall, box
    # The cut takes over the colours of wall and box when it is computed.
    paint(SECTION, box)
    document.recompute()
    draw_finely(cutaway, wall)
    return cutaway


def draw_finely(obj, surface):
    """Draws an object as finely as the exact surface from which it is made."""
    if FreeCAD.GuiUp:
        for name in ("Deviation", "AngularDeflection"):
            setattr(obj.ViewObject, name, getattr(surface.ViewObject, name))


def _mark(face):
    """What tells the faces of a wall apart: the first and the last pole of their surfaces."""
    poles = face.Surface.getPoles()
    return tuple(poles[0][0]), tuple(poles[-1][-1])
