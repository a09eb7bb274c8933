# SPDX-License-Identifier: LGPL-2.1-or-later
"""The marks where the offsets of a surface become singular first."""

import main_window
from support import GuiTest, input_of, wait_for_preview


class SingularMarksTest(GuiTest):
    def test_the_end_of_the_regular_range_of_a_pipe_is_on_its_spine(self):
        _, panel = self.open_panel(self.line, "Edge1")
        main_window.type_text(input_of(panel, "Radius"), "8")
        wait_for_preview()
        *_, point = main_window.singular_points(self.document.ActiveObject)
        self.assertAlmostEqual(point[0], 0, places=4)
        self.assertAlmostEqual(point[1], 0, places=4)
        main_window.screenshot("singular_point")

    def test_an_ellipsoid_is_singular_inside_at_its_least_radius_of_curvature(self):
        feature, panel = self.run_creation("PNSurfaces_QuadricOffset")
        wait_for_preview()
        base, point = main_window.singular_points(feature)[:2]
        # Half-axes a > b > c: at the end of the longest one, with the radius of curvature c c / a.
        a, c = feature.HalfAxisA.Value, feature.HalfAxisC.Value
        self.assertAlmostEqual(abs(base[0]), a, places=2)
        self.assertAlmostEqual(abs(point[0]), a - c * c / a, places=2)
        main_window.screenshot("singular_point_of_ellipsoid")
        main_window.confirm(panel)
        self.assertEqual(main_window.singular_points(feature), [])
