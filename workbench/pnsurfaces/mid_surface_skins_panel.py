# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the skins of a mid-surface: six spheres."""

import FreeCAD
import FreeCADGui

from pnsurfaces.compat import QtWidgets, connect
from pnsurfaces.mid_surface_skins import read_net
from pnsurfaces.panel import TaskPanel, load_form, title
from pnsurfaces.radius_table import RadiusTable, short_length_column
from pnsurfaces.selection import selected_points
from pnsurfaces.sphere_marks import SphereMarks

translate = FreeCAD.Qt.translate

# The names of the spheres in the order of the properties: the corners, then those between them.
_NAMES = ("A", "B", "C", "AB", "BC", "CA")


class MidSurfaceSkinsPanel(TaskPanel):
    """Edits the skins of a mid-surface (mid_surface_skins.MidSurfaceSkins)."""

    def __init__(self, feature):
        self._inputs = load_form("mid_surface_skins")
        self.table = RadiusTable()
        self._inputs.spheres.setModel(self.table)
        self._inputs.spheres.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self._spheres = SphereMarks(feature.ViewObject)
        super().__init__(feature, self._inputs)
        for name in ("Points", "Centres", "Radii"):
            self.record(name)
        self.table.edited.connect(self._assign_table)
        connect(self._inputs.use_selection, "clicked()", self.use_selection)
        self._show_net()

    def use_selection(self):
        """Makes the selected vertices the points of the net."""
        points = selected_points(FreeCADGui.Selection.getSelectionEx())
        if points is None or points[0] == self.feature:
            self._inputs.points.setText(
                translate("PNSurfaces", "Select three or six vertices of one object.")
            )
            return
        self.assign("Points", points)
        self._show_net()

    def close(self):
        super().close()
        self._spheres.hide()

    def _show_net(self):
        link = self.feature.Points
        try:
            rows, problem = read_net(self.feature), ""
            self._spheres.show(rows)
        except ValueError as error:
            rows, problem = [], str(error)
            self._spheres.hide()
        picked = f"<b>{title(link)}</b>" if link else translate("PNSurfaces", "Typed below")
        self._inputs.points.setText("<br>".join(filter(None, [picked, problem])))
        columns = [short_length_column(name) for name in (*"xyz", "r")]
        self.table.show([list(map(float, row)) for row in rows], columns, names=_NAMES)

    def _assign_table(self):
        """A typed centre replaces the points that were picked, a typed radius does not."""
        centres = [FreeCAD.Vector(*row[:3]) for row in self.table.rows]
        before = [FreeCAD.Vector(*row[:3]) for row in read_net(self.feature)]
        if centres != before:
            self.assign("Points", None)
            self.assign("Centres", centres)
        self.assign("Radii", self.table.column(-1))
        self._show_net()
