# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench PN Surfaces: its toolbar and its menu."""

import FreeCADGui

from pnsurfaces import commands, resources


class PNSurfacesWorkbench(FreeCADGui.Workbench):
    """Exact offset surfaces."""

    MenuText = "PN Surfaces"
    ToolTip = "Exact offsets of pipes, ruled surfaces and quadrics, as B-splines"
    Icon = resources.icon("PNSurfaces")

    def Initialize(self):
        names = commands.register()
        self.appendToolbar("PN Surfaces", names)
        self.appendMenu("PN Surfaces", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"
