# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a moving conic section: spine, planes, and the measures of the sections."""

import FreeCAD
import numpy as np

from pnsurfaces.compat import QtWidgets, connect
from pnsurfaces.moving_conic_section import PARALLEL, spine_of
from pnsurfaces.panel import load_form
from pnsurfaces.position import ARC_LENGTH
from pnsurfaces.radius_law import EXPRESSION, TABLE
from pnsurfaces.radius_table import RadiusTable, length_column, number_column, short_length_column
from pnsurfaces.section_law import SECTIONS, inputs_of_all_laws, inputs_of_law, number_of_property
from pnsurfaces.spine_panel import SpinePanel, show_if

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

# The columns of the table, by the names of quantities.
_COLUMNS = {
    "HalfWidth": (length_column, QT_TRANSLATE_NOOP("PNSurfaces", "To the side")),
    "HalfHeight": (length_column, QT_TRANSLATE_NOOP("PNSurfaces", "Upwards")),
    "Radius": (short_length_column, QT_TRANSLATE_NOOP("PNSurfaces", "Radius")),
    "ConicConstant": (number_column, QT_TRANSLATE_NOOP("PNSurfaces", "K")),
    "Depth": (short_length_column, QT_TRANSLATE_NOOP("PNSurfaces", "Depth")),
}


class MovingConicSectionPanel(SpinePanel):
    """Edits a moving conic section (moving_conic_section.MovingConicSection)."""

    def __init__(self, feature):
        super().__init__(feature, load_form("moving_conic_section"))
        form = self._inputs
        self.normal = _one_row(form.normal)
        self.up = _one_row(form.up)
        for name in ("Normal", "Up", *inputs_of_all_laws()):
            self.record(name)
        _share_width(form.radii)
        self.normal.edited.connect(lambda: self._assign_row("Normal", self.normal))
        self.up.edited.connect(lambda: self._assign_row("Up", self.up))
        connect(form.Planes, "currentTextChanged(QString)", self._show_planes)
        connect(form.Section, "currentTextChanged(QString)", self._show_law)
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
        inputs = inputs_of_law(self.feature.Section, law)
        for name in filter(lambda name: hasattr(form, name), inputs_of_all_laws()):
            show_if(name in inputs, getattr(form, f"{name}_label"), getattr(form, name))
        show_if(law == TABLE, form.radii, form.row_buttons)
        fitted = law == EXPRESSION or bool(self._spine and self._spine.fits)
        show_if(fitted, form.tolerance_label, form.FitTolerance)
        if law == TABLE:
            self._fit_table()
            self._show_table()

    def _quantities(self):
        return SECTIONS[self.feature.Section].quantities

    def _fit_table(self):
        """Begins a table with the values that a linear law has there, without one at both ends."""
        feature, quantities = self.feature, self._quantities()
        count = len(feature.Positions) or 2
        for name, plural, *_ in quantities:
            if not getattr(feature, plural):
                ends = [number_of_property(feature, end).Value for end in (name, f"End{name}")]
                self.assign(plural, np.linspace(*ends, count).tolist())
        if self._spine:
            self._fit_positions(len(getattr(feature, quantities[0].plural)))

    def _show_table(self):
        feature, quantities = self.feature, self._quantities()
        position = length_column if feature.PositionBy == ARC_LENGTH else number_column
        columns = [position(translate("PNSurfaces", "Position"))]
        for quantity in quantities:
            column, title = _COLUMNS[quantity.name]
            columns.append(column(translate("PNSurfaces", title)))
        lists = (getattr(feature, quantity.plural) for quantity in quantities)
        self.table.show(zip(feature.Positions, *lists), columns)

    def _assign_table(self):
        names = ("Positions", *(quantity.plural for quantity in self._quantities()))
        for index, name in enumerate(names):
            self.assign(name, self.table.column(index))


def _one_row(view):
    """A table for one direction, in its view."""
    table = RadiusTable()
    view.setModel(table)
    _share_width(view)
    return table


def _share_width(view):
    """All columns are seen, equally wide."""
    view.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
