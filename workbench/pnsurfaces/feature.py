# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all exact surfaces in the tree share: offset, output, results, status and storage."""

import math
from decimal import ROUND_UP, Context
from types import MappingProxyType
from typing import Any, NamedTuple

import FreeCAD

from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.feature_inputs import agree, read_inputs
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.linked_shape import LinkError
from pnsurfaces.shape import measured, own_shape, solid_of_sections, storage_loss, surface_of_sections

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# The choice of Sides that makes one surface, and that of Output whose two surfaces are a wall.
ONE_SIDE = "Offset"
TWO_OFFSETS = "Two offsets"
SOLID = "Solid"

# The distances that each choice shows, the smallest first.
SIDES = {
    ONE_SIDE: lambda distance, second: [distance],
    "Base and offset": lambda distance, second: sorted({0.0, distance}),
    "Both sides": lambda distance, second: sorted({-distance, distance}),
    TWO_OFFSETS: lambda distance, second: sorted({distance, second}),
}

OUTPUTS = ["Surface", SOLID]

# What the user chooses, and what the kernel calls it.
PARAMETER_LINES = {"Even": "even", "Lowest degree": "lowest_degree"}

VALID = "Valid"

# FreeCAD writes the numbers of a file with 17 decimals: this far, in millimetres, may each be off,
# half by writing and half by reading.
STORED_RESOLUTION = 1e-17

# Attributes of FreeCAD's properties. A change of an output asks for no recompute.
READ_ONLY = 1
HIDDEN = 4
OUTPUT = 8

# Editor modes of FreeCAD's properties.
_SHOWN = 0
_HIDDEN = 2


class Base(NamedTuple):
    """The kernel's surface at distance 0, and what had to be found out about the input.

    `notes` are sentences on what was done to the input; `exact` is whether nothing of it was
    fitted; `results` are values of the subclass's own result properties, by name; `deviation` is
    how far fits move the surface at most, in mm.
    """

    surface: Any
    notes: tuple = ()
    exact: bool = True
    results: Any = MappingProxyType({})
    deviation: float = 0.0


class Sections(NamedTuple):
    """What a feature shows: its Base and, for each distance, surface, faces and certificate."""

    base: Base
    surfaces: list
    faces: list
    certificates: list


class Property(NamedTuple):
    """A property of a feature. `value` is its default, or the choices of an enumeration."""

    type: str
    name: str
    group: str
    doc: str
    value: Any = None
    attributes: int = 0


def result(type_, name, doc):
    """A property that execute sets and the user reads."""
    return Property(type_, name, "Result", doc, attributes=READ_ONLY | OUTPUT)


OFFSET_INPUTS = (
    Property(
        "App::PropertyDistance",
        "Distance",
        "Offset",
        QT_TRANSLATE_NOOP("App::Property", "Signed distance from the base surface"),
    ),
    Property(
        "App::PropertyEnumeration",
        "Sides",
        "Offset",
        QT_TRANSLATE_NOOP("App::Property", "The surfaces that are made"),
        list(SIDES),
    ),
    Property(
        "App::PropertyDistance",
        "SecondDistance",
        "Offset",
        QT_TRANSLATE_NOOP("App::Property", "Signed distance of the other one of two offsets"),
    ),
)

OUTPUT_INPUTS = (
    Property(
        "App::PropertyEnumeration",
        "Output",
        "Offset",
        QT_TRANSLATE_NOOP("App::Property", "Open surfaces, or a solid with closed ends"),
        OUTPUTS,
    ),
    Property(
        "App::PropertyEnumeration",
        "ParameterLines",
        "Offset",
        QT_TRANSLATE_NOOP(
            "App::Property", "Smooth faces with even parameter lines, or the lowest degree"
        ),
        list(PARAMETER_LINES),
    ),
)

OFFSET_RESULTS = (
    result(
        "App::PropertyDistance",
        "MinOffset",
        QT_TRANSLATE_NOOP("App::Property", "Smallest distance without a singular point"),
    ),
    result(
        "App::PropertyDistance",
        "MaxOffset",
        QT_TRANSLATE_NOOP("App::Property", "Largest distance without a singular point"),
    ),
)

RESULTS = (
    result(
        "App::PropertyString",
        "Degree",
        QT_TRANSLATE_NOOP("App::Property", "Degree along and across the faces"),
    ),
    result(
        "App::PropertyInteger",
        "Poles",
        QT_TRANSLATE_NOOP("App::Property", "Number of poles of all faces"),
    ),
    result(
        "App::PropertyString",
        "Deviation",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Bound on the distance to the true surface; proven, but for"
            " fits that are said to be measured",
        ),
    ),
    # The property editor would show it as 0.00.
    Property(
        "App::PropertyFloat",
        "DeviationBound",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "The same bound as a number, in millimetres"),
        attributes=READ_ONLY | HIDDEN | OUTPUT,
    ),
    result(
        "App::PropertyString",
        "TrimDeviation",
        QT_TRANSLATE_NOOP("App::Property", "Measured distance of the cut edges from the surface"),
    ),
    result(
        "App::PropertyArea",
        "Area",
        QT_TRANSLATE_NOOP("App::Property", "Area of all faces, by integration"),
    ),
    result(
        "App::PropertyString",
        "AreaError",
        QT_TRANSLATE_NOOP("App::Property", "Estimated error of the area"),
    ),
    result(
        "App::PropertyVolume",
        "Volume",
        QT_TRANSLATE_NOOP("App::Property", "Volume of a solid, by integration"),
    ),
    result(
        "App::PropertyString",
        "VolumeError",
        QT_TRANSLATE_NOOP("App::Property", "Estimated error of the volume"),
    ),
    result(
        "App::PropertyBool",
        "Exact",
        QT_TRANSLATE_NOOP("App::Property", "Whether only rounding to doubles deviates"),
    ),
    result(
        "App::PropertyStringList",
        "Notes",
        QT_TRANSLATE_NOOP("App::Property", "What else was done to the input"),
    ),
    result(
        "App::PropertyString",
        "Status",
        QT_TRANSLATE_NOOP("App::Property", "Valid, a warning or an error"),
    ),
    Property(
        "App::PropertyInteger",
        "SchemaVersion",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Version of this list of properties"),
        attributes=HIDDEN | OUTPUT,
    ),
)


class FeatureBase:
    """Proxy of a Part::FeaturePython whose shape shows sections of one exact surface.

    A subclass lists its own inputs and makes the surface. All data lives in properties. The path
    of the subclass is part of the file format.
    """

    inputs = ()
    offset_inputs = OFFSET_INPUTS
    offset_results = OFFSET_RESULTS
    schema_version = 1

    def __init__(self, obj):
        self._add_missing_properties(obj)
        obj.Proxy = self

    # What `execute` takes instead of computing it, while `finish` runs.
    _arrived = None

    def base(self, inputs):
        """The surface at distance 0 (Base), from the subclass's inputs, in any thread."""
        raise NotImplementedError

    def sound_base(self, inputs):
        """The same. Raises LinkError for what FreeCAD itself cannot do with a damaged shape."""
        try:
            return self.base(inputs)
        except FreeCAD.Base.FreeCADError as error:
            raise LinkError(
                f"FreeCAD cannot work with a linked shape, which may be damaged ({error})."
            ) from error

    def sections(self, inputs, surface):
        """The sections of the surface at distance 0 that are shown, the innermost first."""
        return [surface.offset(distance) for distance in shown_distances(inputs)]

    def solid(self, inputs, sections):
        """The solid inside one section or between two: lists of faces, the innermost first."""
        return solid_of_sections(sections)

    def distances(self, inputs):
        """The distances of those sections that are drawn while they change, the smallest first."""
        return distances_of(inputs)

    def has_offsets(self, obj):
        """Whether the computed surface has other distances than zero."""
        return True

    def inputs_of(self, obj):
        """The FeatureInputs of now. All the rest of a computation needs no document."""
        return read_inputs(obj, [entry.name for entry in self._all_inputs()])

    def has_same_base(self, inputs, others):
        """Whether two FeatureInputs differ at most in what is shown of one surface."""
        return agree(inputs, others, [entry.name for entry in self.inputs])

    def outcome(self, inputs, base):
        """The shape and the values of the result properties, by name, in any thread."""
        sections = self._sections(inputs, base)
        shape = self._shape(inputs, sections)
        warnings = [*self.warnings(sections), *_notes(sections)]
        return shape, {
            **_results(*sections),
            **self.limits(base.surface),
            "Status": f"Warning: {' '.join(warnings)}" if warnings else VALID,
            **measured(shape),
            **base.results,
        }

    def limits(self, surface):
        """The values of offset_results, by name."""
        return dict(zip(("MinOffset", "MaxOffset"), surface.regular_range))

    def warnings(self, sections):
        """A sentence for each of the Sections that has singular points or crosses itself."""
        if not sections.base.surface.has_offsets:
            return _crossings(sections.surfaces)
        low, high = sections.base.surface.regular_range
        distances = [surface.distance for surface in sections.surfaces]
        regular = [surface for surface in sections.surfaces if low < surface.distance < high]
        return [*_irregularities(distances, low, high), *_crossings(regular)]

    def exact_sections(self, obj):
        """The Sections of the present inputs, whatever the shape shows."""
        inputs = self.inputs_of(obj)
        return self._sections(inputs, self.sound_base(inputs))

    def finish(self, obj, arrived):
        """Recomputes the feature with the outcome that arrived() returns, or the error it raises.

        Another thread has computed it from the present inputs.
        """
        self._arrived = arrived
        try:
            obj.recompute()
        finally:
            self._arrived = None

    def execute(self, obj):
        """Makes the shape and the results; on failure keeps both and says why."""
        try:
            self._require_known_schema(obj)
            shape, results = self._arrived() if self._arrived else self._computed(obj)
        except Exception as error:
            obj.Status = f"Error: {error}"
            raise
        obj.Shape = shape
        for name, value in results.items():
            setattr(obj, name, value)
        if obj.Status != VALID:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {obj.Status}\n")

    def onChanged(self, obj, name):
        # While a document is read, other properties may not be there yet.
        if name == "Sides" and not obj.Document.Restoring:
            _show_second_distance(obj)

    def onDocumentRestored(self, obj):
        """Adds the properties that the saving program did not know, and the digits it cut.

        A shape that a damaged file has lost is computed anew. What a newer program saved is left as
        it is: its properties may mean something else.
        """
        _restore_view_provider(obj)
        if obj.SchemaVersion > self.schema_version:
            obj.Status = f"Error: {self._newer(obj)}"
            return
        self._add_missing_properties(obj)
        if obj.Deviation:
            obj.DeviationBound = _deviation_of(obj.Deviation)
        if obj.Poles and obj.Shape.isNull():
            self._restore_shape(obj)
        else:
            self._restore_digits(obj)

    def _require_known_schema(self, obj):
        if obj.SchemaVersion > self.schema_version:
            raise ValueError(self._newer(obj))

    def _newer(self, obj):
        return (
            f"A newer version of PN Surfaces has saved {obj.Label} (schema {obj.SchemaVersion}, this"
            f" one knows {self.schema_version}). Its shape stays as it is; update PN Surfaces to"
            " change it."
        )

    def _sections(self, inputs, base):
        surfaces = self.sections(inputs, base.surface)
        lines = PARAMETER_LINES[inputs.ParameterLines]
        faces = [surface.bsplines(lines=lines) for surface in surfaces]
        return Sections(base, surfaces, faces, [surface.certificate_of(lines) for surface in surfaces])

    def _shape(self, inputs, sections):
        if inputs.Output == SOLID:
            return self.solid(inputs, sections.faces)
        return surface_of_sections(sections.faces)

    def _computed(self, obj):
        inputs = self.inputs_of(obj)
        return self.outcome(inputs, self.sound_base(inputs))

    def _restore_digits(self, obj):
        """Replaces a shape that lost digits in the file by the exact one, and no other shape."""
        try:
            exact = self._shape(self.inputs_of(obj), self.exact_sections(obj))
        except (ValueError, KernelMissing):
            return  # Nothing to compare with: the stored shape stays, as after a failed recompute.
        if 0 < storage_loss(own_shape(obj), exact) <= STORED_RESOLUTION:
            exact.Placement = obj.Placement
            obj.Shape = exact
            obj.purgeTouched()

    def _restore_shape(self, obj):
        """Computes a shape that was there when the results were saved, or has the status say why not.

        FreeCAD opens a file without its end, leaves out what it had to read from there, and calls
        the rest valid.
        """
        message = f"{obj.Label}: The file has lost the shape, which is computed anew.\n"
        FreeCAD.Console.PrintWarning(message)
        placement = obj.Placement
        try:
            self.execute(obj)
        except Exception:
            obj.touch()  # The next recompute says why in the tree, too.
        else:
            # Outside of a recompute FreeCAD takes the placement of the shape.
            obj.Placement = placement
            obj.purgeTouched()

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        pass

    # The same pair, under the names that FreeCAD calls from 0.21.2 on.
    dumps = __getstate__
    loads = __setstate__

    def _add_missing_properties(self, obj):
        for entry in (*self._all_inputs(), *self.offset_results, *RESULTS):
            if entry.name not in obj.PropertiesList:
                obj.addProperty(entry.type, entry.name, entry.group, entry.doc, entry.attributes)
                if entry.value is not None:
                    setattr(obj, entry.name, entry.value)
            elif entry.type == "App::PropertyEnumeration":
                _offer_all_choices(obj, entry)
        obj.SchemaVersion = self.schema_version
        if self.offset_inputs:
            _show_second_distance(obj)

    def _all_inputs(self):
        return (*self.inputs, *self.offset_inputs, *OUTPUT_INPUTS)


class FeatureWithoutOffsets(FeatureBase):
    """Proxy of a surface whose unit normals are not rational: it has no distance but zero."""

    offset_inputs = ()
    offset_results = ()

    def sections(self, inputs, surface):
        return [surface]

    def distances(self, inputs):
        return [0.0]

    def limits(self, surface):
        return {}


def _offer_all_choices(obj, entry):
    """Adds the choices that the program which saved the document did not know."""
    if obj.getEnumerationsOfProperty(entry.name) != entry.value:
        chosen = getattr(obj, entry.name)
        setattr(obj, entry.name, entry.value)
        setattr(obj, entry.name, chosen)


def make_feature(proxy, document, name, values):
    """A new feature with the proxy class `proxy` and these property values.

    It is computed unless the recomputes of its document are frozen. Whatever an assignment raises,
    nothing is then left in the document.
    """
    obj = document.addObject("Part::FeaturePython", name)
    try:
        proxy(obj)
        for property_name, value in values.items():
            setattr(obj, property_name, value)
    except Exception:
        document.removeObject(obj.Name)
        raise
    if FreeCAD.GuiUp:
        from pnsurfaces.view_provider import ViewProviderPNSurface

        ViewProviderPNSurface(obj.ViewObject)
    if not document.RecomputesFrozen:
        obj.recompute(True)
    return obj


def show_only(obj, shown, names):
    """Hides those of the properties `names` that are not in `shown`."""
    for name in names:
        obj.setEditorMode(name, _SHOWN if name in shown else _HIDDEN)


def _show_second_distance(obj):
    shown = {"SecondDistance"} if obj.Sides == TWO_OFFSETS else set()
    show_only(obj, shown, ["SecondDistance"])


def deviation_text(deviation):
    """A distance in millimetres as text: the property editor would show a length as 0.00 mm."""
    return f"{deviation:.1e} mm" if deviation else "0 mm"


def _deviation_of(text):
    """The distance in millimetres that `deviation_text` wrote; infinite where that is not known."""
    try:
        return float(text.removesuffix(" mm"))
    except ValueError:
        return math.inf


def distances_of(inputs):
    """The distances that the choice of sides stands for, the smallest first."""
    return SIDES[inputs.Sides](inputs.Distance.Value, inputs.SecondDistance.Value)


def shown_distances(inputs):
    """The same, of surfaces or of a wall that has a thickness."""
    distances = distances_of(inputs)
    thickness = distances[-1] - distances[0]
    if inputs.Output == SOLID and inputs.Sides != ONE_SIDE and thickness <= CONFUSION:
        raise ValueError(f"The wall would be {thickness:.2g} mm thick. Give it a distance.")
    return distances


def _restore_view_provider(obj):
    """A document saved without FreeCAD's window knows no view provider, so no panel either."""
    if not FreeCAD.GuiUp:
        return
    from pnsurfaces.view_provider import ViewProviderPNSurface

    if not isinstance(obj.ViewObject.Proxy, ViewProviderPNSurface):
        ViewProviderPNSurface(obj.ViewObject)


def _results(base, surfaces, faces, certificates):
    """The values of the result properties that all features have, by name."""
    every_face = [face for section_faces in faces for face in section_faces]
    rounding = max(certificate.deviation for certificate in certificates)
    bound = _rounded_up(rounding + base.deviation)
    trim_deviation = max(certificate.trim_deviation for certificate in certificates)
    u_degree = max(face.u_degree for face in every_face)
    v_degree = max(face.v_degree for face in every_face)
    return {
        "Degree": f"{u_degree} x {v_degree}",
        "Poles": sum(face.weights.size for face in every_face),
        "Deviation": deviation_text(bound),
        "DeviationBound": bound,
        "TrimDeviation": deviation_text(trim_deviation),
        "Exact": base.exact and all(certificate.exact for certificate in certificates),
        "Notes": _notes(Sections(base, surfaces, faces, certificates)),
    }


def _notes(sections):
    """What was done to the input, each sentence once."""
    proved = (note for certificate in sections.certificates for note in certificate.notes)
    return list(dict.fromkeys([*sections.base.notes, *proved]))


def _irregularities(distances, low, high):
    """A sentence for each distance at which the surface has singular points."""
    if low >= high:
        return ["No distance is proved to be free of singular points."]
    limits = [(d, low if d <= low else high) for d in distances if not low < d < high]
    return [
        f"At {d:.6g} mm, beyond the limit of {limit:.6g} mm, the surface has singular points."
        for d, limit in limits
    ]


def _crossings(surfaces):
    """A sentence for each surface that crosses itself, as a pipe that meets itself does."""
    found = [(surface.distance, surface.self_intersection()) for surface in surfaces]
    return [
        f"At {d:.6g} mm the surface crosses itself, at ({_coordinates(crossing.point)}) mm."
        for d, crossing in found
        if crossing
    ]


def _coordinates(point):
    return ", ".join(f"{coordinate:.6g}" for coordinate in point)


def _rounded_up(bound):
    """A bound with two digits, as it is shown; it must not become smaller by that."""
    return float(Context(prec=2, rounding=ROUND_UP).create_decimal_from_float(bound))
