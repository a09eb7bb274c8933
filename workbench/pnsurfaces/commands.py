# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. What they do is the script that a recorded macro repeats."""

import contextlib

import FreeCAD
import FreeCADGui

from pnsurfaces import kernel, preferences
from pnsurfaces.analysis_commands import analysis_commands
from pnsurfaces.certificate_panel import CertificatePanel
from pnsurfaces.command import Command
from pnsurfaces.compat import QtCore, QtWidgets
from pnsurfaces.documentation import show_documentation
from pnsurfaces.edge_chain import end, read_edge_chain, start
from pnsurfaces.examples_dialog import ask_example
from pnsurfaces.export_path import ask_export_path
from pnsurfaces.linked_shape import only_face
from pnsurfaces.mirror_wavefront import facing_light
from pnsurfaces.moving_conic_section import suitable_up
from pnsurfaces.panel import literal
from pnsurfaces.selection import selected_face, selected_pair, selected_points, selected_spine

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

# A tube as thick as a tenth of the spine's length is seen at once and seldom meets itself, one as
# thick as half an edge gets round most corners.
_LENGTH_PER_RADIUS = 20
_EDGE_PER_RADIUS = 4

# Half-axes of a new quadric, in millimetres: unequal, so that all three are seen.
_HALF_AXES = (40.0, 30.0, 20.0)

# Its bounds once it has some: those of quadric_offset.suitable_bounds.
_BOUNDS = {"MinX": -20.0, "MaxX": 20.0, "MinY": -15.0, "MaxY": 15.0, "MinZ": 0.0, "MaxZ": 20.0}


# The net of a new mid-surface, a shallow dome, and its radii, in millimetres: corners first.
_NET = [
    (0.0, 0.0, 0.0),
    (100.0, 0.0, 0.0),
    (50.0, 80.0, 0.0),
    (50.0, 0.0, 12.0),
    (75.0, 40.0, 12.0),
    (25.0, 40.0, 12.0),
]
_NET_RADII = [3.0, 3.0, 3.0, 4.0, 4.0, 4.0]


class CreationCommand(Command):
    """Makes a surface of what is selected and opens its task panel.

    A subclass names it and turns the selection into the call that makes the surface.
    """

    transaction = ""

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        try:
            kernel.pnkernel()
            creation = self.creation(FreeCADGui.Selection.getSelectionEx())
        except (kernel.KernelMissing, NothingSelected) as error:
            _explain(str(error))
            return
        document = FreeCAD.ActiveDocument
        is_first = not document.Objects
        # It stays open until the task panel is closed by OK or Cancel.
        document.openTransaction(translate("PNSurfaces", self.transaction))
        try:
            FreeCADGui.doCommand("import pnsurfaces")
            # What is made of other objects may take long: the panel computes it beside the window.
            with contextlib.nullcontext() if is_first else _frozen(document):
                FreeCADGui.doCommand(creation)
            FreeCADGui.getDocument(document.Name).setEdit(document.ActiveObject.Name)
            if is_first:
                FreeCADGui.SendMsgToActiveView("ViewFit")
        except Exception:
            FreeCAD.closeActiveTransaction(True)
            raise

    def creation(self, selection):
        """The call that makes the surface, as Python source.

        Raises NothingSelected with a sentence on what to select.
        """
        raise NotImplementedError


class NothingSelected(ValueError):
    """The selection is not what a command needs. The text is a sentence for the user."""


class CanalSurfaceCommand(CreationCommand):
    """Makes a canal surface around the selected spine and opens its task panel."""

    name = "PNSurfaces_CanalSurface"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_CanalSurface", "Canal Surface…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_CanalSurface",
        "Creates the exact pipe of varying radius around a spine, and its exact offsets",
    )
    page = "canal_surface_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Canal surface")

    def creation(self, selection):
        spine = _needed_spine(selection)
        return _call("make_canal_surface", literal(spine), repr(_start_radius(spine)))


class SquaredRadiusCanalCommand(CreationCommand):
    """Makes a canal surface from r^2 around the selected spine and opens its task panel."""

    name = "PNSurfaces_SquaredRadiusCanal"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_SquaredRadiusCanal", "Canal Surface from r²…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_SquaredRadiusCanal",
        "Creates the exact envelope of spheres around a spine whose squared radius is given",
    )
    page = "squared_radius_canal_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Canal surface from r²")

    def creation(self, selection):
        spine = _needed_spine(selection)
        square = float(f"{_start_radius(spine) ** 2:.0e}")
        return _call("make_squared_radius_canal", literal(spine), repr(square))


class RuledOffsetCommand(CreationCommand):
    """Makes the offset of a ruled surface of the selection and opens its task panel."""

    name = "PNSurfaces_RuledOffset"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_RuledOffset", "Ruled Surface Offset…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_RuledOffset",
        "Creates the exact offset of the surface of straight lines between two curves",
    )
    page = "ruled_offset_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Ruled surface offset")

    def creation(self, selection):
        face = selected_face(selection)
        if face:
            return _call("make_ruled_offset", literal(face), "None")
        pair = selected_pair(selection)
        if pair is None:
            raise NothingSelected(
                translate(
                    "PNSurfaces", "Select two edges, wires or sketches first, or one ruled face."
                )
            )
        return _call("make_ruled_offset", *map(literal, pair), Reversed=_run_apart(*pair))


class QuadricOffsetCommand(CreationCommand):
    """Makes the offset of a quadric, of the selected face if there is one, and opens its panel."""

    name = "PNSurfaces_QuadricOffset"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_QuadricOffset", "Quadric Offset…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_QuadricOffset",
        "Creates the exact offset of an ellipsoid, hyperboloid, paraboloid, cone or cylinder",
    )
    page = "quadric_offset_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Quadric offset")

    def creation(self, selection):
        face = selected_face(selection)
        if face:
            return _call("make_quadric_offset", literal(face), *map(repr, _HALF_AXES))
        return _call("make_quadric_offset", repr("Ellipsoid"), *map(repr, _HALF_AXES), **_BOUNDS)


class MidSurfaceSkinsCommand(CreationCommand):
    """Makes the skins of a mid-surface, on the selected vertices if there are any."""

    name = "PNSurfaces_MidSurfaceSkins"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_MidSurfaceSkins", "Mid-Surface Skins…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_MidSurfaceSkins",
        "Creates both exact skins of a mid-surface whose thickness varies, from six spheres",
    )
    page = "mid_surface_skins_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Mid-surface skins")

    def creation(self, selection):
        points = selected_points(selection)
        net = literal(points) if points else repr(_NET)
        return _call("make_mid_surface_skins", net, repr(_NET_RADII))


class MirrorWavefrontCommand(CreationCommand):
    """Makes the wavefront that the selected face reflects, of light that faces it."""

    name = "PNSurfaces_MirrorWavefront"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_MirrorWavefront", "Mirror Wavefront…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_MirrorWavefront",
        "Creates the exact wavefront of parallel light, or of light from a point, behind a mirror",
    )
    page = "mirror_wavefront_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Mirror wavefront")

    def creation(self, selection):
        face = selected_face(selection)
        if face is None:
            raise NothingSelected(translate("PNSurfaces", "Select the mirror first: one face."))
        direction, origin, distance = facing_light(only_face(face))
        light = f"direction={direction!r}, origin={origin!r}"
        lines = f"ParameterLines={preferences.parameter_lines()!r}"
        return f"pnsurfaces.make_mirror_wavefront({literal(face)}, {distance!r}, {light}, {lines})"


class MovingConicSectionCommand(CreationCommand):
    """Makes the surface of conics along the selected spine and opens its task panel."""

    name = "PNSurfaces_MovingConicSection"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_MovingConicSection", "Moving Conic Section…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_MovingConicSection",
        "Creates the exact surface of ellipses, parabolas or hyperbolas along a spine, which change",
    )
    page = "moving_conic_section_command.md"
    transaction = QT_TRANSLATE_NOOP("PNSurfaces", "Moving conic section")

    def creation(self, selection):
        spine = _needed_spine(selection)
        radius = _start_radius(spine)
        half_axes, up = repr((2 * radius, radius)), repr(suitable_up(_edges(spine)))
        # As wide and high whatever is chosen in the panel: 2 R h is the square of half the width.
        properties = {
            **dict.fromkeys(("EndHalfWidth", "Radius", "EndRadius"), 2 * radius),
            **dict.fromkeys(("EndHalfHeight", "Depth", "EndDepth"), radius),
            "ParameterLines": preferences.parameter_lines(),
        }
        values = ", ".join(f"{name}={value!r}" for name, value in properties.items())
        given = f"{literal(spine)}, {half_axes}, up={up}, {values}"
        return f"pnsurfaces.make_moving_conic_section({given})"


class ExportStepCommand(Command):
    """Writes the selected shapes to a STEP file that keeps every double."""

    name = "PNSurfaces_ExportStep"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_ExportStep", "STEP Export…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_ExportStep", "Writes the selected objects to a STEP file that keeps every digit"
    )
    page = "step_export_command.md"

    def IsActive(self):
        return bool(FreeCADGui.Selection.getSelection())

    def Activated(self):
        objects = FreeCADGui.Selection.getSelection()
        path = ask_export_path(
            translate("PNSurfaces", "STEP export"),
            f"{objects[0].Label}.step",
            translate("PNSurfaces", "STEP files (*.step *.stp)"),
        )
        if not path:
            return
        options = (
            f"schema={preferences.step_schema()!r},"
            f" parametric_curves={preferences.step_parametric_curves()!r}"
        )
        FreeCADGui.doCommand("import pnsurfaces")
        try:
            FreeCADGui.doCommand(f"pnsurfaces.export_step({literal(objects)}, {path!r}, {options})")
        except FreeCAD.Base.FreeCADAbort:
            FreeCAD.Console.PrintMessage(translate("PNSurfaces", "STEP export cancelled.") + "\n")
        except Exception as error:
            _explain(str(error))


class CertificateCommand(Command):
    """Shows the certificate of the selected objects in a panel."""

    name = "PNSurfaces_Certificate"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_Certificate", "Certificate…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_Certificate",
        "Shows what is proved and measured of the selected surfaces, to read, copy and save",
    )
    page = "certificate_command.md"

    def IsActive(self):
        return bool(FreeCADGui.Selection.getSelection()) and not FreeCADGui.Control.activeDialog()

    def Activated(self):
        try:
            panel = CertificatePanel(FreeCADGui.Selection.getSelection())
        except kernel.KernelMissing as error:
            _explain(str(error))
            return
        FreeCADGui.Control.showDialog(panel)


class ExamplesCommand(Command):
    """Shows the gallery of examples, and makes the one that is chosen."""

    name = "PNSurfaces_Examples"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_Examples", "Examples…")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_Examples", "Opens a ready document from the gallery of examples"
    )
    page = "examples_command.md"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        try:
            kernel.pnkernel()
        except kernel.KernelMissing as error:
            _explain(str(error))
            return
        name = ask_example(FreeCADGui.getMainWindow())
        if name is None:
            return
        FreeCADGui.doCommand("import pnsurfaces")
        FreeCADGui.doCommand(f"pnsurfaces.open_example({name!r})")
        FreeCADGui.activeDocument().activeView().viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")


class DocumentationCommand(Command):
    """Opens the documentation."""

    name = "PNSurfaces_Documentation"
    menu_text = QT_TRANSLATE_NOOP("PNSurfaces_Documentation", "Documentation")
    tooltip = QT_TRANSLATE_NOOP(
        "PNSurfaces_Documentation", "Shows what the commands do, and the theorems they rest on"
    )
    page = "README.md"

    def Activated(self):
        show_documentation(self.page)


def register():
    """Makes the commands known to FreeCAD and returns their names, in the order of the toolbar."""
    return _registered(
        [
            CanalSurfaceCommand(),
            SquaredRadiusCanalCommand(),
            RuledOffsetCommand(),
            QuadricOffsetCommand(),
            MidSurfaceSkinsCommand(),
            MirrorWavefrontCommand(),
            MovingConicSectionCommand(),
            CertificateCommand(),
            ExportStepCommand(),
            ExamplesCommand(),
            DocumentationCommand(),
        ]
    )


def register_analysis():
    """The same for the commands of the toolbar of analyses."""
    return _registered(analysis_commands())


def _registered(commands):
    for command in commands:
        FreeCADGui.addCommand(command.name, command)
    return [command.name for command in commands]


def _call(function, *arguments, **properties):
    """A call of pnsurfaces that makes a new surface as the preferences want it, as source."""
    properties["ParameterLines"] = preferences.parameter_lines()
    assignments = [f"{name}={value!r}" for name, value in properties.items()]
    every = [*arguments, repr(preferences.distance()), *assignments]
    return f"pnsurfaces.{function}({', '.join(every)})"


@contextlib.contextmanager
def _frozen(document):
    """New surfaces are not computed meanwhile."""
    was_frozen = document.RecomputesFrozen
    document.RecomputesFrozen = True
    try:
        yield
    finally:
        document.RecomputesFrozen = was_frozen


def _needed_spine(selection):
    """The selected spine. Raises NothingSelected."""
    spine = selected_spine(selection)
    if spine is None:
        raise NothingSelected(
            translate("PNSurfaces", "Select the spine first: edges of one object, a wire or a sketch.")
        )
    return spine


def _edges(spine):
    source, names = spine
    return [source.getSubObject(name) for name in names] or source.Shape.Edges


def _start_radius(spine):
    """A radius in proportion to the spine, with one significant digit, in millimetres."""
    edges = _edges(spine)
    length = sum(edge.Length for edge in edges)
    radius = min(length / _LENGTH_PER_RADIUS, length / len(edges) / _EDGE_PER_RADIUS)
    return float(f"{radius:.0e}")


def _run_apart(first, second):
    """Whether the ends of two curves are nearer when the second is run through backwards."""
    try:
        a, b = (read_edge_chain(*link).curves for link in (first, second))
    except ValueError:
        return False  # The feature says what is wrong with the edges.
    ends = (start(a[0]), end(a[-1])), (start(b[0]), end(b[-1]))
    straight = sum(p.distanceToPoint(q) for p, q in zip(*ends))
    crossed = sum(p.distanceToPoint(q) for p, q in zip(ends[0], reversed(ends[1])))
    return crossed < straight


def _explain(sentence):
    QtWidgets.QMessageBox.information(FreeCADGui.getMainWindow(), "PN Surfaces", sentence)
