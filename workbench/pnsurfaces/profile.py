# SPDX-License-Identifier: LGPL-2.1-or-later
"""The radius that lets a pipe run through a profile: the distance of the spine from its edges.

The sphere about a point m of the spine with the shortest distance r to the profile touches it, at p.
There (p - m).m' + r r' = 0, so that p lies on the circle in which the sphere touches the envelope:
the profile lies on the pipe. The distance changes no faster than m moves, so that the envelope
exists wherever the profile is not straight ahead. (The distance in normal planes has neither
property.)
"""

import Part

from pnsurfaces.edge_chain import CONFUSION, place
from pnsurfaces.linked_shape import linked_shapes
from pnsurfaces.radius_error import RadiusLawError


class Profile:
    """The distance of a spine from edges, as a radius along its stretches."""

    what = "the distance of the profile"

    def __init__(self, source, names, container=None):
        edges = [
            edge for shape in linked_shapes(source, names, container) for edge in shape.Edges
            if not edge.Degenerated
        ]
        if not edges:
            raise RadiusLawError(f"{source.Label} has no edge that could be the profile.")
        self._shape = Part.Compound(edges)

    def radius(self, stretch, t):
        return self._nearest(stretch.point(t))[0]

    def slope(self, stretch, t):
        """The derivative of the radius by the parameter of the spine."""
        point = stretch.point(t)
        distance, foot = self._nearest(point)
        if distance <= CONFUSION:
            raise RadiusLawError(f"The profile meets the spine at {place(point)}.")
        return (point - foot).dot(stretch.velocity(t)) / distance

    def _nearest(self, point):
        distance, ((foot, _), *_), _ = self._shape.distToShape(Part.Vertex(point))
        return distance, foot
