# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which edges of a spine are taken exactly, and which are fitted.

Each function returns what edge_chain.read_edge_chain wants: from an edge its curve and a Fit or
None.
"""

import Part

from pnsurfaces.curve_fit import fitted_curve
from pnsurfaces.edge_chain import exact_curve, has_exact_form
from pnsurfaces.helix import fitted_helix, read_circle, read_helix
from pnsurfaces.spline_fit import FIT_TOLERANCE

# Their exact forms have weights. A radius law without weights would make of them surfaces of more
# than twice the degree.
_WEIGHTED = (Part.Ellipse, Part.Hyperbola)


def exact_where_possible(tolerance=FIT_TOLERANCE):
    """Helices and curves without a rational form are fitted within `tolerance` millimetres."""

    def curve_of(edge):
        helix = read_helix(edge)
        if helix:
            return _directed(edge, fitted_helix(helix, "a helix", edge.ParameterRange, tolerance))
        if has_exact_form(edge):
            return exact_curve(edge)
        return _directed(edge, fitted_curve(edge.Curve, edge.ParameterRange, tolerance))

    return curve_of


def polynomial_where_possible(tolerance=FIT_TOLERANCE):
    """Conics are fitted, too: where the radius is fitted, nothing is lost any more by that."""
    otherwise = exact_where_possible(tolerance)

    def curve_of(edge):
        domain = edge.ParameterRange
        if isinstance(edge.Curve, Part.Circle):
            fitted = fitted_helix(read_circle(edge), "an arc", domain, tolerance)
            return _directed(edge, fitted)
        if isinstance(edge.Curve, _WEIGHTED):
            return _directed(edge, fitted_curve(edge.Curve, domain, tolerance))
        return otherwise(edge)

    return curve_of


def _directed(edge, fitted):
    curve, fit = fitted
    if edge.Orientation == "Reversed":
        curve.reverse()
    return curve, fit
