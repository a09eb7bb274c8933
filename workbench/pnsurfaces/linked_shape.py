# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the value of a link property to shapes, in the coordinates of the object that links."""

import FreeCAD
import Part


class LinkError(ValueError):
    """A link leads to no shape. The text is a sentence for the user."""


class Source:
    """What a link led to when it was read: the label of an object and the shapes it linked.

    It takes the object's place where the document may not be touched, in other threads. That
    shapes are missing is said when they are asked for: not every link is used.
    """

    def __init__(self, label, shapes, error=None):
        self.Label = label
        self._shapes = shapes
        self._error = error

    @classmethod
    def read(cls, source, names, container=None):
        """The sub-elements `names` of a document object, as `linked_shapes` finds them."""
        try:
            return cls(source.Label, linked_shapes(source, names, container))
        except LinkError as error:
            return cls(source.Label, [], error)

    def __eq__(self, other):
        """Whether both led to the same shapes, not just to equal ones."""
        return (
            self.Label == other.Label
            and len(self._shapes) == len(other._shapes)
            and all(map(_are_one, self._shapes, other._shapes))
        )

    def shapes(self):
        if self._error:
            raise self._error
        return self._shapes


def as_link(value):
    """The pair (object, sub-element names) of an object, (object, "Edge1") or (object, names)."""
    source, names = value if isinstance(value, (tuple, list)) else (value, [])
    return source, [names] if isinstance(names, str) else list(names)


def linked_shapes(source, names, container=None):
    """The sub-elements `names` of the document object `source`; no name stands for all of it.

    A Source that was read before gives what it was read for. Coordinates are those of `container`
    (a part or body, None for the document itself).

    Raises LinkError when a sub-element does not exist any more.
    """
    if isinstance(source, Source):
        return source.shapes()
    return [_in_container(shape, source, container) for shape in _shapes(source, names)]


def only_face(link, container=None):
    """The face that the value (source, names) of a link property names, as `linked_shapes` does.

    Raises LinkError unless it is one face.
    """
    source, names = link
    faces = [face for shape in linked_shapes(source, names, container) for face in shape.Faces]
    if len(faces) != 1:
        raise LinkError(f"{source.Label} gives {len(faces)} faces. Choose one face.")
    return faces[0]


def _are_one(shape, other):
    # Not isSame: reading a shape of a document gives its place anew.
    return shape.isPartner(other) and shape.Placement == other.Placement


def depends_on(obj, other):
    """Whether a document object is another one, or made from it."""
    return obj == other or bool(_path(obj, other))


def circle_through(obj):
    """The objects [obj, ..., obj] of a circle of links that starts at obj, or an empty list."""
    return _path(obj, obj)


def _path(obj, goal):
    """The objects [obj, ..., goal], each made from the next, or an empty list.

    FreeCAD's own lists of sources raise where links go round in a circle.
    """
    reached = {obj: [obj]}
    waiting = [obj]
    while waiting:
        current = waiting.pop()
        for source in current.OutList:
            if source == goal:
                return [*reached[current], goal]
            if source not in reached:
                reached[source] = [*reached[current], source]
                waiting.append(source)
    return []


def _shapes(source, names):
    shapes = [Part.getShape(source, name, needSubElement=True) for name in names or [""]]
    for name, shape in zip(names, shapes):
        if shape.isNull():
            raise LinkError(f"{source.Label} has no {name} any more.")
    return [shape for shape in shapes if not shape.isNull()]


def _in_container(shape, source, container):
    source_frame = _frame(source.getParentGeoFeatureGroup())
    target_frame = _frame(container)
    # The usual case keeps every double of the source.
    if source_frame == target_frame:
        return shape
    # A copy would lose the curves of edges on surfaces, which say what a helix is.
    moved = Part.Shape(shape)
    moved.Placement = target_frame.inverse() * source_frame * shape.Placement
    return moved


def _frame(container):
    return container.getGlobalPlacement() if container else FreeCAD.Placement()
