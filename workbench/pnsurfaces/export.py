# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files that keep every double, and are read back before they count as written."""

import os

import FreeCAD

from pnsurfaces import kernel
from pnsurfaces.progress import progress_bar

SCHEMAS = ("AP203", "AP214", "AP242")


def export_step(objects, path, schema="AP214", parametric_curves=True, progress=None):
    """Writes the shapes of document objects to one STEP file, in global coordinates.

    The file is read back and compared: number of faces, validity, areas and volume, and poles,
    weights and knots bit for bit. Only then it gets its name and replaces an older file, which
    stays as it is after any failure. Returns a sentence on what was compared, and prints it.

    Parameters
    ----------
    objects : sequence of document objects with a Shape; their labels become the product names
    path : file name
    schema : "AP203", "AP214" or "AP242"
    parametric_curves : whether the curves of edges in the parameters of their faces are written;
        without them the file is smaller, and readers project the edges anew
    progress : function that is called with the part that is done, from 0 to 1; what it raises
        breaks the export off. Unless given, FreeCAD's progress bar.

    Raises
    ------
    ValueError
        No object is given, or one has no shape.
    OSError
        The file cannot be written.
    pnocct.OcctError, pnocct.RoundTripError
        OpenCASCADE cannot translate a shape; the file does not hold what was written.
    """
    if not objects:
        raise ValueError("There is no object to export.")
    shapes = [_global_shape(obj).exportBrepToString() for obj in objects]
    names = [obj.Label for obj in objects]
    pnocct = kernel.pnocct()
    try:
        with progress_bar("STEP export", progress) as show:
            report = pnocct.write_step(
                os.fspath(path), shapes, names, schema=schema, pcurves=parametric_curves, progress=show
            )
    except pnocct.RoundTripError as error:
        if parametric_curves:
            raise
        remedy = "Write the parametric curves too, so that the edges need not be projected anew."
        raise pnocct.RoundTripError(f"{error} {remedy}") from error
    sentence = _summary(os.path.basename(os.fspath(path)), schema, report)
    FreeCAD.Console.PrintMessage(f"{sentence}\n")
    return sentence


def _summary(name, schema, report):
    """A sentence on what pnocct.write_step has compared."""
    compared = [f"faces {report['faces']}"]
    if report["bspline_faces"]:
        compared.append(
            f"B-spline faces {report['bspline_faces']} with {report['poles']} poles, bit for bit"
        )
    compared.append("their areas")
    if report["volume"]:
        compared.append(f"volume {report['volume']:.9g} mm³")
    return (
        f"{name} ({schema}, {report['bytes'] / 1000:.0f} kB) was read back and is the same:"
        f" {', '.join(compared)}."
    )


def _global_shape(obj):
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        raise ValueError(f"{obj.Label} has no shape to export.")
    placed = shape.copy(False)
    placed.Placement = obj.getGlobalPlacement()
    return placed
