# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adds the translations, the icons, the preferences page and the workbench to FreeCAD's window."""

import FreeCADGui

from pnsurfaces import resources
from pnsurfaces.workbench import PNSurfacesWorkbench

FreeCADGui.addLanguagePath(resources.TRANSLATIONS)
FreeCADGui.updateLocale()
FreeCADGui.addIconPath(resources.ICONS)
FreeCADGui.addPreferencePage(resources.form("preferences"), "PN Surfaces")
FreeCADGui.addWorkbench(PNSurfacesWorkbench())
