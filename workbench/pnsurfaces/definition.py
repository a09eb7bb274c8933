# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far points lie from the surface that a feature is defined as, with NumPy, in doubles.

No isotropic vector, no normal of the construction and no control point takes part: a point is
compared with spheres, lines or an equation. Its own rounding is some units in the last place of the
coordinates, so that a bound of 1e-14 mm on a surface of 100 mm is met, but not measured.

- A canal surface at distance d is the envelope of the spheres |x - m(t)| = r(t) + d. A point of it
  lies in the plane of a characteristic circle, (x - m).m' + (r + d) r' = 0.
- A canal surface from r^2, at distance zero, is the same envelope by s = r^2 alone: |x - m|^2 = s in
  the plane (x - m).m' + s' / 2 = 0. At other distances r = sqrt(s), r r' = s' / 2.
- A ruled surface at distance d is the envelope of the cylinders of radius d about its rulings: the
  foot c of a point on its ruling has (x - c).c_t = 0.
- A quadric at distance d has the points x with a foot p on it, q(p) = 0, x - p along grad q(p).
- The skins of a mid-surface, also over a triangulation, at distance d are the envelope of the
  spheres |x - m(u, v)| = r(u, v) + d: a point of it is on one sphere and outside all its
  neighbours, (x - m).m_u + (r + d) r_u = 0 and likewise for v.
- A moving conic section has the points x in the plane of a section, (x - m).m' = 0 or with a fixed
  normal, or m' less its part along up, for m'. Their coordinates p to the side and q upwards have
  (p / a)^2 + (q / b)^2 = 1 or, from the vertex, p^2 = 2 R q - (1 + K) q^2.
- The wavefront of a mirror of path length d is the envelope of the spheres |x - m(u, v)| = d - s(u, v)
  around its points, where s is the path of the light to m: Huygens' principle.

Where a point is off the surface by a small distance e, it is on that at distance d + e, so that the
same equation finds d + e.
"""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.canal_surface import CanalSurface, read_bore, read_spheres
from pnsurfaces.feature import SOLID
from pnsurfaces.mid_surface_skins import MidSurfaceSkins, read_net
from pnsurfaces.mirror_wavefront import MirrorWavefront, light_of, read_mirror
from pnsurfaces.moving_conic_section import MovingConicSection, planes_of, read_section
from pnsurfaces.quadric_form import standard_equation
from pnsurfaces.quadric_offset import KINDS, OF_FACE, QuadricOffset, half_axes, read_face
from pnsurfaces.ruled_offset import RuledOffset, read_curves
from pnsurfaces.section_law import ELLIPSE, FROM_THE_VERTEX
from pnsurfaces.spline_grid import Jet, jet_at, spline_surface, spread
from pnsurfaces.squared_radius_canal import SquaredRadiusCanal, read_squared_spheres
from pnsurfaces.triangulated_skins import TriangulatedSkins, read_family

# Parameters between which a root is looked for, on each span: more than the characteristic
# equation of a span has roots in practice. A missed root shows as a deviation, never hides one.
_PARAMETERS_OF_SPAN = 16

# Points that are compared with all parameters at once, which bounds the memory.
_POINTS_AT_ONCE = 64

# Halvings of such a step, to the last place: at distance 0 the deviation is not stationary.
_HALVINGS = 50

# A point at the very end of a span has its root there, give or take the rounding: looked for a
# little beyond, as part of the span.
_BEYOND_END = 1e-7

# Steps of Newton's method from the base point along the normal that the exported surface has.
_NEWTON_STEPS = 8


# Parameters along each side of a mirror, from the best of which Newton's method starts.
_GRID_OF_MIRROR = 33

# Of so many of them.
_STARTS = 3

# Steps along the edges of a triangle of spheres, from the best of which Newton's method starts.
_GRID_OF_NET = 17

# Triangles of spheres from which a point is measured: that over which its centre lies, and those
# across the nearest edges.
_NEAREST_NETS = 3


def definition_of(obj):
    """The definition of a feature: Spheres, SquaredSpheres, Rulings, Sections, Quadric, SphereNet,
    SphereNets, BallNet or Huygens; None for another object."""
    proxy = type(getattr(obj, "Proxy", None))
    return _DEFINITIONS[proxy](obj) if proxy in _DEFINITIONS else None


def definitions_of(obj, count):
    """The definitions of the `count` surfaces that a feature shows, the innermost first."""
    bore = read_bore(obj) if isinstance(obj.Proxy, CanalSurface) else None
    if bore:
        return [_spheres(*bore), definition_of(obj)]
    return [definition_of(obj)] * count


class Spheres(NamedTuple):
    """A canal surface: the PiecewiseRational functions of its centres (3) and radius (1)."""

    centre: Any
    radius: Any

    words = "envelope of the spheres along the spine: distance from the centre minus the radius"

    def deviations(self, points, normals, distance):
        """By how much each of the points (n, 3) is off the surface at a distance, in mm.

        `normals` (n, 3), unit, tell where to begin to look, and are not believed.
        """
        return _along_family(self, points, distance)

    def breaks(self):
        return np.union1d(self.centre.breaks, self.radius.breaks)

    def at(self, t, inside, points, distance):
        """The value that is zero at a characteristic point, and the deviation there.

        `inside` are parameters inside the spans that are taken.
        """
        centre, speed = self.centre.with_derivative(t, inside)
        radius, growth = (part[..., 0] for part in self.radius.with_derivative(t, inside))
        radius = radius + distance
        rays = points - centre
        slope = _dot(rays, speed) + radius * growth
        return slope, np.copysign(_length(rays), radius) - radius


class SquaredSpheres(NamedTuple):
    """A canal surface: the PiecewiseRational functions of its centres (3) and squared radius (1)."""

    centre: Any
    squared_radius: Any

    words = "envelope of the spheres along the spine: distance from the centre minus the root of r^2"

    def deviations(self, points, normals, distance):
        return _along_family(self, points, distance)

    def breaks(self):
        return np.union1d(self.centre.breaks, self.squared_radius.breaks)

    def at(self, t, inside, points, distance):
        centre, speed = self.centre.with_derivative(t, inside)
        square, growth = (part[..., 0] for part in self.squared_radius.with_derivative(t, inside))
        # Beyond the end of a span the square may be negative; there is no point of the surface.
        root = np.sqrt(np.maximum(square, np.finfo(float).tiny))
        rays = points - centre
        slope = _dot(rays, speed) + (1 + distance / root) * growth / 2
        return slope, np.copysign(_length(rays), root + distance) - (root + distance)


class Rulings(NamedTuple):
    """A ruled surface: the PiecewiseRational functions of its two curves, over one domain."""

    first: Any
    last: Any

    words = "feet on the rulings: distance from the ruled surface along its normal"

    def deviations(self, points, normals, distance):
        return _along_family(self, points, distance)

    def breaks(self):
        return np.union1d(self.first.breaks, self.last.breaks)

    def at(self, t, inside, points, distance):
        first, first_speed = self.first.with_derivative(t, inside)
        last, last_speed = self.last.with_derivative(t, inside)
        ruling = last - first
        part = (_dot(points - first, ruling) / _dot(ruling, ruling))[..., None]
        rays = points - first - part * ruling
        slope = _dot(rays, first_speed + part * (last_speed - first_speed))
        return slope, np.copysign(_length(rays), distance) - distance


class Sections(NamedTuple):
    """Conics along a spine: the PiecewiseRational functions of its points (3) and their laws (1).

    `conic` is Ellipse or VertexConic. `up` (3,) and `normal` (3,), or None where the planes are
    perpendicular to the spine or, as `planes` says, upright.
    """

    spine: Any
    laws: Any
    conic: Any
    up: Any
    normal: Any = None
    planes: str = "perpendicular"

    @property
    def words(self):
        return f"{self.conic.words}: distance in the plane of the section, to first order"

    def deviations(self, points, normals, distance):
        return _along_family(self, points, distance)

    def breaks(self):
        return np.unique(np.concatenate([self.spine.breaks, *(law.breaks for law in self.laws)]))

    def at(self, t, inside, points, distance):
        centre, speed = self.spine.with_derivative(t, inside)
        across = speed if self.normal is None else np.broadcast_to(self.normal, speed.shape)
        rays = points - centre
        side = np.cross(across, self.up)
        if self.planes == "upright":
            across = np.cross(self.up, side)
        conic = self.conic(*(law.with_derivative(t, inside)[0][..., 0] for law in self.laws))
        p, q = (_dot(rays, axis) / _length(axis) for axis in (side, np.cross(side, across)))
        return _dot(rays, across), conic.deviation(p, q)


class Ellipse(NamedTuple):
    """Ellipses around the spine with half-axes (...) to the side and upwards."""

    half_width: Any
    half_height: Any

    words = "ellipses along the spine"

    def deviation(self, p, q):
        a, b = self
        return ((p / a) ** 2 + (q / b) ** 2 - 1) / (2 * np.hypot(p / a**2, q / b**2))


class VertexConic(NamedTuple):
    """Conics upwards from their vertex on the spine: radius of curvature, conic constant, depth.

    Which way is up after a place where the spine runs along the direction upwards is not known
    here: the nearer side counts. The depth is where edges are cut, which are not looked at here.
    """

    radius: Any
    constant: Any
    depth: Any

    words = "conics with their vertex on the spine"

    def deviation(self, p, q):
        return np.minimum(self._of_upper(p, q), self._of_upper(p, -q))

    def _of_upper(self, p, q):
        value = p**2 - 2 * self.radius * q + (1 + self.constant) * q**2
        return np.abs(value) / (2 * np.hypot(p, (1 + self.constant) * q - self.radius))


class Quadric(NamedTuple):
    """A quadric squares.x^2 + line.x + constant = 0 in its standard position."""

    squares: np.ndarray
    line: np.ndarray
    constant: float

    words = "feet on the quadric: distance from it along its normal"

    def deviations(self, points, normals, distance):
        # Beyond a singular point the normal of the parametrization is on the other side.
        both = [self._by_newton(points, side * normals, distance) for side in (1, -1)]
        return np.minimum(*both)

    def _by_newton(self, points, normals, distance):
        feet = points - distance * normals
        gradient = 2 * self.squares * feet + self.line
        factor = distance * _dot(normals, gradient) / _dot(gradient, gradient)
        for _ in range(_NEWTON_STEPS):
            feet, factor = self._improved(points, feet, factor)
        return np.abs(_length(points - feet) - abs(distance))

    def _improved(self, points, feet, factor):
        """A Newton step for the system  foot + factor grad q(foot) = point,  q(foot) = 0."""
        gradient = 2 * self.squares * feet + self.line
        matrix = np.zeros((len(feet), 4, 4))
        matrix[:, range(3), range(3)] = 1 + 2 * factor[:, None] * self.squares
        matrix[:, :3, 3] = matrix[:, 3, :3] = gradient
        value = feet**2 @ self.squares + feet @ self.line + self.constant
        residual = np.column_stack([feet + factor[:, None] * gradient - points, value])
        step = np.matmul(np.linalg.pinv(matrix), residual[..., None])[..., 0]
        return feet - step[:, :3], factor - step[:, 3]


class SphereNet(NamedTuple):
    """A quadratic triangle of spheres: the control spheres (6, 4) A, B, C, AB, BC, CA."""

    spheres: np.ndarray

    words = "spheres of the family: distance from the centre minus the radius"

    def deviations(self, points, normals, distance):
        u, v = self._start(points, normals, distance)
        for _ in range(_NEWTON_STEPS):
            u, v = self._improved(points, distance, u, v)
        rays, radius, *_ = self._at(points, distance, u, v)
        return np.abs(_length(rays) - np.abs(radius))

    def _start(self, points, normals, distance):
        """The parameters of a grid whose sphere has the point most nearly at its normal."""
        u, v = (grid.ravel() for grid in np.meshgrid(*[np.linspace(0, 1, _GRID_OF_NET)] * 2))
        u, v = u[u + v <= 1], v[u + v <= 1]
        rays, radius, *_ = self._at(points[:, None], distance, u, v)
        misses = _length(rays - radius[..., None] * normals[:, None])
        best = misses.argmin(axis=1)
        return u[best], v[best]

    def _at(self, points, distance, u, v):
        """Rays from the centres, radii, and the derivatives of centre and radius by u and v."""
        a, b, c, ab, bc, ca = self.spheres
        u, v = u[..., None], v[..., None]
        w = 1 - u - v
        sphere = u * u * a + v * v * b + w * w * c + 2 * (u * v * ab + v * w * bc + u * w * ca)
        by_u = 2 * (u * (a - ca) + v * (ab - bc) + w * (ca - c))
        by_v = 2 * (u * (ab - ca) + v * (b - bc) + w * (bc - c))
        return points - sphere[..., :3], sphere[..., 3] + distance, by_u, by_v

    def _improved(self, points, distance, u, v):
        """A Newton step for  (x - m).m_i + (r + d) r_i = 0,  i = u, v."""
        rays, radius, *slopes = self._at(points, distance, u, v)
        values = [_dot(rays, s[..., :3]) + radius * s[..., 3] for s in slopes]
        a, b, c, ab, bc, ca = self.spheres
        second = [2 * (a - 2 * ca + c), 2 * (ab - bc - ca + c), 2 * (b - 2 * bc + c)]
        (s_u, s_v) = slopes
        j_uu, j_uv, j_vv = (
            -_dot(p[..., :3], q[..., :3]) + p[..., 3] * q[..., 3] + _dot(rays, x[:3]) + radius * x[3]
            for p, q, x in zip((s_u, s_u, s_v), (s_u, s_v, s_v), second)
        )
        determinant = j_uu * j_vv - j_uv**2
        return (
            u - (j_vv * values[0] - j_uv * values[1]) / determinant,
            v - (j_uu * values[1] - j_uv * values[0]) / determinant,
        )


class SphereNets(NamedTuple):
    """Quadratic triangles of spheres over the plane z = 0, side by side.

    corners (m, 3, 2) are theirs, A, B and C, in x and y; nets are their SphereNets.
    """

    corners: np.ndarray
    nets: list

    words = SphereNet.words

    def deviations(self, points, normals, distance):
        # Samples of a face may lie a little beyond its edge, where it goes on over the neighbour.
        candidates = self._nearest(points, normals, distance)
        return np.min([self._from(owners, points, normals, distance) for owners in candidates], axis=0)

    def _from(self, owners, points, normals, distance):
        found = np.empty(len(points))
        for owner in np.unique(owners):
            here = owners == owner
            found[here] = self.nets[owner].deviations(points[here], normals[here], distance)
        return found

    def _nearest(self, points, normals, distance):
        """The triangles (k, n) over or next to which the centre lies, the point at its normal."""
        radii = np.full(len(points), np.mean([net.spheres[:, 3] for net in self.nets]))
        for _ in range(_NEWTON_STEPS):
            centres = points - (radii + distance)[:, None] * normals
            inside = self._barycentric(centres[:, None, :2])
            depths = inside.min(axis=-1)
            owners = depths.argmax(axis=1)
            chosen = inside[np.arange(len(points)), owners]
            for owner in np.unique(owners):
                here = owners == owner
                u, v, w = chosen[here].T
                a, b, c, ab, bc, ca = self.nets[owner].spheres[:, 3]
                radii[here] = (
                    u * u * a + v * v * b + w * w * c + 2 * (u * v * ab + v * w * bc + u * w * ca)
                )
        return np.argsort(-depths, axis=1)[:, :_NEAREST_NETS].T

    def _barycentric(self, places):
        """The coordinates (n, m, 3) of places (n, 1, 2) in all triangles."""
        a, b, c = self.corners.transpose(1, 0, 2)
        area = _cross(a - c, b - c)
        u, v = _cross(places - c, b - c) / area, _cross(a - c, places - c) / area
        return np.stack([u, v, 1 - u - v], axis=-1)


class BallNet(NamedTuple):
    """The union of the balls of a quadratic triangle of spheres, as SphereNet.

    Its boundary touches a sphere inside the triangle, or one of an edge among those of the edge, or a
    corner.
    """

    spheres: np.ndarray

    words = "balls of the family: distance from the boundary of their union"

    def deviations(self, points, normals, distance):
        a, b, c, ab, bc, ca = self.spheres
        edges = ((a, ab, b), (b, bc, c), (c, ca, a))
        parts = [
            SphereNet(self.spheres).deviations(points, normals, distance),
            *(_from_edge(np.array(edge), points, distance) for edge in edges),
            *(_from_sphere(corner, points, distance) for corner in (a, b, c)),
        ]
        return np.min(parts, axis=0)


def _from_edge(spheres, points, distance):
    """How far points are from the envelope of the spheres (3, 4) of a quadratic Bezier curve."""
    a, ab, b = spheres
    t = np.linspace(0, 1, _GRID_OF_NET)[:, None]
    start = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
    gaps = _length(points[:, None] - start[:, :3]) - start[:, 3]
    t = t[gaps.argmin(axis=1)]
    for _ in range(_NEWTON_STEPS):
        sphere = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
        slope, bend = 2 * ((1 - t) * (ab - a) + t * (b - ab)), 2 * (a - 2 * ab + b)
        rays, radius = points - sphere[:, :3], sphere[:, 3] + distance
        value = _dot(rays, slope[:, :3]) + radius * slope[:, 3]
        change = (
            _dot(rays, bend[:3])
            + radius * bend[3]
            - _dot(slope[:, :3], slope[:, :3])
            + slope[:, 3] ** 2
        )
        t = np.clip(t - (value / change)[:, None], 0, 1)
    sphere = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
    return np.abs(_length(points - sphere[:, :3]) - np.abs(sphere[:, 3] + distance))


def _from_sphere(sphere, points, distance):
    return np.abs(_length(points - sphere[:3]) - np.abs(sphere[3] + distance))


class Huygens(NamedTuple):
    """The spheres around the points of a mirror, as the light that reaches them makes them grow.

    `mirror` is a spline_grid.SplineSurface, `light` what mirror_wavefront.light_of gives.
    """

    mirror: Any
    light: dict

    words = (
        "spheres around the points of the mirror: distance from the centre minus the rest of the path"
    )

    def deviations(self, points, normals, distance):
        # Beyond a focal point the normal of the parametrization is on the other side.
        starts = [
            start for side in (1, -1) for start in self._starts(points, side * normals, distance)
        ]
        return np.min([self._by_newton(points, distance, *start) for start in starts], axis=0)

    def _by_newton(self, points, distance, u, v):
        for _ in range(_NEWTON_STEPS):
            u, v = self._improved(points, distance, u, v)
        rays, radius, _, _ = self._at(points, distance, u, v)
        return np.abs(_length(rays) - np.abs(radius))

    def _starts(self, points, normals, distance):
        """Parameters of a grid whose spheres have the points nearly at their normals.

        There are several pairs (u, v) of arrays (n,): near focal points some places of the mirror
        have rays that are close together.
        """
        u, v = (spread(knots, _GRID_OF_MIRROR) for knots in (self.mirror.u_knots, self.mirror.v_knots))
        centres = jet_at(self.mirror, u, v).point.reshape(-1, 3)
        radii = distance - self._path(centres)[0]
        shape = (len(u), len(v))
        best = np.array(
            [
                _lowest_valleys(_length(point - centres - radii[:, None] * normal).reshape(shape))
                for point, normal in zip(points, normals)
            ]
        )
        rows, columns = np.unravel_index(best.T, shape)
        return list(zip(u[rows], v[columns]))

    def _path(self, centres):
        """Of the light to points (n, 3): length, gradient and second derivatives (n, 3, 3)."""
        if "source" in self.light:
            rays = centres - np.array(self.light["source"])
            length = _length(rays)
            gradient = rays / length[:, None]
            across = np.eye(3) - gradient[:, :, None] * gradient[:, None, :]
            return length, gradient, across / length[:, None, None]
        direction = np.array(self.light["direction"]) / np.linalg.norm(self.light["direction"])
        length = (centres - np.array(self.light["start"])) @ direction
        return length, np.broadcast_to(direction, centres.shape), np.zeros((len(centres), 3, 3))

    def _at(self, points, distance, u, v):
        """Rays from the mirror, radii, the Jet (n, 3) of the mirror and the path."""
        jet = Jet(*(values[:, 0] for values in jet_at(self.mirror, u, v[:, None])))
        path = self._path(jet.point)
        return points - jet.point, distance - path[0], jet, path

    def _improved(self, points, distance, u, v):
        """A Newton step for  (x - m).m_i + (d - s) (d - s)_i = 0,  i = u, v."""
        rays, radius, jet, (_, gradient, second) = self._at(points, distance, u, v)
        slopes = (jet.u, jet.v)
        falls = [_dot(gradient, slope) for slope in slopes]
        values = [_dot(rays, slope) - radius * fall for slope, fall in zip(slopes, falls)]
        j_uu, j_uv, j_vv = (
            -_dot(slopes[i], slopes[k])
            + falls[i] * falls[k]
            + _dot(rays, bend)
            - radius * (_dot(gradient, bend) + np.einsum("ni,nij,nj->n", slopes[i], second, slopes[k]))
            for i, k, bend in ((0, 0, jet.uu), (0, 1, jet.uv), (1, 1, jet.vv))
        )
        determinant = j_uu * j_vv - j_uv**2
        u = u - (j_vv * values[0] - j_uv * values[1]) / determinant
        v = v - (j_uu * values[1] - j_uv * values[0]) / determinant
        return _within(self.mirror.u_knots, u), _within(self.mirror.v_knots, v)


def _lowest_valleys(heights):
    """The places (_STARTS,) of the lowest values of a grid that no neighbour is below, lowest first.

    Where there are fewer, other low places fill up.
    """
    m, n = heights.shape
    padded = np.pad(heights, 1, constant_values=np.inf)
    shifts = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    is_valley = np.all([heights <= padded[i : i + m, j : j + n] for i, j in shifts], axis=0)
    order = np.lexsort((heights.ravel(), ~is_valley.ravel()))
    return order[:_STARTS]


def _within(knots, parameters):
    return np.clip(parameters, knots[0], knots[-1])


class PiecewiseRational:
    """A function of one parameter, from the spans that pnkernel gives."""

    def __init__(self, spans, domain=None):
        """`domain` is where the function is moved to, as pnkernel does with a second curve."""
        self.breaks = np.array([spans[0][0], *(last for _, last, _ in spans)])
        self._coefficients = [coefficients for _, _, coefficients in spans]
        if domain is not None:
            part = (self.breaks - self.breaks[0]) / (self.breaks[-1] - self.breaks[0])
            self.breaks = domain[0] + (domain[-1] - domain[0]) * part

    def with_derivative(self, t, inside):
        """Values and derivatives (..., dimension) at parameters (...), of the spans `inside`."""
        t, inside = np.broadcast_arrays(t, inside)
        spans = np.searchsorted(self.breaks, inside) - 1
        shape = t.shape + (self._coefficients[0].shape[1] - 1,)
        value, derivative = np.empty(shape), np.empty(shape)
        for span in np.unique(spans):
            here = spans == span
            value[here], derivative[here] = self._of_span(span, t[here])
        return value, derivative

    def _of_span(self, span, t):
        width = self.breaks[span + 1] - self.breaks[span]
        s = ((t - self.breaks[span]) / width)[:, None]
        coefficients = self._coefficients[span]
        homogeneous = _bernstein(coefficients, s)
        slope = (len(coefficients) - 1) / width * _bernstein(np.diff(coefficients, axis=0), s)
        value = homogeneous[:, :-1] / homogeneous[:, -1:]
        return value, (slope[:, :-1] - slope[:, -1:] * value) / homogeneous[:, -1:]


def _along_family(family, points, distance):
    """The least deviation at a root of the family's equation."""
    starts = range(0, len(points), _POINTS_AT_ONCE)
    blocks = [points[start : start + _POINTS_AT_ONCE] for start in starts]
    return np.concatenate([_of_block(family, block, distance) for block in blocks])


def _of_block(family, points, distance):
    breaks = family.breaks()
    t, inside = _parameters(breaks)
    slope, _ = family.at(t, inside, points[:, None, None], distance)
    sizes = np.full(len(points), np.inf)
    for owners, roots, spans in (
        _roots(family, points, distance, slope, t, inside),
        _roots_at_corners(slope, breaks, inside),
    ):
        _, found = family.at(roots, spans, points[owners], distance)
        np.minimum.at(sizes, owners, np.abs(found))
    # Nearest to a point beyond the ends is an end.
    ends, spans = breaks[[0, -1]], inside[[0, -1], 0]
    _, found = family.at(ends, spans, points[:, None], distance)
    return np.where(np.isinf(sizes), np.abs(found).min(axis=1), sizes)


def _parameters(breaks):
    """Parameters (s, k) of each span, from before its start to beyond its end, and one inside."""
    first, width = breaks[:-1, None], np.diff(breaks)[:, None]
    inner = (np.arange(_PARAMETERS_OF_SPAN) + 0.5) / _PARAMETERS_OF_SPAN
    parts = np.concatenate([[-_BEYOND_END], inner, [1 + _BEYOND_END]])
    return first + width * parts, first + width / 2


def _roots(family, points, distance, slope, t, inside):
    """The zeros (i,) of the slope on all spans, with the points that they belong to."""
    owners, spans, steps = np.nonzero(np.sign(slope[..., :-1]) != np.sign(slope[..., 1:]))
    low, high, inside = t[spans, steps], t[spans, steps + 1], inside[spans, 0]
    rises = slope[owners, spans, steps] < 0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        value, _ = family.at(middle, inside, points[owners], distance)
        is_before = (value < 0) == rises
        low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
    return owners, (low + high) / 2, inside


def _roots_at_corners(slope, breaks, inside):
    """Where the slope changes its sign from one span to the next, the corner itself."""
    owners, corners = np.nonzero(np.sign(slope[:, :-1, -1]) != np.sign(slope[:, 1:, 0]))
    return owners, breaks[corners + 1], inside[corners, 0]


def _bernstein(coefficients, s):
    """Values (n, c) of Bernstein coefficients (k + 1, c) at s (n, 1), by de Casteljau's steps."""
    rows = [row[None] for row in coefficients] or [np.zeros((1, coefficients.shape[1]))]
    while len(rows) > 1:
        rows = [(1 - s) * a + s * b for a, b in zip(rows, rows[1:])]
    return rows[0] + 0 * s


def _dot(a, b):
    return np.sum(a * b, axis=-1)


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _length(a):
    return np.linalg.norm(a, axis=-1)


def _spheres(spine, radius):
    return Spheres(PiecewiseRational(spine.spans), PiecewiseRational(radius.spans_over(spine)))


def _squared_spheres(obj):
    spine, square = read_squared_spheres(obj)
    return SquaredSpheres(PiecewiseRational(spine.spans), PiecewiseRational(square.spans_over(spine)))


def _sections(obj):
    spine, laws = read_section(obj)
    laws = [PiecewiseRational(law.spans_over(spine)) for law in laws]
    conic = _CONICS[obj.Section]
    return Sections(PiecewiseRational(spine.spans), laws, conic, **planes_of(obj))


def _rulings(obj):
    first, last = (chain.kernel_curve() for chain in read_curves(obj))
    return Rulings(PiecewiseRational(first.spans), PiecewiseRational(last.spans, first.domain))


def _quadric(obj):
    if obj.Kind == OF_FACE:
        found = read_face(obj)
        return Quadric(*standard_equation(found.kind, found.axes))
    return Quadric(*standard_equation(KINDS[obj.Kind].name, half_axes(obj)))


def _nets(obj):
    corners, spheres = read_family(obj).pieces
    # In the kernel's order: A, AB, B, CA, BC, C.
    return SphereNets(corners, [SphereNet(net[[0, 2, 5, 1, 4, 3]]) for net in spheres])


_CONICS = {ELLIPSE: Ellipse, FROM_THE_VERTEX: VertexConic}

_DEFINITIONS = {
    CanalSurface: lambda obj: _spheres(*read_spheres(obj)),
    SquaredRadiusCanal: _squared_spheres,
    RuledOffset: _rulings,
    QuadricOffset: _quadric,
    MovingConicSection: _sections,
    MirrorWavefront: lambda obj: Huygens(spline_surface(read_mirror(obj).surface), light_of(obj)),
    MidSurfaceSkins: lambda obj: (BallNet if obj.Output == SOLID else SphereNet)(read_net(obj)),
    TriangulatedSkins: _nets,
}
