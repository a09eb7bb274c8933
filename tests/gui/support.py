# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document with two spines in FreeCAD's window, for the tests of commands and panels."""

import contextlib
import gc
import inspect
import itertools
import math
import unittest

import FreeCAD
import FreeCADGui
import main_window
import Part
from FreeCAD import Vector

# A curved spine with five vertices, in millimetres.
POLES = [(0, 0, 0), (20, 25, 0), (40, 25, 20), (65, -5, 30), (90, 5, 10), (110, 40, 5), (125, 55, 15)]
KNOTS = [0.0, 0.25, 0.5, 0.75, 1.0]
MULTIPLICITIES = [4, 1, 1, 1, 4]


class GuiTest(unittest.TestCase):
    """A test with a document that holds the objects Line and Spline, nothing to undo yet."""

    def setUp(self):
        self._forget_preferences()
        self.addCleanup(self._forget_preferences)
        self.addCleanup(_forget_last_error)
        main_window.show()
        self.document = FreeCAD.newDocument()
        self.addCleanup(self._close_documents)
        self.line = self._curve_object(Part.LineSegment(Vector(), Vector(0, 0, 100)), "Line")
        self.spline = self._curve_object(spline(), "Spline")
        self.document.recompute()
        self.document.clearUndos()
        FreeCADGui.activeDocument().activeView().viewIsometric()

    def open_panel(self, spine, *names):
        """Runs the command Canal surface on a spine: the new feature and its panel."""
        self.select(spine, *names)
        return self.run_creation("PNSurfaces_CanalSurface")

    def run_creation(self, command):
        """Runs a command on what is selected and returns the new feature, computed, and its panel."""
        FreeCADGui.runCommand(command)
        wait_for_preview()
        return self.panel_of(self.document.ActiveObject)

    def assert_asks(self, command, sentence):
        """On what is selected the command makes nothing and says what to select."""
        objects = self.document.Objects
        answers = []
        main_window.answer_message_box(answers)
        FreeCADGui.runCommand(command)
        self.assertEqual(answers, [sentence])
        self.assertEqual(self.document.Objects, objects)

    def assert_recorded(self, since, feature, expected):
        """The commands recorded from number `since` on make the same feature again."""
        name = feature.Name
        script = main_window.recorded_commands()[since:]
        self.document.removeObject(name)
        exec("\n".join(script), {"App": FreeCAD, "Gui": FreeCADGui})
        self.assertEqual(poles(self.document.getObject(name)), expected)

    def reopen_panel(self, feature):
        main_window.double_click_in_tree(feature.Label)
        return self.panel_of(feature)[1]

    def panel_of(self, feature):
        return feature, feature.ViewObject.Proxy.panel

    def select(self, source, *names):
        FreeCADGui.Selection.clearSelection()
        for name in names or [""]:
            FreeCADGui.Selection.addSelection(source, name)

    def assert_radius(self, feature, radius):
        """The surface around Line is the cylinder of that radius, in millimetres."""
        surface = feature.Shape.Faces[0].Surface
        u_first, u_last, v_first, v_last = surface.bounds()
        for i, j in itertools.product(range(8), repeat=2):
            point = surface.value(
                u_first + (u_last - u_first) * i / 8, v_first + (v_last - v_first) * j / 8
            )
            self.assertAlmostEqual(math.hypot(point.x, point.y), radius, places=9)

    def assert_nothing_open(self):
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertIsNone(FreeCADGui.activeDocument().getInEdit())
        self.assertIsNone(FreeCAD.getActiveTransaction())

    def _forget_preferences(self):
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/PNSurfaces").Clear()
        # The preferences dialog writes the file, FreeCAD ends a test run without writing it.
        FreeCAD.saveParameter()

    def shape_object(self, shape, name):
        source = self.document.addObject("Part::Feature", name)
        source.Shape = shape
        return source

    def _curve_object(self, curve, name):
        return self.shape_object(curve.toShape(), name)

    def _close_documents(self):
        for name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)
        main_window.settle()


def _forget_last_error():
    """FreeCAD keeps the last error of Python, and with it the frames of the test and their panels.

    Their widgets would be mistaken for later ones at the same address.
    """
    for frame in filter(inspect.isframe, gc.get_objects()):
        with contextlib.suppress(RuntimeError):  # It is still running.
            frame.clear()


def make_wall(panel, distance, sides):
    """Types the distance of a wall, a string, and chooses its sides."""
    main_window.type_text(input_of(panel, "Distance"), distance)
    input_of(panel, "Sides").setCurrentText(sides)
    input_of(panel, "Output").setCurrentText("Solid")
    wait_for_preview()


def spline():
    curve = Part.BSplineCurve()
    vectors = [Vector(*pole) for pole in POLES]
    curve.buildFromPolesMultsKnots(vectors, MULTIPLICITIES, KNOTS, False, 3)
    return curve


def wait_for_preview():
    """Waits until the surface in the open panel, if there is one, has followed its inputs."""
    document = FreeCADGui.activeDocument()
    edited = document.getInEdit() if document else None
    panel = edited.Proxy.panel if edited else None
    main_window.settle_until(lambda: panel is None or not panel.is_busy())


def input_of(panel, name):
    """The widget with which a panel edits the property `name`, or its button of that name."""
    return next(getattr(form, name) for form in panel.form if hasattr(form, name))


def poles(feature):
    """All poles of all faces, exactly."""
    return [
        [tuple(pole) for row in face.Surface.getPoles() for pole in row]
        for face in feature.Shape.Faces
    ]
