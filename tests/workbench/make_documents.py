# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves a document for each class of features in its present schema, for the tests of later ones.

Run it once after a schema version was raised, and never change what it saved before:

    scripts/freecadcmd -P tests/workbench tests/workbench/make_documents.py
"""

import FreeCAD
import Part
from stored_documents_test import DOCUMENTS
from support import RADII, spline

import pnsurfaces


def save(make, stem):
    """A document with the feature that make(document) makes, unless its schema has one."""
    document = FreeCAD.newDocument()
    obj = make(document)
    path = DOCUMENTS / f"{stem}_schema_{obj.SchemaVersion}.FCStd"
    if not path.exists():
        document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)


def canal_surface(document):
    spine = document.addObject("Part::Feature", "Spine")
    spine.Shape = spline().toShape()
    return pnsurfaces.make_canal_surface(
        spine,
        ("Values at vertices", RADII),
        0.3,
        Hollow="Wall thickness",
        WallThickness=0.5,
        Output="Solid",
    )


def ruled_offset(document):
    root = _bezier(document, "Root", [(0, -4, 0), (2, 0, 1), (0, 4, 3)])
    tip = _bezier(document, "Tip", [(20, -6, 6), (24, 0, 2), (20, 6, 0)])
    return pnsurfaces.make_ruled_offset(root, tip, 0.5, Sides="Both sides", Output="Solid")


def _bezier(document, name, points):
    curve = Part.BezierCurve()
    curve.setPoles([FreeCAD.Vector(*point) for point in points])
    source = document.addObject("Part::Feature", name)
    source.Shape = curve.toShape()
    return source


def quadric_offset(document):
    return pnsurfaces.make_quadric_offset(
        "One-sheet hyperboloid",
        3,
        2,
        4,
        0.25,
        bounds={"z": (-3, 5)},
        document=document,
        Sides="Base and offset",
        Output="Solid",
    )


def mid_surface_skins(document):
    net = [(0, 0, 0), (40, 0, 0), (20, 30, 0), (20, 0, 5), (30, 15, 4), (10, 15, 6)]
    return pnsurfaces.make_mid_surface_skins(net, [2, 3, 2, 2, 3, 2], 0.5, document=document)


def mirror_wavefront(document):
    surface = Part.BezierSurface()
    surface.increase(2, 1)
    for i, z in enumerate((5, -3, 5)):
        for j in range(2):
            surface.setPole(i + 1, j + 1, FreeCAD.Vector(20 * i - 20, 30 * j, z + j))
    mirror = document.addObject("Part::Feature", "Mirror")
    mirror.Shape = surface.toShape()
    return pnsurfaces.make_mirror_wavefront(
        mirror, 60, direction=(0, 0.25, -1), origin=(0, 0, 50), document=document
    )


def triangulated_skins(document):
    points = [(0, 0, 0), (40, 0, 1), (40, 30, 0), (0, 30, 2), (20, 15, 6)]
    triangles = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    return pnsurfaces.make_triangulated_skins(
        points, [2, 3, 2, 2.5, 1], triangles, 0.5, document=document
    )


def moving_conic_section(document):
    spine = _bezier(document, "Spine", [(0, 0, 0), (20, 5, 0), (35, 20, 5)])
    rows = [(0, 5, 2), (0.5, 4, 3), (1, 3, 3)]
    return pnsurfaces.make_moving_conic_section(spine, ("Table", rows), Output="Solid")


def squared_radius_canal(document):
    spine = _bezier(document, "Spine", [(0, 0, 0), (20, 5, 0), (35, 20, 5)])
    rows = [(0, 9), (0.5, 20), (1, 12)]
    return pnsurfaces.make_squared_radius_canal(spine, ("Table", rows), Output="Solid")


save(canal_surface, "canal_surface")
save(ruled_offset, "ruled_offset")
save(quadric_offset, "quadric_offset")
save(mid_surface_skins, "mid_surface_skins")
save(triangulated_skins, "triangulated_skins")
save(mirror_wavefront, "mirror_wavefront")
save(moving_conic_section, "moving_conic_section")
save(squared_radius_canal, "squared_radius_canal")
