# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels by keyboard: Tab reaches every input, from top to bottom."""

import FreeCADGui
import main_window
from support import GuiTest, input_of, wait_for_preview

from pnsurfaces.compat import QtCore, QtWidgets

_INPUTS = (
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QAbstractButton,
    QtWidgets.QComboBox,
    QtWidgets.QLineEdit,
    QtWidgets.QAbstractItemView,
)


def inputs_of(form):
    """The visible inputs of a form as a person counts them: a spin box is one, not its parts."""
    inputs = [w for w in form.findChildren(QtWidgets.QWidget) if isinstance(w, _INPUTS)]
    outermost = [w for w in inputs if not any(o is not w and o.isAncestorOf(w) for o in inputs)]
    return [w for w in outermost if w.isVisible() and w.isEnabled()]


def reached_by_tab(form):
    """The inputs of a form in the order in which Tab comes to them."""
    inputs, reached = inputs_of(form), []
    widget = form.nextInFocusChain()
    while widget is not form:
        owner = next((w for w in inputs if w is widget or w.isAncestorOf(widget)), None)
        if widget.focusPolicy() & QtCore.Qt.TabFocus and owner and owner not in reached:
            reached.append(owner)
        widget = widget.nextInFocusChain()
    return reached


def place(form, widget):
    """Row and column of a widget, in pixels: what stands side by side has one row."""
    corner = widget.mapTo(form, QtCore.QPoint(0, widget.height() // 2))
    return corner.y() // 8, corner.x()


class Keyboard(GuiTest):
    def assert_in_order(self, panel):
        for form in panel.form:
            reached = reached_by_tab(form)
            self.assertCountEqual(reached, inputs_of(form))
            self.assertEqual(reached, sorted(reached, key=lambda widget: place(form, widget)))

    def test_canal_surface(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        for law in ("Constant", "Linear", "Table", "Expression", "Profile"):
            with self.subTest(law):
                input_of(panel, "RadiusLaw").setCurrentText(law)
                input_of(panel, "Hollow").setCurrentText("Wall thickness")
                main_window.settle()
                self.assert_in_order(panel)
        wait_for_preview()

    def test_ruled_surface(self):
        self.select(self.line)
        FreeCADGui.Selection.addSelection(self.spline)
        _, panel = self.run_creation("PNSurfaces_RuledOffset")
        self.assert_in_order(panel)

    def test_quadric(self):
        _, panel = self.run_creation("PNSurfaces_QuadricOffset")
        input_of(panel, "Region").setCurrentText("Box")
        main_window.settle()
        self.assert_in_order(panel)
