# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canal surface from r^2 in the tree: the envelope of spheres whose squared radius is given.

It is rational where r itself is not; its offsets are rational only where r is.
"""

from pnsurfaces import kernel
from pnsurfaces.canal_surface import chosen_spine, lengths, spine_under
from pnsurfaces.feature import (
    QT_TRANSLATE_NOOP,
    Base,
    FeatureBase,
    Property,
    make_feature,
    result,
    show_only,
)
from pnsurfaces.linked_shape import as_link
from pnsurfaces.radius_law import BEZIER_COEFFICIENTS, CONSTANT, EXPRESSION, LINEAR, TABLE
from pnsurfaces.spine_properties import FIT_DEVIATION, fit_tolerance, position_by
from pnsurfaces.spline_fit import deviation_of
from pnsurfaces.squared_radius_law import INPUTS_OF_LAW, squared_radius_law

GROUP = "Canal surface from r²"


class SquaredRadiusCanal(FeatureBase):
    """Proxy of a canal surface from r^2: a spine and the law of the squared radius along it."""

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "Spine",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Edges through the centres of the spheres"),
        ),
        Property(
            "App::PropertyEnumeration",
            "SquaredRadiusLaw",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "How the squared radius runs along the spine"),
            list(INPUTS_OF_LAW),
        ),
        Property(
            "App::PropertyArea",
            "SquaredRadius",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Squared radius, or that at the start"),
            1.0,
        ),
        Property(
            "App::PropertyArea",
            "EndSquaredRadius",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Squared radius at the end"),
            1.0,
        ),
        Property(
            "App::PropertyFloatList",
            "SquaredRadii",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Squared radii at the positions, or Bezier coefficients, in" " mm^2"
            ),
        ),
        position_by(GROUP),
        Property(
            "App::PropertyFloatList",
            "Positions",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Positions of the squared radii on the spine, arc lengths in" " mm"
            ),
        ),
        Property(
            "App::PropertyString",
            "SquaredRadiusExpression",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Squared radius by the position s and the length L of the"
                " spine, such as 4 mm^2 + 5 mm^2 * sin(pi*s)",
            ),
        ),
        fit_tolerance(GROUP),
        FIT_DEVIATION,
        result(
            "App::PropertyBool",
            "RationalRadius",
            QT_TRANSLATE_NOOP(
                "App::Property", "Whether the radius itself is rational, so that offsets are exact"
            ),
        ),
    )

    def has_offsets(self, obj):
        return obj.RationalRadius

    def base(self, inputs):
        spine = _spine(inputs)
        law = squared_radius_law(inputs, spine)
        fits = (*spine.fits, *law.fits)
        surface = kernel.pnkernel().moebius_canal_surface(spine.curve, law.kernel_law())
        return Base(
            surface,
            notes=(*spine.notes, *(fit.note() for fit in fits)),
            exact=not fits,
            # As of a canal surface: fits of r^2 tell how far they are off in r.
            deviation=sum(fit.deviation for fit in fits),
            results={"FitDeviation": deviation_of(fits), "RationalRadius": surface.has_offsets},
        )

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        # While a document is read, other properties may not be there yet.
        if name == "SquaredRadiusLaw" and not obj.Document.Restoring:
            show_only(obj, INPUTS_OF_LAW[obj.SquaredRadiusLaw], set().union(*INPUTS_OF_LAW.values()))


def _spine(obj):
    return spine_of(obj, *chosen_spine(obj))


def spine_of(obj, source, names):
    """The spine that the sub-elements `names` of `source` would be to the feature `obj`."""
    return spine_under(obj.SquaredRadiusLaw, obj, source, names)


def read_squared_spheres(obj):
    """Spine (pnkernel.Curve) and squared radius (pnkernel.Law) of a feature, after fits.

    Raises ChainError, LinkError, FitError or SquaredRadiusError with a sentence for the user.
    """
    spine = _spine(obj)
    return spine.curve, squared_radius_law(obj, spine).kernel_law()


def make_squared_radius_canal(
    spine,
    squared_radius,
    distance=0,
    *,
    document=None,
    name="CanalSurfaceFromSquaredRadius",
    **properties,
):
    """A canal surface from r^2 in the tree, computed. Areas are mm^2 or strings with a unit.

    Parameters
    ----------
    spine : document object (all its edges), (object, "Edge1") or (object, ["Edge1", "Edge2"])
    squared_radius : one of
        a number : constant
        (start, end) : linear in the parameter of the spine
        ("Bezier coefficients", areas) : a polynomial in the parameter of the spine
        ("Table", [(position, area), ...]) : the C2 spline through squared radii at positions
        ("Expression", text) : by the position s and the length L of the spine, such as
            "4 mm^2 + 5 mm^2 * s"; followed by a spline, with the radius within FitTolerance
    distance : signed distance from the base surface; other than zero only where the radius itself
        is rational
    document : the document of the spine unless given
    name : wanted internal name and label
    properties : values of further properties, such as Output="Solid" or PositionBy="Arc length"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises what FreeCAD raises for a property that does not exist (AttributeError) or cannot have
    the value (TypeError, ValueError, ArithmeticError); nothing is then left in the document.
    """
    link = as_link(spine)
    values = {"Spine": link, "Distance": distance, **_law_values(squared_radius), **properties}
    return make_feature(SquaredRadiusCanal, document or link[0].Document, name, values)


def _law_values(squared_radius):
    """The property values that the argument squared_radius stands for."""
    if not isinstance(squared_radius, (tuple, list)):
        return {"SquaredRadiusLaw": CONSTANT, "SquaredRadius": squared_radius}
    first, second = squared_radius
    if first == BEZIER_COEFFICIENTS:
        return {"SquaredRadiusLaw": first, "SquaredRadii": lengths(second)}
    if first == TABLE:
        positions, squares = zip(*second) if second else ((), ())
        return {
            "SquaredRadiusLaw": first,
            "Positions": lengths(positions),
            "SquaredRadii": lengths(squares),
        }
    if first == EXPRESSION:
        return {"SquaredRadiusLaw": first, "SquaredRadiusExpression": second}
    return {"SquaredRadiusLaw": LINEAR, "SquaredRadius": first, "EndSquaredRadius": second}
