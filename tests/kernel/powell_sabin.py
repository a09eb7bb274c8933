# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C1 quadratic spline on Powell-Sabin splits, by its conditions instead of its formulas.

On each of the six parts of a triangle the spline is a quadratic polynomial in s and t with unknown
coefficients. That it has the given values and gradients at the corners, and is C1 across the inner
edges, is a system of linear equations; nothing here knows of control points.
"""

from fractions import Fraction

import numpy as np
from mpmath import mpf
from splines import exactly

SHORT = 5000  # the weights of inner points have denominators below this
REFINEMENTS = 6  # each gives ten digits or so


def pieces(points, spheres, derivatives, triangles, corners):
    """The parts (6 m, 3, 2) of all triangles and the coefficients (6 m, 6, 4) on them.

    points: (n, 2); spheres: (n, 4); derivatives: (n, 2, 4); corners: those of the parts in doubles.
    """
    parts = split(points, triangles, corners)
    exact = exactly(points)
    coefficients = [
        solved(parts[6 * t : 6 * t + 6], {tuple(exact[n]): n for n in triangle}, spheres, derivatives)
        for t, triangle in enumerate(triangles)
    ]
    return parts, np.concatenate(coefficients)


def control_spheres(corners, coefficients):
    """The control points (6, 4) of a part in the order of sphere_families.Family."""
    value = {
        (i, j): sphere_at(coefficients, *(corners[i] + corners[j]) / 2)[0]
        for i in range(3)
        for j in range(3)
    }
    return np.array(
        [
            value[i, i] if i == j else 2 * value[i, j] - (value[i, i] + value[j, j]) / 2
            for i, j in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))
        ]
    )


def split(points, triangles, corners):
    """The parts (6 m, 3, 2) of all triangles at 60 digits, from their corners in doubles.

    points: (n, 2). An inner point has short weights; the point on an edge is on the line between the
    inner points of both neighbours, or in the middle.
    """
    points = exactly(points)
    inner = [
        _inner_point(points[list(triangle)], parts[0][2])
        for triangle, parts in zip(triangles, np.reshape(corners, (-1, 6, 3, 2)), strict=True)
    ]
    beside = {}
    for t, triangle in enumerate(triangles):
        for edge in _edges(triangle):
            beside.setdefault(frozenset(edge), []).append(t)

    def edge_point(a, b):
        p, q = points[a], points[b]
        if len(beside[frozenset((a, b))]) == 1:
            return (p + q) / 2
        first, second = (inner[t] for t in beside[frozenset((a, b))])
        at_p, at_q = (_cross(second - first, end - first) for end in (p, q))
        return p + at_p / (at_p - at_q) * (q - p)

    parts = []
    for t, triangle in enumerate(triangles):
        places = np.array(
            [*points[list(triangle)], inner[t], *(edge_point(*edge) for edge in _edges(triangle))]
        )
        parts.extend(
            [[_nearest(corner, places) for corner in part] for part in corners[6 * t : 6 * t + 6]]
        )
    return np.array(parts)


def _edges(triangle):
    a, b, c = triangle
    return (a, b), (b, c), (c, a)


def _cross(d, e):
    return d[0] * e[1] - d[1] * e[0]


def _inner_point(ends, near):
    a, b, c = ends
    weights = (_cross(exactly(near) - c, b - c), _cross(a - c, exactly(near) - c))
    parts = [
        Fraction(float(weight / _cross(a - c, b - c))).limit_denominator(SHORT) for weight in weights
    ]
    exact = [mpf(part.numerator) / part.denominator for part in parts]
    return c + exact[0] * (a - c) + exact[1] * (b - c)


def _nearest(corner, places):
    return places[np.argmin(((places - exactly(corner)) ** 2).sum(axis=1))]


def monomials(s, t):
    """Values and both derivatives of 1, s, t, s^2, s t, t^2: three vectors (6,)."""
    return (
        np.array([1, s, t, s * s, s * t, t * t]),
        np.array([0, 1, 0, 2 * s, t, 0]),
        np.array([0, 0, 1, 0, s, 2 * t]),
    )


def solved(corners, numbers, spheres, derivatives):
    """The coefficients (6, 6, 4) of the six parts of one triangle, in 60 digits.

    corners: (6, 3, 2), the corners of the parts; numbers: {corner (s, t): number of the point};
    spheres: (n, 4); derivatives: (n, 2, 4).
    """
    spheres, derivatives = exactly(spheres), exactly(derivatives)
    rows, right = [], []

    def condition(parts_and_signs, place, value):
        for k, row in enumerate(monomials(*place)):
            equation = np.array([mpf(0)] * 36)
            for part, sign in parts_and_signs:
                equation[6 * part : 6 * part + 6] = sign * row
            rows.append(equation)
            right.append(value[k])

    nothing = exactly(np.zeros((3, 4)))
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
    return _solution(np.array(rows), np.array(right)).reshape(6, 6, 4)


def _solution(rows, right):
    """Of more equations than unknowns that agree with each other, by a refined inverse in doubles."""
    rough = rows.astype(float)
    assert np.linalg.matrix_rank(rough) == rows.shape[1]
    inverse = np.linalg.pinv(rough)
    solution, residue = exactly(np.zeros((rows.shape[1], right.shape[1]))), right
    for _ in range(REFINEMENTS):
        size = abs(residue).max()
        solution = solution + size * exactly(inverse @ (residue / size).astype(float))
        residue = right - rows @ solution
    assert abs(residue).max() < mpf(10) ** -50 * abs(right).max()
    return solution


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
