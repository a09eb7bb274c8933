# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset of a quadric in the tree."""

import math
from typing import NamedTuple

import FreeCAD

from pnsurfaces import kernel
from pnsurfaces.feature import (
    QT_TRANSLATE_NOOP,
    Base,
    FeatureBase,
    Property,
    deviation_text,
    make_feature,
    result,
    show_only,
)
from pnsurfaces.linked_shape import LinkError, as_link, only_face
from pnsurfaces.quadric_face import read_quadric_face

GROUP = "Quadric"

# Names that are no units: in an expression A is an ampere and C a coulomb.
AXES = ("HalfAxisA", "HalfAxisB", "HalfAxisC")

# The choice of Region without bounds.
WHOLE = "Whole"

# A sector of so many degrees ends nothing.
WHOLE_TURN = 360


class Kind(NamedTuple):
    """A kind of quadric: its name in pnkernel, half-axes, regions, equation.

    A half-axis that it does not have equals a. To begin with, the first region suits, and these
    least and largest heights, as multiples of c.
    """

    name: str
    axes: tuple
    regions: tuple
    heights: tuple
    equation: str


_HEIGHTS_OR_SIDES = ("Heights", "Rectangle", "Box", "Sector")

KINDS = {
    "Ellipsoid": Kind(
        "ellipsoid", AXES, (WHOLE, *_HEIGHTS_OR_SIDES), (0, 1), "x²/a² + y²/b² + z²/c² = 1"
    ),
    "One-sheet hyperboloid": Kind(
        "one_sheet_hyperboloid", AXES, ("Heights", "Sector"), (-1, 1), "x²/a² + y²/b² − z²/c² = 1"
    ),
    "Two-sheet hyperboloid": Kind(
        "two_sheet_hyperboloid", AXES, _HEIGHTS_OR_SIDES, (0, 2), "z²/c² − x²/a² − y²/b² = 1, z > 0"
    ),
    "Elliptic paraboloid": Kind(
        "elliptic_paraboloid", AXES, _HEIGHTS_OR_SIDES, (0, 1), "z = c (x²/a² + y²/b²)"
    ),
    "Hyperbolic paraboloid": Kind(
        "hyperbolic_paraboloid", AXES, ("Rectangle",), (-1, 1), "z = c (x²/a² − y²/b²)"
    ),
    "Cylinder": Kind("elliptic_cylinder", AXES[:1], ("Heights",), (0, 2), "x² + y² = a²"),
    "Cone": Kind("elliptic_cone", AXES[::2], ("Heights",), (0.5, 1), "x² + y² = a² z²/c²"),
    "Parabolic cylinder": Kind("parabolic_cylinder", AXES[::2], ("Rectangle",), (0, 1), "z = c x²/a²"),
}

# The choice of Kind that stands for the quadric on which the face lies.
OF_FACE = "Of a face"

# The coordinates that the bounds of each choice are about.
REGIONS = {
    WHOLE: (),
    "Heights": ("Z",),
    "Rectangle": ("X", "Y"),
    "Box": ("X", "Y", "Z"),
    "Sector": ("Z", "Angle"),
}

BOUNDS = {
    coordinate: (f"Min{coordinate}", f"Max{coordinate}") for coordinate in ("X", "Y", "Z", "Angle")
}


def _bound(name, doc, value):
    kind = "App::PropertyAngle" if name.endswith("Angle") else "App::PropertyDistance"
    return Property(kind, name, "Region", doc, value)


class QuadricOffset(FeatureBase):
    """Proxy of the offset of a quadric: its half-axes and a region, or a face that lies on it."""

    inputs = (
        Property(
            "App::PropertyEnumeration",
            "Kind",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "The kind of quadric, in standard position"),
            [*KINDS, OF_FACE],
        ),
        Property(
            "App::PropertyLength",
            "HalfAxisA",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis a, along x"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "HalfAxisB",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Half-axis b, along y"),
            1.0,
        ),
        Property(
            "App::PropertyLength",
            "HalfAxisC",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Half-axis c, along z; of a paraboloid its height at x = a"
            ),
            1.0,
        ),
        Property(
            "App::PropertyLinkSub",
            "Face",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "A face that lies on a quadric; the placement follows it"
            ),
        ),
        Property(
            "App::PropertyEnumeration",
            "Region",
            "Region",
            QT_TRANSLATE_NOOP("App::Property", "What ends the base surface"),
            list(REGIONS),
        ),
        _bound("MinX", QT_TRANSLATE_NOOP("App::Property", "Smallest x of the base surface"), -1.0),
        _bound("MaxX", QT_TRANSLATE_NOOP("App::Property", "Largest x of the base surface"), 1.0),
        _bound("MinY", QT_TRANSLATE_NOOP("App::Property", "Smallest y of the base surface"), -1.0),
        _bound("MaxY", QT_TRANSLATE_NOOP("App::Property", "Largest y of the base surface"), 1.0),
        _bound("MinZ", QT_TRANSLATE_NOOP("App::Property", "Smallest z of the base surface"), -1.0),
        _bound("MaxZ", QT_TRANSLATE_NOOP("App::Property", "Largest z of the base surface"), 1.0),
        _bound("MinAngle", QT_TRANSLATE_NOOP("App::Property", "Where the sector begins, from x"), 0.0),
        _bound("MaxAngle", QT_TRANSLATE_NOOP("App::Property", "Where the sector ends, from x"), 120.0),
        result(
            "App::PropertyString",
            "Recognised",
            QT_TRANSLATE_NOOP("App::Property", "The quadric on which the face lies"),
        ),
        result(
            "App::PropertyString",
            "FaceDeviation",
            QT_TRANSLATE_NOOP(
                "App::Property", "Largest measured distance of the face from the quadric"
            ),
        ),
    )

    def base(self, obj):
        if obj.Kind == OF_FACE:
            return _base_of_face(read_face(obj))
        name, axes = KINDS[obj.Kind].name, half_axes(obj)
        surface = kernel.pnkernel().quadric(name, *axes, bounds=_bounds(obj))
        return Base(surface, results={"Recognised": "", "FaceDeviation": ""})

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        # While a document is read, other properties may not be there yet.
        if name in ("Kind", "Region") and not obj.Document.Restoring:
            show_only(obj, shown_inputs(obj), CHANGING)


# The properties that only some kinds and regions use.
CHANGING = (*AXES, "Face", "Region", *(name for names in BOUNDS.values() for name in names))


def shown_inputs(obj):
    """Names of the inputs that the kind and the region of a feature QuadricOffset use."""
    if obj.Kind == OF_FACE:
        return {"Face"}
    bounds = [name for coordinate in REGIONS[obj.Region] for name in BOUNDS[coordinate]]
    return {"Region", *KINDS[obj.Kind].axes, *bounds}


def suitable_bounds(obj):
    """Bounds in proportion to kind and half-axes of a feature QuadricOffset, by property name."""
    a, b, c = half_axes(obj)
    low, high = KINDS[obj.Kind].heights
    return {
        "MinX": -a / 2,
        "MaxX": a / 2,
        "MinY": -b / 2,
        "MaxY": b / 2,
        "MinZ": low * c,
        "MaxZ": high * c,
    }


def read_face(obj):
    """The quadric (quadric_face.QuadricFace) on which the face of a feature QuadricOffset lies.

    Raises LinkError or NotQuadric with a sentence for the user.
    """
    if not obj.Face:
        raise LinkError("The face is missing. Choose a face that lies on a quadric.")
    return read_quadric_face(only_face(obj.Face, obj.getParentGeoFeatureGroup()))


def describe(quadric):
    """A quadric_face.QuadricFace for the user: "ellipsoid with a = 20 mm, b = 10 mm, c = 5 mm"."""
    title, kind = next((title, kind) for title, kind in KINDS.items() if kind.name == quadric.kind)
    title, names = title.lower(), kind.axes
    a, b, _ = quadric.axes
    if quadric.kind in ("elliptic_cylinder", "elliptic_cone") and a != b:
        # Such a face is refused, and the user sees why.
        title, names = f"elliptic {title}", AXES
    lengths = dict(zip(AXES, quadric.axes))
    axes = [f"{name[-1].lower()} = {lengths[name]:.6g} mm" for name in names]
    return f"{title} with {', '.join(axes)}"


def make_quadric_offset(
    kind_or_face,
    a=1.0,
    b=1.0,
    c=1.0,
    distance=0,
    *,
    bounds=None,
    placement=None,
    document=None,
    name="QuadricOffset",
    **properties,
):
    """The offset of a quadric in the tree, computed. Lengths are millimetres or strings.

    Parameters
    ----------
    kind_or_face : a kind, such as "Ellipsoid" (see KINDS), or a face that lies on a quadric:
        (object, "Face1"), or an object with one face. A face gives half-axes, region and placement.
    a, b, c : half-axes; those that the kind does not have are not used
    distance : signed offset
    bounds : what ends the base surface, for instance {"z": (0, 10)}: pairs of lengths under "x",
        "y", "z", degrees under "angle"; the names of one of REGIONS
    placement : FreeCAD.Placement of the standard position
    document : the document of the face, or the active one, unless given
    name : wanted internal name and label
    properties : values of further properties, such as Output="Solid" or Sides="Both sides"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    if isinstance(kind_or_face, str):
        document = document or FreeCAD.ActiveDocument or FreeCAD.newDocument()
        axes = dict(zip(AXES, (a, b, c)))
        source = {"Kind": kind_or_face, **axes, **_region_values(bounds or {})}
    else:
        link = as_link(kind_or_face)
        document = document or link[0].Document
        source = {"Kind": OF_FACE, "Face": link}
    placed = {"Placement": placement} if placement else {}
    values = {**source, **placed, "Distance": distance, **properties}
    return make_feature(QuadricOffset, document, name, values)


def _base_of_face(found):
    """The Base of a quadric_face.QuadricFace."""
    surface = kernel.pnkernel().quadric(found.kind, *found.axes, bounds=found.bounds)
    notes = []
    if found.is_fitted():
        notes.append(
            "The face is no quadric exactly: it lies within"
            f" {deviation_text(found.deviation)} of the {describe(found)}."
        )
    if not found.covered:
        notes.append("The face ends along other lines: the offset is that of a region around it.")
    results = {
        "Recognised": describe(found).capitalize(),
        "FaceDeviation": deviation_text(found.deviation),
        "Placement": found.placement,
    }
    return Base(surface, notes=tuple(notes), exact=not found.is_fitted(), results=results)


def half_axes(obj):
    """a, b, c in millimetres."""
    axes = KINDS[obj.Kind].axes
    return [getattr(obj, name if name in axes else AXES[0]).Value for name in AXES]


def _bounds(obj):
    """The bounds of the region as pnkernel.quadric takes them, angles in radians."""
    bounds = {
        coordinate.lower(): tuple(getattr(obj, name).Value for name in BOUNDS[coordinate])
        for coordinate in REGIONS[obj.Region]
    }
    if "angle" in bounds:
        low, high = bounds.pop("angle")
        if low >= high:
            raise ValueError(f"The sector is empty: from {low:g}° to {high:g}°.")
        if not high - low >= WHOLE_TURN:
            bounds["angle"] = math.radians(low), math.radians(high)
    return bounds


def _region_values(bounds):
    """The property values that an argument `bounds` stands for.

    Raises ValueError when no region has these bounds, or an angle is too large.
    """
    wanted = {name.capitalize() for name in bounds}
    region = next((name for name, used in REGIONS.items() if set(used) == wanted), None)
    if region is None:
        raise ValueError(f"No region has the bounds {', '.join(sorted(bounds))}.")
    values = {"Region": region}
    for name, pair in bounds.items():
        values.update(zip(BOUNDS[name.capitalize()], pair))
    # FreeCAD would cut the property down to the limit without a word.
    for angle in map(FreeCAD.Units.Quantity, bounds.get("angle", ())):
        if abs(angle.Value) > WHOLE_TURN:
            raise ValueError(f"The angle {angle.Value:g}° is not between -360° and 360°.")
    return values
