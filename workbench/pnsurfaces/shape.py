# SPDX-License-Identifier: LGPL-2.1-or-later
"""From B-spline faces to Part shapes.

`sections` is a list with the faces of each section of one exact surface, the smallest distance
first; corresponding faces have the same parameters.
"""

import FreeCAD
import numpy as np
import Part

from pnsurfaces import kernel


def surface_of_sections(sections):
    """A shell, or a compound of shells: one for each part of each section."""
    return _together([shell for faces in sections for shell in _shells(faces)])


def solid_of_sections(sections):
    """The solid inside one section, closed flat, or the one between two, closed by normals.

    Sections of several parts give a compound of solids.
    """
    kind = "capped_solid" if len(sections) == 1 else "thick_solid"
    return part_shape(getattr(kernel.pnocct(), kind)(*sections))


def domed_solid_of_sections(sections):
    """The same with ends closed by the spheres that touch the surfaces there."""
    kind = "domed_solid" if len(sections) == 1 else "domed_thick_solid"
    return part_shape(getattr(kernel.pnocct(), kind)(*sections))


def uncapped_solid_of_sections(sections):
    """The solid between two sections, closed by normals, or inside one that has no open end.

    Raises ValueError when it has one.
    """
    if len(sections) == 1 and not all(shell.isClosed() for shell in _shells(sections[0])):
        raise ValueError(
            "Without caps the pipe has open ends and encloses no solid. Choose flat or spherical"
            " caps, two sides, or a surface."
        )
    return solid_of_sections(sections)


def measured(shape):
    """Area of a shape and volume of its solids, with estimates of their errors.

    They are the values of result properties, by name. A shape without a solid has no volume.
    """
    brep = shape.exportBrepToString()
    area, area_error = kernel.pnocct().measured_area(brep)
    volume, volume_error = kernel.pnocct().measured_volume(brep) if shape.Solids else (0.0, None)
    return {
        "Area": area,
        "AreaError": f"{area_error:.1e} mm^2",
        "Volume": volume,
        "VolumeError": "" if volume_error is None else f"{volume_error:.1e} mm^3",
    }


def own_shape(obj):
    """The shape of an object in its own coordinates: its doubles, not moved by the placement."""
    shape = obj.Shape.copy(False)
    shape.Placement = FreeCAD.Placement()
    return shape


def storage_loss(stored, exact):
    """The largest difference of corresponding poles in mm; inf when shapes do not correspond."""
    stored_faces, exact_faces = stored.Faces, exact.Faces
    if len(stored_faces) != len(exact_faces):
        return np.inf
    pairs = zip(map(_poles, stored_faces), map(_poles, exact_faces))
    return max((_difference(a, b) for a, b in pairs), default=np.inf)


def _poles(face):
    """The poles of a face in its own coordinates, (nu, nv, 3); none for a plane."""
    try:
        surface = face.Surface
    except TypeError:  # FreeCAD's word for a face that lost its surface.
        return np.empty(0)
    return np.array(surface.getPoles()) if hasattr(surface, "getPoles") else np.empty(0)


def _difference(a, b):
    return np.abs(a - b).max(initial=0) if a.shape == b.shape else np.inf


def _shells(faces):
    return part_shape(kernel.pnocct().shell(faces)).Shells


def _together(shapes):
    """A single shape as it is, several as a compound."""
    return shapes[0] if len(shapes) == 1 else Part.Compound(shapes)


def part_shape(brep):
    """The Part shape in a BREP text of pnocct."""
    shape = Part.Shape()
    # No progress bar: that is a matter of the thread of the window.
    shape.importBrepFromString(brep, False)
    return shape
