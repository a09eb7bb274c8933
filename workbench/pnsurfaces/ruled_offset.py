# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset of a ruled surface in the tree."""

import Part

from pnsurfaces import kernel
from pnsurfaces.edge_chain import CONFUSION, ChainError, read_edge_chain
from pnsurfaces.feature import QT_TRANSLATE_NOOP, Base, FeatureBase, Property, make_feature
from pnsurfaces.linked_shape import as_link, linked_shapes, only_face
from pnsurfaces.ruled_face import RuledFace, read_ruled_face

GROUP = "Ruled surface"

_OTHER_COMMAND = "The command Quadric Offset makes its exact offset."


class RuledOffset(FeatureBase):
    """Proxy of the offset of a ruled surface: two curves, or one ruled face."""

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "CurveA",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Edges of the curve where the rulings start"),
        ),
        Property(
            "App::PropertyLinkSub",
            "CurveB",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Edges of the curve where the rulings end"),
        ),
        Property(
            "App::PropertyBool",
            "Reversed",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Whether the second curve is run through from its end"),
            False,
        ),
        Property(
            "App::PropertyLinkSub",
            "Face",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "A ruled face, instead of the two curves"),
        ),
    )

    def base(self, obj):
        first, last = read_curves(obj)
        return Base(kernel.pnkernel().ruled_surface(first.kernel_curve(), last.kernel_curve()))


def read_curves(obj):
    """The two curves (ruled_face.RuledFace) of a feature RuledOffset.

    Raises ValueError (ChainError, LinkError, NotRuled) with a sentence for the user.
    """
    container = obj.getParentGeoFeatureGroup()
    if obj.Face:
        curves = read_ruled_face(_skew_face(only_face(obj.Face, container)))
    else:
        if not (obj.CurveA and obj.CurveB):
            raise ChainError("A curve is missing. Choose two edges, or one ruled face.")
        links = obj.CurveA, obj.CurveB
        if not obj.Reversed:
            _require_no_revolution(links, container)
        curves = RuledFace(*(read_edge_chain(*link, container) for link in links))
    return RuledFace(curves.first, curves.last.reversed()) if obj.Reversed else curves


def _skew_face(face):
    """The face, unless it is one whose circles are not circles exactly as B-splines."""
    if isinstance(face.Surface, (Part.Cylinder, Part.Cone)):
        raise ValueError(f"The face lies on a cylinder or cone of revolution. {_OTHER_COMMAND}")
    return face


def _require_no_revolution(links, container):
    """Refuses two circles that bound a cylinder or cone, for the same reason."""
    edges = [
        edge for link in links for shape in linked_shapes(*link, container) for edge in shape.Edges
    ]
    if len(edges) != 2 or not all(isinstance(edge.Curve, Part.Circle) for edge in edges):
        return
    one, other = (edge.Curve for edge in edges)
    differences = (
        (other.Center - one.Center).cross(one.Axis),
        one.Axis - other.Axis,
        one.XAxis - other.XAxis,
    )
    if all(vector.Length <= CONFUSION for vector in differences):
        raise ValueError(
            f"Both circles have one axis: between them lies a cylinder or cone. {_OTHER_COMMAND}"
        )


def make_ruled_offset(
    edge_a, edge_b=None, distance=0, *, document=None, name="RuledOffset", **properties
):
    """The offset of a ruled surface in the tree, computed. Lengths are millimetres or strings.

    Parameters
    ----------
    edge_a, edge_b : the curves: document object (all its edges), (object, "Edge1") or
        (object, ["Edge1", "Edge2"]); straight lines join equal parameters. Without edge_b the
        first is one ruled face: (object, "Face1"), or an object with one face.
    distance : signed offset
    document : the document of edge_a unless given
    name : wanted internal name and label
    properties : values of further properties, such as Reversed=True or Sides="Both sides"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError or TypeError for a property that does not exist or cannot have the value;
    nothing is then left in the document.
    """
    link = as_link(edge_a)
    sources = {"Face": link} if edge_b is None else {"CurveA": link, "CurveB": as_link(edge_b)}
    values = {**sources, "Distance": distance, **properties}
    return make_feature(RuledOffset, document or link[0].Document, name, values)
