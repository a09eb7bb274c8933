# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radius laws of a canal surface, from the properties of a feature. Radii are millimetres."""

import numpy as np

from pnsurfaces import kernel

CONSTANT = "Constant"
LINEAR = "Linear"
VALUES_AT_VERTICES = "Values at vertices"
BEZIER_COEFFICIENTS = "Bezier coefficients"

# The properties that each law reads.
INPUTS_OF_LAW = {
    CONSTANT: ("Radius",),
    LINEAR: ("Radius", "EndRadius"),
    VALUES_AT_VERTICES: ("Radii",),
    BEZIER_COEFFICIENTS: ("Radii",),
}


class RadiusLawError(ValueError):
    """The properties describe no radius law. The text is a sentence for the user."""


def radius_law(obj, spine):
    """The law (pnkernel.Law) of feature `obj` over the whole of `spine` (spine.Spine).

    Raises RadiusLawError when the number of radii does not fit.
    """
    law = kernel.pnkernel().Law
    if obj.RadiusLaw == CONSTANT:
        return law.constant(obj.Radius.Value)
    if obj.RadiusLaw == LINEAR:
        return _bezier(law, spine, [obj.Radius.Value, obj.EndRadius.Value])
    if obj.RadiusLaw == VALUES_AT_VERTICES:
        return _through_vertices(law, spine, obj.Radii)
    return _bezier(law, spine, obj.Radii)


def cubic_spline(parameters, values, periodic):
    """B-spline coefficients (n + 2,) of the C2 cubic spline through n values.

    Its knots are the n strictly increasing parameters, the inner ones simple, so that it is C2
    whatever the rounding of its coefficients. The second derivative is zero at both ends, or, with
    `periodic`, the first two derivatives agree there.
    """
    steps = np.diff(parameters)
    chords = np.diff(values) / steps
    bends = _second_derivatives(steps, chords, periodic)
    slopes = np.append(
        chords - steps * (2 * bends[:-1] + bends[1:]) / 6,
        chords[-1] + steps[-1] * (bends[-2] + 2 * bends[-1]) / 6,
    )
    before = np.insert(steps, 0, 0.0)
    after = np.append(steps, 0.0)
    # A coefficient is the blossom at three successive knots, here about the middle one.
    blossoms = values + slopes * (after - before) / 3 - bends * before * after / 6
    return np.concatenate([values[:1], blossoms, values[-1:]])


def _second_derivatives(steps, chords, periodic):
    count = len(steps) + 1
    system = np.zeros((count, count))
    jumps = np.zeros(count)
    for i in range(1, count - 1):
        system[i, i - 1 : i + 2] = steps[i - 1], 2 * (steps[i - 1] + steps[i]), steps[i]
        jumps[i] = 6 * (chords[i] - chords[i - 1])
    if periodic:
        # The last vertex is the first one again.
        system[0, [0, -1]] = 1, -1
        system[-1, [-2, -1]] += steps[-1], 2 * steps[-1]
        system[-1, [0, 1]] += 2 * steps[0], steps[0]
        jumps[-1] = 6 * (chords[0] - chords[-1])
    else:
        system[0, 0] = system[-1, -1] = 1
    return np.linalg.solve(system, jumps)


def _bezier(law, spine, coefficients):
    order = len(coefficients)
    if order == 0:
        raise RadiusLawError("The radius law needs at least one radius.")
    if order == 1:
        return law.constant(coefficients[0])
    return law.bspline(order - 1, spine.curve.domain, [order, order], coefficients)


def _through_vertices(law, spine, radii):
    vertices = np.asarray(spine.curve.breaks)
    if len(radii) != len(vertices):
        raise RadiusLawError(
            f"The spine has {len(vertices)} vertices, but {len(radii)} radii are given."
        )
    if spine.closed and radii[0] != radii[-1]:
        raise RadiusLawError("The spine is closed: its first and last radius must be equal.")
    if len(vertices) == 2:
        return _bezier(law, spine, radii)
    coefficients = cubic_spline(vertices, np.asarray(radii), periodic=spine.closed)
    multiplicities = [4] + [1] * (len(vertices) - 2) + [4]
    return law.bspline(3, vertices, multiplicities, coefficients)
