# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helices, spirals and circles: a fit by polynomials whose error is proved.

A curve with straight parameters on a cylinder, a cone or a surface that a line makes by revolution
is c(w) = o + z(w) a + ρ(w) (cos θ(w) e + sin θ(w) f) with z, ρ and θ linear in w. Its derivative
of order six is, with ω = θ' and σ = ρ', the length of ρ ω⁶ - 6 i σ ω⁵. Quintic Hermite
interpolation over an interval of length h is off by at most h⁶ / 46080 times the largest of it:
the error of each coordinate, in whatever direction the axes point, is c⁽⁶⁾ (t - a)³ (t - b)³ / 720.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import Part

from pnsurfaces.curve_fit import bspline_curve
from pnsurfaces.spline_fit import Fit, FitError

_STRAIGHT_CURVES = (Part.Line, Part.LineSegment)

# Largest value of |(t - a)³ (t - b)³| / 720 for b - a = 1.
_HERMITE_FACTOR = 1 / 46080

# A derivative is computed in doubles by fewer operations than this, each off by one unit in the
# last place at most.
_OPERATIONS = 16


class Helix(NamedTuple):
    """The curve above for w in [0, 1]; z, rho and theta are pairs (value at 0, rate)."""

    origin: Any
    axis: Any
    across: Any
    z: tuple
    rho: tuple
    theta: tuple

    def derivatives(self, w):
        """The points (n, 3) at w (n,), and their first two derivatives."""
        w = np.asarray(w, dtype=float)[:, None]
        z, rho, theta = ([rate * w + value, rate] for value, rate in (self.z, self.rho, self.theta))
        forward = np.cross(self.axis, self.across)
        out = np.cos(theta[0]) * self.across + np.sin(theta[0]) * forward
        along = np.cos(theta[0]) * forward - np.sin(theta[0]) * self.across
        omega = theta[1]
        return (
            self.origin + z[0] * self.axis + rho[0] * out,
            z[1] * self.axis + rho[1] * out + rho[0] * omega * along,
            2 * rho[1] * omega * along - rho[0] * omega**2 * out,
        )

    def sixth_derivative(self):
        """A bound on the length of the derivative of order six."""
        widest = max(abs(self.rho[0]), abs(self.rho[0] + self.rho[1]))
        omega = abs(self.theta[1])
        return math.hypot(widest * omega**6, 6 * self.rho[1] * omega**5)

    def rounding(self):
        """A bound on the rounding of points: that of the angle, carried out by the radius."""
        size = max(np.abs(np.concatenate(self.derivatives([0, 1])[0])))
        turns = abs(self.theta[0]) + abs(self.theta[1])
        return (turns + _OPERATIONS) * size * np.finfo(float).eps


def read_helix(edge):
    """The helix that an edge really is, or None.

    OpenCASCADE gives the edge a fitted curve in space, but its curve on the surface is exact.
    """
    on_surface = edge.curveOnSurface(0)
    if on_surface is None or not isinstance(edge.Curve, Part.BSplineCurve):
        return None
    curve, surface, placement, first, last = on_surface
    if not isinstance(curve, Part.Geom2d.Line2d) or not _is_round(surface):
        return None
    return _helix(curve.value(first), curve.value(last), surface, placement)


def read_circle(edge):
    """The helix of no height that an arc of a circle is."""
    circle = edge.Curve
    first, last = edge.ParameterRange
    across = (circle.value(first) - circle.Center) / circle.Radius
    return Helix(
        np.array(circle.Center),
        np.array(circle.Axis),
        np.array(across),
        (0.0, 0.0),
        (circle.Radius, 0.0),
        (0.0, last - first),
    )


def fitted_helix(helix, what, domain, tolerance):
    """A C2 quintic spline (Part.BSplineCurve) over the domain (first, last), and its Fit.

    Raises FitError when doubles are coarser than the tolerance.
    """
    allowed = tolerance - helix.rounding()
    if allowed <= 0:
        raise FitError(
            f"No fit: {what} of this size has no points within {tolerance:.2g} mm; its rounding is"
            f" {helix.rounding():.2g} mm."
        )
    step = (allowed / (_HERMITE_FACTOR * helix.sixth_derivative())) ** (1 / 6)
    count = max(1, math.ceil(1 / step))
    shares = np.linspace(0, 1, count + 1)
    values, slopes, bends = helix.derivatives(shares)
    knots = domain[0] + (domain[1] - domain[0]) * shares
    # The derivatives are those by the share of the domain.
    scale = domain[1] - domain[0]
    curve = bspline_curve(knots, values, slopes / scale, bends / scale**2)
    bound = _HERMITE_FACTOR * helix.sixth_derivative() / count**6 + helix.rounding()
    return curve, Fit(what, bound, proven=True)


def _is_round(surface):
    """Whether the surface is made by the revolution of a straight line."""
    if isinstance(surface, Part.SurfaceOfRevolution):
        meridian = surface.BasisCurve
        return isinstance(meridian, _STRAIGHT_CURVES) or getattr(meridian, "Degree", 0) == 1
    return isinstance(surface, (Part.Cylinder, Part.Cone))


def _helix(begin, end, surface, placement):
    """The image of the segment from begin to end, parameters of the surface at the placement."""
    if begin.x == end.x:
        return None
    revolution = isinstance(surface, Part.SurfaceOfRevolution)
    origin = surface.Location if revolution else surface.Center
    axis = surface.Direction if revolution else surface.Axis
    meridian = [surface.value(begin.x, v) - origin for v in (begin.y, end.y)]
    radial = [point - axis * point.dot(axis) for point in meridian]
    widest = max((0, 1), key=lambda i: radial[i].Length)
    across = radial[widest].normalize()
    # An axis with a left-handed frame turns the other way.
    turning = surface.getDN(begin.x, (begin.y, end.y)[widest], 1, 0).dot(axis.cross(across))
    turn = placement.Rotation.multVec
    return Helix(
        np.array(placement.multVec(origin)),
        np.array(turn(axis)),
        np.array(turn(across)),
        _linear(*(point.dot(axis) for point in meridian)),
        _linear(*(point.dot(across) for point in meridian)),
        (0.0, math.copysign(1.0, turning) * (end.x - begin.x)),
    )


def _linear(first, last):
    return first, last - first
