# SPDX-License-Identifier: LGPL-2.1-or-later
"""From edges, wires and sketches to the spine of a canal surface."""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.edge_chain import CONFUSION, end, lay_end_to_end, place, read_edge_chain, start
from pnsurfaces.edge_fit import exact_where_possible
from pnsurfaces.spline_fit import Fit

# A joint that turns by more than this, in radians, is a corner to the kernel whatever its size.
_CORNER = 1e-6

# A unit vector to which no plane that a designer draws in is perpendicular.
_SKEW = np.array([0.36, 0.48, 0.8])


class Stretch(NamedTuple):
    """A part of the spine that is C2: a clamped Part.BSplineCurve.

    It runs from the spine's parameter `begin` to `end`, over the spine's `breaks` (both ends among
    them), and starts `start_length` millimetres from the start of the spine.
    """

    curve: Any
    breaks: Any
    start_length: float

    @property
    def begin(self):
        return self.breaks[0]

    @property
    def end(self):
        return self.breaks[-1]

    @property
    def length(self):
        return self.curve.length()

    def point(self, t):
        return self.curve.value(self._own(t))

    def velocity(self, t):
        """The derivative of the point by the parameter of the spine."""
        return self.curve.getD1(self._own(t))[1] * self._rate()

    def length_at(self, t):
        """The length of the spine from its start to parameter t."""
        return self.start_length + self.curve.length(self.curve.FirstParameter, self._own(t))

    def parameter_at(self, length):
        """The parameter of the spine at this length from its start."""
        along = min(max(length - self.start_length, 0.0), self.length)
        first, last = self.curve.FirstParameter, self.curve.LastParameter
        own = self.curve.parameterAtDistance(along, first)
        # OpenCASCADE finds it within some 1e-6 mm; a step of Newton's method gives more digits.
        speed = self.curve.getD1(own)[1].Length
        if speed > 0:
            own = min(max(own + (along - self.curve.length(first, own)) / speed, first), last)
        return self.begin + (own - first) / self._rate()

    def _own(self, t):
        return self.curve.FirstParameter + (t - self.begin) * self._rate()

    def _rate(self):
        own = self.curve.LastParameter - self.curve.FirstParameter
        return own / (self.end - self.begin)


class Spine(NamedTuple):
    """One curve (pnkernel.Curve), whether it ends where it starts, and its stretches in order.

    `fits` (spline_fit.Fit) are those of edges without an exact form, `notes` sentences.
    """

    curve: Any
    closed: bool
    stretches: tuple
    fits: tuple
    notes: tuple

    @property
    def length(self):
        return self.stretches[-1].start_length + self.stretches[-1].length

    def parameter_at(self, length):
        """The parameter at this length from the start, exactly that of the end at the ends."""
        if length <= CONFUSION:
            return self.stretches[0].begin
        if length >= self.length - CONFUSION:
            return self.stretches[-1].end
        return self._stretch("start_length", length).parameter_at(length)

    def stretch_at(self, t):
        """The stretch of parameter t, at a joint the one that begins there."""
        return self._stretch("begin", t)

    def _stretch(self, key, value):
        keys = [getattr(stretch, key) for stretch in self.stretches]
        return self.stretches[max(np.searchsorted(keys, value, side="right") - 1, 0)]


def read_spine(source, names, container=None, curve_of=None):
    """The spine made of the sub-elements `names` of `source`, as edge_chain.read_edge_chain.

    The parameter of several edges runs with their length, so that a radius law is spread evenly
    over them; through a tangent joint it runs on with the same speed, so that a smooth law gives a
    smooth pipe. `curve_of` is edge_fit.exact_where_possible unless given.
    """
    chain = read_edge_chain(source, names, container, curve_of or exact_where_possible())
    chain = chain._replace(curves=_with_steady_speed(chain.curves))
    curve = chain.kernel_curve()
    stretches = _stretches(chain.curves, np.asarray(curve.breaks))
    return Spine(curve, chain.closed, stretches, _joint_fit(chain.fits), _touching(chain))


def _joint_fit(fits):
    """The fits of many edges as one: no point of the spine is further off than the worst edge."""
    if not fits:
        return ()
    whats = sorted({fit.what for fit in fits})
    deviation = max(fit.deviation for fit in fits)
    return (Fit(", ".join(whats), deviation, all(fit.proven for fit in fits)),)


def _with_steady_speed(curves):
    """The curves over other intervals: at tangent joints each is as fast as the one before."""
    steady = [curve.copy() for curve in curves]
    factors = [1.0]
    for before, after in zip(curves, curves[1:]):
        arriving = before.getD1(before.LastParameter)[1] / factors[-1]
        leaving = after.getD1(after.FirstParameter)[1]
        factors.append(leaving.Length / arriving.Length if _is_tangent(arriving, leaving) else 1.0)
    if len(steady) > 1:
        lay_end_to_end(steady, factors)
    return steady


def _is_tangent(arriving, leaving):
    return min(arriving.Length, leaving.Length) > 0 and arriving.getAngle(leaving) <= _CORNER


def _stretches(curves, breaks):
    stretches = []
    length = 0.0
    for curve in curves:
        knots = curve.getKnots()
        own, breaks = breaks[: len(knots)], breaks[len(knots) - 1 :]
        for first, last in _smooth_ranges(curve):
            part = curve.copy()
            part.segment(knots[first], knots[last])
            stretches.append(Stretch(part, own[first : last + 1], length))
            length += part.length()
    return tuple(stretches)


def _smooth_ranges(curve):
    """Pairs of indices of knots between which the curve is C2 by its multiplicities."""
    rough = [i for i, m in enumerate(curve.getMultiplicities()) if m > curve.Degree - 2]
    return list(zip(rough, rough[1:]))


def _touching(chain):
    """A sentence for each point through which the chain runs more than once."""
    points = [start(curve) for curve in chain.curves]
    if not chain.closed:
        points.append(end(chain.curves[-1]))
    again = sorted({i for i, _ in _coincident(np.array([tuple(point) for point in points]))})
    return tuple(f"The spine touches itself at {place(points[i])}." for i in again)


def _coincident(points):
    """Pairs (i, j), i < j, of the same point, found among neighbours along a skew line."""
    along = points @ _SKEW
    order = np.argsort(along)
    for position, i in enumerate(order):
        for j in order[position + 1 :]:
            if along[j] - along[i] > CONFUSION:
                break
            if np.linalg.norm(points[j] - points[i]) <= CONFUSION:
                yield min(i, j), max(i, j)
