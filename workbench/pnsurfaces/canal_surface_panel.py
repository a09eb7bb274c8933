# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a canal surface: spine, radius law and wall."""

import FreeCAD
import FreeCADGui
import numpy as np

from pnsurfaces.canal_surface import BORE, WALL, spine_of
from pnsurfaces.compat import QtCore, QtGui, QtWidgets, connect
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.linked_shape import depends_on
from pnsurfaces.panel import TaskPanel, load_form, title
from pnsurfaces.position import ARC_LENGTH, VERTEX, measure
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    EXPRESSION,
    FITTED_LAWS,
    INPUTS_OF_LAW,
    LINEAR,
    PROFILE,
    TABLE,
    VALUES_AT_VERTICES,
)
from pnsurfaces.radius_table import RadiusTable, length_column, number_column
from pnsurfaces.selection import selected_spine

translate = FreeCAD.Qt.translate

# Decimals of the tolerance of fits: the default is the fifth.
_TOLERANCE_DECIMALS = 7


class CanalSurfacePanel(TaskPanel):
    """Edits a canal surface (canal_surface.CanalSurface)."""

    def __init__(self, feature):
        self._inputs = load_form("canal_surface")
        self._inputs.FitTolerance.setProperty("decimals", _TOLERANCE_DECIMALS)
        super().__init__(feature, self._inputs)
        for name in ("Spine", "Radii", "Positions", "Profile"):
            self.record(name)
        self._spine = None
        self.table = RadiusTable()
        self.table.edited.connect(self._assign_table)
        self._inputs.radii.setModel(self.table)
        self._paste_key = QtGui.QShortcut(QtGui.QKeySequence.Paste, self._inputs.radii)
        self._paste_key.setContext(QtCore.Qt.WidgetShortcut)
        for sender, signal, slot in (
            (self._inputs.use_selection, "clicked()", self.use_selection),
            (self._inputs.use_profile, "clicked()", self.use_profile),
            (self._inputs.RadiusLaw, "currentTextChanged(QString)", self._show_radius_law),
            (self._inputs.PositionBy, "currentTextChanged(QString)", self._change_measure),
            (self._inputs.Hollow, "currentTextChanged(QString)", self._show_wall),
            (self._inputs.add_row, "clicked()", self._add_row),
            (self._inputs.remove_row, "clicked()", self._remove_row),
            (self._inputs.paste_rows, "clicked()", self._paste_all),
            (self._paste_key, "activated()", self._paste_at_current_row),
        ):
            connect(sender, signal, slot)
        self._measure = feature.PositionBy
        self._show_profile()
        self._show_wall()
        self._show_radius_law()

    def use_selection(self):
        """Makes the current selection the spine."""
        spine = self._selected(self._inputs.spine)
        if spine:
            self.assign("Spine", spine)
            self._show_radius_law()

    def use_profile(self):
        """Makes the current selection the profile."""
        profile = self._selected(self._inputs.profile)
        if profile:
            self.assign("Profile", profile)
            self._show_profile()

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
            self._spine = spine_of(self.feature, *self.feature.Spine)
            recognised = _description(self._spine)
        except (ValueError, KernelMissing) as error:
            recognised = str(error)
        self._inputs.spine.setText(f"<b>{title(self.feature.Spine)}</b><br>{recognised}")

    def _show_profile(self):
        profile = self.feature.Profile
        name = f"<b>{title(profile)}</b>" if profile else translate("PNSurfaces", "No profile")
        self._inputs.profile.setText(name)

    def _show_wall(self):
        form, hollow = self._inputs, self.feature.Hollow
        _show(hollow == WALL, form.wall_label, form.WallThickness)
        _show(hollow == BORE, form.bore_label, form.InnerRadius)

    def _show_radius_law(self):
        self._show_spine()
        form, law = self._inputs, self.feature.RadiusLaw
        inputs = INPUTS_OF_LAW[law]
        _show("Radius" in inputs, form.Radius)
        _show(law == LINEAR, form.start, form.end, form.EndRadius)
        _show("PositionBy" in inputs, form.position_label, form.PositionBy)
        _show(law == EXPRESSION, form.RadiusExpression)
        _show(law == PROFILE, form.profile_label, form.profile, form.use_profile)
        _show("Radii" in inputs, form.radii)
        _show(law in (BEZIER_COEFFICIENTS, TABLE), form.row_buttons)
        fitted = law in FITTED_LAWS or bool(self._spine and self._spine.fits)
        _show(fitted, form.tolerance_label, form.FitTolerance)
        if "Radii" in inputs:
            self._fit_table()
            self._show_table()

    def _change_measure(self):
        """Keeps the places of the rows, as nearly as the two measures allow."""
        before, self._measure = self._measure, self.feature.PositionBy
        if self._spine and self.feature.Positions:
            old, new = measure(self._spine, before), measure(self._spine, self._measure)
            shares = (np.array(self.feature.Positions) - old.start) / (old.end - old.start)
            positions = new.start + shares * (new.end - new.start)
            self.assign("Positions", list(_whole(positions, self._measure)))
        self._show_radius_law()

    def _fit_table(self):
        """Keeps the shape of the law when it needs another number of radii, or positions."""
        radii = self.feature.Radii or [self.feature.Radius.Value] * 2
        if self.feature.RadiusLaw == VALUES_AT_VERTICES and self._spine:
            radii = _resampled(radii, len(self._spine.curve.breaks))
        if self._joins_first_vertex():
            radii = radii[:-1] + radii[:1]
        if radii != self.feature.Radii:
            self.assign("Radii", radii)
        if self.feature.RadiusLaw == TABLE and self._spine:
            self._fit_positions(len(radii))

    def _fit_positions(self, count):
        if len(self.feature.Positions) != count:
            scale = measure(self._spine, self.feature.PositionBy)
            positions = np.linspace(scale.start, scale.end, count)
            self.assign("Positions", list(_whole(positions, self.feature.PositionBy)))

    def _show_table(self):
        radius = length_column(translate("PNSurfaces", "Radius"))
        if self.feature.RadiusLaw == TABLE:
            is_length = self.feature.PositionBy == ARC_LENGTH
            column = length_column if is_length else number_column
            rows = zip(self.feature.Positions, self.feature.Radii)
            self.table.show(rows, [column(translate("PNSurfaces", "Position")), radius])
        elif self.feature.RadiusLaw == BEZIER_COEFFICIENTS:
            rows = [[coefficient] for coefficient in self.feature.Radii]
            self.table.show(rows, [radius], translate("PNSurfaces", "Coefficient {}"))
        else:
            # The last vertex of a closed spine is its first one.
            count = len(self.feature.Radii) - self._joins_first_vertex()
            rows = [[value] for value in self.feature.Radii[:count]]
            self.table.show(rows, [radius], translate("PNSurfaces", "Vertex {}"))

    def _joins_first_vertex(self):
        return (
            self.feature.RadiusLaw == VALUES_AT_VERTICES
            and self._spine is not None
            and self._spine.closed
        )

    def _assign_table(self):
        radii = self.table.column(-1)
        again = radii[:1] if self._joins_first_vertex() else []
        self.assign("Radii", radii + again)
        if self.feature.RadiusLaw == TABLE:
            self.assign("Positions", self.table.column(0))

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
        self._assign_rows(
            [*rows[: current + 1], list(np.mean(near, axis=0)), *rows[current + 1 :]]
        )

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
            fixed = self.feature.RadiusLaw == VALUES_AT_VERTICES
            self._assign_rows(pasted[: len(self.table.rows)] if fixed else pasted)

    def _copied_rows(self):
        """The rows on the clipboard, none after saying what is wrong with them."""
        try:
            return self.table.read_rows(QtWidgets.QApplication.clipboard().text())
        except ValueError:
            self.explain(
                translate("PNSurfaces", "The clipboard has no table of {} columns of numbers.")
                .format(self.table.columnCount())
            )
            return []


def _show(visible, *widgets):
    for widget in widgets:
        widget.setVisible(visible)


def _whole(positions, name):
    """Positions that count vertices are whole numbers."""
    return np.round(positions) if name == VERTEX else positions


def _resampled(radii, count):
    """As many radii along the polygon through the given ones."""
    if count == len(radii):
        return radii
    return list(np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(radii)), radii))


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
