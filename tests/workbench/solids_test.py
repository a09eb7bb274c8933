# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of every kind of surface: ends, walls, measures, and what FreeCAD's tools make of them."""

import math

import FreeCAD
import Part
import PartDesign  # noqa: F401  (its types are known to the document only after that)
from FreeCAD import Placement, Rotation, Vector
from support import DocumentTest, shape_data

from pnsurfaces import kernel, make_canal_surface, make_quadric_offset, make_ruled_offset
from pnsurfaces.edge_chain import CONFUSION

BEND = [Vector(0, 0, 0), Vector(15, 5, 0), Vector(20, 15, 5), Vector(20, 20, 0)]

# The curves of a blade; its regular range is -5.7 to 12.8 mm.
ROOT = [Vector(0, 0, 0), Vector(10, 5, 0), Vector(20, -5, 3), Vector(30, 0, 0)]
TIP = [Vector(0, 15, 5), Vector(12, 18, 0), Vector(20, 20, 2), Vector(33, 14, 6)]


class SolidsTest(DocumentTest):
    def bezier_object(self, poles):
        curve = Part.BezierCurve()
        curve.setPoles(poles)
        return self.shape_object(curve.toShape(), "Bezier")

    def bend(self):
        return self.bezier_object(BEND)

    def pipe(self, radius=2, distance=0, **properties):
        return make_canal_surface(self.bend(), radius, distance, Output="Solid", **properties)

    def blade(self, distance=1, **properties):
        curves = self.bezier_object(ROOT), self.bezier_object(TIP)
        return make_ruled_offset(*curves, distance, Output="Solid", **properties)

    def saddle(self, distance=1, **properties):
        bounds = {"x": (-10, 12), "y": (-8, 9)}
        return make_quadric_offset(
            "Hyperbolic paraboloid", 20, 15, 10, distance, bounds=bounds, Output="Solid", **properties
        )

    def assert_fit_for_tools(self, obj, solids=1):
        """Closed, oriented, of the smallest tolerance, and the Boolean check finds nothing."""
        self.assert_valid(obj)
        shape = obj.Shape
        shape.check(True)  # raises ValueError with what it finds
        self.assertEqual(len(shape.Solids), solids)
        self.assertTrue(all(shell.isClosed() for shell in shape.Shells))
        for kind in (shape.Vertexes, shape.Edges, shape.Faces):
            self.assertEqual({part.Tolerance for part in kind}, {CONFUSION})
        self.assertGreater(obj.Volume.Value, 0)


def bend_length():
    curve = Part.BezierCurve()
    curve.setPoles(BEND)
    return curve.length()


def capsule(radius, length):
    return math.pi * radius**2 * length + 4 / 3 * math.pi * radius**3


class Caps(SolidsTest):
    def test_capsule(self):
        for lines in ("Even", "Lowest degree"):
            with self.subTest(lines):
                obj = make_canal_surface(
                    self.line_object(10),
                    2,
                    0.5,
                    Output="Solid",
                    Caps="Spherical",
                    ParameterLines=lines,
                )
                self.assert_fit_for_tools(obj)
                self.assertAlmostEqual(obj.Volume.Value / capsule(2.5, 10), 1, delta=1e-12)
                self.assertTrue(obj.Exact)

    def test_bent_pipe(self):
        domed = self.pipe(Caps="Spherical")
        self.assert_fit_for_tools(domed)
        self.assertEqual(len(domed.Shape.Faces), 3)
        self.assertAlmostEqual(domed.Volume.Value / capsule(2, bend_length()), 1, delta=1e-9)
        flat = self.pipe()
        self.assertEqual(flat.Caps, "Flat")
        self.assert_fit_for_tools(flat)
        balls = domed.Volume.Value - flat.Volume.Value
        self.assertAlmostEqual(balls / (4 / 3 * math.pi * 8), 1, delta=1e-10)

    def test_caps_touch_the_end_spheres(self):
        obj = self.pipe((2, 3), 0.25, Caps="Spherical")
        self.assert_fit_for_tools(obj)
        _, *caps = obj.Shape.Faces
        for cap in caps:
            middle = cap.Surface.value(0, 0)
            centre, radius = min(
                ((BEND[0], 2.25), (BEND[-1], 3.25)), key=lambda end: middle.distanceToPoint(end[0])
            )
            for edge in cap.Edges:
                for point in edge.discretize(20):
                    self.assertAlmostEqual((point - centre).Length, radius, delta=1e-12)
            self.assertAlmostEqual((middle - centre).Length, radius, delta=1e-12)

    def test_a_hollow_pipe_becomes_a_vessel(self):
        obj = self.pipe(2, 0.5, Sides="Both sides", Caps="Spherical")
        self.assert_fit_for_tools(obj)
        self.assertEqual(len(obj.Shape.Shells), 2)
        wall = capsule(2.5, bend_length()) - capsule(1.5, bend_length())
        self.assertAlmostEqual(obj.Volume.Value / wall, 1, delta=1e-9)

    def test_without_caps_a_hollow_pipe_is_open(self):
        flat, none = (self.pipe(2, 0.5, Sides="Both sides", Caps=c) for c in ("Flat", "None"))
        self.assert_fit_for_tools(none)
        self.assertEqual(shape_data(none.Shape), shape_data(flat.Shape))

    def test_without_caps_only_a_closed_pipe_is_solid(self):
        ring = self.shape_object(Part.makeCircle(20))
        obj = make_canal_surface(ring, 2, Output="Solid", Caps="None")
        self.assert_fit_for_tools(obj)
        obj.Spine = (self.bend(), [])
        self.document.recompute()
        self.assert_error(obj, "Without caps the pipe has open ends and encloses no solid.")
        obj.Output = "Surface"
        self.document.recompute()
        self.assert_valid(obj)
        self.assertFalse(obj.Shape.isClosed())

    def test_a_pointed_end_needs_no_cap(self):
        obj = make_canal_surface(self.line_object(10), (2, 0), Output="Solid", Caps="Spherical")
        self.assert_fit_for_tools(obj)
        # A cone from the tip touches the ball of radius 2 at the start.
        sine = 0.2
        height, base = 10 * (1 - sine**2), 2 * math.sqrt(1 - sine**2)
        segment = 2 * (1 + sine)
        exact = math.pi * (base**2 * height / 3 + segment**2 * (3 * 2 - segment) / 3)
        self.assertAlmostEqual(obj.Volume.Value / exact, 1, delta=1e-12)


class TwoOffsets(SolidsTest):
    def test_a_wall_away_from_the_base(self):
        for make in (self.pipe, self.blade, self.saddle):
            with self.subTest(make.__name__):
                obj = make(distance=1, Sides="Two offsets", SecondDistance=0.25)
                self.assert_fit_for_tools(obj)
                thick, thin = (make(distance=d, Sides="Base and offset") for d in (1, 0.25))
                difference = thick.Volume.Value - thin.Volume.Value
                self.assertAlmostEqual(obj.Volume.Value / difference, 1, delta=1e-9)

    def test_order_does_not_matter(self):
        first = self.pipe(2, 1, Sides="Two offsets", SecondDistance=-0.5)
        second = self.pipe(2, -0.5, Sides="Two offsets", SecondDistance=1)
        self.assertEqual(shape_data(first.Shape), shape_data(second.Shape))

    def test_equal_distances_are_no_wall(self):
        obj = self.pipe(2, 1, Sides="Two offsets", SecondDistance=1)
        self.assert_error(obj, "mm thick. Give it a distance.")

    def test_the_second_distance_is_shown_only_then(self):
        obj = self.pipe()
        self.assertIn("Hidden", obj.getEditorMode("SecondDistance"))
        obj.Sides = "Two offsets"
        self.assertEqual(obj.getEditorMode("SecondDistance"), [])
        obj.Sides = "Offset"
        self.assertIn("Hidden", obj.getEditorMode("SecondDistance"))

    def test_a_limit_is_told_for_both(self):
        obj = self.saddle(1, Sides="Two offsets", SecondDistance=-15)
        self.assertIn("At -15 mm, beyond the limit", obj.Status)


class Measures(SolidsTest):
    def test_volume_and_area_are_those_of_the_shape(self):
        obj = self.blade(Sides="Both sides")
        brep = obj.Shape.exportBrepToString()
        self.assertEqual(obj.Volume.Value, kernel.pnocct().volume(brep))
        self.assertEqual(obj.Area.Value, kernel.pnocct().area(brep))
        self.assertRegex(obj.VolumeError, r"^\d\.\de-\d\d mm\^3$")
        self.assertRegex(obj.AreaError, r"^\d\.\de-\d\d mm\^2$")

    def test_a_surface_has_an_area_only(self):
        obj = make_canal_surface(self.line_object(10), 2, 0.5)
        self.assertAlmostEqual(obj.Area.Value / (2 * math.pi * 2.5 * 10), 1, delta=1e-13)
        self.assertEqual((obj.Volume.Value, obj.VolumeError), (0, ""))

    def test_a_placement_changes_nothing(self):
        obj = self.pipe()
        before = obj.Volume.Value
        obj.Placement = Placement(Vector(100, 200, 300), Rotation(10, 20, 30))
        obj.Radius = 2
        obj.touch()
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value / before, 1, delta=1e-10)

    def test_the_error_covers_the_true_one(self):
        for obj, exact in (
            (self.pipe(Caps="Spherical"), capsule(2, bend_length())),
            (
                make_quadric_offset("Ellipsoid", 5, 5, 5, 2, Sides="Base and offset", Output="Solid"),
                4 / 3 * math.pi * (7**3 - 5**3),
            ),
        ):
            error = float(obj.VolumeError.removesuffix(" mm^3"))
            # The length of the bend is known to 1e-10 only.
            self.assertLessEqual(abs(obj.Volume.Value - exact), error + 1e-8)
            self.assertLess(error, 1e-6)

    def test_steiner(self):
        """V(d) of the wall between 0 and d is a cubic in d without constant term."""
        for make in (self.pipe, self.blade, self.saddle):
            with self.subTest(make.__name__):
                walls = [make(distance=0.3 * i, Sides="Base and offset") for i in range(1, 5)]
                v1, v2, v3, v4 = (wall.Volume.Value for wall in walls)
                self.assertAlmostEqual((4 * v1 - 6 * v2 + 4 * v3 - v4) / v4, 0, delta=1e-9)


class Parts(SolidsTest):
    def test_two_parts_are_two_solids(self):
        region = {"x": (-6, 10), "y": (-6, 6)}
        obj = make_quadric_offset(
            "Ellipsoid", 20, 15, 10, 1, bounds=region, Output="Solid", Sides="Base and offset"
        )
        self.assert_fit_for_tools(obj, solids=2)
        first, second = (solid.exportBrepToString() for solid in obj.Shape.Solids)
        volumes = kernel.pnocct().volume(first), kernel.pnocct().volume(second)
        self.assertAlmostEqual(volumes[0] / volumes[1], 1, delta=1e-9)
        self.assertAlmostEqual(sum(volumes) / obj.Volume.Value, 1, delta=1e-12)


class OldDocuments(SolidsTest):
    def test_new_choices_and_properties_appear(self):
        obj = self.pipe(name="Pipe")
        for name in ("Caps", "SecondDistance", "Volume", "VolumeError", "Area", "AreaError"):
            obj.removeProperty(name)
        obj.Sides = ["Offset", "Base and offset", "Both sides"]
        obj.Sides = "Both sides"
        path = str(self.folder / "pipe.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        obj = self.document.getObject("Pipe")
        self.assertEqual((obj.Sides, obj.Caps), ("Both sides", "Flat"))
        obj.Sides = "Two offsets"
        obj.Distance, obj.SecondDistance = 1, 0.5
        self.document.recompute()
        self.assert_fit_for_tools(obj)


class Tools(SolidsTest):
    """What users do next with a solid: each kind of surface, each tool."""

    def solids(self):
        yield "flat pipe", self.pipe()
        yield "capsule", self.pipe((2, 3), Caps="Spherical")
        yield "vessel", self.pipe(2, 0.4, Sides="Both sides", Caps="Spherical")
        yield "wall of a pipe", self.pipe(2, 0.4, Sides="Both sides")
        yield "blade", self.blade(Sides="Both sides")
        yield "saddle", self.saddle(Sides="Both sides")
        yield "bowl", make_quadric_offset(
            "Ellipsoid", 20, 15, 10, 1, bounds={"z": (-6, 5)}, Output="Solid", Sides="Base and offset"
        )
        yield "ellipsoid", make_quadric_offset("Ellipsoid", 20, 15, 10, 1, Output="Solid")

    def corner(self, shape):
        """Where a box begins that takes about a half of a shape."""
        return shape.CenterOfMass + Vector(-0.123, -99.783, -98.311)

    def box(self, shape):
        return Part.makeBox(200, 200, 200, self.corner(shape))

    def test_cut_fuse_common_section(self):
        for name, obj in self.solids():
            with self.subTest(name):
                self.assert_fit_for_tools(obj)
                solid, box = obj.Shape, self.box(obj.Shape)
                results = solid.cut(box), solid.common(box), solid.fuse(box)
                for result in results:
                    self.assertTrue(result.isValid())
                cut, common, fused = map(volume_of, results)
                self.assertGreater(min(cut, common), 0.1 * obj.Volume.Value)
                # OpenCASCADE fits the section curves.
                self.assertAlmostEqual((cut + common) / obj.Volume.Value, 1, delta=1e-6)
                self.assertAlmostEqual(
                    (fused + common) / (obj.Volume.Value + box.Volume), 1, delta=1e-6
                )
                section = solid.section(box)
                self.assertTrue(section.isValid())
                self.assertGreater(section.Length, 1)

    def test_slice_with_a_plane(self):
        normal = Vector(1, 0.2, 0.1).normalize()
        for name, obj in self.solids():
            with self.subTest(name):
                wires = obj.Shape.slice(normal, normal.dot(obj.Shape.CenterOfMass))
                self.assertGreater(len(wires), 0)
                self.assertTrue(all(wire.isClosed() for wire in wires))

    def test_fillet_of_an_edge_of_the_cut_body(self):
        for name, obj in self.solids():
            with self.subTest(name):
                cut = obj.Shape.cut(self.box(obj.Shape))
                edge = edges_of_planes(cut)[0]
                filleted = cut.makeFillet(0.05, [edge])
                self.assertTrue(filleted.isValid())
                self.assertNotAlmostEqual(volume_of(filleted), volume_of(cut), delta=1e-4)

    def test_in_a_body(self):
        for name, obj in self.solids():
            with self.subTest(name):
                body = self.document.addObject("PartDesign::Body", "Body")
                body.BaseFeature = obj
                cutter = body.newObject("PartDesign::SubtractiveBox", "Cutter")
                cutter.Length = cutter.Width = cutter.Height = 200
                cutter.Placement = Placement(self.corner(obj.Shape), Rotation())
                self.document.recompute()
                self.assertTrue(cutter.isValid(), cutter.getStatusString())
                cut = volume_of(obj.Shape.cut(self.box(obj.Shape)))
                self.assertAlmostEqual(volume_of(body.Shape) / cut, 1, delta=1e-6)
                fillet = body.newObject("PartDesign::Fillet", "Fillet")
                edge = edges_of_planes(cutter.Shape)[0]
                names = [f"Edge{i}" for i, e in enumerate(cutter.Shape.Edges, 1) if e.isSame(edge)]
                fillet.Base = (cutter, names)
                fillet.Radius = 0.05
                self.document.recompute()
                self.assertTrue(fillet.isValid(), fillet.getStatusString())
                self.assertTrue(body.Shape.isValid())

    def test_through_a_binder(self):
        obj = self.pipe(Caps="Spherical")
        body = self.document.addObject("PartDesign::Body", "Body")
        binder = body.newObject("PartDesign::SubShapeBinder", "Binder")
        binder.Support = [(obj, "")]
        self.document.recompute()
        self.assertTrue(binder.isValid(), binder.getStatusString())
        self.assertAlmostEqual(volume_of(binder.Shape) / obj.Volume.Value, 1, delta=1e-12)
        before = volume_of(binder.Shape)
        obj.Radius = 2.5
        self.document.recompute()
        self.assertGreater(volume_of(binder.Shape), 1.2 * before)


def volume_of(shape):
    return kernel.pnocct().volume(shape.exportBrepToString())


def edges_of_planes(shape):
    """The edges on planar faces, the longest first."""
    edges = [
        edge for face in shape.Faces if isinstance(face.Surface, Part.Plane) for edge in face.Edges
    ]
    return sorted(edges, key=lambda edge: -edge.Length)
