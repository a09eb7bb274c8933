# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving conics by their definition, at 60 digits: points of planes and of quadratic equations.

Nothing here is taken from the kernel. A span is (frame, conic, cut), Bernstein coefficients as the
kernel takes them: (k + 1, 4, 3), (h + 1, 3, 3) and (l + 1, 3) or None.
"""

import mpmath
import numpy as np
from mpmath import mpf
from splines import exactly, norm


def at(coefficients, t):
    """The value at t of polynomials by their Bernstein coefficients (k + 1, ...)."""
    rows = list(exactly(coefficients))
    while len(rows) > 1:
        rows = [(1 - t) * a + t * b for a, b in zip(rows, rows[1:])]
    return rows[0]


def upright_frame(length):
    """Planes z = length t with the coordinates (1, x, y)."""
    frame = np.zeros((2, 4, 3))
    frame[:, 0, 1] = frame[:, 1, 2] = frame[:, 3, 0] = 1
    frame[1, 2, 0] = length
    return frame


def random_ellipses(random, degree):
    """Symmetric matrices whose Bernstein coefficients are circles, moved and turned a little."""
    conic = np.zeros((degree + 1, 3, 3))
    for matrix in conic:
        turned = np.eye(3) + 0.125 * random.integers(-1, 2, (3, 3))
        matrix[:] = turned.T @ np.diag([-4.0, 1.0, 1.0]) @ turned
    return conic


def random_arcs(random, degree, kinds):
    """Conics x^2 + k y^2 = y, moved and turned a little, and the cut y < 1, moved with them.

    k runs through `kinds`: positive for ellipses, zero for parabolas, negative for hyperbolas.
    """
    conic, cut = np.zeros((degree + 1, 3, 3)), np.zeros((degree + 1, 3))
    for i, k in enumerate(np.linspace(*kinds, degree + 1)):
        moved = np.eye(3)
        moved[1:] += random.integers(-1, 2, (2, 3)) / 16
        moved_conic = moved.T @ np.array([[0, 0, -0.5], [0, 1, 0], [-0.5, 0, k]]) @ moved
        conic[i] = (moved_conic + moved_conic.T) / 2  # symmetric to the last digit
        cut[i] = np.array([1.0, 0, -1]) @ moved
    return conic, cut


def _plane_side(frame, t, x):
    """Zero when the point x is in the plane at t."""
    matrix = mpmath.matrix(4, 4)
    for i, row in enumerate(np.column_stack([at(frame, t), [*x, mpf(1)]])):
        for j, entry in enumerate(row):
            matrix[i, j] = entry
    return mpmath.det(matrix)


def parameter_of(frame, x, near):
    """The t of the plane through x that is next to `near`; planes in [0, 1] and a little beyond."""
    return mpmath.findroot(lambda t: _plane_side(frame, t, x), (mpf(near), mpf(near) + mpf("1e-3")))


def coordinates(frame, t, x):
    """y with frame(t) y = (x, 1), for a point of the plane."""
    matrix, right = at(frame, t), [*x, mpf(1)]
    normal, product = matrix.T @ matrix, matrix.T @ np.array(right)
    return np.array(
        mpmath.lu_solve(mpmath.matrix(normal.tolist()), mpmath.matrix(product.tolist())).T.tolist()[0]
    )


def residual(span, t, x):
    """How far y^T C y is from zero, in parts of its size."""
    y, conic = coordinates(span[0], t, x), at(span[1], t)
    return abs(y @ conic @ y) / (y @ y * abs(conic).max())


def beyond_cut(span, t, x):
    """cut . y for the point y of weight 1, in parts of the lengths of both."""
    y, cut = coordinates(span[0], t, x), at(span[2], t)
    return cut @ y / (norm(cut) * norm(y))
