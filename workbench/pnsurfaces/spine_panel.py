# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels of surfaces along a spine share: the spine, and a table of positions on it."""

import FreeCAD
import FreeCADGui
import numpy as np

from pnsurfaces.compat import QtCore, QtGui, QtWidgets, connect
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.linked_shape import depends_on
from pnsurfaces.panel import TaskPanel, title
from pnsurfaces.position import VERTEX, measure
from pnsurfaces.radius_table import RadiusTable
from pnsurfaces.selection import selected_spine

translate = FreeCAD.Qt.translate

# Decimals of the tolerance of fits: the default is the fifth.
_TOLERANCE_DECIMALS = 7


class SpinePanel(TaskPanel):
    """Edits a surface along the property Spine, whose laws may be a table with Positions.

    A subclass reads the spine, assigns the rows of the table to properties, and shows its law.
    """

    def __init__(self, feature, inputs):
        self._inputs = inputs
        inputs.FitTolerance.setProperty("decimals", _TOLERANCE_DECIMALS)
        super().__init__(feature, inputs)
        for name in ("Spine", "Positions"):
            self.record(name)
        self._spine = None
        self._measure = feature.PositionBy
        self.table = RadiusTable()
        self.table.edited.connect(self._assign_table)
        inputs.radii.setModel(self.table)
        self._paste_key = QtGui.QShortcut(QtGui.QKeySequence.Paste, inputs.radii)
        self._paste_key.setContext(QtCore.Qt.WidgetShortcut)
        for sender, signal, slot in (
            (inputs.use_selection, "clicked()", self.use_selection),
            (inputs.PositionBy, "currentTextChanged(QString)", self._change_measure),
            (inputs.add_row, "clicked()", self._add_row),
            (inputs.remove_row, "clicked()", self._remove_row),
            (inputs.paste_rows, "clicked()", self._paste_all),
            (self._paste_key, "activated()", self._paste_at_current_row),
        ):
            connect(sender, signal, slot)

    def read_spine(self):
        """The spine.Spine of the feature's property. Raises ValueError or KernelMissing."""
        raise NotImplementedError

    def has_fixed_rows(self):
        """Whether the table has as many rows as something else says."""
        return False

    def _assign_table(self):
        """Gives the properties of the table its rows."""
        raise NotImplementedError

    def _show_table(self):
        raise NotImplementedError

    def _show_law(self):
        """Shows the spine, and the inputs of the chosen law."""
        raise NotImplementedError

    def use_selection(self):
        """Makes the current selection the spine."""
        spine = self._selected(self._inputs.spine)
        if spine:
            self.assign("Spine", spine)
            self._show_law()

    def _selected(self, label):
        """The selected edges, or None after saying on the label what to select."""
        link = selected_spine(FreeCADGui.Selection.getSelectionEx())
        if link is None:
            sentence = "Select edges of one object, a wire or a sketch first."
        elif depends_on(link[0], self.feature):
            sentence = "What is selected is made from this surface itself."
        else:
            return link
        label.setText(translate("PNSurfaces", sentence))
        return None

    def _show_spine(self):
        self._spine = None
        if not self.feature.Spine:
            self._inputs.spine.setText(translate("PNSurfaces", "No spine"))
            return
        try:
            self._spine = self.read_spine()
            recognised = _description(self._spine)
        except (ValueError, KernelMissing) as error:
            recognised = str(error)
        self._inputs.spine.setText(f"<b>{title(self.feature.Spine)}</b><br>{recognised}")

    def _change_measure(self):
        """Keeps the places of the rows, as nearly as the two measures allow."""
        before, self._measure = self._measure, self.feature.PositionBy
        if self._spine and self.feature.Positions:
            old, new = measure(self._spine, before), measure(self._spine, self._measure)
            shares = (np.array(self.feature.Positions) - old.start) / (old.end - old.start)
            positions = new.start + shares * (new.end - new.start)
            self.assign("Positions", list(_whole(positions, self._measure)))
        self._show_law()

    def _fit_positions(self, count):
        if len(self.feature.Positions) != count:
            scale = measure(self._spine, self.feature.PositionBy)
            positions = np.linspace(scale.start, scale.end, count)
            self.assign("Positions", list(_whole(positions, self.feature.PositionBy)))

    def _assign_rows(self, rows):
        self.table.rows = rows
        self._assign_table()
        self._show_table()

    def _current_row(self):
        row = self._inputs.radii.currentIndex().row()
        return row if row >= 0 else len(self.table.rows) - 1

    def _add_row(self):
        """A row below the current one, halfway to the next."""
        rows, current = self.table.rows, self._current_row()
        near = rows[max(current, 0) : current + 2] if len(rows) > 1 else rows
        self._assign_rows([*rows[: current + 1], list(np.mean(near, axis=0)), *rows[current + 1 :]])

    def _remove_row(self):
        rows, current = self.table.rows, self._current_row()
        if len(rows) > 1:
            self._assign_rows(rows[:current] + rows[current + 1 :])

    def _paste_all(self):
        rows = self._copied_rows()
        if rows:
            self._assign_rows(rows)

    def _paste_at_current_row(self):
        """Overwrites rows from the current one on; only vertices are as many as they are."""
        rows, current = self._copied_rows(), self._current_row()
        if rows:
            pasted = self.table.rows[:current] + rows + self.table.rows[current + len(rows) :]
            is_fixed = self.has_fixed_rows()
            self._assign_rows(pasted[: len(self.table.rows)] if is_fixed else pasted)

    def _copied_rows(self):
        """The rows on the clipboard, none after saying what is wrong with them."""
        try:
            return self.table.read_rows(QtWidgets.QApplication.clipboard().text())
        except ValueError:
            self.explain(
                translate("PNSurfaces", "The clipboard has no table of {} columns of numbers.").format(
                    self.table.columnCount()
                )
            )
            return []


def show_if(visible, *widgets):
    """Shows widgets, or hides them."""
    for widget in widgets:
        widget.setVisible(visible)


def _whole(positions, name):
    """Positions that count vertices are whole numbers."""
    return np.round(positions) if name == VERTEX else positions


def _description(spine):
    spans = len(spine.curve.breaks) - 1
    text = (
        translate("PNSurfaces", "Degree {}, spans {}, vertices {}, closed, {}")
        if spine.closed
        else translate("PNSurfaces", "Degree {}, spans {}, vertices {}, {}")
    )
    length = FreeCAD.Units.Quantity(spine.length, FreeCAD.Units.Length).UserString
    vertices = spans if spine.closed else spans + 1
    return text.format(spine.curve.degree, spans, vertices, length)
