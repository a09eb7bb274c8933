# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a face to the quadric that it lies on.

Spheres, cylinders and cones are read from their own numbers, any other surface through points of
the face. Whether a B-spline is a quadric identically is decided over Q; of others, and of those
that were rounded, the distance that was measured says how near they are.
"""

import math
from typing import NamedTuple

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

from pnsurfaces.bspline_surface import clamped_bspline
from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.quadric_form import ROUNDING, QuadricForm, frame_along, nearest_form
from pnsurfaces.quadric_identity import satisfies_quadric
from pnsurfaces.quadric_region import region_of_face

# A face further than this from every quadric, as part of its size, is not taken for one: a
# micrometre on a face of 100 mm, where another program's fit of a quadric ends and other surfaces
# begin.
FIT_LIMIT = 1e-5

# Points in each direction at which a face is compared with its quadric.
_GRID = 24

_CHOICE = "Choose a face of a sphere, cylinder, cone or another curved quadric."
_FLAT = f"The face is flat. {_CHOICE}"


class NotQuadric(ValueError):
    """The face lies on no quadric of which offsets are known. The text is a sentence."""

    code = "not_quadric"


class QuadricFace(NamedTuple):
    """A quadric in the terms of pnkernel.quadric, and how the face lies on it.

    `placement` takes the standard position to the face; `bounds` end its region there, in
    millimetres and radians. `deviation` is the largest distance between face and quadric that was
    measured, `rounding` what rounding alone may leave, both in millimetres. `identical` says that
    the face is the quadric by its type or over Q. `covered` says that the bounds are the edges of
    the face, not a region around it.
    """

    kind: str
    axes: tuple
    placement: FreeCAD.Placement
    bounds: dict
    deviation: float
    rounding: float
    identical: bool
    covered: bool

    def is_fitted(self):
        """Whether the face is further from the quadric than rounding explains."""
        return not self.identical and self.deviation > self.rounding


def read_quadric_face(face):
    """The quadric (QuadricFace) that `face` lies on.

    Raises NotQuadric, with the distance from the nearest quadric where that is what is wrong.
    """
    points = _points(face)
    size = np.ptp(points, axis=0).max()
    typed = _typed_form(face.Surface, points)
    form = typed or _fitted_form(face, points, size)
    deviation = form.distances(points).max()
    if not deviation <= FIT_LIMIT * size:
        raise NotQuadric(
            f"The face is no quadric: it is up to {deviation:.2g} mm away from the nearest one."
        )
    rounding = ROUNDING * size
    identical = typed is not None or (deviation <= rounding and _satisfies_quadric(face.Surface))
    tolerance = max(2 * deviation, *(edge.Tolerance for edge in face.Edges))
    bounds, covered = region_of_face(form, face, tolerance)
    return QuadricFace(
        form.kind,
        tuple(float(axis) for axis in form.axes),
        _placement(form),
        bounds,
        float(deviation),
        float(rounding),
        identical,
        covered,
    )


def _points(face):
    """Points of the face's own surface, (n, 3), inside the face and on its edges."""
    u_first, u_last, v_first, v_last = face.ParameterRange
    parameters = [
        (u, v)
        for u in np.linspace(u_first, u_last, _GRID)
        for v in np.linspace(v_first, v_last, _GRID)
        if face.isPartOfDomain(u, v)
    ]
    # The curve of an edge that a Boolean operation made is fitted, and off the surface.
    for line, first, last in map(face.curveOnSurface, face.Edges):
        along = [line.value(t) for t in np.linspace(first, last, _GRID)]
        parameters += [(point.x, point.y) for point in along]
    return np.array([tuple(face.valueAt(u, v)) for u, v in parameters])


def _typed_form(surface, points):
    """The form of a surface of its own type, None for a surface of another type."""
    if isinstance(surface, Part.Plane):
        raise NotQuadric(_FLAT)
    if isinstance(surface, Part.Toroid):
        raise NotQuadric(f"The face lies on a torus, which is no quadric. {_CHOICE}")
    if isinstance(surface, Part.Sphere):
        frame = frame_along(surface.Axis)
        return QuadricForm("ellipsoid", (surface.Radius,) * 3, frame, np.array(surface.Center))
    if isinstance(surface, Part.Cylinder):
        frame = frame_along(surface.Axis)
        axes = surface.Radius, surface.Radius, surface.Radius
        return QuadricForm("elliptic_cylinder", axes, frame, np.array(surface.Center))
    if isinstance(surface, Part.Cone):
        return _typed_cone(surface, points)
    return None


def _typed_cone(surface, points):
    apex = np.array(surface.Apex)
    frame = frame_along(surface.Axis)
    heights = (points - apex) @ frame[:, 2]
    if heights.min() < -CONFUSION and heights.max() > CONFUSION:
        raise NotQuadric("The face lies on both sides of the cone's apex. Choose one side.")
    if heights.mean() < 0:
        frame = frame_along(-surface.Axis)
    height = np.abs(heights).max()
    radius = height * math.tan(abs(surface.SemiAngle))
    return QuadricForm("elliptic_cone", (radius, radius, height), frame, apex)


def _fitted_form(face, points, size):
    offsets = points - points.mean(axis=0)
    if np.linalg.svd(offsets, compute_uv=False)[-1] <= FIT_LIMIT * size * math.sqrt(len(points)):
        raise NotQuadric(_FLAT)
    u_first, u_last, v_first, v_last = face.ParameterRange
    top = np.array(face.normalAt((u_first + u_last) / 2, (v_first + v_last) / 2))
    form = nearest_form(points, top)
    if form is None:
        raise NotQuadric(f"The face is near no quadric of which exact offsets are known. {_CHOICE}")
    return form


def _satisfies_quadric(surface):
    clamped = clamped_bspline(surface)
    return clamped is not None and satisfies_quadric(clamped)


def _placement(form):
    x, y, z = (Vector(*column) for column in form.frame.T)
    return FreeCAD.Placement(Vector(*form.origin), FreeCAD.Rotation(x, y, z, "ZXY"))
