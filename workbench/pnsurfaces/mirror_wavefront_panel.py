# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the wavefront of a mirror: a face, and the light."""

import FreeCAD
import FreeCADGui

from pnsurfaces.compat import QtWidgets, connect
from pnsurfaces.mirror_wavefront import PARALLEL, read_mirror
from pnsurfaces.panel import TaskPanel, load_form, title
from pnsurfaces.radius_table import RadiusTable, number_column, short_length_column
from pnsurfaces.selection import selected_direction, selected_face, selected_place

translate = FreeCAD.Qt.translate


class MirrorWavefrontPanel(TaskPanel):
    """Edits the wavefront of a mirror (mirror_wavefront.MirrorWavefront)."""

    def __init__(self, feature):
        self._inputs = load_form("mirror_wavefront")
        self.direction = self._table(self._inputs.direction)
        self.origin = self._table(self._inputs.origin)
        super().__init__(feature, self._inputs)
        for name in ("Face", "Direction", "Origin"):
            self.record(name)
        self.direction.edited.connect(lambda: self._assign_row("Direction", self.direction))
        self.origin.edited.connect(lambda: self._assign_row("Origin", self.origin))
        connect(self._inputs.use_selection, "clicked()", self.use_selection)
        connect(self._inputs.Light, "currentTextChanged(QString)", self._show_light)
        self._show_face()
        self._show_light()

    def use_selection(self):
        """Takes a selected face as the mirror, an edge as the direction, a vertex as the origin."""
        selection = FreeCADGui.Selection.getSelectionEx()
        if any(selected.Object == self.feature for selected in selection):
            selection = []
        place, direction = selected_place(selection), selected_direction(selection)
        face = None if place or direction else selected_face(selection)
        for name, value in (("Origin", place), ("Direction", direction), ("Face", face)):
            if value:
                self.assign(name, value)
        if not (place or direction or face):
            self._inputs.mirror.setText(
                translate("PNSurfaces", "Select one face, one straight edge or one vertex.")
            )
            return
        self._show_face()
        self._show_light()

    def _table(self, view):
        table = RadiusTable()
        view.setModel(table)
        view.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        return table

    def _show_face(self):
        link = self.feature.Face
        try:
            surface = read_mirror(self.feature).surface
            degrees = translate("PNSurfaces", "degree {} x {}")
            recognised = degrees.format(surface.UDegree, surface.VDegree)
        except ValueError as error:
            recognised = str(error)
        picked = f"<b>{title(link)}</b>" if link else ""
        self._inputs.mirror.setText("<br>".join(filter(None, [picked, recognised])))

    def _show_light(self):
        is_parallel = self.feature.Light == PARALLEL
        for widget in (self._inputs.direction, self._inputs.direction_title):
            widget.setVisible(is_parallel)
        self.direction.show([list(self.feature.Direction)], [number_column(x) for x in "xyz"])
        self.origin.show([list(self.feature.Origin)], [short_length_column(x) for x in "xyz"])

    def _assign_row(self, name, table):
        self.assign(name, FreeCAD.Vector(*table.rows[0]))
        self._show_light()
