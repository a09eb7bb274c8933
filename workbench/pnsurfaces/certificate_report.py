# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of exact surfaces: what is proved of them, and what was measured besides.

A certificate is plain data, so that it can be kept as JSON. Lengths are millimetres; None stands
for an infinite limit. What is proved comes from the kernel, what is measured from the doubles of
the shape in the document, by routes that share nothing with the construction.
"""

import datetime
import json
import math
import pathlib

import FreeCAD
import numpy as np
import Part

from pnsurfaces import kernel
from pnsurfaces.certificate_text import as_markdown
from pnsurfaces.definition import definitions_of
from pnsurfaces.face_grid import face_grid, patches
from pnsurfaces.feature import FeatureBase
from pnsurfaces.shape import own_shape, part_shape
from pnsurfaces.spline_grid import points_and_normals

# Of the dictionary below; a reader of files of version 1 finds all that it knows in later ones.
VERSION = 1

# Points of a section at which it is compared with its definition, at least.
_POINTS = 1000

# Rows and columns of points on a face, at least, however many faces there are.
_LEAST_ROWS = 5

# The rounding of points and definition in doubles, as part of the size of the surface.
_ROUNDING = 16 * np.finfo(float).eps

# FreeCAD's own tolerance of an offset, in mm.
_OFFSET_TOLERANCE = 1e-7


def certificate(objects, compare=False):
    """The certificate of document objects: a dictionary that JSON can keep.

    Parameters
    ----------
    objects : sequence of document objects; those that are no surface of PN Surfaces, or have no
        valid one, are answered by a sentence
    compare : whether FreeCAD's own offset of the same base surface is tried and measured as well,
        which may take seconds

    Raises ValueError when no object is given, kernel.KernelMissing without the compiled modules.
    """
    if not objects:
        raise ValueError("There is no object to certify.")
    return {
        "format": "PN Surfaces certificate",
        "version": VERSION,
        "date": datetime.date.today().isoformat(),
        "program": f"FreeCAD {'.'.join(FreeCAD.Version()[:2])}",
        "unit": "mm",
        "objects": [_of_object(obj, compare) for obj in objects],
    }


def write_certificate(objects, path, compare=False):
    """Writes the certificate of objects to a file: JSON if its name ends in .json, else Markdown.

    Raises OSError when the file cannot be written, and as `certificate` does.
    """
    save_certificate(certificate(objects, compare), path)


def save_certificate(report, path):
    """Writes what `certificate` returned to a file, as write_certificate does."""
    path = pathlib.Path(path)
    if path.suffix.lower() == ".json":
        text = json.dumps(report, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    else:
        text = as_markdown(report)
    path.write_text(text, encoding="utf-8")


def _of_object(obj, compare):
    names = {"label": obj.Label, "name": obj.Name}
    sentence = _why_not(obj)
    if sentence:
        return {**names, "answer": sentence}
    try:
        sections = obj.Proxy.exact_sections(obj)
    except ValueError as error:
        return {**names, "answer": f"{obj.Label} cannot be computed: {error}"}
    shape = own_shape(obj)
    if not _shows(shape, sections.faces):
        return {
            **names,
            "answer": f"{obj.Label} does not show what its properties say. Recompute it first.",
        }
    low, high = sections.base.surface.regular_range
    return {
        **names,
        "kind": type(obj.Proxy).__name__,
        "status": obj.Status,
        "sides": getattr(obj, "Sides", None),
        "output": obj.Output,
        "lines": obj.ParameterLines,
        "exact": sections.base.exact and all(c.exact for c in sections.certificates),
        "fitted": list(sections.base.notes),
        "fit_deviation": sections.base.deviation,
        "regular_range": [_finite(low), _finite(high)] if sections.base.surface.has_offsets else None,
        "sections": _of_sections(obj, sections, compare),
        "shape": _of_shape(shape),
    }


def _why_not(obj):
    """Why an object has no certificate, as a sentence; empty when it may have one."""
    if not isinstance(getattr(obj, "Proxy", None), FeatureBase):
        return f"{obj.Label} is no surface of PN Surfaces: nothing is proved of it."
    if not obj.isValid():
        return f"{obj.Label} has an error: {obj.getStatusString()}"
    if "Touched" in obj.State:
        return f"{obj.Label} has changed since its shape was computed. Recompute it first."
    return ""


def _of_sections(obj, sections, compare):
    reports = []
    definitions = definitions_of(obj, len(sections.surfaces))
    for definition, surface, faces, proved in zip(definitions, *sections[1:]):
        distance = surface.distance
        low, high = surface.regular_range
        report = {
            "distance": distance,
            "regular": low < distance < high if surface.has_offsets else None,
            "faces": len(faces),
            "bidegree": list(proved.bidegree),
            "poles": int(proved.poles),
            "deviation": proved.deviation,
            "precision_bits": int(proved.precision_bits),
            "exact": proved.exact,
            "notes": list(proved.notes),
            "trim_deviation": proved.trim_deviation,
            "sampling": _sampled(definition, _shell(faces), distance),
        }
        if compare and distance != 0:
            report["freecad_offset"] = _offset_by_freecad(
                definition, sections.base.surface.bsplines(), distance
            )
        reports.append(report)
    return reports


def _sampled(definition, shape, distance):
    """How far points of the faces of a shape are from the surface at a distance, by definition."""
    grids = [grid for grid in map(face_grid, shape.Faces) if grid]
    rows = max(_LEAST_ROWS, math.ceil(math.sqrt(_POINTS / len(grids))))
    samples = [
        points_and_normals(grid.surface, *patch)
        for grid in grids
        for patch in patches(grid, rows, rows)
    ]
    points, normals = (np.concatenate(parts) for parts in zip(*samples))
    deviations = definition.deviations(points, normals, distance)
    return {
        "points": len(points),
        "worst": float(deviations.max()),
        "rounding": float(_ROUNDING * np.abs(points).max()),
        "against": definition.words,
    }


def _of_shape(shape):
    """Kind, validity, area and, of closed shapes, volume of what the document shows."""
    pnocct = kernel.pnocct()
    brep = shape.exportBrepToString()
    report = {
        "type": shape.ShapeType,
        "faces": len(shape.Faces),
        "faults": pnocct.check(brep),
        "area": _measure(pnocct.measured_area(brep)),
    }
    if any(shell.isClosed() for shell in shape.Shells):
        report["volume"] = _measure(pnocct.measured_volume(brep))
    return report


def _offset_by_freecad(definition, base_faces, distance):
    """What FreeCAD's own offset of the base surface gives: poles and deviation, or why it fails."""
    try:
        shape = _shell(base_faces).makeOffsetShape(distance, _OFFSET_TOLERANCE)
        faces = [_as_bspline(face) for face in shape.Faces]
    except (Part.OCCError, RuntimeError) as error:
        return {"fails": str(error)}
    if not faces:
        return {"fails": "The result has no face."}
    surfaces = [face.Surface for face in faces]
    sampling = _sampled(definition, Part.Compound(faces), distance)
    return {
        "faces": len(faces),
        "bidegree": [max(s.UDegree for s in surfaces), max(s.VDegree for s in surfaces)],
        "poles": sum(s.NbUPoles * s.NbVPoles for s in surfaces),
        "deviation": sampling["worst"],
        "points": sampling["points"],
    }


def _as_bspline(face):
    """The face on the B-spline surface that a STEP file of it would need."""
    surface = face.Surface
    if isinstance(surface, Part.BSplineSurface):
        return face
    return surface.toBSpline().toShape()


def _shell(faces):
    return part_shape(kernel.pnocct().shell(faces))


def _shows(shape, sections):
    """Whether the faces of all sections are among those of the shape, pole for pole."""
    shown = {_poles(face.Surface) for face in shape.Faces if hasattr(face.Surface, "getPoles")}
    return all(
        np.ascontiguousarray(face.poles).tobytes() in shown for faces in sections for face in faces
    )


def _poles(surface):
    return np.array(surface.getPoles()).tobytes()


def _measure(pair):
    value, error = pair
    return {"value": value, "error": error}


def _finite(limit):
    return limit if math.isfinite(limit) else None
