# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids and lines in the parameters of a face that end where the face ends.

A face that is cut along curves (u, v)(t) is run through by its lines u = const: the curves cut each
of them into intervals, of which every second one lies inside. Where neighbouring lines have equally
many intervals, these bound patches with straight rows.
"""

from typing import NamedTuple

import numpy as np

from pnsurfaces.spline_grid import spread, spline_surface

# Points of a boundary curve; between them it is taken for straight, which is seen by nobody.
_POINTS_OF_EDGE = 129

# A boundary curve runs along a side that it follows to this part of the range of parameters.
_PARAMETRIC_CONFUSION = 1e-9

# Lines where a cut face begins, ends or turns lie this part of its width beside it, where they
# cross its boundary or do not.
_INSET = 1e-6

# Lines beside those, as parts of a step.
_CLOSER = np.array([1, 4, 9]) / 16


class FaceGrid(NamedTuple):
    """A face of FreeCAD on a B-spline surface, prepared for grids.

    `sides` are its parameter range, ((u_first, u_last), (v_first, v_last)); `boundary` are the
    segments (s, 2, 2) of its boundary, edge by edge, None where that is the sides themselves.
    `side` is 1 where the face points along S_u x S_v, -1 where against it.
    """

    surface: tuple
    sides: tuple
    boundary: np.ndarray
    side: int


class Patch(NamedTuple):
    """Parameters of a grid: u (m,), and v (k,) for all of them or (m, k)."""

    u: np.ndarray
    v: np.ndarray


def face_grid(face):
    """The FaceGrid of a face; None when it lies on no B-spline surface."""
    surface = spline_surface(face.Surface)
    if surface is None:
        return None
    u_first, u_last, v_first, v_last = face.ParameterRange
    sides = (u_first, u_last), (v_first, v_last)
    lines = [line for edge in face.Edges for line in _boundary_lines(face, edge, sides)]
    is_whole = all(_runs_along_side(line, sides) for line in lines)
    segments = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    side = -1 if face.Orientation == "Reversed" else 1
    return FaceGrid(surface, sides, None if is_whole else np.concatenate(segments), side)


def patches(grid, rows, columns):
    """Patches that fill the face, with about rows x columns parameters together."""
    u = _spread_between(grid.surface.u_knots, grid.sides[0], rows)
    if grid.boundary is None:
        return [Patch(u, _spread_between(grid.surface.v_knots, grid.sides[1], columns))]
    return [
        Patch(values, ends[:, :1] + (ends[:, 1:] - ends[:, :1]) * np.linspace(0, 1, columns))
        for values, ends in _strips(_with_turns(u, grid.boundary), grid.boundary)
    ]


def lines(grid, axis, count, points):
    """Lines u = const (axis 0) or v = const (axis 1) of the face, at least `count` of the surface.

    Each is an array (points, 2) of parameters; every knot has its line.
    """
    knots = (grid.surface.u_knots, grid.surface.v_knots)[axis]
    values = _spread_between(knots, grid.sides[axis], count)
    if grid.boundary is None:
        ends = [(value, [grid.sides[1 - axis]]) for value in values]
    else:
        boundary = grid.boundary if axis == 0 else grid.boundary[..., ::-1]
        ends = [(value, _intervals(boundary, value)) for value in _inset(values)]
    along = [
        np.column_stack([np.full(points, value), np.linspace(first, last, points)])
        for value, intervals in ends
        for first, last in intervals
    ]
    return along if axis == 0 else [line[:, ::-1] for line in along]


def _boundary_lines(face, edge, sides):
    """The curves (n, 2) of an edge in the parameters of its face: two where it is a seam."""
    curve, first, last = face.curveOnSurface(edge)
    points = [curve.value(t) for t in np.linspace(first, last, _POINTS_OF_EDGE)]
    line = np.array([(point.x, point.y) for point in points])
    if not edge.isSeam(face):
        return [line]
    axis = int(np.argmin(np.ptp(line, axis=0)))
    copies = [line.copy(), line.copy()]
    for copy, value in zip(copies, sides[axis]):
        copy[:, axis] = value
    return copies


def _runs_along_side(line, sides):
    return any(
        np.abs(line[:, axis] - value).max() <= _PARAMETRIC_CONFUSION * (ends[1] - ends[0])
        for axis, ends in enumerate(sides)
        for value in ends
    )


def _spread_between(knots, ends, count):
    first, last = ends
    inner = knots[(knots > first) & (knots < last)]
    return spread(np.concatenate([[first], inner, [last]]), count)


def _inset(values):
    inset = _INSET * (values[-1] - values[0])
    return np.concatenate([[values[0] + inset], values[1:-1], [values[-1] - inset]])


def _with_turns(u, boundary):
    """The parameters, and some about each at which the boundary turns back: there strips may end.

    They are closer and closer there, since the boundary runs like a square root.
    """
    steps = np.sign(boundary[:, 1, 0] - boundary[:, 0, 0])
    goes_on = (boundary[:-1, 1] == boundary[1:, 0]).all(axis=1) & (steps[:-1] == steps[1:])
    turns = np.concatenate(
        [
            boundary[:1, 0, 0],
            boundary[-1:, 1, 0],
            boundary[:-1, 1, 0][~goes_on],
            boundary[1:, 0, 0][~goes_on],
        ]
    )
    step = (u[-1] - u[0]) / (len(u) - 1)
    beside = np.append(step * _CLOSER, _INSET * (u[-1] - u[0]))
    near = np.add.outer(turns, np.concatenate([-beside, beside]))
    return np.unique(np.concatenate([u, near.ravel()]))


def _strips(u, boundary):
    """Runs of lines u = const between the same pieces of boundary: pairs (u (m,), ends (m, 2))."""
    intervals = [_intervals(boundary, value) for value in u]
    counts = [len(ends) for ends in intervals]
    jumps = [i for i in range(1, len(u)) if counts[i] != counts[i - 1]]
    for first, last in zip([0, *jumps], [*jumps, len(u)]):
        if last - first > 1:
            for k in range(counts[first]):
                yield u[first:last], np.array([ends[k] for ends in intervals[first:last]])


def _intervals(boundary, value):
    """The intervals in which a line of the first parameter runs inside, as pairs of the second."""
    (u0, v0), (u1, v1) = boundary.transpose(1, 2, 0)
    crosses = (u0 > value) != (u1 > value)
    parts = (value - u0[crosses]) / (u1 - u0)[crosses]
    ends = np.sort(v0[crosses] + parts * (v1 - v0)[crosses])
    return list(zip(ends[::2], ends[1::2]))
