# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random surfaces of every shape, and how far their exported points are from the true surface.

The certificate is held to account by the definitions of canal.py, rulings.py, quadrics.py,
sphere_families.py, sphere_translations.py, powell_sabin.py, mirrors.py and quadratic_cones.py: from
the exported doubles back to the spheres, lines or the equation, at 60 digits. Nothing of the
kernel's construction takes part.

The surfaces are biased to what is degenerate or badly scaled: straight spines, constant radii, equal
half-axes, poles on a coarse grid, weights that differ by thousands, sizes from a micrometre to a
kilometre.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import mpmath
import numpy as np
import pnkernel as pn
from mpmath import mpf
from canal import Canal, random_canal
from mirrors import Mirror, ParallelLight, PointLight, random_mirror, reflected
from powell_sabin import control_spheres, dome, pieces
from quadratic_cones import random_cones
from quadrics import bounded_kinds, quadric
from rulings import Cones, random_pair
from sphere_families import Family, random_spheres
from sphere_translations import Translation, random_translation
from splines import Spline, exactly, norm, surface_point
from trims import is_on_face

DEGREES = (1, 2, 3, 4)
OUTER, INNER = 1, -1
GAUSS_NEWTON_STEPS, NEWTON_STEPS = 6, 30
# Where Newton's method begins on a family over a triangle or a square. A skin this near [mm] is not
# another one by chance.
STARTS = ((1 / 3, 1 / 3), (1.5, 0), (0, 1.5), (-0.5, -0.5), (1.5, 1.5))
NEAR = 1e-6
# What is this near [mm] is on the surface itself, up to rounding.
ROUNDED = 1e-11


@dataclass(frozen=True)
class Specimen:
    """A surface of the kernel and error(point, u, v), how far a point is from what it should be [mm].

    (u, v) is its place on its face: where to begin to look.
    """

    surface: Any
    error: Callable

    def largest_error(self, random, count):
        """Of so many random points, some of them corners of faces.

        The certificate does not stop at the trims of a face. But far beyond them Newton's method may
        find no contact, or that of another skin; such a point says nothing.
        """
        faces = self.surface.bsplines()
        errors = []
        for _ in range(count):
            face = faces[random.integers(len(faces))]
            place = _place_on(face, random)
            error = self.error(surface_point(face, *place), *place)
            if error < NEAR or is_on_face(face, place):
                errors.append(error)
        return float(max(errors, default=0))


def _place_on(face, random):
    ends = [(knots[0], knots[-1]) for knots in (face.u_knots, face.v_knots)]
    if random.random() < 0.3:
        return [random.choice(end) for end in ends]
    return [random.uniform(*end) for end in ends]


# Inputs -------------------------------------------------------------------------------------------


def _degraded(spline, random):
    """The spline as it is, or with poles on a coarse grid, or with uneven weights."""
    choice = random.integers(4)
    if choice == 0:
        return replace(spline, poles=np.round(spline.poles))
    if choice == 1 and not (spline.weights == 1).all():
        return replace(spline, weights=spline.weights * 10 ** random.uniform(-1.5, 1.5))
    return spline


def _scaled(splines, random):
    """All of one size, from a micrometre to a kilometre."""
    size = 10 ** random.uniform(-4, 5) if random.random() < 0.3 else 1.0
    return [replace(spline, poles=size * spline.poles) for spline in splines], size


def _seed(random):
    return int(random.integers(2**31))


# Shapes -------------------------------------------------------------------------------------------


def canal(random):
    degree = int(random.choice(DEGREES))
    spans = int(random.integers(1, 4)) if degree > 1 else 1  # a corner has no parameter on the spine
    plain = random_canal(_seed(random), degree, spans, rational=random.random() < 0.5)
    radius = plain.radius
    if random.random() < 0.3:
        radius = replace(radius, poles=np.full_like(radius.poles, radius.poles[0]))
    (spine, radius), size = _scaled([_degraded(plain.spine, random), radius], random)
    pipe = Canal(replace(spine, weights=radius.weights), radius)
    surface = pipe.surface().offset(size * random.choice([0.0, random.uniform(-1, 1)]))
    distance = surface.distance

    def error_from(point, start):
        return pipe.distance(point, distance, start, spine.span_at(start))

    return Specimen(surface, _nearest(error_from, spine))


def ruled(random):
    degree = int(random.choice(DEGREES[:3]))
    spans = int(random.integers(1, 3)) if degree > 1 else 1
    pair = random_pair(_seed(random), degree, spans, random.random() < 0.5, noise=0.5)
    return _along_rulings(pair, (), random)


def cones(random):
    first, second = random_pair(_seed(random), int(random.choice(DEGREES[:3])), noise=0.3)

    def law(mean):
        values = mean + random.uniform(-0.2, 0.2, len(first.poles)) * random.integers(2)
        return Spline(first.degree, first.knots, first.multiplicities, values, first.weights)

    return _along_rulings((first, second), (law(1.5), law(2.5)), random)


def _along_rulings(centres, radii, random):
    splines, size = _scaled([*centres, *radii], random)
    family = Cones(tuple(splines[:2]), tuple(splines[2:]))
    surface = family.surface().offset(size * random.choice([0.0, random.uniform(-0.5, 0.75)]))

    def error(point, u, _):
        span = family.centres[0].span_at(u)
        return abs(family.contact(point, surface.distance, u, span)[2] - surface.distance)

    return Specimen(surface, error)


def quadrics(random):
    cases = bounded_kinds()
    kind, a, b, c, bounds = cases[random.integers(len(cases))]
    size = 10 ** random.uniform(-3, 3)
    a, b, c = (size * x * random.uniform(0.9, 1.1) for x in (a, b, c))
    # Other half-axes leave the regions of these two elsewhere.
    if kind == "elliptic_cylinder" or random.random() < 0.3:
        b = a
    if kind == "elliptic_cone":
        b = a
    if bounds:
        bounds = {axis: tuple(size * end for end in ends) for axis, ends in bounds.items()}
    surface, definition = quadric(kind, a, b, c, bounds)
    surface = surface.offset(size * random.choice([0.0, random.uniform(-0.1, 0.25)]))

    def error(point, *_):
        return abs(definition.contact(point, surface.distance)[1] - surface.distance)

    return Specimen(surface, error)


def skins(random):
    spheres = random_spheres(random, dome=random.random() < 0.7)
    surface = _skin(pn.sphere_family(spheres), random.choice([OUTER, INNER]), random)
    return Specimen(surface, _from_spheres(_jet_of(Family.of(spheres)), surface.distance))


def triangulated_skins(random):
    """Over two triangles, in any position."""
    points, radii, derivatives, triangles = dome(1)
    points = points[:, :2] + random.uniform(-20, 20, (4, 2))
    heights = np.column_stack([points, random.uniform(-8, 8, 4)])
    derivatives = derivatives + random.uniform(-0.1, 0.1, derivatives.shape) * [0, 0, 1, 0.1]
    radii = radii + random.uniform(-0.5, 0.5, 4) * random.integers(2)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    centres = heights @ turn.T
    derivatives[:, :, :3] = derivatives[:, :, :3] @ turn.T
    family = pn.sphere_family_powell_sabin(centres, radii, derivatives, triangles, parameters=points)
    surface = _skin(family, random.choice([OUTER, INNER]), random)
    parts = zip(
        *pieces(points, np.column_stack([centres, radii]), derivatives, triangles, family.pieces[0]),
        strict=True,
    )
    errors = [
        _from_spheres(_jet_of(Family(control_spheres(*part))), surface.distance) for part in parts
    ]

    def error(point, u, v):
        # Faces are in the order of the parts, over [i, i + 1]; a part may have more than one. Beside
        # a common edge the smooth continuation of the neighbour is near, but not the surface.
        found = []
        for i in sorted(range(len(errors)), key=lambda i: abs(i + 0.5 - u)):
            found.append(errors[i](point, u, v))
            if found[-1] < ROUNDED:
                break
        return min(found)

    return Specimen(surface, error)


def envelopes(random):
    """Parts of the envelope of quadratic spheres, over their normals."""
    x, y, z, r = random.uniform(-0.05, 0.05, (4, 6)) * [50, 5, 5, 3, 5, 3]
    x[1], y[2] = random.uniform(30, 60, 2)
    z[3], z[5] = random.uniform(3, 6, 2) * random.choice([-1, 1])
    r[0] = random.uniform(2, 4)
    family = pn.sphere_family_from_surface([_array(c) for c in (x, y, z)], _array(r))
    low = random.uniform(-0.1, 0, 2)
    bounds = [(a, a + random.uniform(0.02, 0.1)) for a in low]
    skin = family.skin(int(random.integers(2)), bounds)
    surface = skin.offset(random.choice([0.0, random.uniform(-1, 2)]))
    control = control_spheres(exactly([[1, 0], [0, 1], [0, 0]]), exactly(np.stack([x, y, z, r], 1)))
    return Specimen(surface, _from_spheres(_jet_of(Family(control)), surface.distance))


def _array(c):
    """Coefficients of u^i v^j, of those of 1, u, v, u u, u v, v v."""
    return np.array([[c[0], c[2], c[5]], [c[1], c[4], 0], [c[3], 0, 0]])


def _jet_of(family):
    by_uu, by_uv, by_vv = family.second_derivatives()

    def jet(u, v):
        return *family.sphere(u, v), by_uu, by_uv, by_vv

    return jet


def wavefronts(random):
    """Of mirrors in the light of one direction or of a point, so far on their way."""
    degrees = random.choice([(1, 1), (2, 1), (2, 2), (3, 2)])
    mirror = random_mirror(random, *map(int, degrees), random.random() < 0.4)
    if random.random() < 0.7:
        light = ParallelLight(np.array([*random.uniform(-0.3, 0.3, 2), -1]), random.uniform(5, 9, 3))
        distance = random.uniform(0, 30)
    else:
        light, distance = PointLight(np.array([*random.uniform(0, 8, 2), random.uniform(4, 9)])), 0.0
    surface = pn.mirror(mirror, **light.arguments()).offset(distance)
    exact = Mirror.of(mirror)

    def error(point, u, v):
        # Faces have the parameters of the mirror.
        return norm(point - reflected(exact, light, mpf(u), mpf(v), mpf(distance)))

    return Specimen(surface, error)


def cone_envelopes(random):
    """Of quadratic cones."""
    cones = random_cones(random)
    surface = pn.quadratic_cone_envelope(*cones.arguments())
    return Specimen(surface, lambda point, *_: cones.distance(point))


def translations(random):
    # In any position: of a plate along the axes only the tangential coordinates are large.
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    flat = random_translation(random)
    family = Translation(
        *(
            replace(c, poles=np.column_stack([c.poles[:, :3] @ turn.T, c.poles[:, 3]]))
            for c in (flat.c, flat.d)
        )
    )
    curves = [pn.SphereSpline.bspline(*curve.arguments[:4]) for curve in (family.c, family.d)]
    sign = random.choice([OUTER, INNER])
    surface = _skin(pn.sphere_family_translational(*curves), sign, random)

    def jet(u, v):
        (c, by_u, by_uu), (d, by_v, by_vv) = family.c.derivatives(u, 0), family.d.derivatives(v, 0)
        return c + d, by_u, by_v, by_uu, 0 * c, by_vv

    return Specimen(surface, _from_spheres(jet, surface.distance))


def sections(random):
    """Ellipses perpendicular to the spine, or parallel."""
    degree = int(random.choice(DEGREES[:2]))
    spine = random_canal(_seed(random), degree, rational=random.random() < 0.3).spine
    up = np.array([1.0, *random.uniform(-0.2, 0.2, 2)])
    normal = None if random.random() < 0.7 else np.array([*random.uniform(-0.2, 0.2, 2), 1.0])
    axes = [
        Spline(
            degree,
            spine.knots,
            spine.multiplicities,
            random.uniform(1, 3, degree + 1)
            if random.random() < 0.5
            else np.full(degree + 1, random.uniform(1, 3)),
            spine.weights,
        )
        for _ in range(2)
    ]
    surface = pn.moving_conic_section(
        pn.Curve.bspline(*spine.arguments),
        up=up,
        normal=normal,
        half_axes=tuple(pn.Law.bspline(*axis.arguments) for axis in axes),
    )

    def inside(point, near):
        """(p / a)^2 + (q / b)^2 - 1 in the section through the point, and its t."""
        t = mpf(near)
        for _ in range(NEWTON_STEPS):
            m, m1, m2 = spine.derivatives(t, 0)
            arm = point - m
            across, turn = (m1, arm @ m2) if normal is None else (exactly(normal), 0)
            step = (arm @ across) / (turn - m1 @ across)
            t -= step
            if abs(step) < mpf(10) ** -45:
                break
        side = np.cross(across, exactly(up))
        above = np.cross(side, across)
        a, b = (axis.derivatives(t, 0)[0][0] for axis in axes)
        p, q = ((point - m) @ axis / norm(axis) for axis in (side, above))
        return (p / a) ** 2 + (q / b) ** 2 - 1, t

    def error_from(point, start):
        """The value over its gradient: of second order in the error itself."""
        value, t = inside(point, start)
        step = mpf(10) ** -25
        gradient = np.array(
            [
                (inside(point + step * e, t)[0] - value) / step
                for e in np.array(np.eye(3), dtype=object)
            ]
        )
        return abs(value) / norm(gradient)

    return Specimen(surface, _nearest(error_from, spine))


def squared_radii(random):
    """Of spheres whose squared radii alone are rational: |x - m| = r where (x - m).m' + r r' = 0."""
    degree = int(random.choice(DEGREES[:2]))
    plain = random_canal(_seed(random), degree)
    spine, square = plain.spine, replace(plain.radius, poles=plain.radius.poles**2)
    surface = pn.moebius_canal_surface(
        pn.Curve.bspline(*spine.arguments), pn.Law.bspline(*square.arguments)
    )

    def error_from(point, start):
        t = mpf(start)
        for _ in range(NEWTON_STEPS):
            (m, m1, m2), (r, r1, r2) = spine.derivatives(t, 0), square.derivatives(t, 0)
            arm = point - m
            step = (arm @ m1 + r1[0] / 2) / (arm @ m2 - m1 @ m1 + r2[0] / 2)
            t -= step
            if abs(step) < mpf(10) ** -45:
                break
        return abs(norm(arm) - mpmath.sqrt(abs(r[0])))

    return Specimen(surface, _nearest(error_from, spine))


def _nearest(error_from, spine):
    """The error by the section or circle nearest to the point.

    A face has a parameter of its own where its circles or conics are real on an interval only: then
    other places of the spine are tried than its first parameter, and the first that is found may be
    another one, so that its error says nothing.
    """

    def error(point, u, _):
        found = []
        for start in (u, *np.linspace(spine.knots[0], spine.knots[-1], 9)):
            try:
                found.append(error_from(point, start))
            except ArithmeticError:  # Newton's method leads nowhere from there.
                continue
            if found[-1] < ROUNDED:
                break
        return min(found, default=np.inf)

    return error


def _skin(family, sign, random):
    surface = family.skins[0 if sign == OUTER else 1]
    return surface.offset(random.choice([0.0, random.uniform(-1, 2)]))


def _from_spheres(jet, distance):
    """The error of a point on a skin of the spheres (m, r)(u, v) with these derivatives.

    Where s |x - m| - r is stationary, s the sign of the radius r + d, its value is the distance at
    which x is on a skin.
    """

    def error(point, *_):
        return min(_distances(point, jet, mpf(distance)), default=np.inf)

    return error


def _distances(point, jet, distance):
    """From the skins through stationary places: all bound the error, and one is that of the point."""
    for u, v in STARTS:
        place = _foot(point, jet, u, v)
        for side in (1, -1):
            try:
                found = abs(_stationary_value(point, side, jet, *place) - distance)
            except ArithmeticError:
                continue
            yield found
            if found < NEAR:
                return


def _foot(point, jet, u, v):
    """Roughly (u, v) of the centre nearest to a point, by the method of Gauss and Newton."""
    for _ in range(GAUSS_NEWTON_STEPS):
        centre, by_u, by_v = (np.array(d[:3], dtype=float) for d in jet(mpf(u), mpf(v))[:3])
        step, *_ = np.linalg.lstsq(
            np.stack([by_u, by_v], axis=1), np.array(point, dtype=float) - centre, rcond=None
        )
        u, v = u + step[0], v + step[1]
    return mpf(u), mpf(v)


def _stationary_value(point, side, jet, u, v):
    for _ in range(NEWTON_STEPS):
        sphere, *first, by_uu, by_uv, by_vv = jet(u, v)
        arm = point - sphere[:3]
        length = side * norm(arm)
        ray = arm / length
        slopes = [-(ray @ d[:3]) - d[3] for d in first]

        def bend(d, e, second):
            return (
                (d[:3] @ e[:3] - (ray @ d[:3]) * (ray @ e[:3])) / length - ray @ second[:3] - second[3]
            )

        a, c = bend(first[0], first[0], by_uu), bend(first[1], first[1], by_vv)
        b = bend(first[0], first[1], by_uv)
        determinant = a * c - b * b
        step_u = (slopes[0] * c - slopes[1] * b) / determinant
        step_v = (slopes[1] * a - slopes[0] * b) / determinant
        u, v = u - step_u, v - step_v
        if abs(step_u) + abs(step_v) < mpf(10) ** -30:
            return length - sphere[3]
    raise ArithmeticError("no stationary place")


SHAPES = {
    shape.__name__: shape
    for shape in (
        canal,
        ruled,
        cones,
        quadrics,
        skins,
        triangulated_skins,
        envelopes,
        translations,
        sections,
        squared_radii,
        wavefronts,
        cone_envelopes,
    )
}
