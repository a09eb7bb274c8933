# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adds the icons, the preferences page and the workbench to FreeCAD's window."""

import FreeCADGui

from pnsurfaces import resources
from pnsurfaces.workbench import PNSurfacesWorkbench

FreeCADGui.addIconPath(resources.ICONS)
FreeCADGui.addPreferencePage(resources.form("preferences"), "PN Surfaces")
FreeCADGui.addWorkbench(PNSurfacesWorkbench())
