# SPDX-License-Identifier: LGPL-2.1-or-later
"""From B-spline faces to Part shapes.

`sections` is a list with the faces of each section of one exact surface, the smallest distance
first; corresponding faces have the same parameters.
"""

from collections import Counter

import FreeCAD
import numpy as np
import Part

from pnsurfaces import kernel

# A wall and its face have the same curve, each within some 1e-9 mm of it. Nothing else is as near.
_SEWING_TOLERANCE = 1e-6


def surface_of_sections(sections):
    """A shell, or a compound of shells: one for each part of each section."""
    return _together([shell for faces in sections for shell in _shells(faces)])


def solid_of_sections(sections):
    """The solid inside one section, closed flat, or the one between two, closed by normals.

    Sections of several parts give a compound of solids.
    """
    if len(sections) == 1:
        return part_shape(kernel.pnocct().capped_solid(sections[0]))
    if any(face.trims for faces in sections for face in faces):
        return _together([_joined_by_walls(*pair) for pair in zip(*map(_shells, sections))])
    return part_shape(kernel.pnocct().thick_solid(*sections))


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


def _joined_by_walls(inner, outer):
    """The solid between two open shells of trimmed faces, which pnocct does not join.

    Edges of the same place correspond: both shells come from the same parameters.
    """
    pairs = zip(_free_edges(inner), _free_edges(outer))
    walls = [Part.makeRuledSurface(*pair) for pair in pairs]
    shell = Part.Compound([*inner.Faces, *outer.Faces, *walls])
    shell.sewShape(_SEWING_TOLERANCE)
    return Part.makeSolid(shell)


def _free_edges(shell):
    """The edges of one face only, in the order of the faces."""
    edges = [edge for face in shell.Faces for edge in face.Edges if not edge.Degenerated]
    uses = Counter(edge.hashCode() for edge in edges)
    return [edge for edge in edges if uses[edge.hashCode()] == 1]


def _poles(face):
    """The poles of a face in its own coordinates, (nu, nv, 3); none for a plane."""
    surface = face.Surface
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
