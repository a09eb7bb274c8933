# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the skins of a mid-surface over a triangulation: a sphere at every point."""

import FreeCAD

from pnsurfaces.compat import QtWidgets
from pnsurfaces.panel import TaskPanel, load_form
from pnsurfaces.radius_table import RadiusTable, short_length_column


class TriangulatedSkinsPanel(TaskPanel):
    """Edits the spheres of triangulated_skins.TriangulatedSkins; triangles and slopes stay."""

    def __init__(self, feature):
        self._inputs = load_form("triangulated_skins")
        self.table = RadiusTable()
        self._inputs.spheres.setModel(self.table)
        self._inputs.spheres.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        super().__init__(feature, self._inputs)
        for name in ("Centres", "Radii"):
            self.record(name)
        self.table.edited.connect(self._assign_table)
        self._show_spheres()

    def _show_spheres(self):
        rows = [[*centre, radius] for centre, radius in zip(self.feature.Centres, self.feature.Radii)]
        columns = [short_length_column(name) for name in (*"xyz", "r")]
        names = tuple(str(point) for point in range(len(rows)))
        self.table.show(rows, columns, names=names)

    def _assign_table(self):
        self.assign("Centres", [FreeCAD.Vector(*row[:3]) for row in self.table.rows])
        self.assign("Radii", self.table.column(-1))
        self._show_spheres()
