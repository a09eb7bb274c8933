# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command with a panel that makes a surface promises: OK is one step, Cancel is none."""

import main_window
from support import input_of, poles, wait_for_preview


class CreationTests:
    """Mixed into a GuiTest whose open() runs the command: the new feature and its panel.

    `feature_name` is the name of the new feature, and `undo_name` that of the step that OK can be
    undone by. `typed` are the texts that are typed for properties, in the units of their values,
    and `picture` is the name of a screenshot.
    """

    feature_name = ""
    undo_name = ""
    typed = {"Distance": "1.5"}
    picture = ""

    def enter(self, panel):
        for name, text in self.typed.items():
            main_window.type_text(input_of(panel, name), text)

    def test_ok_is_one_undo_step(self):
        objects, since = self.document.Objects, len(main_window.recorded_commands())
        feature, panel = self.open()
        self.assertEqual(feature.Name, self.feature_name)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.enter(panel)
        wait_for_preview()
        main_window.screenshot(self.picture)
        main_window.confirm(panel)
        self.assert_nothing_open()
        self.assertEqual(self.document.UndoNames, [self.undo_name])
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertNotIn("Touched", feature.State)
        for name, text in self.typed.items():
            self.assertEqual(getattr(feature, name).Value, float(text))
        made = poles(feature)
        self.document.undo()
        self.assertEqual(self.document.Objects, objects)
        self.document.redo()
        again = self.document.getObject(self.feature_name)
        self.assertEqual(poles(again), made)
        self.assert_recorded(since, again, made)

    def test_cancel_leaves_nothing(self):
        objects = self.document.Objects
        _, panel = self.open()
        self.enter(panel)
        wait_for_preview()
        main_window.cancel(panel)
        self.assert_nothing_left(objects)

    def test_cancel_of_an_untouched_panel_leaves_nothing(self):
        objects = self.document.Objects
        _, panel = self.open()
        main_window.cancel(panel)
        self.assert_nothing_left(objects)

    def test_cancel_before_the_preview_leaves_nothing(self):
        objects = self.document.Objects
        _, panel = self.open()
        self.enter(panel)
        main_window.cancel(panel)
        wait_for_preview()
        self.assert_nothing_left(objects)

    def assert_nothing_left(self, objects):
        """The document has these objects only, and nothing to undo."""
        self.assert_nothing_open()
        self.assertEqual(self.document.Objects, objects)
        self.assertEqual(self.document.UndoCount, 0)
