# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a canal surface: spine and radius law."""

import FreeCAD
import FreeCADGui
import numpy as np

from pnsurfaces.compat import QtCore, connect
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.panel import TaskPanel, load_form, title
from pnsurfaces.radius_law import BEZIER_COEFFICIENTS, INPUTS_OF_LAW, LINEAR, VALUES_AT_VERTICES
from pnsurfaces.selection import selected_spine
from pnsurfaces.spine import read_spine

translate = FreeCAD.Qt.translate


class RadiiModel(QtCore.QAbstractTableModel):
    """A column of radii, shown and typed as lengths in the user's units."""

    edited = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.radii = []
        self._row_name = ""

    def show(self, radii, row_name):
        """Replaces the column. `row_name` has a {} for the number of the row."""
        self.beginResetModel()
        self.radii = list(radii)
        self._row_name = row_name
        self.endResetModel()

    def rowCount(self, parent=QtCore.QModelIndex()):
        return len(self.radii)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return 1

    def flags(self, index):
        return super().flags(index) | QtCore.Qt.ItemIsEditable

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        if role != QtCore.Qt.DisplayRole:
            return None
        if orientation == QtCore.Qt.Horizontal:
            return translate("PNSurfaces", "Radius")
        return self._row_name.format(section + 1)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        radius = FreeCAD.Units.Quantity(self.radii[index.row()], FreeCAD.Units.Length)
        if role == QtCore.Qt.DisplayRole:
            return radius.UserString
        if role == QtCore.Qt.EditRole:
            _, factor, unit = radius.getUserPreferred()
            return f"{radius.Value / factor!r} {unit}"
        return None

    def setData(self, index, value, role=QtCore.Qt.EditRole):
        """Takes a typed length, refuses all else."""
        try:
            radius = _length(value)
        except ValueError:
            return False
        self.radii[index.row()] = radius
        self.dataChanged.emit(index, index)
        self.edited.emit()
        return True


class CanalSurfacePanel(TaskPanel):
    """Edits a canal surface (canal_surface.CanalSurface)."""

    def __init__(self, feature):
        self._inputs = load_form("canal_surface")
        super().__init__(feature, self._inputs)
        self.record("Spine")
        self.record("Radii")
        self._spine = None
        self.radii = RadiiModel()
        self.radii.edited.connect(self._assign_radii)
        self._inputs.radii.setModel(self.radii)
        connect(self._inputs.use_selection, "clicked()", self.use_selection)
        connect(self._inputs.RadiusLaw, "currentTextChanged(QString)", self._show_radius_law)
        connect(self._inputs.add_coefficient, "clicked()", self._add_coefficient)
        connect(self._inputs.remove_coefficient, "clicked()", self._remove_coefficient)
        self._show_spine()
        self._show_radius_law()

    def use_selection(self):
        """Makes the current selection the spine."""
        spine = selected_spine(FreeCADGui.Selection.getSelectionEx())
        if spine is None or spine[0] == self.feature:
            self._inputs.spine.setText(
                translate("PNSurfaces", "Select edges of one object, a wire or a sketch first.")
            )
            return
        self.assign("Spine", spine)
        self._show_spine()
        self._show_radius_law()

    def _show_spine(self):
        self._spine = None
        if not self.feature.Spine:
            self._inputs.spine.setText(translate("PNSurfaces", "No spine"))
            return
        source, names = self.feature.Spine
        try:
            container = self.feature.getParentGeoFeatureGroup()
            self._spine = read_spine(source, names, container)
            recognised = _description(self._spine)
        except (ValueError, KernelMissing) as error:
            recognised = str(error)
        self._inputs.spine.setText(f"<b>{title(self.feature.Spine)}</b><br>{recognised}")

    def _show_radius_law(self):
        law = self.feature.RadiusLaw
        by_values = "Radii" in INPUTS_OF_LAW[law]
        self._inputs.Radius.setVisible(not by_values)
        for widget in (self._inputs.start, self._inputs.end, self._inputs.EndRadius):
            widget.setVisible(law == LINEAR)
        self._inputs.radii.setVisible(by_values)
        self._inputs.coefficient_buttons.setVisible(law == BEZIER_COEFFICIENTS)
        if by_values:
            self._fit_radii()
            self._show_radii()

    def _fit_radii(self):
        """Keeps the shape of the law when it needs another number of radii."""
        radii = self.feature.Radii or [self.feature.Radius.Value] * 2
        if self.feature.RadiusLaw == VALUES_AT_VERTICES and self._spine:
            radii = _resampled(radii, len(self._spine.curve.breaks))
        if self._joins_first_vertex():
            radii = radii[:-1] + radii[:1]
        if radii != self.feature.Radii:
            self.assign("Radii", radii)

    def _show_radii(self):
        if self.feature.RadiusLaw == BEZIER_COEFFICIENTS:
            self.radii.show(self.feature.Radii, translate("PNSurfaces", "Coefficient {}"))
        else:
            # The last vertex of a closed spine is its first one.
            count = len(self.feature.Radii) - self._joins_first_vertex()
            self.radii.show(self.feature.Radii[:count], translate("PNSurfaces", "Vertex {}"))

    def _joins_first_vertex(self):
        return (
            self.feature.RadiusLaw == VALUES_AT_VERTICES
            and self._spine is not None
            and self._spine.closed
        )

    def _assign_radii(self):
        again = self.radii.radii[:1] if self._joins_first_vertex() else []
        self.assign("Radii", self.radii.radii + again)

    def _add_coefficient(self):
        self.assign("Radii", self.feature.Radii + self.feature.Radii[-1:])
        self._show_radii()

    def _remove_coefficient(self):
        self.assign("Radii", self.feature.Radii[:-1] or self.feature.Radii)
        self._show_radii()


def _resampled(radii, count):
    """As many radii along the polygon through the given ones."""
    if count == len(radii):
        return radii
    return list(np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(radii)), radii))


def _length(text):
    """The millimetres of a typed length. A bare number is one in the unit that is shown.

    Raises ValueError when the text is no length.
    """
    quantity = FreeCAD.Units.Quantity(text)
    if quantity.Unit == FreeCAD.Units.Length:
        return quantity.Value
    _, factor, _ = FreeCAD.Units.Quantity(1, FreeCAD.Units.Length).getUserPreferred()
    return float(text) * factor


def _description(spine):
    spans = len(spine.curve.breaks) - 1
    text = (
        translate("PNSurfaces", "Degree {}, spans {}, vertices {}, closed")
        if spine.closed
        else translate("PNSurfaces", "Degree {}, spans {}, vertices {}")
    )
    return text.format(spine.curve.degree, spans, spans if spine.closed else spans + 1)
