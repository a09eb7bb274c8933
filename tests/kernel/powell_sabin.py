# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C1 quadratic spline on Powell-Sabin splits, by its conditions instead of its formulas.

On each of the six parts of a triangle the spline is a quadratic polynomial in s and t with unknown
coefficients. That it has the given values and gradients at the corners, and is C1 across the inner
edges, is a system of linear equations; nothing here knows of control points.
"""

import numpy as np


def monomials(s, t):
    """Values and both derivatives of 1, s, t, s^2, s t, t^2: three vectors (6,)."""
    return (np.array([1, s, t, s * s, s * t, t * t]), np.array([0, 1, 0, 2 * s, t, 0.0]),
            np.array([0, 0, 1, 0, s, 2 * t]))


def solved(corners, numbers, spheres, derivatives):
    """The coefficients (6, 6, 4) of the six parts of one triangle.

    corners: (6, 3, 2), the corners of the parts; numbers: {corner (s, t): number of the point};
    spheres: (n, 4); derivatives: (n, 2, 4).
    """
    rows, right = [], []

    def condition(parts_and_signs, place, value):
        for k, row in enumerate(monomials(*place)):
            equation = np.zeros(36)
            for part, sign in parts_and_signs:
                equation[6 * part:6 * part + 6] = sign * row
            rows.append(equation)
            right.append(value[k])

    nothing = np.zeros((3, 4))
    for i, own in enumerate(corners):
        for place in map(tuple, own):
            if place in numbers:
                n = numbers[place]
                condition([(i, 1)], place, np.vstack([spheres[n][None], derivatives[n]]))
        for j in range(i):
            common = {tuple(p) for p in own} & {tuple(p) for p in corners[j]}
            if len(common) == 2:
                a, b = (np.array(p) for p in common)
                for place in (a, (a + b) / 2, b):
                    condition([(i, 1), (j, -1)], place, nothing)
    rows, right = np.array(rows), np.array(right)
    solution, _, rank, _ = np.linalg.lstsq(rows, right, rcond=None)
    assert rank == 36
    assert np.abs(rows @ solution - right).max() < 1e-9 * np.abs(right).max()
    return solution.reshape(6, 6, 4)


def sphere_at(coefficients, s, t):
    """(x, y, z, r) and both derivatives of a part."""
    return tuple(row @ coefficients for row in monomials(s, t))


def dome(count, moved=0.2, seed=0, side=100.0):
    """points (n, 3), radii (n,), derivatives (n, 2, 4), triangles (m, 3) of a dome of varying wall.

    A graph over a square, divided into count x count squares of two triangles; inner points are moved
    by a part of their distance.
    """
    random = np.random.default_rng(seed)
    steps = np.linspace(0, side, count + 1)
    x, y = (a.ravel() for a in np.meshgrid(steps, steps, indexing="ij"))
    inside = (x > 0) & (x < side) & (y > 0) & (y < side)
    away = moved * side / count * random.uniform(-1, 1, (2, x.size)) * inside
    x, y = x + away[0], y + away[1]
    a, b = (x - side / 2) / side, (y - side / 2) / side
    one, zero = np.ones_like(x), np.zeros_like(x)
    z = 12 * np.cos(a) * np.cos(1.2 * b)
    by_x = [one, zero, -12 * np.sin(a) * np.cos(1.2 * b) / side, (2 * a + 0.3 * b) / side]
    by_y = [zero, one, -14.4 * np.cos(a) * np.sin(1.2 * b) / side, 0.3 * a / side]
    radii = 3 + a * a + 0.3 * a * b
    derivatives = np.stack([np.stack(by_x, axis=1), np.stack(by_y, axis=1)], axis=1)
    triangles = []
    for i in range(count):
        for j in range(count):
            k = i * (count + 1) + j
            right, up = k + count + 1, k + 1
            triangles += [(k, right, right + 1), (k, right + 1, up)]
    return np.stack([x, y, z], axis=1), radii, derivatives, np.array(triangles)
