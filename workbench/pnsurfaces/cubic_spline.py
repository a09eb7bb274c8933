# SPDX-License-Identifier: LGPL-2.1-or-later
"""C2 cubic splines through values, as B-splines.

The inner knots are the parameters of the values, and simple, so that a spline is C2 whatever the
rounding of its coefficients.
"""

import numpy as np


def cubic_spline(parameters, values, ends):
    """B-spline coefficients (n + 2,) of the C2 cubic spline through n values.

    Its knots are the n strictly increasing parameters. `ends` is one of `natural_ends`,
    `periodic_ends`, and what `clamped_ends` returns.
    """
    steps = np.diff(parameters)
    slopes, bends = _derivatives(steps, np.diff(values) / steps, ends)
    before = np.insert(steps, 0, 0.0)
    after = np.append(steps, 0.0)
    # A coefficient is the blossom at three successive knots, here about the middle one.
    blossoms = values + slopes * (after - before) / 3 - bends * before * after / 6
    return np.concatenate([values[:1], blossoms, values[-1:]])


def spline_slopes(parameters, values, ends):
    """The first derivatives (n,) of the same spline at its knots."""
    steps = np.diff(parameters)
    return _derivatives(steps, np.diff(values) / steps, ends)[0]


def values_at_ends(parameters, values, first, last):
    """The values (2,) at the ends of the natural spline over [first, last] through values (n,).

    Its knots are first, the inner parameters, and last.
    """
    knots = np.concatenate([[first], parameters[1:-1], [last]])

    def outermost(at_ends):
        through = np.concatenate([at_ends[:1], values[1:-1], at_ends[1:]])
        steps = np.diff(knots)
        _, bends = _derivatives(steps, np.diff(through) / steps, natural_ends)
        return np.array(
            [
                _value_beside(through[0], through[1], steps[0], bends[1], parameters[0] - first),
                _value_beside(through[-1], through[-2], steps[-1], bends[-2], last - parameters[-1]),
            ]
        )

    # The spline depends linearly on its values.
    none = outermost(np.zeros(2))
    effects = np.column_stack([outermost(unit) - none for unit in np.eye(2)])
    return np.linalg.solve(effects, values[[0, -1]] - none)


def natural_ends(system, jumps, steps, chords):
    """The second derivative is zero at both ends."""
    system[0, 0] = system[-1, -1] = 1


def periodic_ends(system, jumps, steps, chords):
    """The first two derivatives agree at both ends: the last knot is the first one again."""
    system[0, [0, -1]] = 1, -1
    system[-1, [-2, -1]] += steps[-1], 2 * steps[-1]
    system[-1, [0, 1]] += 2 * steps[0], steps[0]
    jumps[-1] = 6 * (chords[0] - chords[-1])


def clamped_ends(first_slope, last_slope):
    """The first derivatives at both ends are given."""

    def ends(system, jumps, steps, chords):
        system[0, :2] = 2 * steps[0], steps[0]
        system[-1, -2:] = steps[-1], 2 * steps[-1]
        jumps[0] = 6 * (chords[0] - first_slope)
        jumps[-1] = 6 * (last_slope - chords[-1])

    return ends


def _value_beside(end_value, next_value, step, bend, distance):
    """The value at a distance from a natural end; `bend` is the second derivative one step away."""
    share = distance / step
    chord = end_value * (1 - share) + next_value * share
    return chord - step**2 / 6 * bend * (share - share**3)


def _derivatives(steps, chords, ends):
    """The first and second derivatives at the knots, by the equations that make the spline C2."""
    count = len(steps) + 1
    system = np.zeros((count, count))
    jumps = np.zeros(count)
    for i in range(1, count - 1):
        system[i, i - 1 : i + 2] = steps[i - 1], 2 * (steps[i - 1] + steps[i]), steps[i]
        jumps[i] = 6 * (chords[i] - chords[i - 1])
    ends(system, jumps, steps, chords)
    bends = np.linalg.solve(system, jumps)
    slopes = np.append(
        chords - steps * (2 * bends[:-1] + bends[1:]) / 6,
        chords[-1] + steps[-1] * (bends[-2] + 2 * bends[-1]) / 6,
    )
    return slopes, bends
