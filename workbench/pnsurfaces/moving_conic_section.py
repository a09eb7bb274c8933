# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a moving conic section in the tree: ellipses or arcs of conics along a spine."""

import FreeCAD
import Part

from pnsurfaces import kernel
from pnsurfaces.canal_surface import chosen_spine
from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.edge_fit import exact_where_possible
from pnsurfaces.feature import (
    QT_TRANSLATE_NOOP,
    Base,
    FeatureWithoutOffsets,
    Property,
    make_feature,
    show_only,
)
from pnsurfaces.linked_shape import as_link
from pnsurfaces.section_law import (
    ELLIPSE,
    FROM_THE_VERTEX,
    INPUTS_OF_LAW,
    SECTIONS,
    inputs_of_all_laws,
    inputs_of_law,
    section_laws,
    values_of_law,
)
from pnsurfaces.spine import read_spine
from pnsurfaces.spine_properties import FIT_DEVIATION, fit_tolerance, position_by
from pnsurfaces.spline_fit import deviation_of

GROUP = "Moving conic section"

# Directions upwards, the first that suits a spine.
_UPRIGHT = (FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(0, 1, 0), FreeCAD.Vector(1, 0, 0))

PERPENDICULAR = "Perpendicular"
PARALLEL = "Parallel"
UPRIGHT = "Upright"

# Where the sections lie, as keywords of pnkernel.moving_conic_section.
_PLANES = {
    PERPENDICULAR: lambda inputs: {},
    PARALLEL: lambda inputs: {"normal": tuple(inputs.Normal)},
    UPRIGHT: lambda inputs: {"planes": "upright"},
}


class SectionError(ValueError):
    """There are no such sections. The text is a sentence for the user."""


class MovingConicSection(FeatureWithoutOffsets):
    """Proxy of the surface of ellipses around a spine, or of conics with their vertex on it."""

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "Spine",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Edges through the centres or vertices of the sections"
            ),
        ),
        Property(
            "App::PropertyEnumeration",
            "Planes",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Whether sections are perpendicular to the spine, parallel to"
                " one another, or upright: through the direction upwards,"
                " perpendicular to the spine as it is seen along that",
            ),
            list(_PLANES),
        ),
        Property(
            "App::PropertyVector",
            "Normal",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "The direction that parallel sections are" " perpendicular to"
            ),
            FreeCAD.Vector(1, 0, 0),
        ),
        Property(
            "App::PropertyVector",
            "Up",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "The direction upwards: the height of a section runs along it, as"
                " far as its plane allows",
            ),
            FreeCAD.Vector(0, 0, 1),
        ),
        Property(
            "App::PropertyEnumeration",
            "Section",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Ellipses around the spine, or conics that open upwards from"
                " their vertex on the spine",
            ),
            list(SECTIONS),
        ),
        Property(
            "App::PropertyEnumeration",
            "SectionLaw",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "How the measures of the sections run along the spine"),
            list(INPUTS_OF_LAW),
        ),
        Property(
            "App::PropertyLength",
            "HalfWidth",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis to the side, everywhere or at the start"),
            2.0,
        ),
        Property(
            "App::PropertyLength",
            "HalfHeight",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis upwards, everywhere or at the start"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "EndHalfWidth",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis to the side at the end"),
            2.0,
        ),
        Property(
            "App::PropertyLength",
            "EndHalfHeight",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis upwards at the end"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "Radius",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Radius of curvature at the vertex, everywhere or at the start"
            ),
            1.0,
        ),
        Property(
            "App::PropertyFloat",
            "ConicConstant",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Conic constant, everywhere or at the start: below -1 a"
                " hyperbola, -1 a parabola, above an ellipse, 0 a circle",
            ),
            -1.0,
        ),
        Property(
            "App::PropertyLength",
            "Depth",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "How high a section goes above its vertex, everywhere or at the" " start",
            ),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "EndRadius",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Radius of curvature at the vertex, at the end"),
            1.0,
        ),
        Property(
            "App::PropertyFloat",
            "EndConicConstant",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Conic constant at the end"),
            -1.0,
        ),
        Property(
            "App::PropertyLength",
            "EndDepth",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "How high a section goes above its vertex, at the end"),
            1.0,
        ),
        position_by(GROUP),
        Property(
            "App::PropertyFloatList",
            "Positions",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Positions of the rows of the table on the spine, arc lengths in" " mm",
            ),
        ),
        Property(
            "App::PropertyFloatList",
            "HalfWidths",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axes to the side at the positions, in mm"),
        ),
        Property(
            "App::PropertyFloatList",
            "HalfHeights",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axes upwards at the positions, in mm"),
        ),
        Property(
            "App::PropertyFloatList",
            "Radii",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Radii of curvature at the vertex at the positions, in mm"
            ),
        ),
        Property(
            "App::PropertyFloatList",
            "ConicConstants",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Conic constants at the positions"),
        ),
        Property(
            "App::PropertyFloatList",
            "Depths",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "How high sections go above their vertex at the positions, in" " mm"
            ),
        ),
        Property(
            "App::PropertyString",
            "HalfWidthExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Half-axis to the side by the position s and the length L of the"
                " spine, such as 20 mm + 5 mm * cos(pi*s)",
            ),
        ),
        Property(
            "App::PropertyString",
            "HalfHeightExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Half-axis upwards by the position s and the length L of the"
                " spine, such as 10 mm * exp(s)",
            ),
        ),
        Property(
            "App::PropertyString",
            "RadiusExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Radius of curvature at the vertex by the position s and the"
                " length L of the spine, such as 20 mm + 5 mm * s",
            ),
        ),
        Property(
            "App::PropertyString",
            "ConicConstantExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Conic constant by the position s, a plain number, such as" " -1 + 0.5 * sin(pi*s)",
            ),
        ),
        Property(
            "App::PropertyString",
            "DepthExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "How high a section goes above its vertex by the position s and"
                " the length L of the spine, such as 10 mm",
            ),
        ),
        fit_tolerance(GROUP),
        FIT_DEVIATION,
    )

    def base(self, inputs):
        spine = _spine(inputs)
        section, laws = SECTIONS[inputs.Section], section_laws(inputs, spine)
        surface = kernel.pnkernel().moving_conic_section(
            spine.curve, **{section.argument: [law.kernel_law() for law in laws]}, **planes_of(inputs)
        )
        # Where planes do not turn with a fitted spine, points move by as much as it does.
        fits = (*spine.fits, *section.displacements(laws))
        return Base(
            surface,
            notes=(*spine.notes, *(fit.note() for fit in fits)),
            exact=not fits,
            deviation=sum(fit.deviation for fit in fits),
            results={"FitDeviation": deviation_of(fits)},
        )

    def solid(self, inputs, sections):
        if inputs.Section == FROM_THE_VERTEX:
            raise SectionError(
                "Sections from the vertex are open and enclose no solid. Choose a surface."
            )
        return super().solid(inputs, sections)

    def onChanged(self, obj, name):
        # While a document is read, other properties may not be there yet.
        if name in ("Planes", "Section", "SectionLaw") and not obj.Document.Restoring:
            _show_inputs(obj)

    def _add_missing_properties(self, obj):
        super()._add_missing_properties(obj)
        _show_inputs(obj)


def _show_inputs(obj):
    """Hides the properties that belong to other choices."""
    shown = inputs_of_law(obj.Section, obj.SectionLaw)
    show_only(
        obj, ["Normal", *shown] if obj.Planes == PARALLEL else shown, {"Normal", *inputs_of_all_laws()}
    )


def spine_of(obj, source, names):
    """The spine that the sub-elements `names` of `source` would be to the feature `obj`."""
    curve_of = exact_where_possible(obj.FitTolerance.Value)
    return read_spine(source, names, obj.getParentGeoFeatureGroup(), curve_of)


def planes_of(inputs):
    """Where the sections lie, as keywords of pnkernel.moving_conic_section."""
    return {"up": tuple(inputs.Up), **_PLANES[inputs.Planes](inputs)}


def read_section(obj):
    """Spine (pnkernel.Curve) and laws (pnkernel.Law) of the section of a feature, after fits.

    Raises ChainError, LinkError, SectionError or SectionLawError with a sentence for the user.
    """
    spine = _spine(obj)
    return spine.curve, [law.kernel_law() for law in section_laws(obj, spine)]


def _spine(obj):
    spine = spine_of(obj, *chosen_spine(obj))
    if spine.fits and obj.Planes != PARALLEL:
        raise SectionError(
            f"The spine has no exact form ({spine.fits[0].what}). How far planes that turn with"
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


def make_moving_conic_section(
    spine,
    half_axes=None,
    *,
    vertex=None,
    up=(0, 0, 1),
    normal=None,
    document=None,
    name="MovingConicSection",
    **properties,
):
    """The surface of a conic section along a spine, in the tree, computed. Lengths are millimetres
    or strings with a unit.

    Parameters
    ----------
    spine : document object (all its edges), (object, "Edge1") or (object, ["Edge1", "Edge2"])
    half_axes : of ellipses around the spine, one of
        (a, b) : to the side and upwards, constant
        ((a, b), (a, b)) : at the start and at the end, linear in the parameter of the spine
        ("Table", [(position, a, b), ...]) : the C2 splines through half-axes at positions
        ("Expression", (text, text)) : by the position s and the length L of the spine, such as
            "20 mm + 5 mm * s"; followed by splines within FitTolerance
    vertex : instead of half_axes, the same of (R, K, h) of the conics x^2 = 2 R z - (1 + K) z^2, z
        upwards from the spine, to z = h: radius of curvature, conic constant (a number), depth
    up : direction upwards. In the plane of a section the height runs along its projection, at the
        start of the spine, and goes on smoothly from there; the side is perpendicular to it.
    normal : that of parallel sections; none for sections perpendicular to the spine, or upright
        ones, with Planes="Upright"
    document : the document of the spine unless given
    name : wanted internal name and label
    properties : values of further properties, such as Output="Solid" or PositionBy="Arc length"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    if (half_axes is None) == (vertex is None):
        raise ValueError("Either half_axes or vertex must be given.")
    link = as_link(spine)
    planes = (
        {"Planes": PERPENDICULAR}
        if normal is None
        else {"Planes": PARALLEL, "Normal": FreeCAD.Vector(*normal)}
    )
    section, given = (ELLIPSE, half_axes) if vertex is None else (FROM_THE_VERTEX, vertex)
    values = {
        "Spine": link,
        **planes,
        "Up": FreeCAD.Vector(*up),
        "Section": section,
        **values_of_law(section, given),
        **properties,
    }
    return make_feature(MovingConicSection, document or link[0].Document, name, values)
