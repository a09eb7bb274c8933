# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files that keep every double."""

import os

from pnsurfaces import kernel


def export_step(objects, path, schema="AP214"):
    """Writes the shapes of document objects to one STEP file, in global coordinates.

    Poles, weights and knots come back from the file bit for bit.

    Parameters
    ----------
    objects : sequence of document objects with a Shape; their labels become the product names
    path : file name
    schema : "AP203", "AP214" or "AP242"

    Raises
    ------
    ValueError
        No object is given, or one has no shape.
    OSError
        The file cannot be written.
    pnocct.OcctError
        OpenCASCADE cannot translate a shape.
    """
    if not objects:
        raise ValueError("There is no object to export.")
    shapes = [_global_shape(obj).exportBrepToString() for obj in objects]
    names = [obj.Label for obj in objects]
    kernel.pnocct().write_step(os.fspath(path), shapes, names, schema=schema)


def _global_shape(obj):
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        raise ValueError(f"{obj.Label} has no shape to export.")
    placed = shape.copy(False)
    placed.Placement = obj.getGlobalPlacement()
    return placed
