# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canal surface in the tree: the envelope of spheres along a spine."""

import FreeCAD

from pnsurfaces import kernel
from pnsurfaces.edge_chain import CONFUSION, ChainError
from pnsurfaces.edge_fit import exact_where_possible, polynomial_where_possible
from pnsurfaces.feature import QT_TRANSLATE_NOOP, Base, FeatureBase, Property, make_feature, show_only
from pnsurfaces.linked_shape import as_link, circle_through
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    CONSTANT,
    EXPRESSION,
    FITTED_LAWS,
    INPUTS_OF_LAW,
    LINEAR,
    PROFILE,
    TABLE,
    VALUES_AT_VERTICES,
    radius_law,
)
from pnsurfaces.shape import domed_solid_of_sections, solid_of_sections, uncapped_solid_of_sections
from pnsurfaces.spine import read_spine
from pnsurfaces.spine_properties import FIT_DEVIATION, fit_tolerance, position_by
from pnsurfaces.spline_fit import deviation_of

GROUP = "Canal surface"
HOLLOW_GROUP = "Hollow pipe"

SOLID_PIPE = "No"
WALL = "Wall thickness"
BORE = "Inner radius"

# The properties that each kind of hollow pipe reads.
INPUTS_OF_HOLLOW = {SOLID_PIPE: (), WALL: ("WallThickness",), BORE: ("InnerRadius",)}


class HollowError(ValueError):
    """The pipe has no such wall. The text is a sentence for the user."""


# How the ends of a solid are closed. Without caps only a wall is a solid, closed by its normals,
# and a pipe without ends.
CAPS = {
    "Flat": solid_of_sections,
    "Spherical": domed_solid_of_sections,
    "None": uncapped_solid_of_sections,
}


class CanalSurface(FeatureBase):
    """Proxy of a canal surface: a spine and the law of the radius along it."""

    # Version 2 added the laws Table, Expression and Profile, the fits, the hollow pipe and caps.
    schema_version = 2

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "Spine",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Edges through the centres of the spheres"),
        ),
        Property(
            "App::PropertyEnumeration",
            "RadiusLaw",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "How the radius runs along the spine"),
            list(INPUTS_OF_LAW),
        ),
        Property(
            "App::PropertyLength",
            "Radius",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Radius, or radius at the start"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "EndRadius",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Radius at the end"),
            1.0,
        ),
        Property(
            "App::PropertyFloatList",
            "Radii",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Radii at the vertices or positions, or Bezier coefficients," " in mm"
            ),
        ),
        position_by(GROUP),
        Property(
            "App::PropertyFloatList",
            "Positions",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Positions of the radii on the spine, arc lengths in mm"
            ),
        ),
        Property(
            "App::PropertyString",
            "RadiusExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Radius by the position s and the length L of the spine, such"
                " as 2 mm + 0.5 mm * sin(2*pi*s)",
            ),
        ),
        Property(
            "App::PropertyLinkSub",
            "Profile",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Edges that the pipe runs through"),
        ),
        fit_tolerance(GROUP),
        Property(
            "App::PropertyEnumeration",
            "Hollow",
            HOLLOW_GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Whether the pipe is hollow, and how its wall" " is given"
            ),
            list(INPUTS_OF_HOLLOW),
        ),
        Property(
            "App::PropertyLength",
            "WallThickness",
            HOLLOW_GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Thickness of the wall, measured inwards"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "InnerRadius",
            HOLLOW_GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Radius of the bore, the same everywhere"),
            1.0,
        ),
        Property(
            "App::PropertyEnumeration",
            "Caps",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "How the ends of a solid are closed"),
            list(CAPS),
        ),
        FIT_DEVIATION,
    )

    def base(self, obj):
        spine = _spine(obj)
        law = radius_law(obj, spine)
        fits = (*spine.fits, *law.fits)
        return Base(
            kernel.pnkernel().canal_surface(spine.curve, law.kernel_law()),
            notes=(*spine.notes, *(fit.note() for fit in fits)),
            exact=not fits,
            # A sphere contains another one whose centre or radius is off by as much, if it grows by
            # that; so the envelope of all spheres is off by no more than both errors together.
            deviation=sum(fit.deviation for fit in fits),
            results={"FitDeviation": deviation_of(fits)},
        )

    def distances(self, inputs):
        outer = inputs.Distance.Value
        if inputs.Hollow == WALL:
            return [outer - inputs.WallThickness.Value, outer]
        # The bore has a radius of its own.
        return [outer] if inputs.Hollow == BORE else super().distances(inputs)

    def sections(self, obj, surface):
        if obj.Hollow == SOLID_PIPE:
            return super().sections(obj, surface)
        if obj.Sides != "Offset":
            raise HollowError(
                f"A hollow pipe has its own two sides. Choose the side Offset, not {obj.Sides}."
            )
        outer = surface.offset(obj.Distance.Value)
        inner = _bore(obj) if obj.Hollow == BORE else _inside_of_wall(obj, outer)
        return [inner, outer]

    def solid(self, inputs, sections):
        return CAPS[inputs.Caps](sections)

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        # While a document is read, other properties may not be there yet.
        if obj.Document.Restoring:
            return
        if name == "RadiusLaw":
            _show(obj, INPUTS_OF_LAW, obj.RadiusLaw)
        if name == "Hollow":
            _show(obj, INPUTS_OF_HOLLOW, obj.Hollow)
        if name in ("Spine", "Profile"):
            _report_circle(obj)


def _spine(obj):
    return spine_of(obj, *chosen_spine(obj))


def chosen_spine(obj):
    """What the property Spine leads to. Raises ChainError."""
    if obj.Spine is None:
        raise ChainError("The spine is missing. Choose an edge, a wire or a sketch.")
    return obj.Spine


def spine_of(obj, source, names):
    """The spine that the sub-elements `names` of `source` would be to the feature `obj`."""
    return spine_under(obj.RadiusLaw, obj, source, names)


def spine_under(law, obj, source, names):
    """The same for a feature whose radius runs by `law`."""
    curve_of = polynomial_where_possible if law in FITTED_LAWS else exact_where_possible
    container = obj.getParentGeoFeatureGroup()
    return read_spine(source, names, container, curve_of(obj.FitTolerance.Value))


def _inside_of_wall(obj, outer):
    thickness = obj.WallThickness.Value
    if thickness <= CONFUSION:
        raise HollowError(f"The wall would be {thickness:.2g} mm thick. Give it a thickness.")
    return outer.offset(-thickness)


def _bore(obj):
    """The pipe of the inner radius around the spine. It must lie inside the outer one."""
    spine = _spine(obj)
    wall = radius_law(obj, spine).lowered(obj.InnerRadius.Value - obj.Distance.Value)
    canal_surface, law = kernel.pnkernel().canal_surface, kernel.pnkernel().Law
    try:
        canal_surface(spine.curve, wall.kernel_law())
    except ValueError as error:
        raise HollowError(
            f"A bore of radius {obj.InnerRadius.Value:.6g} mm leaves no wall: {error}"
        ) from error
    return canal_surface(spine.curve, law.constant(obj.InnerRadius.Value))


def read_spheres(obj):
    """Spine (pnkernel.Curve) and radius (pnkernel.Law) of a feature CanalSurface, after fits.

    Raises ChainError, LinkError or RadiusLawError with a sentence for the user.
    """
    spine = _spine(obj)
    return spine.curve, radius_law(obj, spine).kernel_law()


def read_bore(obj):
    """The same of the bore of a feature CanalSurface; None when it has none of its own radius."""
    if obj.Hollow != BORE:
        return None
    return _spine(obj).curve, kernel.pnkernel().Law.constant(obj.InnerRadius.Value)


def make_canal_surface(spine, radius, distance=0, *, document=None, name="CanalSurface", **properties):
    """A canal surface in the tree, computed. Lengths are millimetres or strings with a unit.

    Parameters
    ----------
    spine : document object (all its edges), (object, "Edge1") or (object, ["Edge1", "Edge2"])
    radius : one of
        a number : constant
        (start, end) : linear in the parameter of the spine
        ("Values at vertices", [r1, r2, ...]) : the C2 spline through a radius for each vertex
        ("Bezier coefficients", [b0, b1, ...]) : the polynomial with these coefficients
        ("Table", [(position, r), ...]) : the C2 spline through radii at positions, in any order
        ("Expression", text) : the radius by the position s and the length L of the spine, such as
            "2 mm + 0.5 mm * sin(2*pi*s)"; followed by a spline within FitTolerance
        ("Profile", edges) : the distance of these edges, given as a spine is; the pipe runs through
            them. Followed by a spline within FitTolerance, unless both are straight in one plane
    distance : signed offset, positive away from the spine
    document : the document of the spine unless given
    name : wanted internal name and label
    properties : values of further properties, among them
        PositionBy : "Relative length" (0 to 1), "Arc length" (mm), "Parameter" (0 to 1), or, of a
            table, "Vertex" (1, 2, ...)
        FitTolerance : how far fits may be off; 1e-5 mm unless given
        Hollow : "No", "Wall thickness" or "Inner radius", with WallThickness (measured inwards) or
            InnerRadius
        Output : "Surface" or "Solid";  Sides, Caps, ParameterLines : as in the task panel

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises what FreeCAD raises for a property that does not exist (AttributeError) or cannot have
    the value (TypeError, ValueError, ArithmeticError); nothing is then left in the document.
    """
    source, names = as_link(spine)
    values = {"Spine": (source, names), "Distance": distance, **_radius_values(radius), **properties}
    return make_feature(CanalSurface, document or source.Document, name, values)


def _radius_values(radius):
    """The property values that a radius argument stands for."""
    if not isinstance(radius, (tuple, list)):
        return {"RadiusLaw": CONSTANT, "Radius": radius}
    first, second = radius
    if first in _VALUES_OF_LAW:
        return {"RadiusLaw": first, **_VALUES_OF_LAW[first](second)}
    return {"RadiusLaw": LINEAR, "Radius": first, "EndRadius": second}


def _table_values(rows):
    positions, radii = zip(*rows) if rows else ((), ())
    return {"Positions": [_number(position) for position in positions], "Radii": lengths(radii)}


def lengths(values):
    """The numbers of a list of lengths, in millimetres."""
    return [_number(value) for value in values]


def _number(value):
    """A number as it is, a string with a unit in millimetres."""
    return FreeCAD.Units.Quantity(value).Value if isinstance(value, str) else float(value)


# What the second half of a pair (law, values) means.
_VALUES_OF_LAW = {
    VALUES_AT_VERTICES: lambda radii: {"Radii": lengths(radii)},
    BEZIER_COEFFICIENTS: lambda coefficients: {"Radii": lengths(coefficients)},
    TABLE: _table_values,
    EXPRESSION: lambda text: {"RadiusExpression": text},
    PROFILE: lambda profile: {"Profile": as_link(profile)},
}


def _show(obj, inputs, choice):
    """Hides the properties that belong to other choices."""
    show_only(obj, inputs[choice], set().union(*inputs.values()))


def _report_circle(obj):
    """Says so when the sources of a feature depend on it: FreeCAD would not compute it any more."""
    circle = circle_through(obj)
    if circle:
        names = " from ".join(linked.Label for linked in circle)
        obj.Status = f"Error: {names}: these objects are made from one another in a circle."
