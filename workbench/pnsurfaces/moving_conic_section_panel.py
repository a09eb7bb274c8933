# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a moving conic section: spine, planes and half-axes."""

import FreeCAD

from pnsurfaces.compat import QtWidgets, connect
from pnsurfaces.moving_conic_section import PARALLEL, spine_of
from pnsurfaces.panel import load_form
from pnsurfaces.position import ARC_LENGTH
from pnsurfaces.radius_law import EXPRESSION, LINEAR, TABLE
from pnsurfaces.radius_table import RadiusTable, length_column, number_column
from pnsurfaces.section_law import inputs_of_law
from pnsurfaces.spine_panel import SpinePanel, show_if

translate = FreeCAD.Qt.translate


class MovingConicSectionPanel(SpinePanel):
    """Edits a moving conic section (moving_conic_section.MovingConicSection)."""

    def __init__(self, feature):
        super().__init__(feature, load_form("moving_conic_section"))
        form = self._inputs
        self.normal = _one_row(form.normal)
        self.up = _one_row(form.up)
        for name in ("Normal", "Up", "HalfWidths", "HalfHeights"):
            self.record(name)
        self.normal.edited.connect(lambda: self._assign_row("Normal", self.normal))
        self.up.edited.connect(lambda: self._assign_row("Up", self.up))
        connect(form.Planes, "currentTextChanged(QString)", self._show_planes)
        connect(form.SectionLaw, "currentTextChanged(QString)", self._show_law)
        self._show_planes()
        self._show_law()

    def read_spine(self):
        return spine_of(self.feature, *self.feature.Spine)

    def _show_planes(self):
        is_parallel = self.feature.Planes == PARALLEL
        show_if(is_parallel, self._inputs.normal_title, self._inputs.normal)
        for name, table in (("Normal", self.normal), ("Up", self.up)):
            table.show([list(getattr(self.feature, name))], [number_column(x) for x in "xyz"])

    def _assign_row(self, name, table):
        self.assign(name, FreeCAD.Vector(*table.rows[0]))
        self._show_planes()

    def _show_law(self):
        self._show_spine()
        form, law = self._inputs, self.feature.SectionLaw
        inputs = inputs_of_law(law)
        show_if("HalfWidth" in inputs,
                form.side_label, form.HalfWidth, form.height_label, form.HalfHeight)
        show_if(law == LINEAR,
                form.end_side_label, form.EndHalfWidth, form.end_height_label, form.EndHalfHeight)
        show_if("PositionBy" in inputs, form.position_label, form.PositionBy)
        show_if(law == EXPRESSION,
                form.side_expression_label, form.HalfWidthExpression,
                form.height_expression_label, form.HalfHeightExpression)
        show_if(law == TABLE, form.radii, form.row_buttons)
        fitted = law == EXPRESSION or bool(self._spine and self._spine.fits)
        show_if(fitted, form.tolerance_label, form.FitTolerance)
        if law == TABLE:
            self._fit_table()
            self._show_table()

    def _fit_table(self):
        """Begins a table with the half-axes of the other laws, at both ends."""
        feature = self.feature
        if not feature.HalfWidths:
            self.assign("HalfWidths", [feature.HalfWidth.Value, feature.EndHalfWidth.Value])
            self.assign("HalfHeights", [feature.HalfHeight.Value, feature.EndHalfHeight.Value])
        if self._spine:
            self._fit_positions(len(feature.HalfWidths))

    def _show_table(self):
        feature = self.feature
        position = length_column if feature.PositionBy == ARC_LENGTH else number_column
        columns = [
            position(translate("PNSurfaces", "Position")),
            length_column(translate("PNSurfaces", "To the side")),
            length_column(translate("PNSurfaces", "Upwards")),
        ]
        rows = zip(feature.Positions, feature.HalfWidths, feature.HalfHeights)
        self.table.show(rows, columns)

    def _assign_table(self):
        for index, name in enumerate(("Positions", "HalfWidths", "HalfHeights")):
            self.assign(name, self.table.column(index))


def _one_row(view):
    """A table for one direction, in its view."""
    table = RadiusTable()
    view.setModel(table)
    view.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
    return table
