# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. What they do is the script that a recorded macro repeats."""

import FreeCAD
import FreeCADGui

from pnsurfaces import kernel, preferences
from pnsurfaces.canal_surface_panel import selected_spine
from pnsurfaces.compat import QtCore, QtWidgets
from pnsurfaces.panel import literal

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

# A tube as thick as a tenth of the spine's length is seen at once and seldom meets itself.
_LENGTH_PER_RADIUS = 20


class CanalSurfaceCommand:
    """Makes a canal surface around the selected spine and opens its task panel."""

    name = "PNSurfaces_CanalSurface"

    def GetResources(self):
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("PNSurfaces_CanalSurface", "Canal surface…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "PNSurfaces_CanalSurface",
                "Creates the exact pipe of varying radius around a spine, and its exact offsets",
            ),
        }

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        try:
            kernel.pnkernel()
        except kernel.KernelMissing as error:
            _explain(str(error))
            return
        spine = selected_spine(FreeCADGui.Selection.getSelectionEx())
        if spine is None:
            _explain(
                translate(
                    "PNSurfaces",
                    "Select the spine first: edges of one object, a wire or a sketch.",
                )
            )
            return
        document = FreeCAD.ActiveDocument
        # It stays open until the task panel is closed by OK or Cancel.
        document.openTransaction(translate("PNSurfaces", "Canal surface"))
        try:
            FreeCADGui.doCommand("import pnsurfaces")
            FreeCADGui.doCommand(_creation(spine))
            FreeCADGui.getDocument(document.Name).setEdit(document.ActiveObject.Name)
        except Exception:
            FreeCAD.closeActiveTransaction(True)
            raise


class ExportStepCommand:
    """Writes the selected shapes to a STEP file that keeps every double."""

    name = "PNSurfaces_ExportStep"

    def GetResources(self):
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("PNSurfaces_ExportStep", "STEP export…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "PNSurfaces_ExportStep",
                "Writes the selected objects to a STEP file that keeps every digit",
            ),
        }

    def IsActive(self):
        return bool(FreeCADGui.Selection.getSelection())

    def Activated(self):
        objects = FreeCADGui.Selection.getSelection()
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(),
            translate("PNSurfaces", "STEP export"),
            f"{objects[0].Label}.step",
            translate("PNSurfaces", "STEP files (*.step *.stp)"),
        )
        if not path:
            return
        schema = preferences.step_schema()
        FreeCADGui.doCommand("import pnsurfaces")
        try:
            FreeCADGui.doCommand(
                f"pnsurfaces.export_step({literal(objects)}, {path!r}, schema={schema!r})"
            )
        except Exception as error:
            _explain(str(error))


def register():
    """Makes the commands known to FreeCAD and returns their names, in the order of the toolbar."""
    commands = [CanalSurfaceCommand(), ExportStepCommand()]
    for command in commands:
        FreeCADGui.addCommand(command.name, command)
    return [command.name for command in commands]


def _creation(spine):
    """The call that makes a canal surface around `spine`, as Python source."""
    arguments = [
        literal(spine),
        repr(_start_radius(spine)),
        repr(preferences.distance()),
        f"ParameterLines={preferences.parameter_lines()!r}",
    ]
    return f"pnsurfaces.make_canal_surface({', '.join(arguments)})"


def _start_radius(spine):
    """A radius in proportion to the spine, with one significant digit, in millimetres."""
    source, names = spine
    edges = [source.getSubObject(name) for name in names] or source.Shape.Edges
    return float(f"{sum(edge.Length for edge in edges) / _LENGTH_PER_RADIUS:.0e}")


def _explain(sentence):
    QtWidgets.QMessageBox.information(FreeCADGui.getMainWindow(), "PN Surfaces", sentence)
