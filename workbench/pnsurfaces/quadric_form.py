# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quadric nearest to points, in standard position.

The points are fitted by x^T A x + 2 b^T x + c = 0 with the least sum of squares. Which eigenvalues
of A are zero and which half-axes equal is never asked of a number alone: each form that the
equation may stand for is compared with the points, and the simplest one that is as near as any is
taken.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

# What the rounding of poles, weights and eigenvalues leaves, as part of the size of the points:
# some thousand units in the last place.
ROUNDING = 1e-12

# The columns of the ten monomials x_i x_j of (x, y, z, 1).
PAIRS = list(itertools.combinations_with_replacement(range(4), 2))

# Kinds whose third half-axis is of another nature than the first two, which are equal on a surface
# of revolution, and among them those that are the same upside down.
_AROUND_AXIS = (
    "one_sheet_hyperboloid",
    "two_sheet_hyperboloid",
    "elliptic_cone",
    "elliptic_cylinder",
    "elliptic_paraboloid",
)
_SAME_UPSIDE_DOWN = ("ellipsoid", "one_sheet_hyperboloid", "elliptic_cylinder")


class QuadricForm(NamedTuple):
    """A quadric in the terms of pnkernel.quadric, `axes` its a, b, c in millimetres.

    The columns of `frame` (3, 3), right-handed, are the axes of the standard position, `origin`
    (3,) is its origin.
    """

    kind: str
    axes: tuple
    frame: np.ndarray
    origin: np.ndarray

    def local(self, points):
        """Points (n, 3) in standard position."""
        return (np.asarray(points) - self.origin) @ self.frame

    def distances(self, points):
        """The distance of each point from the quadric, to first order."""
        local = self.local(points)
        squares, line, constant = standard_equation(self.kind, self.axes)
        values = np.abs(local**2 @ squares + local @ line + constant)
        slopes = np.linalg.norm(2 * local * squares + line, axis=1)
        # At the apex of a cone the slope vanishes and the value grows with the squared distance.
        at_apex = np.sqrt(values / np.abs(squares).max())
        return np.minimum(values / np.maximum(slopes, np.finfo(float).tiny), at_apex)


def nearest_form(points, top):
    """The form nearest to points (n, 3); None if that is no quadric with known offsets.

    A sheet or half has its z-axis towards the points. A hyperbolic paraboloid, of which up and down
    are alike, has it on the side of the direction `top` (3,).
    """
    size = np.ptp(points, axis=0).max()
    centre = points.mean(axis=0)
    unit = (points - centre) / size
    forms = [
        form._replace(
            axes=tuple(size * axis for axis in form.axes), origin=centre + size * form.origin
        )
        for form in _forms(*_least_squares(unit), unit)
    ]
    if not forms:
        return None
    form = _simplest(forms, points, size)
    form = _simplest([*_symmetric(form), form], points, size)
    return _aligned(_measured(_upright(form, points, top), points))


def frame_along(axis):
    """A right-handed frame with this z-axis, whose x-axis is as near as can be to a global one."""
    z = np.array(axis) / np.linalg.norm(axis)
    # A global axis that is far from parallel to z.
    x = np.eye(3)[0 if abs(z[0]) < 0.9 else 1]
    x = x - (x @ z) * z
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def standard_equation(kind, axes):
    """The standard equation squares.x^2 + line.x + constant = 0: (3,), (3,) and a number."""
    a, b, c = axes
    up = np.array([0, 0, -1 / c])
    flat = np.zeros(3)
    return {
        "ellipsoid": (np.array([1 / a**2, 1 / b**2, 1 / c**2]), flat, -1),
        "one_sheet_hyperboloid": (np.array([1 / a**2, 1 / b**2, -1 / c**2]), flat, -1),
        "two_sheet_hyperboloid": (np.array([1 / a**2, 1 / b**2, -1 / c**2]), flat, 1),
        "elliptic_cone": (np.array([1 / a**2, 1 / b**2, -1 / c**2]), flat, 0),
        "elliptic_cylinder": (np.array([1 / a**2, 1 / b**2, 0]), flat, -1),
        "elliptic_paraboloid": (np.array([1 / a**2, 1 / b**2, 0]), up, 0),
        "hyperbolic_paraboloid": (np.array([1 / a**2, -1 / b**2, 0]), up, 0),
        "parabolic_cylinder": (np.array([1 / a**2, 0, 0]), up, 0),
    }[kind]


def _simplest(forms, points, size):
    """The first form that is as near to the points as the nearest, but for rounding."""
    distances = [form.distances(points).max() for form in forms]
    limit = max(ROUNDING * size, 2 * min(distances))
    return next((form for form, d in zip(forms, distances) if d <= limit), forms[-1])


def _least_squares(points):
    """A (3, 3), b (3,) and c of the unit vector of coefficients with the least sum of squares."""
    columns = np.column_stack([points, np.ones(len(points))])
    monomials = np.column_stack([columns[:, i] * columns[:, j] for i, j in PAIRS])
    coefficients = np.linalg.svd(monomials, full_matrices=False)[2][-1]
    matrix = np.zeros((4, 4))
    for (i, j), coefficient in zip(PAIRS, coefficients):
        matrix[i, j] += coefficient / 2
        matrix[j, i] += coefficient / 2
    return matrix[:3, :3], matrix[:3, 3], matrix[3, 3]


def _forms(matrix, line, constant, points):
    """All forms that the equation may stand for, the simplest first."""
    values, vectors = np.linalg.eigh(matrix)
    order = np.argsort(-np.abs(values))
    values, vectors = values[order], vectors[:, order]
    with np.errstate(all="ignore"):
        forms = [
            *_with_one_square(values[0], vectors, line, constant),
            *_with_two_squares(values[:2], vectors, line, constant, points),
            *_with_three_squares(values, vectors, line, constant, points),
        ]
    return [form for form in forms if np.isfinite([*form.axes, *form.origin]).all()]


def _with_one_square(value, vectors, line, constant):
    """l x^2 + 2 b.x + c = 0: a parabolic cylinder."""
    x = vectors[:, 0]
    across = 2 * (line - (line @ x) * x) * np.sign(value)
    slope = np.linalg.norm(across)
    if slope == 0:
        return
    z = -across / slope
    foot = -(line @ x) / value
    height = (constant - (line @ x) ** 2 / value) * np.sign(value) / slope
    # z = x^2 l / slope is c (x / a)^2 with c = 1.
    a = math.sqrt(slope / abs(value))
    frame = np.column_stack([x, np.cross(z, x), z])
    yield QuadricForm("parabolic_cylinder", (a, 1, 1), frame, foot * x + height * z)


def _with_two_squares(values, vectors, line, constant, points):
    """l x^2 + m y^2 + 2 b.x + c = 0: cylinders and paraboloids."""
    x, y = vectors[:, 0], vectors[:, 1]
    z = np.cross(x, y)
    feet = np.array([-(line @ x), -(line @ y)]) / values
    axis_point = feet[0] * x + feet[1] * y
    rest = constant - values @ feet**2
    squares = -rest / values
    if (squares > 0).all():
        # The middle of the face is the origin on the axis.
        origin = axis_point + (z @ points.mean(axis=0)) * z
        axes = (*np.sqrt(squares), 1)
        yield QuadricForm("elliptic_cylinder", axes, np.column_stack([x, y, z]), origin)
    bends = -values / (2 * line @ z)
    vertex = axis_point - rest / (2 * line @ z) * z
    if bends[0] * bends[1] > 0:
        up = np.sign(bends[0])
        axes = (*1 / np.sqrt(np.abs(bends)), 1)
        frame = np.column_stack([x, up * y, up * z])
        yield QuadricForm("elliptic_paraboloid", axes, frame, vertex)
    elif bends[0] * bends[1] < 0:
        first, second = (x, y) if bends[0] > 0 else (y, x)
        a, b = sorted(bends, reverse=True)
        axes = 1 / math.sqrt(a), 1 / math.sqrt(-b), 1
        # The x-axis is the one along which the surface bends up, for this z.
        frame = np.column_stack([first, np.cross(z, first), z])
        yield QuadricForm("hyperbolic_paraboloid", axes, frame, vertex)


def _with_three_squares(values, vectors, line, constant, points):
    """l x^2 + m y^2 + n z^2 + 2 b.x + c = 0: quadrics with a centre."""
    feet = -(vectors.T @ line) / values
    centre = vectors @ feet
    squares = -(constant - values @ feet**2) / values
    if (values > 0).all() or (values < 0).all():
        if (squares > 0).all():
            yield QuadricForm("ellipsoid", tuple(np.sqrt(squares)), _right_handed(vectors), centre)
        return
    # z is the axis whose sign is alone.
    signs = np.sign(values)
    alone = int(np.argmin(signs * signs.sum()))
    order = [i for i in range(3) if i != alone] + [alone]
    squares, frame = squares[order], _right_handed(vectors[:, order])
    cone = np.sqrt(1 / np.abs(values[order]))
    height = np.abs((points - centre) @ frame[:, 2]).max()
    yield QuadricForm("elliptic_cone", tuple(cone * height / cone[2]), frame, centre)
    kind = "one_sheet_hyperboloid" if squares[0] > 0 else "two_sheet_hyperboloid"
    yield QuadricForm(kind, tuple(np.sqrt(np.abs(squares))), frame, centre)


def _right_handed(frame):
    return frame * np.array([1, 1, np.sign(np.linalg.det(frame))])


def _symmetric(form):
    """The same form with equal axes, the most symmetric first, the odd one last."""
    a, b, c = form.axes
    if form.kind == "ellipsoid":
        yield form._replace(axes=((a + b + c) / 3,) * 3, frame=np.eye(3))
        for i in range(3):
            turned = form._replace(
                axes=tuple(np.roll(form.axes, 2 - i)), frame=np.roll(form.frame, 2 - i, axis=1)
            )
            yield _of_revolution(turned)
    elif form.kind in _AROUND_AXIS:
        yield _of_revolution(form)


def _of_revolution(form):
    a, b, c = form.axes
    return form._replace(axes=((a + b) / 2,) * 2 + (c,), frame=frame_along(form.frame[:, 2]))


def _upright(form, points, top):
    """The form with its z-axis where its kind, or else `top`, wants it."""
    if form.kind in ("two_sheet_hyperboloid", "elliptic_cone"):
        down = form.local(points)[:, 2].mean() < 0
        return form._replace(frame=form.frame * np.array([1, -1, -1])) if down else form
    x, y, z = form.frame.T
    if form.kind == "hyperbolic_paraboloid" and z @ top < 0:
        a, b, c = form.axes
        return form._replace(axes=(b, a, c), frame=np.column_stack([y, x, -z]))
    return form


def _measured(form, points):
    """The form with the height of the points as its c where z = c (...) leaves that free."""
    if form.kind not in ("elliptic_paraboloid", "hyperbolic_paraboloid", "parabolic_cylinder"):
        return form
    a, b, c = form.axes
    height = np.abs(form.local(points)[:, 2]).max()
    return form._replace(axes=(a * math.sqrt(height / c), b * math.sqrt(height / c), height))


def _aligned(form):
    """The form with its axes named and directed so that they are nearest to the global ones."""
    a, b, _ = form.axes
    if form.kind == "ellipsoid" and len(set(form.axes)) == 3:
        orders = list(itertools.permutations(range(3)))
    elif form.kind in _AROUND_AXIS and a != b:
        orders = [(0, 1, 2), (1, 0, 2)]
    else:
        orders = [(0, 1, 2)]
    frames = [
        (form.frame[:, order] * np.array(signs), order)
        for order in orders
        for signs in itertools.product((1, -1), repeat=3)
        if signs[2] == 1 or form.kind in _SAME_UPSIDE_DOWN
    ]
    right_handed = [(frame, order) for frame, order in frames if np.linalg.det(frame) > 0]
    frame, order = max(right_handed, key=lambda pair: np.trace(pair[0]))
    return form._replace(frame=frame, axes=tuple(form.axes[i] for i in order))
