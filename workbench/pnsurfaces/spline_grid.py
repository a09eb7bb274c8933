# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and derivatives of a B-spline surface on a grid, with NumPy from its poles alone.

A route of its own: neither the kernel nor OpenCASCADE takes part. In homogeneous coordinates a
surface is  sum_ij B_i(u) C_j(v) (w x, w y, w z, w)_ij;  a grid is two matrix products.
"""

from typing import NamedTuple

import numpy as np

from pnsurfaces.bspline_surface import clamped_bspline


class SplineSurface(NamedTuple):
    """Degrees, knots as often as their multiplicity says, and homogeneous poles (nu, nv, 4)."""

    u_degree: int
    v_degree: int
    u_knots: np.ndarray
    v_knots: np.ndarray
    poles: np.ndarray


class Jet(NamedTuple):
    """Points (m, k, 3) and partial derivatives of the same shape."""

    point: np.ndarray
    u: np.ndarray
    v: np.ndarray
    uu: np.ndarray
    uv: np.ndarray
    vv: np.ndarray

    def normals(self):
        """Unit vectors along S_u x S_v; nan where that vanishes."""
        across = np.cross(self.u, self.v)
        length = np.linalg.norm(across, axis=-1, keepdims=True)
        # A pole of the parametrization: what rounding leaves there has no direction.
        speed = np.linalg.norm(self.u, axis=-1, keepdims=True).max()
        speed *= np.linalg.norm(self.v, axis=-1, keepdims=True).max()
        return across / np.where(length > _VANISHING * speed, length, np.nan)


# Of the largest product of speeds: below the square root of the rounding a cross product has lost
# half of its digits.
_VANISHING = 1e-8


def spline_surface(surface):
    """The SplineSurface of a surface of FreeCAD; None when that is neither B-spline nor Bezier."""
    clamped = clamped_bspline(surface)
    if clamped is None:
        return None
    weights = np.array(clamped.getWeights())[..., None]
    return SplineSurface(
        clamped.UDegree,
        clamped.VDegree,
        np.repeat(clamped.getUKnots(), clamped.getUMultiplicities()),
        np.repeat(clamped.getVKnots(), clamped.getVMultiplicities()),
        np.concatenate([np.array(clamped.getPoles()) * weights, weights], axis=-1),
    )


def points_at(surface, u, v):
    """Points (m, k, 3) at parameters u (m,) and v (k,), or (m, k) where each u has its own."""
    (x,) = _homogeneous(surface, u, v, [(0, 0)])
    return x[..., :3] / x[..., 3:]


def points_and_normals(surface, u, v):
    """Points and unit normals along S_u x S_v, each (m k, 3), in one list; poles left out."""
    jet = jet_at(surface, u, v)
    points, normals = (values.reshape(-1, 3) for values in (jet.point, jet.normals()))
    is_regular = ~np.isnan(normals[:, 0])
    return points[is_regular], normals[is_regular]


def jet_at(surface, u, v):
    """The Jet at parameters u (m,) and v (k,), or (m, k) where each u has its own.

    Of a knot with jumping derivatives those of the span behind it are taken.
    """
    orders = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
    x, a, b, aa, ab, bb = _homogeneous(surface, u, v, orders)
    weight = x[..., 3:]
    point = x[..., :3] / weight
    # The product rule for x w = (x w), once and twice.
    du = (a[..., :3] - a[..., 3:] * point) / weight
    dv = (b[..., :3] - b[..., 3:] * point) / weight
    duu = (aa[..., :3] - 2 * a[..., 3:] * du - aa[..., 3:] * point) / weight
    duv = (ab[..., :3] - a[..., 3:] * dv - b[..., 3:] * du - ab[..., 3:] * point) / weight
    dvv = (bb[..., :3] - 2 * b[..., 3:] * dv - bb[..., 3:] * point) / weight
    return Jet(point, du, dv, duu, duv, dvv)


def spread(knots, count):
    """At least `count` parameters over all spans: every knot, and as many between each two."""
    breaks = np.unique(knots)
    steps = max(1, -(-(count - 1) // (len(breaks) - 1)))
    inner = [np.linspace(a, b, steps, endpoint=False) for a, b in zip(breaks, breaks[1:])]
    return np.concatenate([*inner, breaks[-1:]])


def basis(knots, degree, parameters, derivative=0):
    """Values (..., n) of the n B-spline functions, or of a derivative, at parameters (...)."""
    t = np.asarray(parameters, dtype=float)[..., None]
    if derivative:
        if degree == 0:
            return np.zeros(t.shape[:-1] + (len(knots) - 1,))
        lower = basis(knots, degree - 1, parameters, derivative - 1)
        slopes = degree * _over_support(lower, knots, degree)
        return slopes[..., :-1] - slopes[..., 1:]
    first, last = np.searchsorted(knots, knots[0], "right"), np.searchsorted(knots, knots[-1])
    span = np.clip(np.searchsorted(knots, t, "right"), first, last) - 1
    values = (np.arange(len(knots) - 1) == span).astype(float)
    for order in range(1, degree + 1):
        slopes = _over_support(values, knots, order)
        values = (t - knots[: -order - 1]) * slopes[..., :-1]
        values += (knots[order + 1 :] - t) * slopes[..., 1:]
    return values


def _over_support(values, knots, degree):
    """B-splines of one degree less, each by the length of its support; 0 for an empty one."""
    length = knots[degree:] - knots[:-degree]
    return np.divide(values, length, out=np.zeros_like(values), where=length > 0)


def _homogeneous(surface, u, v, orders):
    """Derivatives (m, k, 4) of the homogeneous coordinates, one for each of the pairs of orders."""
    rows = {
        order: np.tensordot(basis(surface.u_knots, surface.u_degree, u, order), surface.poles, 1)
        for order in {along for along, _ in orders}
    }
    across = {
        order: basis(surface.v_knots, surface.v_degree, np.atleast_2d(v), order)
        for order in {across for _, across in orders}
    }
    return [np.matmul(across[j], rows[i]) for i, j in orders]
