# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of all sections of an exact surface at once, for drawing.

The section at distance d is  x_d = x_0 + d n  with the same unit normal n at the same parameters, and
so are the faces that the kernel makes of it. Two sections give points x_0 and normals n; every other
section is a sum. Edges of trimmed faces are the same curves in the parameters for all distances.
"""

import itertools
from typing import NamedTuple

import numpy as np

# So many points are drawn at once on a usual graphics card, about; with fewest and most steps of
# each knot span, between which curves look like polygons or no better any more.
_POINTS = 40_000
_STEPS = (2, 16)

# Straight pieces of an edge of a trimmed face.
_PIECES_OF_EDGE = 64

# How often the gap is halved between two lines that the boundary cuts into different numbers of
# pieces: it is less than a millionth of the face then.
_HALVINGS = 16

# Trimmed faces, of which there are few, have so many times more lines along their edges.
_LINES_OF_TRIMMED_FACE = 3

# The first and the last line of a trimmed face lie this part of its width inside, where they still
# cross its boundary.
_INSET = 1e-6


class SectionMesh(NamedTuple):
    """Points (n, 3) of the section at distance 0, normals (n, 3) and triangles (m, 3) of indices."""

    points: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray

    def section(self, distance):
        """Points (n, 3) of the section at a distance."""
        return self.points + distance * self.normals


def section_mesh(surface):
    """The SectionMesh of a kernel surface at distance 0."""
    faces = surface.bsplines()
    raised = surface.offset(1.0).bsplines() if surface.has_offsets else faces
    rectangles = sum((len(face.u_knots) - 1) * (len(face.v_knots) - 1) for face in faces)
    steps = int(np.clip(np.sqrt(_POINTS / rectangles), *_STEPS))
    points, normals, triangles = [], [], []
    count = 0
    for group in _alike(faces):
        for u, v in _patches(faces[group[0]], steps):
            bases = _local_basis(faces[group[0]], "u", u), _local_basis(faces[group[0]], "v", v)
            grids = _points([faces[i] for i in group], *bases)
            offsets = _points([raised[i] for i in group], *bases)
            indices = count + np.arange(grids[..., 0].size).reshape(grids.shape[:-1])
            count += indices.size
            points.append(grids.reshape(-1, 3))
            normals.append((offsets - grids).reshape(-1, 3))
            triangles.append(_triangles(indices))
    mesh = SectionMesh(*map(np.concatenate, (points, normals, triangles)))
    if not surface.has_offsets:
        mesh = mesh._replace(normals=_vertex_normals(mesh))
    return mesh._replace(triangles=_facing_normals(mesh))


def _alike(faces):
    """Indices of the faces in groups over the same parameters, up to scale; trimmed ones alone."""
    groups = {}
    for i, face in enumerate(faces):
        key = i if face.trims else _structure(face)
        groups.setdefault(key, []).append(i)
    return groups.values()


def _structure(face):
    return tuple(
        part
        for side in ("u", "v")
        for part in (
            getattr(face, f"{side}_degree"),
            tuple(getattr(face, f"{side}_multiplicities")),
            _unit_knots(face, side).tobytes(),
        )
    )


def _unit_knots(face, side):
    knots = np.asarray(getattr(face, f"{side}_knots"))
    return (knots - knots[0]) / (knots[-1] - knots[0])


def _patches(face, steps):
    """Parameters u (m,), v (k,) or (m, k) of grids that fill a face, from 0 to 1."""
    u_knots, v_knots = (_unit_knots(face, side) for side in ("u", "v"))
    v = _spread(v_knots, steps)
    if not face.trims:
        return [(_spread(u_knots, steps), v)]
    u = _spread(u_knots, _LINES_OF_TRIMMED_FACE * steps)
    u[0], u[-1] = _INSET, 1 - _INSET
    parts = np.linspace(0, 1, len(v))
    return [
        (values, ends[:, :1] + (ends[:, 1:] - ends[:, :1]) * parts)
        for values, ends in _strips(u, _boundary(face))
    ]


def _spread(knots, steps):
    inner = [np.linspace(a, b, steps, endpoint=False) for a, b in itertools.pairwise(knots)]
    return np.concatenate([*inner, knots[-1:]])


def _boundary(face):
    """Straight pieces (s, 2, 2) of the edges of a trimmed face, in parameters from 0 to 1."""
    ranges = [np.asarray(getattr(face, f"{side}_knots"))[[0, -1]] for side in ("u", "v")]
    first, last = np.transpose(ranges)
    lines = [(_curve_points(curve) - first) / (last - first) for loop in face.trims for curve in loop]
    return np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in lines])


def _curve_points(curve):
    knots = np.repeat(curve.knots, curve.multiplicities)
    t = np.linspace(knots[0], knots[-1], _PIECES_OF_EDGE + 1)
    values, indices = _nonzero_bsplines(knots, curve.degree, t)
    return np.einsum("ma,mac->mc", values, np.asarray(curve.poles)[indices])


def _strips(u, boundary):
    """Strips of lines u = const that the boundary cuts alike: pairs of u (m,) and ends (m, 2)."""
    lines = [(value, _intervals(boundary, value)) for value in u]
    lines = list(_with_lines_at_changes(lines, boundary))
    for count, run in itertools.groupby(lines, key=lambda line: len(line[1])):
        places = [value for value, _ in run]
        # Where a boundary turns back, its ends are like the height of a circle over a diameter.
        turns = (1 - np.cos(np.linspace(0, np.pi, len(u)))) / 2
        values = places[0] + (places[-1] - places[0]) * turns
        cut = [(value, _intervals(boundary, value)) for value in values]
        alike = [(value, intervals) for value, intervals in cut if len(intervals) == count]
        for k in range(count):
            yield (
                np.array([value for value, _ in alike]),
                np.array([intervals[k] for _, intervals in alike]),
            )


def _with_lines_at_changes(lines, boundary):
    """The lines, and two more wherever the number of pieces changes, one on either side of it."""
    for line, after in itertools.pairwise(lines):
        yield line
        if len(line[1]) != len(after[1]):
            for _ in range(_HALVINGS):
                middle = (line[0] + after[0]) / 2
                found = middle, _intervals(boundary, middle)
                line, after = (found, after) if len(found[1]) == len(line[1]) else (line, found)
            yield line
            yield after
    yield lines[-1]


def _intervals(boundary, value):
    """The pieces of the line u = value inside the boundary: pairs of v."""
    (u0, v0), (u1, v1) = boundary.transpose(1, 2, 0)
    crosses = (u0 > value) != (u1 > value)
    part = (value - u0[crosses]) / (u1 - u0)[crosses]
    ends = np.sort(v0[crosses] + part * (v1 - v0)[crosses])
    return list(zip(ends[::2], ends[1::2]))


def _local_basis(face, side, parameters):
    multiplicities = getattr(face, f"{side}_multiplicities")
    knots = np.repeat(_unit_knots(face, side), multiplicities)
    return _nonzero_bsplines(knots, getattr(face, f"{side}_degree"), parameters)


def _nonzero_bsplines(knots, degree, t):
    """The degree + 1 B-splines that do not vanish at t (...): values and indices, (..., p + 1)."""
    t = np.asarray(t)
    span = np.clip(np.searchsorted(knots, t, "right") - 1, degree, len(knots) - degree - 2)
    values = np.ones(t.shape + (degree + 1,))
    for order in range(1, degree + 1):
        carried = np.zeros(t.shape)
        for r in range(order):
            right, left = knots[span + r + 1] - t, t - knots[span + r + 1 - order]
            share = values[..., r] / (right + left)
            values[..., r] = carried + right * share
            carried = left * share
        values[..., order] = carried
    return values, span[..., None] + np.arange(-degree, 1)


def _points(faces, along, across):
    """Points (f, m, k, 3) of faces of one structure, at u of `along` and v of `across`."""
    weights = np.stack([face.weights for face in faces])[..., None]
    poles = np.concatenate([np.stack([face.poles for face in faces]) * weights, weights], axis=-1)
    values, indices = along
    rows = np.einsum("ma,fmajc->fmjc", values, poles[:, indices], optimize=True)
    values, indices = across
    if values.ndim == 2:
        homogeneous = np.einsum("kb,fmkbc->fmkc", values, rows[:, :, indices], optimize=True)
    else:
        lines = np.arange(len(values))[:, None, None]
        homogeneous = np.einsum("mkb,fmkbc->fmkc", values, rows[:, lines, indices], optimize=True)
    return homogeneous[..., :3] / homogeneous[..., 3:]


def _facing_normals(mesh):
    """The triangles, each run through so that it faces the side of its normals."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    normals = mesh.normals[mesh.triangles].sum(axis=1)
    is_turned = np.einsum("mc,mc->m", np.cross(b - a, c - a), normals) < 0
    return np.where(is_turned[:, None], mesh.triangles[:, ::-1], mesh.triangles)


def _vertex_normals(mesh):
    """Unit normals (n, 3), of the triangles around each point."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    normals, across = np.zeros_like(mesh.points), np.cross(b - a, c - a)
    for i in range(3):
        np.add.at(normals, mesh.triangles[:, i], across)
    return normals / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)[:, None]


def _triangles(indices):
    """Two triangles for each mesh of grids of indices (f, m, k)."""
    a, b = indices[:, :-1, :-1], indices[:, 1:, :-1]
    c, d = indices[:, 1:, 1:], indices[:, :-1, 1:]
    return np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
