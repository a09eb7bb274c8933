# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laws of r^2 along a spine, from the properties of a feature. Squared radii are in mm^2.

They run as the radius of a canal surface does. An expression is followed in millimetres: where r is
at least R, a law that is off by d in r^2 / R is off by no more in r, for

    | sqrt(a) - sqrt(b) | = | a - b | / (sqrt(a) + sqrt(b)) <= | a - b | / R,   sqrt(a) >= R.
"""

import math
from types import SimpleNamespace

import numpy as np

from pnsurfaces.fitted_law import fitted_law, sampled
from pnsurfaces.radius_error import RadiusLawError
from pnsurfaces.radius_expression import AREA
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    CONSTANT,
    EXPRESSION,
    LINEAR,
    TABLE,
    RadiusLaw,
    along_spine,
    radius_law,
)

# The properties that each law reads.
INPUTS_OF_LAW = {
    CONSTANT: ("SquaredRadius",),
    LINEAR: ("SquaredRadius", "EndSquaredRadius"),
    BEZIER_COEFFICIENTS: ("SquaredRadii",),
    TABLE: ("PositionBy", "Positions", "SquaredRadii"),
    EXPRESSION: ("PositionBy", "SquaredRadiusExpression"),
}


class SquaredRadiusError(ValueError):
    """A law of r^2 does not fit the spine. The text is a sentence for the user."""


def squared_radius_law(obj, spine):
    """The radius_law.RadiusLaw of r^2 of feature `obj` over the whole of `spine` (spine.Spine).

    Raises FitError or SquaredRadiusError.
    """
    try:
        if obj.SquaredRadiusLaw == EXPRESSION:
            return _expression(obj, spine)
        return radius_law(_as_radii(obj), spine)
    except RadiusLawError as error:
        raise SquaredRadiusError(f"The squared radius: {error}") from error


def _as_radii(obj):
    """The same inputs under the names that a law of radii has."""
    return SimpleNamespace(
        RadiusLaw=obj.SquaredRadiusLaw,
        Radius=obj.SquaredRadius,
        EndRadius=obj.EndSquaredRadius,
        Radii=obj.SquaredRadii,
        PositionBy=obj.PositionBy,
        Positions=obj.Positions,
    )


def _expression(obj, spine):
    square = along_spine(
        obj.SquaredRadiusExpression, obj.PositionBy, spine, "the squared radius", AREA
    )
    least = _least_radius(square, spine)
    law = RadiusLaw(*fitted_law(_Over(square, least), spine, obj.FitTolerance.Value))
    return law._replace(coefficients=least * np.asarray(law.coefficients))


def _least_radius(square, spine):
    """That of the places at which a deviation is measured."""
    places = sampled(square, spine)
    parameter, least = places[np.argmin(places[:, 1])]
    if least <= 0:
        raise SquaredRadiusError(
            f"The squared radius is {least:.6g} mm^2 at parameter {parameter:.6g}; it must be"
            " positive."
        )
    return math.sqrt(least)


class _Over:
    """A squared radius over a radius, in millimetres, as what fitted_law follows."""

    def __init__(self, square, radius):
        self._square = square
        self._radius = radius
        self.what = square.what

    def radius(self, stretch, t):
        return self._square.radius(stretch, t) / self._radius

    def slope(self, stretch, t):
        return self._square.slope(stretch, t) / self._radius
