# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature of faces on a grid, combs of their parameter lines, and their smallest radius.

With the fundamental forms E, F, G of a Jet and L, M, N along its unit normal n, the principal
curvatures are the eigenvalues of the second with respect to the first (M. P. do Carmo, Differential
Geometry of Curves and Surfaces, section 3.3).
"""

from typing import NamedTuple

import numpy as np

from pnsurfaces.face_grid import FaceGrid, Patch, patches
from pnsurfaces.spline_grid import jet_at

# The smallest radius is sought in ever smaller windows around the best point so far: points in a
# row of a window, how much smaller the next one is (more than the step of this one), and their
# number, which is when the curvature at a smooth maximum does not change any more.
_WINDOW = 9
_SHRINK = 0.4
_ROUNDS = 16

# Next to a pole of the parametrization, where the squared area of a frame is less than this part of
# the usual one, curvature keeps less than six digits.
_ILL_CONDITIONED = 1e-10

# Instead it is looked at this part of the range beside the pole: far enough where the area vanishes
# with the square of the distance.
_NUDGE = 4e-3


class CurvedPatch(NamedTuple):
    """A grid of points (m, k, 3) with unit normals and principal curvatures (m, k) in 1/mm.

    Normals are on the side to which the face points; a curvature is positive where the surface
    bends towards its normal. `grid` and `patch` are the face and the parameters.
    """

    grid: FaceGrid
    patch: Patch
    points: np.ndarray
    normals: np.ndarray
    least: np.ndarray
    greatest: np.ndarray

    def strongest(self):
        """The absolute curvature (m, k) that is larger: one over the smallest radius."""
        return np.maximum(np.abs(self.least), np.abs(self.greatest))

    def gauss(self):
        """The Gauss curvature (m, k), in 1/mm^2."""
        return self.least * self.greatest


class SmallestRadius(NamedTuple):
    """The smallest radius of curvature that was found, in mm, and its point (3,)."""

    radius: float
    point: np.ndarray


def curved_patches(grid, rows, columns):
    """The CurvedPatches of a face_grid.FaceGrid, with about rows x columns points together."""
    return [_curved(grid, patch) for patch in patches(grid, rows, columns)]


def smallest_radius(curved):
    """The SmallestRadius of CurvedPatches, between their points too; inf when all are flat."""
    curvature, point = _strongest_near(max(curved, key=lambda part: part.strongest().max()))
    return SmallestRadius(1 / curvature if curvature > 0 else np.inf, point)


def combs(grid, lines):
    """Along lines (k, 2) of parameters: points, normals (k, 3) and normal curvatures (k,)."""
    return [_comb(grid, line) for line in lines]


def _strongest_near(curved):
    """The strongest curvature near that of a grid, and its point, by windows in its indices."""
    patch = curved.patch
    v = np.broadcast_to(patch.v, (len(patch.u), np.shape(patch.v)[-1]))
    strongest = curved.strongest()
    best = np.unravel_index(np.argmax(strongest), strongest.shape)
    result = strongest[best], curved.points[best]
    centre, reach = np.array(best, dtype=float), 1.0
    for _ in range(_ROUNDS):
        i, j = (
            np.linspace(max(c - reach, 0), min(c + reach, size - 1), _WINDOW)
            for c, size in zip(centre, v.shape)
        )
        window = _curved(
            curved.grid, Patch(np.interp(i, np.arange(len(v)), patch.u), _bilinear(v, i, j))
        )
        strongest = window.strongest()
        best = np.unravel_index(np.argmax(strongest), strongest.shape)
        result = max(result, (strongest[best], window.points[best]), key=lambda pair: pair[0])
        centre, reach = np.array([i[best[0]], j[best[1]]]), reach * _SHRINK
    return result


def _bilinear(values, i, j):
    """Values (m, k) between those of a grid, at fractional indices i (m,) and j (k,)."""
    row, column = (
        np.minimum(index.astype(int), size - 2) for index, size in zip((i, j), values.shape)
    )
    below, beside = (i - row)[:, None], j - column
    first, last = values[row], values[row + 1]
    mixed = (1 - below) * first + below * last
    return (1 - beside) * mixed[:, column] + beside * mixed[:, column + 1]


def _curved(grid, patch):
    points, normals, least, greatest = _forms(grid, patch)
    if np.isnan(least).any():
        # At a pole there is no frame, but there is one beside it.
        beside = _forms(grid, Patch(_nudged(patch.u), _nudged(patch.v)))
        normals, least, greatest = (
            np.where(np.isnan(here), near, here)
            for here, near in zip((normals, least, greatest), beside[1:])
        )
    # Where a surface is singular beside its poles, too, nothing is said.
    shown = (np.nan_to_num(values) for values in (normals, least, greatest))
    return CurvedPatch(grid, patch, points, *shown)


def _forms(grid, patch):
    """Points, normals and principal curvatures of a patch, nan where it has no normal."""
    jet = jet_at(grid.surface, *patch)
    normals = grid.side * jet.normals()
    e, f, g = (_dot(*pair) for pair in ((jet.u, jet.u), (jet.u, jet.v), (jet.v, jet.v)))
    l, m, n = (_dot(second, normals) for second in (jet.uu, jet.uv, jet.vv))
    area = e * g - f * f
    area = np.where(area > _ILL_CONDITIONED * _usual_area(grid.surface) ** 2, area, np.nan)
    mean = (e * n - 2 * f * m + g * l) / (2 * area)
    gauss = (l * n - m * m) / area
    spread = np.sqrt(np.maximum(mean**2 - gauss, 0))
    return jet.point, normals, mean - spread, mean + spread


def _usual_area(surface):
    """The area of a frame of a surface of this size whose speed is even."""
    points = surface.poles[..., :3] / surface.poles[..., 3:]
    size = np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0))
    return size**2 / (np.ptp(surface.u_knots) * np.ptp(surface.v_knots))


def _comb(grid, line):
    points, normals, curvature = _bend(grid, line)
    _, *beside = _bend(grid, _nudged(line))
    return points, *(
        np.nan_to_num(np.where(np.isnan(here), near, here))
        for here, near in zip((normals, curvature), beside)
    )


def _bend(grid, line):
    """Points, normals and normal curvatures along a line of parameters, nan where there is none."""
    jet = jet_at(grid.surface, line[:, 0], line[:, 1:])
    point, u, v, uu, uv, vv = (part[:, 0] for part in jet)
    normals = grid.side * jet.normals()[:, 0]
    step = line[-1] - line[0]
    speed = step[0] * u + step[1] * v
    bend = step[0] ** 2 * uu + 2 * step[0] * step[1] * uv + step[1] ** 2 * vv
    square = _dot(speed, speed)
    curvature = _dot(bend, normals) / np.where(square > 0, square, np.nan)
    return point, normals, curvature


def _nudged(parameters):
    """Parameters drawn a little towards their middle, away from the ends."""
    middle = (parameters[0] + parameters[-1]) / 2
    nudged = parameters + _NUDGE * (middle - parameters)
    if parameters.ndim == 1:
        return nudged
    middle = (nudged[..., :1] + nudged[..., -1:]) / 2
    return nudged + _NUDGE * (middle - nudged)


def _dot(a, b):
    return np.sum(a * b, axis=-1)
