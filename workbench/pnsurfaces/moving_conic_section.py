# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a moving conic section in the tree: ellipses along a spine."""

import FreeCAD
import Part

from pnsurfaces import kernel
from pnsurfaces.canal_surface import chosen_spine, lengths
from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.edge_fit import exact_where_possible
from pnsurfaces.feature import (
    QT_TRANSLATE_NOOP,
    Base,
    FeatureWithoutOffsets,
    Property,
    make_feature,
    result,
    show_only,
)
from pnsurfaces.linked_shape import as_link
from pnsurfaces.position import MEASURES
from pnsurfaces.radius_law import CONSTANT, EXPRESSION, LINEAR, TABLE
from pnsurfaces.section_law import HALF_AXES, INPUTS_OF_LAW, half_axis_law, inputs_of_law
from pnsurfaces.spine import read_spine
from pnsurfaces.spline_fit import FIT_TOLERANCE, deviation_of

GROUP = "Moving conic section"

# Directions upwards, the first that suits a spine.
_UPRIGHT = (FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(0, 1, 0), FreeCAD.Vector(1, 0, 0))

PERPENDICULAR = "Perpendicular"
PARALLEL = "Parallel"


class SectionError(ValueError):
    """The sections have no such planes. The text is a sentence for the user."""


class MovingConicSection(FeatureWithoutOffsets):
    """Proxy of the surface of ellipses along a spine."""

    inputs = (
        Property("App::PropertyLinkSub", "Spine", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Edges through the centres of the sections")),
        Property("App::PropertyEnumeration", "Planes", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Whether sections are perpendicular to the spine or parallel to"
                                   " one another"),
                 [PERPENDICULAR, PARALLEL]),
        Property("App::PropertyVector", "Normal", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "The direction that parallel sections are"
                                                    " perpendicular to"),
                 FreeCAD.Vector(1, 0, 0)),
        Property("App::PropertyVector", "Up", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "The direction upwards: the height of a section runs along it, as"
                                   " far as its plane allows"),
                 FreeCAD.Vector(0, 0, 1)),
        Property("App::PropertyEnumeration", "SectionLaw", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "How the half-axes run along the spine"),
                 list(INPUTS_OF_LAW)),
        Property("App::PropertyLength", "HalfWidth", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Half-axis to the side, everywhere or at the start"),
                 2.0),
        Property("App::PropertyLength", "HalfHeight", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Half-axis upwards, everywhere or at the start"),
                 1.0),
        Property("App::PropertyLength", "EndHalfWidth", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Half-axis to the side at the end"),
                 2.0),
        Property("App::PropertyLength", "EndHalfHeight", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Half-axis upwards at the end"),
                 1.0),
        Property("App::PropertyEnumeration", "PositionBy", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "What positions on the spine count"),
                 MEASURES),
        Property("App::PropertyFloatList", "Positions", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Positions of the half-axes on the spine, arc lengths in mm")),
        Property("App::PropertyFloatList", "HalfWidths", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Half-axes to the side at the positions, in mm")),
        Property("App::PropertyFloatList", "HalfHeights", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Half-axes upwards at the positions, in mm")),
        Property("App::PropertyString", "HalfWidthExpression", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Half-axis to the side by the position s and the length L of the"
                                   " spine, such as 20 mm + 5 mm * cos(pi*s)")),
        Property("App::PropertyString", "HalfHeightExpression", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Half-axis upwards by the position s and the length L of the"
                                   " spine, such as 10 mm * exp(s)")),
        # The property editor would show it as 0.00.
        Property("App::PropertyLength", "FitTolerance", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "How far a fit may be from what has no exact form"),
                 FIT_TOLERANCE),
        result("App::PropertyString", "FitDeviation",
               QT_TRANSLATE_NOOP("App::Property",
                                 "How far fits are off, part of the deviation; proven or"
                                 " measured")),
    )

    def base(self, inputs):
        spine = _spine(inputs)
        laws = [half_axis_law(inputs, axis, spine) for axis in HALF_AXES]
        fits_of_laws = [fit for law in laws for fit in law.fits]
        surface = kernel.pnkernel().moving_conic_section(
            spine.curve, half_axes=[law.kernel_law() for law in laws], **planes_of(inputs)
        )
        # A point moves by no more than its half-axes, of which one at most is off in full, and by as
        # much as the spine where the planes do not turn with it.
        largest = max(fits_of_laws, key=lambda fit: fit.deviation, default=None)
        fits = (*spine.fits, *((largest,) if largest else ()))
        return Base(
            surface,
            notes=(*spine.notes, *(fit.note() for fit in (*spine.fits, *fits_of_laws))),
            exact=not fits,
            deviation=sum(fit.deviation for fit in fits),
            results={"FitDeviation": deviation_of(fits)},
        )

    def onChanged(self, obj, name):
        # While a document is read, other properties may not be there yet.
        if obj.Document.Restoring:
            return
        if name == "Planes":
            show_only(obj, {"Normal"} if obj.Planes == PARALLEL else set(), ["Normal"])
        if name == "SectionLaw":
            every = {input_ for law in INPUTS_OF_LAW for input_ in inputs_of_law(law)}
            show_only(obj, inputs_of_law(obj.SectionLaw), every)


def spine_of(obj, source, names):
    """The spine that the sub-elements `names` of `source` would be to the feature `obj`."""
    curve_of = exact_where_possible(obj.FitTolerance.Value)
    return read_spine(source, names, obj.getParentGeoFeatureGroup(), curve_of)


def planes_of(inputs):
    """Where the sections lie, as keywords of pnkernel.moving_conic_section."""
    normal = {"normal": tuple(inputs.Normal)} if inputs.Planes == PARALLEL else {}
    return {"up": tuple(inputs.Up), **normal}


def read_section(obj):
    """Spine (pnkernel.Curve) and half-axes (pnkernel.Law) of a feature, after fits.

    Raises ChainError, LinkError, SectionError or SectionLawError with a sentence for the user.
    """
    spine = _spine(obj)
    return spine.curve, [half_axis_law(obj, axis, spine).kernel_law() for axis in HALF_AXES]


def _spine(obj):
    spine = spine_of(obj, *chosen_spine(obj))
    if spine.fits and obj.Planes == PERPENDICULAR:
        raise SectionError(
            f"The spine has no exact form ({spine.fits[0].what}). How far planes perpendicular to"
            " its fit would be off is not known: choose parallel sections, or another spine."
        )
    return spine


def suitable_up(edges):
    """A direction upwards for a spine: the normal of its plane, or the z axis, or y beside that."""
    plane = Part.Compound(edges).findPlane()
    directions = [plane.Axis] if plane else []
    for up in (*directions, *_UPRIGHT):
        if not any(_is_line_along(edge, up) for edge in edges):
            upwards = up if up.dot(FreeCAD.Vector(1, 2, 4)) > 0 else -up
            return tuple(x + 0.0 for x in upwards)
    return tuple(_UPRIGHT[0])


def _is_line_along(edge, direction):
    if not isinstance(edge.Curve, Part.Line):
        return False
    return edge.Curve.Direction.cross(direction).Length <= CONFUSION


def make_moving_conic_section(spine, half_axes, *, up=(0, 0, 1), normal=None, document=None,
                              name="MovingConicSection", **properties):
    """The surface of ellipses along a spine, in the tree, computed. Lengths are millimetres or
    strings with a unit.

    Parameters
    ----------
    spine : document object (all its edges), (object, "Edge1") or (object, ["Edge1", "Edge2"])
    half_axes : one of
        (a, b) : to the side and upwards, constant
        ((a, b), (a, b)) : at the start and at the end, linear in the parameter of the spine
        ("Table", [(position, a, b), ...]) : the C2 splines through half-axes at positions
        ("Expression", (text, text)) : by the position s and the length L of the spine, such as
            "20 mm + 5 mm * s"; followed by splines within FitTolerance
    up : direction upwards. In the plane of a section the height runs along its projection, at the
        start of the spine, and goes on smoothly from there; the side is perpendicular to it.
    normal : that of parallel sections; none for sections perpendicular to the spine
    document : the document of the spine unless given
    name : wanted internal name and label
    properties : values of further properties, such as Output="Solid" or PositionBy="Arc length"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    link = as_link(spine)
    planes = {"Planes": PERPENDICULAR} if normal is None else {
        "Planes": PARALLEL, "Normal": FreeCAD.Vector(*normal)
    }
    values = {
        "Spine": link, **planes, "Up": FreeCAD.Vector(*up), **_law_values(half_axes), **properties
    }
    return make_feature(MovingConicSection, document or link[0].Document, name, values)


def _law_values(half_axes):
    """The property values that the argument half_axes stands for."""
    first, second = half_axes
    if first == TABLE:
        positions, widths, heights = zip(*second) if second else ((), (), ())
        return {
            "SectionLaw": TABLE, "Positions": lengths(positions), "HalfWidths": lengths(widths),
            "HalfHeights": lengths(heights),
        }
    if first == EXPRESSION:
        width, height = second
        return {
            "SectionLaw": EXPRESSION, "HalfWidthExpression": width, "HalfHeightExpression": height
        }
    if isinstance(first, (tuple, list)):
        return {
            "SectionLaw": LINEAR,
            **dict(zip(("HalfWidth", "HalfHeight"), first)),
            **dict(zip(("EndHalfWidth", "EndHalfHeight"), second)),
        }
    return {"SectionLaw": CONSTANT, "HalfWidth": first, "HalfHeight": second}
