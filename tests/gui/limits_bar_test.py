# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bar of distances: its scale, and its state in the panel."""

import itertools
import math
import unittest

import main_window
from support import GuiTest, input_of, wait_for_preview

from pnsurfaces.limits_bar import Scale

RANGES = [(-5.0, 20.0), (-5.0, math.inf), (-math.inf, 3.0), (-math.inf, math.inf), (0.0, 0.0)]


class ScaleTest(unittest.TestCase):
    def test_greater_distances_lie_further_right(self):
        for low, high in RANGES:
            scale = Scale(low, high)
            places = [scale.place(distance) for distance in range(-40, 41)]
            self.assertEqual(places, sorted(places))
            self.assertGreaterEqual(places[0], 0)
            self.assertLessEqual(places[-1], 1)

    def test_marks_lie_in_the_zone_of_their_colour(self):
        for (low, high), distance in itertools.product(RANGES, range(-40, 41)):
            scale = Scale(low, high)
            mark = scale.mark(distance + 0.5)
            zones = [zone for zone in scale.zones() if zone.start <= mark.place <= zone.end]
            self.assertIn(mark.is_regular, [zone.is_regular for zone in zones])
            self.assertEqual(mark.is_regular, low < distance + 0.5 < high)

    def test_the_bar_is_covered(self):
        for low, high in RANGES:
            zones = Scale(low, high).zones()
            self.assertEqual((zones[0].start, zones[-1].end), (0, 1))
            for zone, after in zip(zones, zones[1:]):
                self.assertEqual(zone.end, after.start)
                self.assertNotEqual(zone.is_regular, after.is_regular)

    def test_nothing_is_red_beyond_an_infinite_end(self):
        regular = [zone.is_regular for zone in Scale(-5, math.inf).zones()]
        self.assertEqual(regular, [False, True])
        regular = [zone.is_regular for zone in Scale(-math.inf, 3).zones()]
        self.assertEqual(regular, [True, False])
        self.assertEqual(len(Scale(-math.inf, math.inf).zones()), 1)

    def test_a_limit_out_of_all_proportion_is_drawn_like_none(self):
        for far, endless in (
            (Scale(-5, 7e10), Scale(-5, math.inf)),
            (Scale(-7e10, 5), Scale(-math.inf, 5)),
        ):
            self.assertEqual(far.zones(), endless.zones())
            for distance in (-7.0, 0.0, 2.0, 7.0):
                self.assertEqual(far.mark(distance), endless.mark(distance))
        self.assertFalse(Scale(-5, 7e10).mark(8e10).is_regular)

    def test_limits_lie_between_the_zones(self):
        scale = Scale(-5, 20)
        _, regular, _ = scale.zones()
        self.assertAlmostEqual(scale.place(-5), regular.start)
        self.assertAlmostEqual(scale.place(20), regular.end)
        self.assertAlmostEqual(scale.place(7.5), 0.5)


class BarInPanelTest(GuiTest):
    def test_the_mark_follows_typing_at_once(self):
        _, panel = self.open_panel(self.line, "Edge1")
        main_window.type_text(input_of(panel, "Radius"), "5")
        wait_for_preview()
        main_window.type_text(input_of(panel, "Distance"), "-4")
        (mark,) = panel.limits.marks
        self.assertEqual(mark.distance, -4)
        self.assertTrue(mark.is_regular)
        main_window.type_text(input_of(panel, "Distance"), "-7")
        (mark,) = panel.limits.marks
        self.assertEqual(mark.distance, -7)
        self.assertFalse(mark.is_regular)
        wait_for_preview()
        main_window.screenshot("limits_beyond")

    def test_both_sides_have_two_marks(self):
        _, panel = self.open_panel(self.line, "Edge1")
        main_window.type_text(input_of(panel, "Radius"), "5")
        main_window.type_text(input_of(panel, "Distance"), "6")
        input_of(panel, "Sides").setCurrentText("Both sides")
        wait_for_preview()
        inner, outer = panel.limits.marks
        self.assertEqual((inner.distance, outer.distance), (-6, 6))
        self.assertEqual((inner.is_regular, outer.is_regular), (False, True))
        main_window.screenshot("limits_both_sides")

    def test_limits_are_those_of_the_surface(self):
        self.document.addObject("Part::Box", "Other")
        main_window.settle()
        feature, panel = self.run_creation("PNSurfaces_QuadricOffset")
        wait_for_preview()
        self.assertEqual(panel.limits.scale.low, feature.MinOffset.Value)
        self.assertEqual(panel.limits.scale.high, feature.MaxOffset.Value)
        main_window.screenshot("limits_of_ellipsoid")
