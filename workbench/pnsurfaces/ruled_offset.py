# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset of a ruled surface in the tree."""

import Part

from pnsurfaces import kernel
from pnsurfaces.edge_chain import ChainError, read_edge_chain
from pnsurfaces.feature import QT_TRANSLATE_NOOP, Base, FeatureBase, Property, make_feature
from pnsurfaces.linked_shape import as_link, only_face
from pnsurfaces.ruled_face import RuledFace, read_ruled_face

GROUP = "Ruled surface"


class RuledOffset(FeatureBase):
    """Proxy of the offset of a ruled surface: two curves, or one ruled face."""

    inputs = (
        Property("App::PropertyLinkSub", "CurveA", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Edges of the curve where the rulings start")),
        Property("App::PropertyLinkSub", "CurveB", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Edges of the curve where the rulings end")),
        Property("App::PropertyBool", "Reversed", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Whether the second curve is run through from its end"),
                 False),
        Property("App::PropertyLinkSub", "Face", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "A ruled face, instead of the two curves")),
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
        curves = RuledFace(*(read_edge_chain(*link, container) for link in links))
    return RuledFace(curves.first, curves.last.reversed()) if obj.Reversed else curves


def _skew_face(face):
    """The face, unless it is one whose circles are not circles exactly as B-splines."""
    if isinstance(face.Surface, (Part.Cylinder, Part.Cone)):
        raise ValueError(
            "The face lies on a cylinder or cone of revolution. Use the command Quadric offset,"
            " which makes its exact offset."
        )
    return face


def make_ruled_offset(edge_a, edge_b=None, distance=0, *, document=None, name="RuledOffset",
                      **properties):
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
