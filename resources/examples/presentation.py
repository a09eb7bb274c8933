# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the examples in FreeCAD's window and writes them to a folder, with pictures."""

import FreeCAD
import FreeCADGui
import main_window
from pivy import coin

import pnsurfaces
from pnsurfaces.compat import QtCore, QtGui, QtWidgets
from pnsurfaces.examples import gallery
from pnsurfaces.feature import VALID


# In pixels.
_WINDOW_SIZE = (1280, 840)

# Wide enough, in pixels, for names and values of properties.
_TREE_WIDTH = 340

# Pictures are drawn this large, in pixels, cut to what is shown with a margin around it, and made
# smaller, which leaves no jagged line.
_DRAWING_SIZE = (2400, 1650)
_MARGIN = 40
_PICTURE_SIZE = (880, 600)

# The light in a view: FreeCAD's own comes from the camera and leaves slanted faces black. The
# percentage of that one, light from everywhere, and lights from the left above and the right, as
# directions in the coordinates of the camera with their intensities.
_HEADLIGHT = 55
_AMBIENT = 0.9
_LIGHTS = (((0.6, -0.8, -0.7), 0.45), ((-0.9, 0.1, -0.5), 0.3))

_WHITE = 0xFFFFFFFF

# Height of the tree and of the properties below it, in pixels.
_TREE_AND_PROPERTIES = (220, 580)


def present(folder):
    """Writes documents, STEP, pictures and, last, the table of certificates to a folder (Path).

    Raises RuntimeError when a surface is in error or irregular.
    """
    _show_window()
    certificates = [row for example in gallery() for row in _presented(example, folder)]
    (folder / "certificates.txt").write_text(_table(certificates))


def _presented(example, folder):
    """Writes the files of one example and returns the certificates of its surfaces."""
    document = pnsurfaces.open_example(example.name)
    surfaces = [document.getObject(name) for name in example.surfaces]
    _require_valid(document.Objects)
    _require_regular(surfaces)
    _take_pictures(example, surfaces[0], folder)
    document.saveAs(str(folder / f"{example.name}.FCStd"))
    pnsurfaces.export_step(surfaces, folder / f"{example.name}.step")
    certificates = [_certificate(example, surface) for surface in surfaces]
    FreeCAD.closeDocument(document.Name)
    return certificates


def _show_window():
    # FreeCAD stores preferences when it is closed, which the demo does not wait for.
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    preferences.SetInt("HeadlightIntensity", _HEADLIGHT)
    preferences.SetBool("Gradient", False)
    preferences.SetUnsigned("BackgroundColor", _WHITE)
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
    """Pictures of the window, with the properties of `selected`, and of the surfaces alone."""
    window = FreeCADGui.getMainWindow()
    combo_view = window.findChild(QtWidgets.QDockWidget, "Combo View")
    # The tree follows the document after a while.
    main_window.settle()
    combo_view.findChild(QtWidgets.QTreeWidget).expandAll()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(selected)
    view = FreeCADGui.activeDocument().activeView()
    view.setAnimationEnabled(False)
    view.setCameraType("Perspective")
    camera = _camera(example)
    view.setCameraOrientation(camera.Q)
    view.fitAll()
    _light(view, camera)
    main_window.settle()
    # A widget cannot grab the OpenGL part of itself, the screen can.
    picture = window.screen().grabWindow(window.winId())
    picture.save(str(folder / f"{example.name}_window.png"))
    FreeCADGui.Selection.clearSelection()
    path = str(folder / f"{example.name}.png")
    view.saveImage(path, *_DRAWING_SIZE, "White")
    _trimmed(QtGui.QImage(path)).save(path)


def _light(view, camera):
    """Lights a view whose camera has the orientation `camera` (FreeCAD.Rotation)."""
    scene = view.getSceneGraph()
    for direction, intensity in _LIGHTS:
        light = coin.SoDirectionalLight()
        light.direction = tuple(camera.multVec(FreeCAD.Vector(*direction)))
        light.intensity = intensity
        scene.insertChild(light, 0)
    environment = coin.SoEnvironment()
    environment.ambientIntensity = _AMBIENT
    scene.insertChild(environment, 0)


def _trimmed(image):
    """What is shown on a white image, in the size of a picture."""
    shown = QtGui.QRegion(QtGui.QBitmap.fromImage(image.createMaskFromColor(_WHITE)))
    rectangle = shown.boundingRect().adjusted(-_MARGIN, -_MARGIN, _MARGIN, _MARGIN)
    return image.copy(rectangle).scaled(
        *_PICTURE_SIZE, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation
    )


def _camera(example):
    around = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), example.azimuth)
    return around * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90 - example.elevation)


def _table(certificates):
    """Certificates, a line each."""
    header = (
        "example",
        "surface",
        "distance",
        "degree",
        "poles",
        "deviation",
        "exact",
        "regular offsets",
    )
    rows = [header, *certificates]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return "\n".join(lines) + "\n"


def _certificate(example, surface):
    distance, limits = _offset(surface)
    return (
        example.name,
        surface.Label,
        distance,
        surface.Degree,
        str(surface.Poles),
        surface.Deviation,
        "yes" if surface.Exact else "no",
        limits,
    )


def _offset(surface):
    """Distance and regular distances as text."""
    if not surface.Proxy.offset_inputs:
        return "none", "none"
    sign = "±" if surface.Sides == "Both sides" else ""
    return (
        f"{sign}{surface.Distance.Value:g} mm",
        f"{surface.MinOffset.Value:.6g} to {surface.MaxOffset.Value:.6g} mm",
    )
