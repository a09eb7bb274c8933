# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a selection in FreeCAD's window (Gui.Selection.getSelectionEx()) means for a surface.

Every function returns values of link properties, (object, sub-element names), or None.
"""

# The corners of a net, or all its points.
_POINTS_OF_NET = (3, 6)


def selected_spine(selection):
    """The selected edges of one object, or all of an object that is selected as a whole."""
    return _edges(selection[0]) if len(selection) == 1 else None


def selected_pair(selection):
    """Two curves: two edges of one object, or the spine-like selections of two objects."""
    if len(selection) == 2:
        pair = tuple(_edges(selected) for selected in selection)
        return pair if all(pair) else None
    link = selected_spine(selection)
    if link is None or len(link[1]) != 2:
        return None
    source, names = link
    return tuple((source, [name]) for name in names)


def selected_face(selection):
    """The one face that is selected, or that a selected object has."""
    if len(selection) != 1:
        return None
    source, names = selection[0].Object, selection[0].SubElementNames
    if not hasattr(source, "Shape"):
        return None
    if not names and len(source.Shape.Faces) == 1:
        return source, ["Face1"]
    return (source, list(names)) if len(names) == 1 and names[0].startswith("Face") else None


def selected_place(selection):
    """The point of the one selected vertex, or None. Coordinates are those of its document."""
    (vertex,) = _sub_shapes(selection, "Vertex") or [None]
    return vertex and vertex.Point


def selected_direction(selection):
    """The direction of the one selected straight edge, or None."""
    (edge,) = _sub_shapes(selection, "Edge") or [None]
    is_straight = edge is not None and edge.Curve.TypeId == "Part::GeomLine"
    return edge.tangentAt(edge.FirstParameter) if is_straight else None


def selected_points(selection):
    """Three or six selected vertices of one object, or an object that has as many."""
    if len(selection) != 1:
        return None
    source, chosen = selection[0].Object, selection[0].SubElementNames
    names = [name for name in chosen if name.startswith("Vertex")]
    if len(names) in _POINTS_OF_NET and len(names) == len(chosen):
        return source, names
    if chosen or not hasattr(source, "Shape"):
        return None
    return (source, []) if len(source.Shape.Vertexes) in _POINTS_OF_NET else None


def _sub_shapes(selection, kind):
    """The one selected sub-shape of a kind, in a list; nothing where more or others are selected."""
    if len(selection) != 1 or len(selection[0].SubElementNames) != 1:
        return []
    is_of_kind = selection[0].SubElementNames[0].startswith(kind)
    return list(selection[0].SubObjects) if is_of_kind else []


def _edges(selected):
    source, chosen = selected.Object, selected.SubElementNames
    names = [name for name in chosen if name.startswith("Edge")]
    has_edges = hasattr(source, "Shape") and bool(source.Shape.Edges)
    return (source, names) if has_edges and (names or not chosen) else None
