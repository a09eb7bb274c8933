# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radius laws of a canal surface, from the properties of a feature. Radii are millimetres."""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces import kernel
from pnsurfaces.cubic_spline import cubic_spline, natural_ends, periodic_ends, values_at_ends
from pnsurfaces.fitted_law import fitted_law
from pnsurfaces.position import ARC_LENGTH, measure
from pnsurfaces.profile import Profile
from pnsurfaces.radius_error import RadiusLawError
from pnsurfaces.radius_expression import LENGTH, RadiusExpression
from pnsurfaces.spline_grid import basis

CONSTANT = "Constant"
LINEAR = "Linear"
VALUES_AT_VERTICES = "Values at vertices"
BEZIER_COEFFICIENTS = "Bezier coefficients"
TABLE = "Table"
EXPRESSION = "Expression"
PROFILE = "Profile"

# The properties that each law reads.
INPUTS_OF_LAW = {
    CONSTANT: ("Radius",),
    LINEAR: ("Radius", "EndRadius"),
    VALUES_AT_VERTICES: ("Radii",),
    BEZIER_COEFFICIENTS: ("Radii",),
    TABLE: ("PositionBy", "Positions", "Radii"),
    EXPRESSION: ("PositionBy", "RadiusExpression"),
    PROFILE: ("Profile",),
}


# Laws that are no splines of themselves.
FITTED_LAWS = (EXPRESSION, PROFILE)


# Radii that are as near to a line, by their largest, lie on it. A cubic through them would have
# nothing but rounding in its higher terms, and a surface of ten times the degree.
_ROUNDING = 16 * np.finfo(float).eps


class RadiusLaw(NamedTuple):
    """A B-spline over the whole of a spine, or one coefficient, a constant.

    `fits` (spline_fit.Fit) tell how far the spline is from a law that is none.
    """

    degree: int
    knots: Any
    multiplicities: Any
    coefficients: Any
    fits: tuple = ()

    def lowered(self, radius):
        """The law of the radii that are left when `radius` is taken away."""
        return self._replace(coefficients=np.asarray(self.coefficients) - radius)

    def values(self, parameters):
        """The values (n,) at parameters (n,) of the spine."""
        knots = np.repeat(np.asarray(self.knots, dtype=float), self.multiplicities)
        return basis(knots, self.degree, parameters) @ np.asarray(self.coefficients, dtype=float)

    def kernel_law(self):
        """The same as a pnkernel.Law."""
        law = kernel.pnkernel().Law
        if len(self.coefficients) == 1:
            return law.constant(self.coefficients[0])
        return law.bspline(self.degree, self.knots, self.multiplicities, self.coefficients)


def radius_law(obj, spine):
    """The law of feature `obj` over the whole of `spine` (spine.Spine).

    Raises RadiusLawError when the properties do not fit the spine.
    """
    return _LAWS[obj.RadiusLaw](obj, spine)


def _constant(obj, spine):
    return _bezier(spine, [obj.Radius.Value])


def _linear(obj, spine):
    return _bezier(spine, [obj.Radius.Value, obj.EndRadius.Value])


def _bezier_coefficients(obj, spine):
    return _bezier(spine, obj.Radii)


def _values_at_vertices(obj, spine):
    vertices = np.asarray(spine.curve.breaks)
    radii = obj.Radii
    if len(radii) != len(vertices):
        raise RadiusLawError(
            f"The spine has {len(vertices)} vertices, but {len(radii)} radii are given."
        )
    return _through(spine, vertices, np.asarray(radii))


def _table(obj, spine):
    positions, radii = np.asarray(obj.Positions), np.asarray(obj.Radii)
    if len(positions) != len(radii) or len(radii) == 0:
        raise RadiusLawError(
            f"The table has {len(positions)} positions and {len(radii)} values. Give each position"
            " a value, and at least one."
        )
    scale = measure(spine, obj.PositionBy)
    order = np.argsort(positions, kind="stable")
    positions, radii = positions[order], radii[order]
    _require_distinct(positions, scale)
    _require_on_spine(positions, scale)
    if len(radii) == 1:
        return _bezier(spine, radii)
    parameters = np.array([scale.parameter(position) for position in positions])
    if spine.closed:
        return _through(spine, *_closed_up(spine, parameters, radii))
    return _through(spine, *_extended(spine, parameters, radii))


def _expression(obj, spine):
    return fitted_expression(obj.RadiusExpression, obj, spine, "the radius expression")


def _profile(obj, spine):
    if obj.Profile is None:
        raise RadiusLawError("The profile is missing. Choose an edge, a wire or a sketch.")
    source, names = obj.Profile
    profile = Profile(source, names, obj.getParentGeoFeatureGroup())
    radii = profile.radii_along_line(spine)
    return _bezier(spine, radii) if radii else _fitted(profile, obj, spine)


_LAWS = {
    CONSTANT: _constant,
    LINEAR: _linear,
    VALUES_AT_VERTICES: _values_at_vertices,
    BEZIER_COEFFICIENTS: _bezier_coefficients,
    TABLE: _table,
    EXPRESSION: _expression,
    PROFILE: _profile,
}


def fitted_expression(text, obj, spine, what, dimension=LENGTH):
    """The RadiusLaw that follows an expression of a dimension within the FitTolerance of `obj`.

    `what` it is called. Raises RadiusLawError when the text is no such expression.
    """
    return _fitted(along_spine(text, obj.PositionBy, spine, what, dimension), obj, spine)


def along_spine(text, position_by, spine, what, dimension=LENGTH):
    """An expression of a dimension in the position, as what fitted_law follows; `what` it is called.

    Raises RadiusLawError when the text is no such expression.
    """
    scale = measure(spine, position_by)
    position_dimension = 1 if position_by == ARC_LENGTH else 0
    expression = RadiusExpression(text, position_dimension, spine.length, dimension)
    return _AlongSpine(expression, scale, what)


class _AlongSpine:
    """An expression in the position as a function of the parameter of a spine."""

    def __init__(self, expression, scale, what):
        self._expression = expression
        self._scale = scale
        self.what = what

    def radius(self, stretch, t):
        return self._expression.radius(self._scale.position(stretch, t))

    def slope(self, stretch, t):
        by_position = self._expression.slope(self._scale.position(stretch, t))
        return by_position * self._scale.rate(stretch, t)


def _fitted(function, obj, spine):
    return RadiusLaw(*fitted_law(function, spine, obj.FitTolerance.Value))


def _bezier(spine, coefficients):
    order = len(coefficients)
    if order == 0:
        raise RadiusLawError("The radius law needs at least one radius.")
    return RadiusLaw(order - 1, spine.curve.domain, [order, order], coefficients)


def _through(spine, parameters, radii):
    """The C2 cubic spline through radii at parameters from end to end, periodic if closed."""
    if spine.closed and radii[0] != radii[-1]:
        raise RadiusLawError("The spine is closed: its first and last radius must be equal.")
    if _is_straight(parameters, radii):
        return _bezier(spine, radii[[0, -1]])
    ends = periodic_ends if spine.closed else natural_ends
    coefficients = cubic_spline(parameters, radii, ends)
    multiplicities = [4] + [1] * (len(parameters) - 2) + [4]
    return RadiusLaw(3, parameters, multiplicities, coefficients)


def _require_distinct(positions, scale):
    for before, after in zip(positions, positions[1:]):
        if after - before <= scale.confusion:
            raise RadiusLawError(f"Two rows of the table have the position {after:.6g}.")


def _require_on_spine(positions, scale):
    for position in positions:
        if not scale.start - scale.confusion <= position <= scale.end + scale.confusion:
            raise RadiusLawError(
                f"Position {position:.6g} of the table is not on the spine, which runs from"
                f" {scale.start:.6g} to {scale.end:.6g}."
            )


def _closed_up(spine, parameters, radii):
    """The rows of a closed spine from its start to its end, which is the start again."""
    first, last = spine.curve.domain
    if parameters[0] != first:
        raise RadiusLawError("The spine is closed: give the table a row at its start.")
    if parameters[-1] == last:
        return parameters, radii
    return np.append(parameters, last), np.append(radii, radii[0])


def _extended(spine, parameters, radii):
    """The rows, the first and the last moved along their spline to the ends of the spine."""
    first, last = spine.curve.domain
    if len(parameters) == 2:
        at_ends = radii[0] + (np.array([first, last]) - parameters[0]) * (
            (radii[1] - radii[0]) / (parameters[1] - parameters[0])
        )
    else:
        at_ends = values_at_ends(parameters, radii, first, last)
    return (
        np.concatenate([[first], parameters[1:-1], [last]]),
        np.concatenate([at_ends[:1], radii[1:-1], at_ends[1:]]),
    )


def _is_straight(parameters, radii):
    line = np.interp(parameters, parameters[[0, -1]], radii[[0, -1]])
    return np.abs(radii - line).max() <= _ROUNDING * np.abs(radii).max()
