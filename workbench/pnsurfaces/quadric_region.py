# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which region of a quadric a face is, in the terms of pnkernel.quadric."""

import itertools
import math

import numpy as np
from FreeCAD import Vector

from pnsurfaces.edge_chain import CONFUSION

# Points of an edge, and rounds of refining between two of them (16 times each), for the extremes.
_POINTS_OF_EDGE = 33
_ROUNDS = 6

_WHOLE_TURN = 2 * math.pi

# The coordinates by which a region of each kind may be bounded; the first ones are those of a
# region around a face that ends along other lines.
_ALL_AROUND = (("z",),)
_AROUND_AXIS = (("z",), ("z", "angle"))
_ABOVE_PLANE = (("x", "y"),)
_REGIONS = {
    "ellipsoid": _AROUND_AXIS,
    "one_sheet_hyperboloid": _AROUND_AXIS,
    "two_sheet_hyperboloid": _AROUND_AXIS,
    "elliptic_cylinder": _ALL_AROUND,
    "elliptic_cone": _ALL_AROUND,
    "elliptic_paraboloid": _AROUND_AXIS + _ABOVE_PLANE,
    "hyperbolic_paraboloid": _ABOVE_PLANE,
    "parabolic_cylinder": _ABOVE_PLANE,
}


def region_of_face(form, face, tolerance):
    """The bounds of a face on a quadric_form.QuadricForm, and whether its edges run along them.

    Bounds are millimetres in standard position and radians about its z-axis. Edges run along them
    to within `tolerance`, in millimetres; otherwise the bounds enclose the face.
    """
    edges = [edge for edge in face.Edges if not (edge.Degenerated or edge.isSeam(face))]
    if not edges:
        return {}, True
    lines = [form.local([tuple(p) for p in edge.discretize(_POINTS_OF_EDGE)]) for edge in edges]
    regions = _REGIONS[form.kind]
    covering = [
        region
        for region in regions
        if all(any(_RUNS_ALONG[name](line, tolerance) for name in region) for line in lines)
    ]
    region = covering[0] if covering else regions[0]
    ranges = {
        "x": lambda: _range(form, edges, 0),
        "y": lambda: _range(form, edges, 1),
        "z": lambda: _height_range(form, face, edges, tolerance),
        "angle": lambda: _angle_range(
            form, face, [line for line in lines if not _RUNS_ALONG["z"](line, tolerance)]
        ),
    }
    return {name: ranges[name]() for name in region}, bool(covering)


def _lies_in_meridian(line, tolerance):
    """Whether points lie in one plane through the z-axis."""
    x, y = line[np.argmax(np.hypot(line[:, 0], line[:, 1])), :2]
    across = line[:, :2] @ np.array([-y, x]) / math.hypot(x, y)
    return np.abs(across).max() <= tolerance


# Whether points (n, 3) in standard position have one value of a coordinate.
_RUNS_ALONG = {
    "x": lambda line, tolerance: np.ptp(line[:, 0]) <= tolerance,
    "y": lambda line, tolerance: np.ptp(line[:, 1]) <= tolerance,
    "z": lambda line, tolerance: np.ptp(line[:, 2]) <= tolerance,
    "angle": _lies_in_meridian,
}


def _height_range(form, face, edges, tolerance):
    """The least and the largest z of the face: on an edge, or where the quadric is level."""
    low, high = _range(form, edges, 2)
    c = form.axes[2]
    level = {
        "ellipsoid": (-c, c),
        "two_sheet_hyperboloid": (c,),
        "elliptic_paraboloid": (0.0,),
        "elliptic_cone": (0.0,),
    }
    for z in level.get(form.kind, ()):
        point = Vector(*(form.origin + z * form.frame[:, 2]))
        if face.isInside(point, tolerance, True):
            low, high = min(low, z), max(high, z)
    return low, high


def _range(form, edges, axis):
    """The least and the largest coordinate along the edges."""

    def coordinate(point):
        return form.local([point])[0, axis]

    low = -max(_largest(lambda point: -coordinate(point), edge) for edge in edges)
    high = max(_largest(coordinate, edge) for edge in edges)
    return low, high


def _largest(height, edge):
    """The largest height of the points of an edge."""
    first, last = edge.ParameterRange
    for _ in range(_ROUNDS):
        grid = np.linspace(first, last, _POINTS_OF_EDGE)
        heights = [height(tuple(edge.valueAt(t))) for t in grid]
        best = int(np.argmax(heights))
        first, last = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
    return max(heights)


def _angle_range(form, face, meridians):
    """The angles about z between which the face lies."""
    ends = sorted({angle for line in meridians for angle in _angles_of(line)})
    middle = form.local([tuple(_inner_point(face))])[0]
    inside = math.atan2(middle[1], middle[0])
    below = [angle for angle in ends if angle <= inside]
    above = [angle for angle in ends if angle > inside]
    low = below[-1] if below else ends[-1] - _WHOLE_TURN
    high = above[0] if above else ends[0] + _WHOLE_TURN
    return low, high


def _angles_of(line):
    """The one or two angles at which points in a plane through the z-axis lie."""
    radii = np.hypot(line[:, 0], line[:, 1])
    x, y = line[np.argmax(radii), :2]
    yield math.atan2(y, x)
    along = line[:, :2] @ np.array([x, y])
    opposite = line[np.argmin(along)]
    if along.min() < -CONFUSION * radii.max():
        yield math.atan2(opposite[1], opposite[0])


def _inner_point(face):
    """A point well inside the face."""
    u_first, u_last, v_first, v_last = face.ParameterRange
    candidates = [
        (u_first + (u_last - u_first) * i, v_first + (v_last - v_first) * j)
        for i, j in itertools.product((0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8), repeat=2)
    ]
    parameters = next((c for c in candidates if face.isPartOfDomain(*c)), candidates[0])
    return face.valueAt(*parameters)
