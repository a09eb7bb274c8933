# SPDX-License-Identifier: LGPL-2.1-or-later
"""The radius that lets a pipe run through a profile: the distance of the spine from its edges.

The sphere about a point m of the spine whose radius r is the distance of the profile touches it, at
a point p. There (p - m).m' + r r' = 0, so that p lies on the circle in which the sphere touches the
envelope: the profile lies on the pipe. The distance changes no faster than m moves, so that the
envelope exists wherever the profile is not straight ahead. (The distance in normal planes has
neither property.)

Along a straight spine the distance of a straight profile in one plane with it is linear, and exact.
"""

from fractions import Fraction

import Part

from pnsurfaces.edge_chain import CONFUSION, place
from pnsurfaces.linked_shape import linked_shapes
from pnsurfaces.radius_error import RadiusLawError


class Profile:
    """The distance of a spine from edges, as a radius along its stretches."""

    what = "the distance of the profile"

    def __init__(self, source, names, container=None):
        edges = [
            edge
            for shape in linked_shapes(source, names, container)
            for edge in shape.Edges
            if not edge.Degenerated
        ]
        if not edges:
            raise RadiusLawError(f"{source.Label} has no edge that could be the profile.")
        self._shape = Part.Compound(edges)

    def radii_along_line(self, spine):
        """The radii at both ends when the law is linear between them, else None."""
        if len(spine.stretches) != 1 or len(self._shape.Edges) != 1:
            return None
        stretch, edge = spine.stretches[0], self._shape.Edges[0]
        line = [stretch.point(t) for t in (stretch.begin, stretch.end)]
        profile = [edge.valueAt(t) for t in edge.ParameterRange]
        if not (stretch.curve.Degree == 1 and isinstance(edge.Curve, Part.Line)):
            return None
        return [self._nearest(point)[0] for point in line] if _is_opposite(profile, line) else None

    def radius(self, stretch, t):
        return self._nearest(stretch.point(t))[0]

    def slope(self, stretch, t):
        """The derivative of the radius by the parameter of the spine."""
        point = stretch.point(t)
        distance, foot = self._nearest(point)
        return (point - foot).dot(stretch.velocity(t)) / distance

    def _nearest(self, point):
        distance, ((foot, _), *_), _ = self._shape.distToShape(Part.Vertex(point))
        if distance <= CONFUSION:
            raise RadiusLawError(f"The profile meets the spine at {place(point)}.")
        return distance, foot


def _is_opposite(profile, line):
    """Whether two segments lie in one plane, the second one on one side of the first and above it.

    It is decided over Q: then the nearest points of the first are the feet, all along the second.
    """
    (a, b), (c, d) = ([_exact(point) for point in segment] for segment in (profile, line))
    along, first, last = _minus(b, a), _minus(c, a), _minus(d, a)
    normals = [_cross(along, first), _cross(along, last)]
    in_plane = _dot(normals[0], last) == 0
    same_side = _dot(*normals) > 0
    return (
        in_plane
        and same_side
        and all(0 <= _dot(along, offset) <= _dot(along, along) for offset in (first, last))
    )


def _exact(point):
    return [Fraction(coordinate) for coordinate in point]


def _minus(p, q):
    return [a - b for a, b in zip(p, q)]


def _dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def _cross(p, q):
    return [p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2] for i in range(3)]
