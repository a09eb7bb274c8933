# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quadrics that are recognised in faces: made in known position, found again, refused."""

import itertools
import math

import Part
from FreeCAD import Matrix, Placement, Rotation, Vector
from support import DocumentTest

from pnsurfaces.bspline_surface import clamped_bspline
from pnsurfaces.quadric_face import FIT_LIMIT, NotQuadric, read_quadric_face
from pnsurfaces.quadric_identity import satisfies_quadric

POSITION = Placement(Vector(10, -20, 30), Rotation(Vector(1, 2, 3), 50))

# The standard equation of each kind as a function of x / a, y / b and z / c.
EQUATIONS = {
    "ellipsoid": lambda x, y, z: x**2 + y**2 + z**2 - 1,
    "one_sheet_hyperboloid": lambda x, y, z: x**2 + y**2 - z**2 - 1,
    "two_sheet_hyperboloid": lambda x, y, z: z**2 - x**2 - y**2 - 1,
    "elliptic_paraboloid": lambda x, y, z: x**2 + y**2 - z,
    "hyperbolic_paraboloid": lambda x, y, z: x**2 - y**2 - z,
    "elliptic_cylinder": lambda x, y, z: x**2 + y**2 - 1,
    "elliptic_cone": lambda x, y, z: x**2 + y**2 - z**2,
    "parabolic_cylinder": lambda x, y, z: x**2 - z,
}


def equation_value(found, local):
    return EQUATIONS[found.kind](*(x / axis for x, axis in zip(local, found.axes)))


def scaled(shape, x, y, z):
    matrix = Matrix()
    matrix.scale(x, y, z)
    return shape.transformGeometry(matrix)


def placed(shape):
    copy = shape.copy()
    copy.Placement = POSITION.multiply(copy.Placement)
    return copy.Faces[0]


def revolved(curve, first, last, axis, angle=360):
    return curve.toShape(first, last).revolve(Vector(), axis, angle).Faces[0]


def parabola():
    curve = Part.Parabola()
    curve.Focal = 5
    return curve


def hyperbola():
    curve = Part.Hyperbola()
    curve.MajorRadius, curve.MinorRadius = 10, 5
    return curve


def patch(height, size=10):
    """The biquadratic Bezier patch z = height(x, y) over a square, for a polynomial height."""
    surface = Part.BezierSurface()
    surface.increase(2, 2)
    # The blossom of a quadratic polynomial of each variable at (-s, -s), (-s, s), (s, s).
    places = ((-size, -size), (-size, size), (size, size))
    for (i, xs), (j, ys) in itertools.product(enumerate(places), repeat=2):
        surface.setPole(i + 1, j + 1, Vector(sum(xs) / 2, sum(ys) / 2, height(xs, ys)))
    return surface.toShape().Faces[0]


def product(pair):
    return pair[0] * pair[1]


class Recognition(DocumentTest):
    def assert_found(self, face, kind, axes=None):
        found = read_quadric_face(face)
        self.assertEqual(found.kind, kind)
        if axes:
            for found_axis, axis in zip(sorted(found.axes[: len(axes)]), sorted(axes)):
                self.assertAlmostEqual(found_axis, axis, delta=1e-10)
        inverse = found.placement.inverse()
        u_first, u_last, v_first, v_last = face.ParameterRange
        for i, j in itertools.product(range(1, 10), repeat=2):
            u = u_first + (u_last - u_first) * i / 10
            v = v_first + (v_last - v_first) * j / 10
            local = inverse.multVec(face.valueAt(u, v))
            self.assertLess(abs(equation_value(found, local)), 1e-12)
            for name, (low, high) in found.bounds.items():
                value = {
                    "x": local.x,
                    "y": local.y,
                    "z": local.z,
                    "angle": low + (math.atan2(local.y, local.x) - low) % (2 * math.pi),
                }[name]
                self.assertGreaterEqual(value, low - 1e-9)
                self.assertLessEqual(value, high + 1e-9)
        self.assertLess(found.deviation, 1e-12)
        self.assertFalse(found.is_fitted())
        return found

    def test_surfaces_that_say_what_they_are(self):
        for shape, kind, axes in (
            (Part.makeSphere(10), "ellipsoid", (10, 10, 10)),
            (Part.makeCylinder(5, 10), "elliptic_cylinder", (5, 5)),
            (Part.makeCone(5, 2, 10), "elliptic_cone", None),
            (Part.makeCone(0, 5, 10), "elliptic_cone", (5, 5, 10)),
        ):
            with self.subTest(kind):
                found = self.assert_found(placed(shape), kind, axes)
                self.assertTrue(found.identical)
                self.assertTrue(found.covered)

    def test_the_same_surfaces_as_bsplines(self):
        for shape, kind, axes in (
            (Part.makeSphere(10), "ellipsoid", (10, 10, 10)),
            (Part.makeCylinder(5, 10), "elliptic_cylinder", (5, 5)),
            (Part.makeCone(5, 2, 10), "elliptic_cone", None),
        ):
            with self.subTest(kind):
                self.assert_found(placed(Part.Face(shape.toNurbs().Faces[0])), kind, axes)

    def test_scaled_spheres(self):
        for x, y, z in ((2, 1, 0.5), (2, 1, 1), (1, 1, 0.25), (1, 3, 1)):
            with self.subTest((x, y, z)):
                face = scaled(Part.makeSphere(10), x, y, z).Faces[0]
                found = self.assert_found(face, "ellipsoid", (10 * x, 10 * y, 10 * z))
                self.assertEqual((found.bounds, found.covered), ({}, True))
                self.assert_found(placed(face), "ellipsoid", (10 * x, 10 * y, 10 * z))

    def test_axes_of_a_spheroid_are_equal_as_doubles(self):
        """The odd axis is z; a kernel that asks whether a = b gets an answer."""
        found = read_quadric_face(scaled(Part.makeSphere(10), 2, 1, 1).Faces[0])
        self.assertEqual(found.axes[0], found.axes[1])
        self.assertAlmostEqual(found.axes[2], 20, delta=1e-12)

    def test_a_scaled_sphere_keeps_its_directions(self):
        found = read_quadric_face(scaled(Part.makeSphere(10), 2, 1, 0.5).Faces[0])
        for axis, expected in zip(found.axes, (20, 10, 5)):
            self.assertAlmostEqual(axis, expected, delta=1e-11)
        self.assertLess(found.placement.Rotation.Angle, 1e-12)

    def test_surfaces_of_revolution(self):
        x, y = Vector(1, 0, 0), Vector(0, 1, 0)
        for face, kind, axes in (
            (revolved(parabola(), 0, 10, x), "elliptic_paraboloid", (10, 10, 5)),
            (revolved(hyperbola(), -1, 1, y), "one_sheet_hyperboloid", (10, 10, 5)),
            (revolved(hyperbola(), 0, 1, x), "two_sheet_hyperboloid", (5, 5, 10)),
            (parabola().toShape(-10, 10).extrude(Vector(0, 0, 7)), "parabolic_cylinder", None),
        ):
            with self.subTest(kind):
                self.assert_found(placed(face), kind, axes)

    def test_scaled_surfaces_of_revolution(self):
        x, y = Vector(1, 0, 0), Vector(0, 1, 0)
        for face, kind, axes in (
            (revolved(parabola(), 0, 10, x), "elliptic_paraboloid", (10, 20, 5)),
            (revolved(hyperbola(), 0, 1, x), "two_sheet_hyperboloid", (5, 10, 10)),
        ):
            with self.subTest(kind):
                self.assert_found(placed(scaled(face, 1, 2, 1)), kind, axes)
        face = revolved(hyperbola(), -1, 1, y)
        self.assert_found(placed(scaled(face, 2, 1, 1)), "one_sheet_hyperboloid", (20, 10, 5))

    def test_ruled_saddle(self):
        ends = ((-10, 5), (10, -5))
        lines = [Part.makeLine(Vector(-10, y, -z), Vector(10, y, z)) for y, z in ends]
        saddle = Part.makeRuledSurface(*lines)
        found = self.assert_found(saddle, "hyperbolic_paraboloid")
        self.assertTrue(found.identical)
        # Its edges are rulings, which run at 45 degrees to the axes.
        self.assertFalse(found.covered)

    def test_the_side_of_a_saddle_is_that_of_its_normal(self):
        face = patch(lambda xs, ys: (product(xs) - product(ys)) / 20)
        for oriented in (face, face.reversed()):
            found = read_quadric_face(oriented)
            up = found.placement.Rotation.multVec(Vector(0, 0, 1))
            self.assertGreater(up * oriented.normalAt(0.5, 0.5), 0.9)

    def test_bsplines_of_short_numbers_are_decided_over_q(self):
        for bend, kind in ((1, "elliptic_paraboloid"), (-1, "hyperbolic_paraboloid")):
            face = patch(lambda xs, ys: (product(xs) + bend * product(ys) / 2) / 16)
            found = self.assert_found(face, kind)
            self.assertTrue(found.identical)
            self.assertEqual(sorted(found.bounds), ["x", "y"])
            self.assertTrue(found.covered)


class Identity(DocumentTest):
    def test_a_pole_moved_by_the_last_bit_is_noticed(self):
        surface = patch(lambda xs, ys: (product(xs) - product(ys)) / 16).Surface
        poles = surface.getPoles()
        bspline = Part.BSplineSurface()

        def rebuilt():
            bspline.buildFromPolesMultsKnots(
                poles, [3, 3], [3, 3], [0.0, 1.0], [0.0, 1.0], False, False, 2, 2
            )
            return satisfies_quadric(bspline)

        self.assertTrue(rebuilt())
        poles[1][1] = Vector(poles[1][1].x, poles[1][1].y, math.nextafter(poles[1][1].z, 9))
        self.assertFalse(rebuilt())

    def test_many_spans(self):
        """Halving spans of a polynomial surface with short numbers rounds nothing."""
        surface = patch(lambda xs, ys: (product(xs) - product(ys)) / 16).Surface
        bspline = clamped_bspline(surface)
        for knot, multiplicity in ((0.5, 1), (0.25, 2)):
            bspline.insertUKnot(knot, multiplicity, 0.0)
            bspline.insertVKnot(knot, multiplicity, 0.0)
        self.assertEqual((bspline.NbUKnots, bspline.NbVKnots), (4, 4))
        self.assertTrue(satisfies_quadric(bspline))
        bspline.setPole(5, 2, bspline.getPole(5, 2) + Vector(0, 0, 1e-12))
        self.assertFalse(satisfies_quadric(bspline))

    def test_weights(self):
        """A cone over a quarter circle with weights 1, 1, 2 has an exact net."""
        circle = [(5, 0), (5, 5), (0, 5)]
        poles = [[Vector(0, 0, 0), Vector(x, y, 10)] for x, y in circle]
        weights = [[w, w] for w in (1, 1, 2)]
        cone = Part.BSplineSurface()
        cone.buildFromPolesMultsKnots(
            poles, [3, 3], [2, 2], [0.0, 1.0], [0.0, 1.0], False, False, 2, 1, weights
        )
        self.assertTrue(satisfies_quadric(cone))
        # Another pole or weight of the circle would make another cone; two apexes make none.
        cone.setPole(2, 1, Vector(1, 0, 0))
        self.assertFalse(satisfies_quadric(cone))


class Regions(DocumentTest):
    def assert_bounds(self, face, **expected):
        found = read_quadric_face(face)
        self.assertTrue(found.covered)
        self.assertEqual(sorted(found.bounds), sorted(expected))
        for name, pair in expected.items():
            for bound, value in zip(found.bounds[name], pair):
                self.assertAlmostEqual(bound, value, delta=1e-9)

    def sphere(self, *angles):
        shape = Part.makeSphere(10, Vector(), Vector(0, 0, 1), *angles)
        return next(face for face in shape.Faces if isinstance(face.Surface, Part.Sphere))

    def test_whole(self):
        self.assert_bounds(self.sphere(-90, 90, 360))

    def test_heights(self):
        low, high = (10 * math.sin(math.radians(angle)) for angle in (-30, 40))
        self.assert_bounds(self.sphere(-30, 40, 360), z=(low, high))
        self.assert_bounds(self.sphere(-30, 90, 360), z=(low, 10))

    def test_sector(self):
        self.assert_bounds(self.sphere(0, 30, 100), z=(0, 5), angle=(0, math.radians(100)))
        self.assert_bounds(self.sphere(0, 30, 300), z=(0, 5), angle=(0, math.radians(300)))

    def test_cut_by_a_boolean_operation(self):
        """The cut runs through the axis: half a spheroid, which ends in a plane z = 0."""
        whole = scaled(Part.makeSphere(10), 1, 2, 1)
        half = whole.common(Part.makeBox(60, 60, 60, Vector(-30, 0, -30)))
        face = next(face for face in half.Faces if face.Area > 500)
        found = read_quadric_face(face)
        self.assertFalse(found.is_fitted())
        self.assertTrue(found.covered)
        self.assertEqual(list(found.bounds), ["z"])
        low, high = sorted(abs(z) for z in found.bounds["z"])
        self.assertAlmostEqual(low, 0, delta=1e-6)
        self.assertAlmostEqual(high, 20, delta=1e-11)

    def test_a_slanted_edge_is_enclosed(self):
        """The plane at distance 6 from the centre, 30 degrees steep, cuts a circle of radius 8."""
        tilt = math.radians(30)
        normal = Vector(math.sin(tilt), 0, math.cos(tilt))
        box = Part.makeBox(40, 40, 40, Vector(-20, -20, 0))
        position = Placement(normal * 6, Rotation(Vector(0, 0, 1), normal))
        box.Placement = position.multiply(box.Placement)
        cap = Part.makeSphere(10).common(box)
        face = next(face for face in cap.Faces if isinstance(face.Surface, Part.Sphere))
        found = read_quadric_face(face)
        self.assertFalse(found.covered)
        low, high = found.bounds["z"]
        self.assertAlmostEqual(low, 6 * math.cos(tilt) - 8 * math.sin(tilt), delta=1e-6)
        self.assertEqual(high, 10)

    def test_other_edges_are_enclosed_and_told(self):
        cut = Part.makeSphere(10).cut(Part.makeBox(8, 8, 30, Vector(3, 3, -15)))
        face = next(face for face in cut.Faces if isinstance(face.Surface, Part.Sphere))
        found = read_quadric_face(face)
        self.assertFalse(found.covered)
        self.assertEqual(found.bounds, {"z": (-10, 10)})


class Fits(DocumentTest):
    def bumpy(self, bump):
        """A patch of a paraboloid with its middle off by a quarter of the bump."""
        surface = patch(lambda xs, ys: (product(xs) + product(ys)) / 16).Surface.copy()
        surface.setPole(2, 2, surface.getPole(2, 2) + Vector(0, 0, bump))
        return surface.toShape().Faces[0]

    def test_deviation_is_that_of_the_face(self):
        face = self.bumpy(1e-3)
        found = read_quadric_face(face)
        self.assertTrue(found.is_fitted())
        self.assertFalse(found.identical)
        inverse, step = found.placement.inverse(), 1e-4

        def distance(point):
            value = equation_value(found, point)
            slopes = [
                (equation_value(found, point + offset) - value) / step
                for offset in (Vector(step, 0, 0), Vector(0, step, 0), Vector(0, 0, step))
            ]
            return abs(value) / Vector(*slopes).Length

        places = [i / 40 for i in range(41)]
        measured = max(
            distance(inverse.multVec(face.valueAt(u, v)))
            for u, v in itertools.product(places, repeat=2)
        )
        self.assertGreater(measured, 1e-6)
        self.assertAlmostEqual(found.deviation / measured, 1, delta=0.05)

    def test_beyond_the_limit_it_is_refused(self):
        self.assert_refused(self.bumpy(0.5), "up to [0-9.e-]+ mm away")

    def test_the_limit_is_a_part_of_the_size(self):
        """Near the limit one bump is accepted, and refused with four times its height."""
        size = 20
        bump = 1e-3 * FIT_LIMIT * size / read_quadric_face(self.bumpy(1e-3)).deviation
        self.assertTrue(read_quadric_face(self.bumpy(bump / 2)).is_fitted())
        self.assert_refused(self.bumpy(2 * bump), "mm away")

    def test_other_surfaces(self):
        for shape, sentence in (
            (Part.makeTorus(10, 2), "lies on a torus"),
            (Part.makePlane(3, 4), "flat"),
            (Part.makeTorus(10, 2).toNurbs(), "mm away"),
            (Part.Face(Part.makePlane(3, 4).toNurbs().Faces[0]), "flat"),
        ):
            self.assert_refused(shape.Faces[0], sentence)

    def assert_refused(self, face, sentence):
        with self.assertRaisesRegex(NotQuadric, sentence) as caught:
            read_quadric_face(face)
        self.assertEqual(caught.exception.code, "not_quadric")
        self.assertRegex(str(caught.exception), r"^[A-Z][^\n]*[.]$")
