# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench PN Surfaces: its toolbar and its menu.

FreeCAD imports this module when it starts; all that the commands need is imported when the workbench
is first chosen.
"""

import FreeCADGui

from pnsurfaces import resources


class PNSurfacesWorkbench(FreeCADGui.Workbench):
    """Exact offset surfaces."""

    MenuText = "PN Surfaces"
    ToolTip = "Exact offsets of pipes, ruled surfaces and quadrics, as B-splines"
    Icon = resources.icon("PNSurfaces")

    def Initialize(self):
        from pnsurfaces import commands

        names = commands.register()
        self.appendToolbar("PN Surfaces", names)
        self.appendMenu("PN Surfaces", names)
        self._analyses = commands.register_analysis()
        self.appendToolbar("PN Analysis", self._analyses)
        self.appendMenu(["PN Surfaces", "Analysis"], self._analyses)

    def ContextMenu(self, recipient):
        from pnsurfaces.analysis_commands import selected_analyses

        if selected_analyses():
            self.appendContextMenu("PN Analysis", self._analyses)
            self.appendContextMenu([], ["PNSurfaces_Certificate", "PNSurfaces_ExportStep"])

    def GetClassName(self):
        return "Gui::PythonWorkbench"
