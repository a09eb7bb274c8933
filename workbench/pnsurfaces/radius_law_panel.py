# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels of canal surfaces share: the law of the radius, or of its square."""

from typing import NamedTuple

import FreeCAD
import numpy as np

from pnsurfaces.compat import connect
from pnsurfaces.position import ARC_LENGTH
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    EXPRESSION,
    FITTED_LAWS,
    LINEAR,
    TABLE,
    VALUES_AT_VERTICES,
)
from pnsurfaces.radius_table import length_column, number_column
from pnsurfaces.spine_panel import SpinePanel, show_if

translate = FreeCAD.Qt.translate


class LawNames(NamedTuple):
    """The properties of a law: the choice of it, its value at the start, the list of values."""

    law: str
    value: str
    values: str

    @property
    def end(self):
        return f"End{self.value}"

    @property
    def expression(self):
        return f"{self.value}Expression"


class RadiusLawPanel(SpinePanel):
    """Edits a surface whose radius, or its square, runs along the spine by a law.

    A subclass has `names` (LawNames), and `inputs_of_law`: the properties that each law reads.
    """

    names = None
    inputs_of_law = None

    def __init__(self, feature, inputs):
        super().__init__(feature, inputs)
        self.record(self.names.values)
        connect(self._input(self.names.law), "currentTextChanged(QString)", self._show_law)
        self._show_law()

    def value_column(self):
        """The radius_table.Column of the values."""
        raise NotImplementedError

    def has_fixed_rows(self):
        return self._law == VALUES_AT_VERTICES

    @property
    def _law(self):
        return getattr(self.feature, self.names.law)

    @property
    def _values(self):
        return getattr(self.feature, self.names.values)

    def _input(self, name):
        return getattr(self._inputs, name)

    def _show_law(self):
        self._show_spine()
        form, law, names = self._inputs, self._law, self.names
        inputs = self.inputs_of_law[law]
        show_if(names.value in inputs, self._input(names.value))
        show_if(law == LINEAR, form.start, form.end, self._input(names.end))
        show_if("PositionBy" in inputs, form.position_label, form.PositionBy)
        show_if(law == EXPRESSION, self._input(names.expression))
        show_if(names.values in inputs, form.radii)
        show_if(law in (BEZIER_COEFFICIENTS, TABLE), form.row_buttons)
        fitted = law in FITTED_LAWS or bool(self._spine and self._spine.fits)
        show_if(fitted, form.tolerance_label, form.FitTolerance)
        if names.values in inputs:
            self._fit_table()
            self._show_table()

    def _fit_table(self):
        """Keeps the shape of the law when it needs another number of values, or positions."""
        values = self._values or [getattr(self.feature, self.names.value).Value] * 2
        if self._law == VALUES_AT_VERTICES and self._spine:
            values = _resampled(values, len(self._spine.curve.breaks))
        if self._joins_first_vertex():
            values = values[:-1] + values[:1]
        if values != self._values:
            self.assign(self.names.values, values)
        if self._law == TABLE and self._spine:
            self._fit_positions(len(values))

    def _show_table(self):
        column = self.value_column()
        if self._law == TABLE:
            is_length = self.feature.PositionBy == ARC_LENGTH
            position = length_column if is_length else number_column
            rows = zip(self.feature.Positions, self._values)
            self.table.show(rows, [position(translate("PNSurfaces", "Position")), column])
        elif self._law == BEZIER_COEFFICIENTS:
            rows = [[coefficient] for coefficient in self._values]
            self.table.show(rows, [column], translate("PNSurfaces", "Coefficient {}"))
        else:
            # The last vertex of a closed spine is its first one.
            count = len(self._values) - self._joins_first_vertex()
            rows = [[value] for value in self._values[:count]]
            self.table.show(rows, [column], translate("PNSurfaces", "Vertex {}"))

    def _joins_first_vertex(self):
        return self._law == VALUES_AT_VERTICES and self._spine is not None and self._spine.closed

    def _assign_table(self):
        values = self.table.column(-1)
        again = values[:1] if self._joins_first_vertex() else []
        self.assign(self.names.values, values + again)
        if self._law == TABLE:
            self.assign("Positions", self.table.column(0))


def _resampled(values, count):
    """As many values along the polygon through the given ones."""
    if count == len(values):
        return values
    return list(np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(values)), values))
