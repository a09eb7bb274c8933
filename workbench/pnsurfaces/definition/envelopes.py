# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of spheres along a spine, and of cylinders about the rulings of a ruled surface.

- A canal surface at distance d is the envelope of the spheres |x - m(t)| = r(t) + d. A point of it
  lies in the plane of a characteristic circle, (x - m).m' + (r + d) r' = 0.
- A canal surface from r^2, at distance zero, is the same envelope by s = r^2 alone: |x - m|^2 = s in
  the plane (x - m).m' + s' / 2 = 0. At other distances r = sqrt(s), r r' = s' / 2.
- A ruled surface at distance d is the envelope of the cylinders of radius d about its rulings: the
  foot c of a point on its ruling has (x - c).c_t = 0.
"""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.definition.along_curve import deviations_along
from pnsurfaces.definition.vectors import dot, length


class Spheres(NamedTuple):
    """A canal surface: the PiecewiseRational functions of its centres (3) and radius (1)."""

    centre: Any
    radius: Any

    words = "envelope of the spheres along the spine: distance from the centre minus the radius"

    deviations = deviations_along

    def breaks(self):
        return np.union1d(self.centre.breaks, self.radius.breaks)

    def at(self, t, inside, points, distance):
        centre, speed = self.centre.with_derivative(t, inside)
        radius, growth = (part[..., 0] for part in self.radius.with_derivative(t, inside))
        radius = radius + distance
        rays = points - centre
        slope = dot(rays, speed) + radius * growth
        return slope, np.copysign(length(rays), radius) - radius


class SquaredSpheres(NamedTuple):
    """A canal surface: the PiecewiseRational functions of its centres (3) and squared radius (1)."""

    centre: Any
    squared_radius: Any

    words = "envelope of the spheres along the spine: distance from the centre minus the root of r^2"

    deviations = deviations_along

    def breaks(self):
        return np.union1d(self.centre.breaks, self.squared_radius.breaks)

    def at(self, t, inside, points, distance):
        centre, speed = self.centre.with_derivative(t, inside)
        square, growth = (part[..., 0] for part in self.squared_radius.with_derivative(t, inside))
        # Beyond the end of a span the square may be negative; there is no point of the surface.
        root = np.sqrt(np.maximum(square, np.finfo(float).tiny))
        rays = points - centre
        slope = dot(rays, speed) + (1 + distance / root) * growth / 2
        return slope, np.copysign(length(rays), root + distance) - (root + distance)


class Rulings(NamedTuple):
    """A ruled surface: the PiecewiseRational functions of its two curves, over one domain."""

    first: Any
    last: Any

    words = "feet on the rulings: distance from the ruled surface along its normal"

    deviations = deviations_along

    def breaks(self):
        return np.union1d(self.first.breaks, self.last.breaks)

    def at(self, t, inside, points, distance):
        first, first_speed = self.first.with_derivative(t, inside)
        last, last_speed = self.last.with_derivative(t, inside)
        ruling = last - first
        part = (dot(points - first, ruling) / dot(ruling, ruling))[..., None]
        rays = points - first - part * ruling
        slope = dot(rays, first_speed + part * (last_speed - first_speed))
        return slope, np.copysign(length(rays), distance) - distance
