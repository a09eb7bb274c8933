# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset of a quadric in the tree: every kind, region and property, every error, recovery."""

import math

import FreeCAD
import Part
from FreeCAD import Matrix, Placement, Rotation, Vector
from support import DocumentTest, Recovery, base_and_offset, grid, shape_data, volume

from pnsurfaces import make_quadric_offset
from pnsurfaces.quadric_offset import AXES, KINDS, suitable_bounds

# Bounds that suit each kind with half-axes 20, 15, 10.
CASES = {
    "Ellipsoid": None,
    "One-sheet hyperboloid": {"z": (-12, 9)},
    "Two-sheet hyperboloid": {"z": (9, 13)},
    "Elliptic paraboloid": {"z": (0, 10)},
    "Hyperbolic paraboloid": {"x": (-10, 12), "y": (-8, 9)},
    "Parabolic cylinder": {"x": (-10, 12), "y": (-8, 9)},
}
CASES_OF_REVOLUTION = {"Cylinder": {"z": (-5, 5)}, "Cone": {"z": (4, 10)}}


def _gradients(a, b, c):
    """Value and outward gradient of each kind's equation, the side of a positive distance."""

    def central(signs, constant):
        def both(p):
            terms = [s * x / h**2 for s, x, h in zip(signs, p, (a, b, c))]
            return sum(t * x for t, x in zip(terms, p)) + constant, Vector(*terms)

        return both

    def graph(k, m, up):
        def both(p):
            slope = Vector(2 * k * p.x, 2 * m * p.y, -1)
            return k * p.x**2 + m * p.y**2 - p.z, -slope if up else slope

        return both

    return {
        "Ellipsoid": central((1, 1, 1), -1),
        "One-sheet hyperboloid": central((1, 1, -1), -1),
        "Two-sheet hyperboloid": central((1, 1, -1), 1),
        "Cylinder": central((1, 1, 0), -1),
        "Cone": central((1, 1, -1), 0),
        "Elliptic paraboloid": graph(c / a**2, c / b**2, False),
        "Hyperbolic paraboloid": graph(c / a**2, -c / b**2, True),
        "Parabolic cylinder": graph(c / a**2, 0, False),
    }


class QuadricOffsetTest(DocumentTest):
    def make(self, kind, distance, **properties):
        if kind in CASES_OF_REVOLUTION:
            return make_quadric_offset(
                kind,
                20,
                20,
                10,
                distance,
                bounds=CASES_OF_REVOLUTION[kind],
                document=self.document,
                **properties,
            )
        return make_quadric_offset(
            kind, 20, 15, 10, distance, bounds=CASES[kind], document=self.document, **properties
        )

    def ball(self, *scale):
        matrix = Matrix()
        matrix.scale(*scale)
        return self.face_object(Part.makeSphere(10).transformGeometry(matrix), "Ball")


class Kinds(QuadricOffsetTest):
    def test_base_offset_and_side(self):
        for kind in [*CASES, *CASES_OF_REVOLUTION]:
            with self.subTest(kind):
                obj = self.make(kind, 0.5, Sides="Base and offset")
                self.assert_valid(obj)
                self.assert_offset(obj, 0.5)
                axes = (getattr(obj, name).Value for name in AXES)
                equation = _gradients(*axes)[kind]
                for base, offset in base_and_offset(obj):
                    value, gradient = equation(base)
                    self.assertLess(abs(value), 1e-10)
                    self.assertAlmostEqual((offset - base) * gradient.normalize(), 0.5, delta=1e-9)

    def test_only_the_properties_of_kind_and_region_are_shown(self):
        obj = self.make("Ellipsoid", 0)
        every = (*AXES, "Face", "Region", "MinX", "MaxZ", "MinAngle")
        for kind, region, shown in (
            ("Ellipsoid", "Whole", {*AXES, "Region"}),
            ("Cylinder", "Heights", {"HalfAxisA", "Region", "MaxZ"}),
            ("Cone", "Heights", {"HalfAxisA", "HalfAxisC", "Region", "MaxZ"}),
            ("Parabolic cylinder", "Rectangle", {"HalfAxisA", "HalfAxisC", "Region", "MinX"}),
            ("Ellipsoid", "Box", {*AXES, "Region", "MinX", "MaxZ"}),
            ("Ellipsoid", "Sector", {*AXES, "Region", "MaxZ", "MinAngle"}),
            ("Of a face", "Sector", {"Face"}),
        ):
            obj.Kind, obj.Region = kind, region
            visible = {name for name in every if "Hidden" not in obj.getEditorMode(name)}
            self.assertEqual(visible, shown)

    def test_limits_of_an_ellipsoid(self):
        """Inwards the smallest radius of curvature, c^2 / a at the end of the longest axis."""
        obj = make_quadric_offset("Ellipsoid", 30, 20, 10, -3)
        self.assertEqual(obj.Status, "Valid")
        self.assertAlmostEqual(obj.MinOffset.Value, -10 / 3, delta=1e-5)
        self.assertEqual(obj.MaxOffset.Value, math.inf)
        obj.Distance = -4
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())
        self.assertRegex(obj.Status, "^Warning: At -4 mm, beyond the limit of -3.33")

    def test_expression_and_placement(self):
        placement = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
        obj = make_quadric_offset("Ellipsoid", 20, 20, 20, 1, placement=placement)
        self.assert_valid(obj)
        obj.setExpression("Distance", "HalfAxisA / 10")
        self.document.recompute()
        self.assertEqual(obj.Placement, placement)
        for face in obj.Shape.Faces:
            for u, v in grid(face.Surface, 5):
                self.assertAlmostEqual((face.valueAt(u, v) - placement.Base).Length, 22, delta=1e-9)


class Solids(QuadricOffsetTest):
    def test_sphere(self):
        obj = make_quadric_offset("Ellipsoid", 10, 10, 10, 2, Output="Solid")
        self.assert_valid(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")
        self.assertAlmostEqual(volume(obj) / (4 / 3 * math.pi * 12**3), 1, delta=1e-9)

    def test_ellipsoid_agrees_with_steiner(self):
        """V(d) is a cubic with V(0) = 4/3 pi a b c and third derivative 8 pi."""
        volumes = []
        for distance in range(4):
            obj = make_quadric_offset("Ellipsoid", 20, 15, 10, distance, Output="Solid")
            self.assert_valid(obj)
            volumes.append(volume(obj))
        v0, v1, v2, v3 = volumes
        self.assertAlmostEqual(v0 / (4 / 3 * math.pi * 20 * 15 * 10), 1, delta=1e-9)
        self.assertAlmostEqual((v3 - 3 * v2 + 3 * v1 - v0) / (8 * math.pi), 1, delta=1e-6)

    def test_wall_of_an_ellipsoid(self):
        inner, outer = (
            make_quadric_offset("Ellipsoid", 20, 15, 10, distance, Output="Solid")
            for distance in (-1, 1)
        )
        wall = make_quadric_offset("Ellipsoid", 20, 15, 10, 1, Sides="Both sides", Output="Solid")
        self.assert_valid(wall)
        self.assertEqual(len(wall.Shape.Shells), 2)
        self.assertAlmostEqual(volume(wall) / (volume(outer) - volume(inner)), 1, delta=1e-9)

    def test_cylinder(self):
        bounds = {"z": (0, 10)}
        obj = make_quadric_offset("Cylinder", 5, distance=1, bounds=bounds, Output="Solid")
        self.assert_valid(obj)
        self.assertAlmostEqual(volume(obj) / (math.pi * 36 * 10), 1, delta=1e-10)

    def test_walls_of_open_surfaces(self):
        """V(d) of the wall between -d and d is odd: V / d runs with d^2."""
        for kind in ("One-sheet hyperboloid", "Elliptic paraboloid", "Hyperbolic paraboloid"):
            with self.subTest(kind):
                walls = []
                for distance in (0.5, 1, 1.5):
                    wall = self.make(kind, distance, Sides="Both sides", Output="Solid")
                    self.assert_valid(wall)
                    walls.append(volume(wall) / distance)
                v1, v2, v3 = walls
                self.assertGreater(v1, 0)
                self.assertAlmostEqual((v2 - v1) / 3, (v3 - v2) / 5, delta=1e-6 * v1)

    def test_an_open_end_that_is_not_flat_is_told(self):
        obj = self.make("Hyperbolic paraboloid", 1, Output="Solid")
        self.assert_error(obj, "not flat: it leaves its plane by up to ")


class Regions(QuadricOffsetTest):
    def test_bounds_of_the_base(self):
        for bounds in ({"z": (-5, 8)}, {"z": (0, 5), "angle": (0, 90)}):
            with self.subTest(sorted(bounds)):
                obj = make_quadric_offset("Ellipsoid", 20, 15, 10, bounds=bounds)
                self.assert_valid(obj)
                low, high = bounds["z"]
                points = [
                    face.valueAt(u, v)
                    for face in obj.Shape.Faces
                    for u, v in grid(face.Surface)
                    if face.isPartOfDomain(u, v)
                ]
                self.assertGreaterEqual(min(point.z for point in points), low - 1e-9)
                self.assertLessEqual(max(point.z for point in points), high + 1e-9)
                if "angle" in bounds:
                    self.assertGreaterEqual(min(min(p.x, p.y) for p in points), -1e-9)
                heights = [vertex.Z for vertex in obj.Shape.Vertexes]
                self.assertAlmostEqual(min(heights), low, delta=1e-9)
                self.assertAlmostEqual(max(heights), high, delta=1e-9)

    def test_two_parts_are_two_shells_or_two_walls(self):
        """Above and below a rectangle an ellipsoid has two parts that mirror each other."""
        region = {"x": (-6, 10), "y": (-6, 6)}
        caps = make_quadric_offset("Ellipsoid", 20, 15, 10, 1, bounds=region)
        self.assert_valid(caps)
        self.assertEqual(len(caps.Shape.Shells), 2)
        low, high = sorted([v.Z for v in shell.Vertexes] for shell in caps.Shape.Shells)
        self.assertGreater(min(high), 0)
        self.assertAlmostEqual(min(high), -max(low), delta=1e-9)
        walls = make_quadric_offset(
            "Ellipsoid", 20, 15, 10, 1, bounds=region, Sides="Both sides", Output="Solid"
        )
        self.assert_valid(walls)
        volumes = [solid.Volume for solid in walls.Shape.Solids]
        self.assertEqual(len(volumes), 2)
        self.assertAlmostEqual(volumes[0], volumes[1], delta=1e-6 * volumes[0])
        self.assertGreater(volumes[0], 0)

    def test_angles_are_degrees_and_lengths_take_units(self):
        obj = make_quadric_offset(
            "Ellipsoid", 20, 15, 10, bounds={"z": (0, "0.5 cm"), "angle": (0, "0.25 rad")}
        )
        self.assertEqual(obj.Region, "Sector")
        self.assertEqual(obj.MaxZ.Value, 5)
        self.assertAlmostEqual(obj.MaxAngle.Value, math.degrees(0.25), delta=1e-12)

    def test_a_whole_turn_ends_nothing(self):
        around, sector = (
            make_quadric_offset("Ellipsoid", 20, 15, 10, bounds=bounds)
            for bounds in ({"z": (-5, 5)}, {"z": (-5, 5), "angle": (-90, 270)})
        )
        self.assert_valid(sector)
        self.assertEqual(shape_data(sector.Shape), shape_data(around.Shape))

    def test_suitable_bounds_suit(self):
        """The panel begins with them: every region that it offers makes a surface."""
        obj = make_quadric_offset("Ellipsoid", 20, 15, 10)
        for title, kind in KINDS.items():
            obj.Kind = title
            for name, value in suitable_bounds(obj).items():
                setattr(obj, name, value)
            for region in kind.regions:
                with self.subTest(kind=title, region=region):
                    obj.Region = region
                    self.document.recompute()
                    self.assert_valid(obj)

    def test_angles_beyond_a_whole_turn(self):
        for angle in ((0, 400), ("-7 rad", 0)):
            with self.assertRaisesRegex(ValueError, "is not between -360° and 360°"):
                make_quadric_offset("Ellipsoid", 20, 15, 10, bounds={"z": (0, 5), "angle": angle})

    def test_bounds_without_a_region(self):
        before = self.document.Objects
        with self.assertRaisesRegex(ValueError, "No region has the bounds x"):
            make_quadric_offset("Ellipsoid", 20, 15, 10, bounds={"x": (0, 1)})
        self.assertEqual(self.document.Objects, before)


class Faces(QuadricOffsetTest):
    def assert_distance_to(self, obj, face, distance):
        for own in obj.Shape.Faces:
            for u, v in grid(own.Surface, 5):
                point = Part.Vertex(own.valueAt(u, v))
                self.assertAlmostEqual(face.distToShape(point)[0], distance, delta=1e-6)

    def test_sphere(self):
        ball = self.face_object(Part.makeSphere(10, Vector(1, 2, 3)))
        obj = make_quadric_offset(ball, distance=2)
        self.assert_valid(obj)
        self.assertEqual(obj.Recognised, "Ellipsoid with a = 10 mm, b = 10 mm, c = 10 mm")
        self.assertTrue(obj.Exact)
        self.assertEqual(obj.Placement.Base, Vector(1, 2, 3))
        for face in obj.Shape.Faces:
            for u, v in grid(face.Surface, 5):
                radius = (face.valueAt(u, v) - Vector(1, 2, 3)).Length
                self.assertAlmostEqual(radius, 12, delta=1e-9)

    def test_scaled_sphere_in_any_position(self):
        source, name = self.ball(2, 1, 0.5)
        source.Placement = Placement(Vector(10, 20, 30), Rotation(30, 40, 50))
        obj = make_quadric_offset((source, name), distance=1)
        self.assert_valid(obj)
        self.assertEqual((obj.Status, obj.Exact), ("Valid", True))
        self.assertRegex(obj.FaceDeviation, r"^\d.\de-1[0-9] mm$")
        self.assert_distance_to(obj, source.Shape.Faces[0], 1)

    def test_it_follows_the_face(self):
        source, name = self.ball(2, 1, 0.5)
        obj = make_quadric_offset((source, name), distance=1)
        source.Placement = Placement(Vector(0, 0, 50), Rotation())
        self.document.recompute()
        self.assertAlmostEqual(obj.Placement.Base.z, 50, delta=1e-12)
        self.assert_distance_to(obj, source.Shape.Faces[0], 1)
        self.assertNotIn("Touched", obj.State)

    def test_coordinates_are_those_of_the_container(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = Placement(Vector(100, 0, 0), Rotation(Vector(0, 0, 1), 90))
        source, name = self.face_object(Part.makeSphere(10, Vector(1, 2, 3)))
        part.addObject(source)
        outside = make_quadric_offset((source, name))
        expected = part.Placement.multVec(Vector(1, 2, 3))
        self.assertLess((outside.Placement.Base - expected).Length, 1e-12)
        part.addObject(outside)
        outside.touch()
        self.document.recompute()
        self.assertLess((outside.Placement.Base - Vector(1, 2, 3)).Length, 1e-12)

    def test_a_fitted_face_is_told(self):
        source, _ = self.ball(2, 1, 0.5)
        surface = source.Shape.Faces[0].Surface.copy()
        surface.setPole(2, 3, surface.getPole(2, 3) + Vector(1e-4, 0, 0))
        obj = make_quadric_offset(self.face_object(surface.toShape()), distance=1)
        self.assert_valid(obj)
        self.assertFalse(obj.Exact)
        self.assertRegex(obj.Notes[0], r"^The face is no quadric exactly: it lies within \d")
        self.assertIn(obj.Notes[0], obj.Status)

    def test_part_of_a_cylinder_or_cone_gives_all_of_it_around(self):
        for shape in (
            Part.makeCylinder(5, 10, Vector(), Vector(0, 0, 1), 180),
            Part.makeCone(5, 2, 10, Vector(), Vector(0, 0, 1), 120),
        ):
            with self.subTest(shape.Faces[0].Surface.TypeId):
                obj = make_quadric_offset(self.face_object(shape), distance=1)
                self.assert_valid(obj)
                self.assertIn("the offset is that of a region around it", obj.Status)

    def test_a_region_around_the_face_is_told(self):
        cut = Part.makeSphere(10).cut(Part.makeBox(8, 8, 30, Vector(3, 3, -15)))
        number = next(i for i, f in enumerate(cut.Faces) if isinstance(f.Surface, Part.Sphere))
        obj = make_quadric_offset((self.shape_object(cut), f"Face{number + 1}"), distance=1)
        self.assert_valid(obj)
        self.assertIn("ends along other lines", obj.Status)


class Errors(Recovery, QuadricOffsetTest):
    def setUp(self):
        super().setUp()
        self.remember(make_quadric_offset("Ellipsoid", 20, 15, 10, 1, document=self.document))

    def test_half_axes(self):
        for value, sentence in ((0, "positive"), (-3, "positive"), (math.nan, "not a finite number")):
            with self.subTest(value):
                self.obj.HalfAxisB = value
                self.assert_fails_and_recovers(sentence, lambda: setattr(self.obj, "HalfAxisB", 15))

    def test_bounds(self):
        for low, high, sentence in (
            (3, 1, "bounds"),
            (2, 2, "bounds"),
            (math.nan, 2, "not a finite number"),
            (20, 30, "miss"),
        ):
            with self.subTest(sentence):
                self.obj.Region, self.obj.MinZ, self.obj.MaxZ = "Heights", low, high
                self.assert_fails_and_recovers(sentence, lambda: setattr(self.obj, "Region", "Whole"))

    def test_sectors(self):
        for low, high, sentence in (
            (90, 0, "The sector is empty: from 90° to 0°."),
            (30, 30, "The sector is empty: from 30° to 30°."),
            (0, math.nan, "not a finite number"),
        ):
            with self.subTest(sentence):
                self.obj.Region, self.obj.MinZ, self.obj.MaxZ = "Sector", -5, 5
                self.obj.MinAngle, self.obj.MaxAngle = low, high
                self.assert_fails_and_recovers(sentence, lambda: setattr(self.obj, "Region", "Whole"))

    def test_a_wall_without_thickness(self):
        for distance in (0, 1e-9):
            with self.subTest(distance):
                self.obj.Sides, self.obj.Output, self.obj.Distance = "Both sides", "Solid", distance
                self.assert_fails_and_recovers("mm thick. Give it a distance.", self.repair)

    def repair(self):
        self.obj.Sides, self.obj.Output, self.obj.Distance = "Offset", "Surface", 1

    def test_a_surface_without_end(self):
        self.obj.Kind = "One-sheet hyperboloid"
        self.assert_fails_and_recovers("", lambda: setattr(self.obj, "Kind", "Ellipsoid"))

    def test_not_rational(self):
        matrix = Matrix()
        matrix.scale(2, 1, 1)
        tube = Part.makeCylinder(5, 10).transformGeometry(matrix)
        self.obj.Kind, self.obj.Face = "Of a face", self.face_object(tube)
        self.assert_fails_and_recovers("not rational", lambda: setattr(self.obj, "Kind", "Ellipsoid"))

    def test_face_deleted(self):
        source, name = self.ball(2, 1.5, 1)
        self.obj.Face = (source, [name])
        self.obj.Kind = "Of a face"
        self.document.recompute()
        self.assertTrue(self.obj.isValid(), self.obj.getStatusString())
        recognised = self.obj.Recognised
        self.document.removeObject(source.Name)
        self.document.recompute()
        self.assert_error(self.obj, "The face is missing.")
        self.assertEqual(self.obj.Recognised, recognised)
        self.assertFalse(self.obj.Shape.isNull())

    def test_face_that_is_no_quadric(self):
        torus, name = self.face_object(Part.makeTorus(10, 2))
        self.obj.Face = (torus, [name])
        self.obj.Kind = "Of a face"
        self.assert_fails_and_recovers(
            "lies on a torus", lambda: setattr(self.obj, "Kind", "Ellipsoid")
        )

    def test_nothing_is_left_of_a_wrong_call(self):
        before = self.document.Objects
        for properties in ({"Colour": "red"}, {"Output": "Mesh"}):
            with self.assertRaises((AttributeError, ValueError)):
                make_quadric_offset("Ellipsoid", **properties)
        with self.assertRaises(ValueError):
            make_quadric_offset("Paraboloid")
        self.assertEqual(self.document.Objects, before)


class Storage(QuadricOffsetTest):
    def test_a_document_keeps_everything(self):
        source, name = self.ball(2, 1, 0.5)
        made = make_quadric_offset((source, name), distance=1, name="Shell")
        names = [
            "Kind",
            "HalfAxisA",
            "Region",
            "MinZ",
            "MaxAngle",
            "Recognised",
            "FaceDeviation",
            "Degree",
            "Status",
        ]
        modes = {name: made.getEditorMode(name) for name in ("HalfAxisA", "Face", "MinZ")}
        values = {name: str(getattr(made, name)) for name in names}
        poles = [_poles(face) for face in made.Shape.Faces]
        placement = made.Placement
        path = str(self.folder / "shell.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        obj = self.document.Shell
        self.assertEqual({name: str(getattr(obj, name)) for name in values}, values)
        # FreeCAD stores a placement with 16 decimals.
        for number, stored in zip(placement.toMatrix().A, obj.Placement.toMatrix().A):
            self.assertAlmostEqual(number, stored, delta=1e-14)
        self.assertEqual({name: obj.getEditorMode(name) for name in modes}, modes)
        self.assertEqual(obj.Face[0].Name, "Ball")
        for face, saved in zip(obj.Shape.Faces, poles):
            for pole, saved_pole in zip(_poles(face), saved):
                self.assertLess((pole - saved_pole).Length, 1e-12)
        self.assertNotIn("Touched", obj.State)
        obj.touch()
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())


def _poles(face):
    return [pole for row in face.Surface.getPoles() for pole in row]
