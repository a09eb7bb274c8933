# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wavefronts of light that a mirror reflects, in the tree."""

from types import SimpleNamespace
from typing import Any, NamedTuple

import FreeCAD
import numpy as np
import Part

from pnsurfaces import kernel
from pnsurfaces.bspline_surface import clamped_bspline
from pnsurfaces.feature import QT_TRANSLATE_NOOP, Base, FeatureBase, Property, make_feature, show_only
from pnsurfaces.linked_shape import LinkError, as_link, only_face

GROUP = "Mirror"

PARALLEL = "Parallel"
FROM_A_POINT = "From a point"

# Trimmed faces have less area than their rectangle by more than this part of it.
_AREA_TOLERANCE = 1e-6


class MirrorError(ValueError):
    """A face is no mirror. The text is a sentence for the user."""


class Mirror(NamedTuple):
    """The clamped B-spline surface of a mirror, and sentences on what was done to the face."""

    surface: Any
    notes: tuple
    exact: bool


class MirrorWavefront(FeatureBase):
    """Proxy of the wavefronts of parallel light, or of light from a point, behind a mirror."""

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "Face",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "The mirror: a face, taken as its whole" " rectangle of parameters"
            ),
        ),
        Property(
            "App::PropertyEnumeration",
            "Light",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Whether the light is parallel or comes from a point"),
            [PARALLEL, FROM_A_POINT],
        ),
        Property(
            "App::PropertyVector",
            "Direction",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Direction of parallel light"),
            FreeCAD.Vector(0, 0, -1),
        ),
        Property(
            "App::PropertyPosition",
            "Origin",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "The light source, or a point of the plane where parallel light" " starts",
            ),
        ),
    )

    def base(self, inputs):
        mirror = read_mirror(inputs)
        surface = kernel.pnkernel().mirror(kernel_surface(mirror.surface), **light_of(inputs))
        return Base(surface, notes=mirror.notes, exact=mirror.exact)

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        # While a document is read, other properties may not be there yet.
        if name == "Light" and not obj.Document.Restoring:
            show_only(obj, {"Direction"} if obj.Light == PARALLEL else set(), ["Direction"])


def read_mirror(inputs):
    """The Mirror of a feature MirrorWavefront or its inputs.

    Raises LinkError or MirrorError.
    """
    if not inputs.Face:
        raise LinkError("There is no mirror. Choose a face.")
    face = only_face(inputs.Face, inputs.getParentGeoFeatureGroup())
    surface, notes = _mirror_surface(face)
    is_exact = not notes
    if face.Area < surface.toShape().Area * (1 - _AREA_TOLERANCE):
        notes.append("The face is trimmed; its whole rectangle of parameters reflects.")
    return Mirror(surface, tuple(notes), is_exact)


def _mirror_surface(face):
    """The surface of a face over its range, and sentences on what was changed."""
    surface = clamped_bspline(face.Surface)
    if surface is not None:
        if surface.bounds() == face.ParameterRange:
            return surface, []
        surface.segment(*face.ParameterRange)
        return surface, ["The mirror is a part of a larger surface, with rounded poles."]
    converted = face.toNurbs().Faces[0]
    surface = clamped_bspline(converted.Surface)
    if surface is None:
        raise MirrorError(f"The face ({face.Surface.TypeId}) has no rational form.")
    if surface.bounds() != converted.ParameterRange:
        surface.segment(*converted.ParameterRange)
    if isinstance(face.Surface, Part.Plane):
        return surface, []
    return surface, ["The mirror is the spline that FreeCAD makes of its face."]


def kernel_surface(surface):
    """A clamped B-spline surface of FreeCAD with the attributes that the kernel reads."""
    return SimpleNamespace(
        u_degree=surface.UDegree,
        v_degree=surface.VDegree,
        u_knots=surface.getUKnots(),
        v_knots=surface.getVKnots(),
        u_multiplicities=surface.getUMultiplicities(),
        v_multiplicities=surface.getVMultiplicities(),
        poles=np.array(surface.getPoles()),
        weights=np.array(surface.getWeights()) if _is_rational(surface) else None,
    )


def light_of(inputs):
    """The light as keywords of pnkernel.mirror."""
    origin = tuple(inputs.Origin)
    if inputs.Light == FROM_A_POINT:
        return {"source": origin}
    return {"direction": tuple(inputs.Direction), "start": origin}


def facing_light(face):
    """Direction, origin and distance that suit a face: light falls on its middle and comes back.

    The origin is as far before the middle as the face is large; numbers have few digits.
    """
    u_first, u_last, v_first, v_last = face.ParameterRange
    u, v = (u_first + u_last) / 2, (v_first + v_last) / 2
    middle, normal = face.valueAt(u, v), face.normalAt(u, v)
    size = float(f"{face.BoundBox.DiagonalLength:.1g}")
    direction = [round(-x, 2) + 0.0 for x in normal]
    origin = [float(f"{x:.4g}") for x in middle + normal * size]
    return tuple(direction), tuple(origin), 2 * size


def _is_rational(surface):
    return surface.isURational() or surface.isVRational()


def make_mirror_wavefront(
    face,
    distance=0,
    *,
    direction=None,
    origin=(0, 0, 0),
    document=None,
    name="MirrorWavefront",
    **properties,
):
    """The wavefront of light that a mirror reflects, in the tree, computed. Lengths are millimetres.

    Parameters
    ----------
    face : the mirror, (object, "Face1") or an object with one face
    distance : path length of the wavefront, from where the light starts
    direction : that of parallel light; none for light from a point
    origin : the light source, or a point of the plane, perpendicular to parallel light, where it
        starts
    document : the document of the face, unless given
    name : wanted internal name and label
    properties : values of further properties, such as Sides="Two offsets"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    link = as_link(face)
    light = (
        {"Light": FROM_A_POINT}
        if direction is None
        else {"Light": PARALLEL, "Direction": FreeCAD.Vector(*direction)}
    )
    values = {
        "Face": link,
        **light,
        "Origin": FreeCAD.Vector(*origin),
        "Distance": distance,
        **properties,
    }
    return make_feature(MirrorWavefront, document or link[0].Document, name, values)
