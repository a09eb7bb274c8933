# SPDX-License-Identifier: LGPL-2.1-or-later
"""How every exact surface appears in the tree, and that a double-click edits it."""

import FreeCAD
import FreeCADGui

from pnsurfaces import resources
from pnsurfaces.analysis import Analysis
from pnsurfaces.canal_surface import CanalSurface
from pnsurfaces.canal_surface_panel import CanalSurfacePanel
from pnsurfaces.compat import connect
from pnsurfaces.mid_surface_skins import MidSurfaceSkins
from pnsurfaces.mid_surface_skins_panel import MidSurfaceSkinsPanel
from pnsurfaces.mirror_wavefront import MirrorWavefront
from pnsurfaces.mirror_wavefront_panel import MirrorWavefrontPanel
from pnsurfaces.moving_conic_section import MovingConicSection
from pnsurfaces.moving_conic_section_panel import MovingConicSectionPanel
from pnsurfaces.quadric_offset import QuadricOffset
from pnsurfaces.quadric_offset_panel import QuadricOffsetPanel
from pnsurfaces.ruled_offset import RuledOffset
from pnsurfaces.ruled_offset_panel import RuledOffsetPanel
from pnsurfaces.squared_radius_canal import SquaredRadiusCanal
from pnsurfaces.squared_radius_canal_panel import SquaredRadiusCanalPanel
from pnsurfaces.triangulated_skins import TriangulatedSkins
from pnsurfaces.triangulated_skins_panel import TriangulatedSkinsPanel

translate = FreeCAD.Qt.translate

# The task panel that edits a feature of each class.
PANELS = {
    CanalSurface: CanalSurfacePanel,
    MidSurfaceSkins: MidSurfaceSkinsPanel,
    MirrorWavefront: MirrorWavefrontPanel,
    MovingConicSection: MovingConicSectionPanel,
    QuadricOffset: QuadricOffsetPanel,
    RuledOffset: RuledOffsetPanel,
    SquaredRadiusCanal: SquaredRadiusCanalPanel,
    TriangulatedSkins: TriangulatedSkinsPanel,
}

# Edit modes other than this one (moving, colouring) are FreeCAD's own.
_DEFAULT_MODE = 0

# FreeCAD's own tessellation shows corners on a flaring tube: per cent of its size, and degrees.
_DEVIATION = 0.1
_ANGULAR_DEFLECTION = 10


class ViewProviderPNSurface:
    """View provider of an exact surface. Its path is part of the file format."""

    def __init__(self, view_object):
        view_object.Proxy = self
        # FreeCAD does so itself, but not where it read the object from a file without its view.
        self.attach(view_object)
        view_object.Deviation = _DEVIATION
        view_object.AngularDeflection = _ANGULAR_DEFLECTION

    def attach(self, view_object):
        self.object = view_object.Object
        self.panel = None
        self.analysis = Analysis(view_object)

    def updateData(self, obj, name):
        if name == "Shape":
            self.analysis.update()

    def onChanged(self, view_object, name):
        # FreeCAD reports properties before it attaches the provider, too.
        if name == "Visibility" and hasattr(self, "analysis"):
            self.analysis.follow_visibility()

    def getIcon(self):
        return resources.icon(f"PNSurfaces_{type(self.object.Proxy).__name__}")

    def claimChildren(self):
        """The objects that the surface is made from."""
        names = self.object.PropertiesList
        links = [
            getattr(self.object, name)
            for name in names
            if self.object.getTypeIdOfProperty(name) == "App::PropertyLinkSub"
        ]
        # Two links may lead to one object.
        return list(dict.fromkeys(link[0] for link in links if link))

    def doubleClicked(self, view_object):
        self._edit()
        return True

    def setupContextMenu(self, view_object, menu):
        title = translate("PNSurfaces", "Edit {}").format(self.object.Label)
        connect(menu.addAction(title), "triggered()", self._edit)

    def _edit(self):
        FreeCADGui.getDocument(self.object.Document.Name).setEdit(self.object.Name)

    def setEdit(self, view_object, mode):
        if mode != _DEFAULT_MODE:
            return None
        self.panel = PANELS[type(self.object.Proxy)](self.object)
        FreeCADGui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, view_object, mode):
        if mode != _DEFAULT_MODE:
            return None
        self.panel.close()
        self.panel = None
        FreeCADGui.Control.closeDialog()
        return True

    # FreeCAD calls the first pair up to version 0.21, the second one later. Nothing is stored.

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    def dumps(self):
        return None

    def loads(self, state):
        return None
