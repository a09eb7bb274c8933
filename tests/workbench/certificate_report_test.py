# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate says what the kernel proves and what is so; it is plain data."""

import json
import math
import unittest

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector
from support import RADII, DocumentTest

import pnsurfaces
from pnsurfaces import make_canal_surface, make_quadric_offset, make_ruled_offset
from pnsurfaces.certificate_text import as_markdown

# Of a sample in doubles, in mm, on surfaces of up to 100 mm.
ROUNDING = 1e-12


class Certificates(DocumentTest):
    def entry(self, obj, compare=False):
        report = pnsurfaces.certificate([obj], compare=compare)
        self.assertEqual(json.loads(json.dumps(report, allow_nan=False)), report)
        (entry,) = report["objects"]
        return entry

    def ruled(self, distance=1.0, **properties):
        low = Part.makeLine(Vector(0, 0, 0), Vector(40, 0, 0))
        high = Part.makeLine(Vector(0, 30, 0), Vector(40, 40, 30))
        edges = self.shape_object(low, "Low"), self.shape_object(high, "High")
        return make_ruled_offset(*edges, distance, **properties)


class Truth(Certificates):
    def test_it_is_what_the_kernel_proves(self):
        for obj in (
            make_canal_surface(self.spline_object(), ("Values at vertices", RADII), 0.3),
            self.ruled(),
            make_quadric_offset("Ellipsoid", 30, 20, 10, 2),
        ):
            entry = self.entry(obj)
            surface = obj.Proxy.base(obj).surface
            proved = surface.offset(obj.Distance.Value).certificate
            (section,) = entry["sections"]
            self.assertEqual(section["deviation"], proved.deviation)
            self.assertEqual(tuple(section["bidegree"]), tuple(proved.bidegree))
            self.assertEqual(section["poles"], obj.Poles)
            self.assertEqual(section["precision_bits"], proved.precision_bits)
            self.assertEqual(section["trim_deviation"], proved.trim_deviation)
            self.assertEqual(entry["exact"], obj.Exact)
            self.assertTrue(section["regular"])
            for found, limit in zip(entry["regular_range"], surface.regular_range):
                self.assertEqual(found, limit if math.isfinite(limit) else None)

    def test_samples_meet_the_definition(self):
        for obj in (
            make_canal_surface(self.spline_object(), (2, 3), 0.5),
            self.ruled(),
            make_quadric_offset("Ellipsoid", 30, 20, 10, 2),
        ):
            (section,) = self.entry(obj)["sections"]
            sampling = section["sampling"]
            self.assertGreaterEqual(sampling["points"], 900)
            self.assertLessEqual(sampling["worst"], section["deviation"] + sampling["rounding"])
            self.assertLess(sampling["rounding"], ROUNDING)

    def test_volume_of_a_wall(self):
        length, inner, outer = 10.0, 2.5, 3.5
        pipe = make_canal_surface(self.line_object(length), 3, 0.5, Sides="Both sides", Output="Solid")
        entry = self.entry(pipe)
        self.assertEqual([s["distance"] for s in entry["sections"]], [-0.5, 0.5])
        shape = entry["shape"]
        self.assertEqual((shape["type"], shape["faults"]), ("Solid", []))
        ends = math.pi * (outer**2 - inner**2)
        sides = 2 * math.pi * (inner + outer) * length
        for measure, exact in ((shape["volume"], ends * length), (shape["area"], 2 * ends + sides)):
            self.assertLessEqual(abs(measure["value"] - exact), measure["error"])
            self.assertLess(measure["error"], 1e-9 * exact)

    def test_an_open_surface_has_no_volume(self):
        shape = self.entry(make_canal_surface(self.line_object(), 2))["shape"]
        self.assertNotIn("volume", shape)

    def test_the_placement_plays_no_part(self):
        obj = make_quadric_offset("Ellipsoid", 30, 20, 10, 2)
        before = self.entry(obj)
        obj.Placement = Placement(Vector(1e3, 2, 3), Rotation(Vector(1, 2, 3), 40))
        self.document.recompute()
        after = self.entry(obj)
        self.assertEqual(after["sections"], before["sections"])

    def test_singular_surfaces_say_so(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), 5).toShape()
        entry = self.entry(make_canal_surface(self.shape_object(circle), 3, 4))
        (section,) = entry["sections"]
        self.assertFalse(section["regular"])
        self.assertLess(section["sampling"]["worst"], ROUNDING)
        text = as_markdown(pnsurfaces.certificate([self.document.ActiveObject]))
        self.assertIn("not excluded", text)

    def test_both_sides_of_a_hollow_pipe(self):
        spine = self.spline_object()
        for hollow, distances in (
            ({"Hollow": "Wall thickness", "WallThickness": 0.5}, [-0.25, 0.25]),
            ({"Hollow": "Inner radius", "InnerRadius": 1}, [0, 0.25]),
        ):
            pipe = make_canal_surface(spine, (2, 3.5), 0.25, Output="Solid", **hollow)
            entry = self.entry(pipe)
            self.assertEqual([s["distance"] for s in entry["sections"]], distances)
            for section in entry["sections"]:
                self.assertTrue(section["regular"])
                self.assertLess(section["sampling"]["worst"], ROUNDING)

    def test_fits_count(self):
        helix = make_canal_surface(self.shape_object(Part.makeHelix(10, 20, 5)), 1, 0.5)
        entry = self.entry(helix)
        self.assertFalse(entry["exact"])
        self.assertGreater(entry["fit_deviation"], 0)
        (section,) = entry["sections"]
        self.assertLessEqual(entry["fit_deviation"] + section["deviation"], helix.DeviationBound)
        self.assertIn("Deviation in all", as_markdown(pnsurfaces.certificate([helix])))
        # The sample is against what was fitted.
        self.assertLess(section["sampling"]["worst"], ROUNDING)

    def test_what_was_fitted(self):
        egg = Part.makeSphere(10).toNurbs()
        surface = egg.Faces[0].Surface
        pole = surface.getPole(3, 3)
        surface.setPole(3, 3, pole + Vector(1e-5, 0, 0))
        obj = make_quadric_offset(self.face_object(surface.toShape(), "Dented"), distance=1)
        entry = self.entry(obj)
        self.assertFalse(entry["exact"])
        self.assertIn("no quadric exactly", entry["fitted"][0])


class Comparison(Certificates):
    def test_freecads_offset_of_the_same_surface(self):
        (section,) = self.entry(self.ruled(), compare=True)["sections"]
        offset = section["freecad_offset"]
        self.assertGreater(offset["poles"], section["poles"])
        self.assertGreater(offset["deviation"], 1e-12)
        self.assertLess(offset["deviation"], 1e-3)

    @unittest.skipUnless(FreeCAD.Version()[:2] == ["0", "20"], "later versions may do better")
    def test_failure_has_a_reason(self):
        egg = make_quadric_offset("Ellipsoid", 3, 2, 1, 0.5)
        (section,) = self.entry(egg, compare=True)["sections"]
        self.assertEqual(section["freecad_offset"], {"fails": "Cannot convert to B-spline surface"})

    def test_only_when_asked(self):
        (section,) = self.entry(self.ruled())["sections"]
        self.assertNotIn("freecad_offset", section)

    def test_nothing_to_compare_at_distance_zero(self):
        (section,) = self.entry(self.ruled(0.0), compare=True)["sections"]
        self.assertNotIn("freecad_offset", section)


class Answers(Certificates):
    def answer(self, obj):
        return self.entry(obj)["answer"]

    def test_another_object(self):
        box = self.document.addObject("Part::Box", "Crate")
        self.document.recompute()
        self.assertIn("Crate is no surface of PN Surfaces", self.answer(box))
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        self.assertIn("Group is no surface of PN Surfaces", self.answer(group))

    def test_an_error(self):
        pipe = make_canal_surface(self.line_object(10), (1, 50))
        self.assertFalse(pipe.isValid())
        self.assertIn(pipe.getStatusString(), self.answer(pipe))

    def test_a_shape_that_is_not_up_to_date(self):
        pipe = make_canal_surface(self.line_object(), 2)
        pipe.Distance = 1
        self.assertIn("Recompute it first", self.answer(pipe))
        pipe.purgeTouched()
        self.assertIn("does not show what its properties say", self.answer(pipe))
        self.document.recompute()
        pipe.touch()
        self.document.recompute()
        self.assertIn("sections", self.entry(pipe))

    def test_no_object(self):
        with self.assertRaisesRegex(ValueError, "no object"):
            pnsurfaces.certificate([])


class Files(Certificates):
    def setUp(self):
        super().setUp()
        self.obj = make_canal_surface(self.line_object(), 2, 1)
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()

    def test_json(self):
        path = self.folder / "pipe.json"
        pnsurfaces.write_certificate([self.obj, self.box], path)
        report = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual(report, pnsurfaces.certificate([self.obj, self.box]))

    def test_markdown(self):
        path = self.folder / "pipe.md"
        self.obj.Label = "A | b *c*"
        pnsurfaces.write_certificate([self.obj, self.box], str(path))
        text = path.read_text(encoding="utf-8")
        self.assertIn(r"## A \| b \*c\*", text)
        (section,) = self.entry(self.obj)["sections"]
        self.assertIn(f"| Faces, poles | 1, {section['poles']} |", text)
        self.assertIn(f"| Proven deviation | {section['deviation']:.2g} mm |", text)
        self.assertIn("Box is no surface of PN Surfaces", text)

    def test_a_folder_that_does_not_exist(self):
        with self.assertRaises(FileNotFoundError):
            pnsurfaces.write_certificate([self.obj], self.folder / "nowhere" / "pipe.md")
