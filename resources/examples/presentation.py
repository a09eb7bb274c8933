# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the intake horn in FreeCAD's window and writes it to a folder, with pictures of it."""

import FreeCAD
import FreeCADGui
import main_window
from intake_horn import make_intake_horn

import pnsurfaces
from pnsurfaces.compat import QtCore, QtWidgets
from pnsurfaces.feature import VALID

# Where the camera stands: degrees about the vertical axis and above the horizon.
_AZIMUTH, _ELEVATION = 26, 27

# In pixels.
_WINDOW_SIZE = (1440, 940)

# Wide enough, in pixels, for names and values of properties.
_TREE_WIDTH = 380

# Height of the tree and of the properties below it, in pixels.
_TREE_AND_PROPERTIES = (260, 640)


def present(folder):
    """Writes document, STEP, pictures and, last, the table of certificates to a folder (Path).

    Raises RuntimeError when a surface is in error or irregular.
    """
    _show_window()
    document = make_intake_horn()
    surfaces = [document.Outer, document.Inner, document.Wall]
    _require_valid(document.Objects)
    _require_regular(surfaces)
    _take_pictures(document.Outer, folder)
    document.saveAs(str(folder / "intake_horn.FCStd"))
    pnsurfaces.export_step(surfaces, folder / "intake_horn.step")
    (folder / "certificates.txt").write_text(_table(surfaces))
    FreeCAD.closeDocument(document.Name)


def _show_window():
    main_window.show()
    window = FreeCADGui.getMainWindow()
    window.resize(*_WINDOW_SIZE)
    # Without the Start page and the progress of loading it.
    window.findChild(QtWidgets.QMdiArea).closeAllSubWindows()
    window.statusBar().hide()
    combo_view = window.findChild(QtWidgets.QDockWidget, "Combo View")
    window.resizeDocks([combo_view], [_TREE_WIDTH], QtCore.Qt.Horizontal)
    combo_view.findChild(QtWidgets.QSplitter).setSizes(_TREE_AND_PROPERTIES)


def _require_valid(objects):
    for obj in objects:
        if not obj.isValid():
            raise RuntimeError(f"{obj.Label}: {obj.getStatusString()}")


def _require_regular(surfaces):
    for surface in surfaces:
        if surface.Status != VALID:
            raise RuntimeError(f"{surface.Label}: {surface.Status}")


def _take_pictures(selected, folder):
    """Pictures of the 3D view and of the window, with the properties of `selected`."""
    window = FreeCADGui.getMainWindow()
    combo_view = window.findChild(QtWidgets.QDockWidget, "Combo View")
    # The tree follows the document after a while.
    main_window.settle()
    combo_view.findChild(QtWidgets.QTreeWidget).expandAll()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(selected)
    view = FreeCADGui.activeDocument().activeView()
    view.setAnimationEnabled(False)
    view.setCameraOrientation(_camera().Q)
    view.fitAll()
    view.zoomIn()
    main_window.settle()
    view.saveImage(str(folder / "intake_horn_3d.png"), 1600, 1100, "White")
    # A widget cannot grab the OpenGL part of itself, the screen can.
    picture = window.screen().grabWindow(window.winId())
    picture.save(str(folder / "intake_horn.png"))


def _camera():
    around = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), _AZIMUTH)
    return around * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90 - _ELEVATION)


def _table(surfaces):
    """The certificates of surfaces in the tree, a line each."""
    header = ("surface", "distance", "degree", "poles", "deviation", "exact", "regular offsets")
    rows = [header, *(_certificate(surface) for surface in surfaces)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines) + "\n"


def _certificate(surface):
    sign = "±" if surface.Sides == "Both sides" else ""
    return (
        surface.Label,
        f"{sign}{surface.Distance.Value:g} mm",
        surface.Degree,
        str(surface.Poles),
        surface.Deviation,
        "yes" if surface.Exact else "no",
        f"{surface.MinOffset.Value:.6g} to {surface.MaxOffset.Value:.6g} mm",
    )
