# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the examples in FreeCAD's window and writes them to a folder, with pictures."""

from typing import Callable, NamedTuple

import FreeCAD
import FreeCADGui
import main_window
from cooling_tower import make_cooling_tower
from intake_horn import make_intake_horn
from reflector import make_reflector
from saddle_roof import make_saddle_roof
from twisted_blade import make_twisted_blade

import pnsurfaces
from pnsurfaces.compat import QtCore, QtWidgets
from pnsurfaces.feature import VALID


class Example(NamedTuple):
    """What is shown of an example.

    `surfaces` are the names of the objects that are exported, the first one selected in the
    pictures. The camera stands at `azimuth` degrees about the vertical axis and `elevation` above
    the horizon.
    """

    file_name: str
    make: Callable
    surfaces: tuple
    azimuth: float
    elevation: float


EXAMPLES = (
    Example("intake_horn", make_intake_horn, ("Outer", "Inner", "Wall"), 26, 27),
    Example("reflector", make_reflector, ("Back", "Front", "Dish"), 30, 35),
    Example("saddle_roof", make_saddle_roof, ("Upper", "Lower", "Shell"), 35, 22),
    Example("cooling_tower", make_cooling_tower, ("Outer", "Inner", "Wall"), 30, 18),
    Example("twisted_blade", make_twisted_blade, ("Suction", "Pressure", "Blade"), 60, 30),
)

# In pixels.
_WINDOW_SIZE = (1440, 940)

# Wide enough, in pixels, for names and values of properties.
_TREE_WIDTH = 380

# Height of the tree and of the properties below it, in pixels.
_TREE_AND_PROPERTIES = (260, 640)


def present(folder):
    """Writes documents, STEP, pictures and, last, the table of certificates to a folder (Path).

    Raises RuntimeError when a surface is in error or irregular.
    """
    _show_window()
    certificates = [row for example in EXAMPLES for row in _presented(example, folder)]
    (folder / "certificates.txt").write_text(_table(certificates))


def _presented(example, folder):
    """Writes the files of one example and returns the certificates of its surfaces."""
    document = example.make()
    surfaces = [document.getObject(name) for name in example.surfaces]
    _require_valid(document.Objects)
    _require_regular(surfaces)
    _take_pictures(example, surfaces[0], folder)
    document.saveAs(str(folder / f"{example.file_name}.FCStd"))
    pnsurfaces.export_step(surfaces, folder / f"{example.file_name}.step")
    certificates = [_certificate(example, surface) for surface in surfaces]
    FreeCAD.closeDocument(document.Name)
    return certificates


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


def _take_pictures(example, selected, folder):
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
    view.setCameraOrientation(_camera(example).Q)
    view.fitAll()
    view.zoomIn()
    main_window.settle()
    view.saveImage(str(folder / f"{example.file_name}_3d.png"), 1600, 1100, "White")
    # A widget cannot grab the OpenGL part of itself, the screen can.
    picture = window.screen().grabWindow(window.winId())
    picture.save(str(folder / f"{example.file_name}.png"))


def _camera(example):
    around = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), example.azimuth)
    return around * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90 - example.elevation)


def _table(certificates):
    """Certificates, a line each."""
    header = (
        "example", "surface", "distance", "degree", "poles", "deviation", "exact", "regular offsets"
    )
    rows = [header, *certificates]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines) + "\n"


def _certificate(example, surface):
    sign = "±" if surface.Sides == "Both sides" else ""
    return (
        example.file_name,
        surface.Label,
        f"{sign}{surface.Distance.Value:g} mm",
        surface.Degree,
        str(surface.Poles),
        surface.Deviation,
        "yes" if surface.Exact else "no",
        f"{surface.MinOffset.Value:.6g} to {surface.MaxOffset.Value:.6g} mm",
    )
