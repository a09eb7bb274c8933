# SPDX-License-Identifier: LGPL-2.1-or-later
"""From B-spline faces to Part shapes.

`sections` is a list with the faces of each section of one exact surface, the smallest distance
first; corresponding faces have the same parameters.
"""

from types import SimpleNamespace

import numpy as np
import Part

from pnsurfaces import kernel


def surface_of_sections(sections):
    """A shell, or a compound of one shell for each section."""
    shells = [_shape(kernel.pnocct().shell(faces)) for faces in sections]
    return shells[0] if len(shells) == 1 else Part.Compound(shells)


def solid_of_sections(sections):
    """The solid inside one section, closed flat, or the wall between two, closed by normals."""
    if len(sections) == 1:
        return _shape(kernel.pnocct().capped_solid(sections[0]))
    inner, outer = sections
    ends = _ends(inner, outer)
    if ends:
        return _shape(kernel.pnocct().capped_solid([*inner, *outer, *ends]))
    hollow = [_shape(kernel.pnocct().shell(outer)), _shape(kernel.pnocct().shell(inner)).reversed()]
    return Part.makeSolid(Part.Compound(hollow))


def storage_loss(stored, exact):
    """The largest difference of corresponding poles in mm; inf when the shapes do not correspond."""
    stored_faces, exact_faces = stored.Faces, exact.Faces
    if len(stored_faces) != len(exact_faces):
        return np.inf
    pairs = zip(map(_poles, stored_faces), map(_poles, exact_faces))
    return max((_difference(a, b) for a, b in pairs), default=np.inf)


def _poles(face):
    """The poles of a face in its own coordinates, (nu, nv, 3); none for a plane."""
    surface = face.Surface
    return np.array(surface.getPoles()) if hasattr(surface, "getPoles") else np.empty(0)


def _difference(a, b):
    return np.abs(a - b).max(initial=0) if a.shape == b.shape else np.inf


def _ends(inner, outer):
    """The ruled faces that join two sections where a face's first or last u-line has no neighbour.

    Corresponding points lie on one normal, so that these faces are parts of a cone or plane.
    """
    first_lines = {face.poles[0].tobytes() for face in inner}
    last_lines = {face.poles[-1].tobytes() for face in inner}
    return [
        _ruled_face(a, b, row)
        for a, b in zip(inner, outer)
        for row, neighbours in ((0, last_lines), (-1, first_lines))
        if a.poles[row].tobytes() not in neighbours
    ]


def _ruled_face(a, b, row):
    return SimpleNamespace(
        u_degree=1,
        u_knots=np.array([0.0, 1.0]),
        u_multiplicities=np.array([2, 2]),
        v_degree=a.v_degree,
        v_knots=a.v_knots,
        v_multiplicities=a.v_multiplicities,
        poles=np.stack([a.poles[row], b.poles[row]]),
        weights=np.stack([a.weights[row], b.weights[row]]),
        trims=[],
    )


def _shape(brep):
    shape = Part.Shape()
    shape.importBrepFromString(brep)
    return shape
