# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several surfaces of the kernel as one, such as the two skins of a mid-surface."""

from types import SimpleNamespace


class SeveralSurfaces:
    """Has those members of a kernel surface that features use, for all the surfaces together."""

    def __init__(self, surfaces):
        self._surfaces = surfaces

    @property
    def distance(self):
        return self._surfaces[0].distance

    @property
    def has_offsets(self):
        return all(surface.has_offsets for surface in self._surfaces)

    def offset(self, distance):
        return SeveralSurfaces([surface.offset(distance) for surface in self._surfaces])

    def bsplines(self, lines="even"):
        """The faces of one surface after those of the other."""
        return [face for surface in self._surfaces for face in surface.bsplines(lines=lines)]

    def certificate_of(self, lines):
        """What holds for all of them: the largest deviation, the sum of the poles, all notes."""
        parts = [surface.certificate_of(lines) for surface in self._surfaces]
        return SimpleNamespace(
            deviation=max(part.deviation for part in parts),
            precision_bits=max(part.precision_bits for part in parts),
            exact=all(part.exact for part in parts),
            bidegree=tuple(map(max, *(part.bidegree for part in parts))),
            poles=sum(part.poles for part in parts),
            notes=list(dict.fromkeys(note for part in parts for note in part.notes)),
            trim_deviation=max(part.trim_deviation for part in parts),
        )

    @property
    def regular_range(self):
        ranges = [surface.regular_range for surface in self._surfaces]
        return max(low for low, _ in ranges), min(high for _, high in ranges)

    @property
    def focal_points(self):
        """Those of the first surface that has some."""
        found = [surface.focal_points for surface in self._surfaces]
        return tuple(next(filter(None, points), None) for points in zip(*found))

    def self_intersection(self):
        """Where one of them crosses itself. That they cross each other is not looked for."""
        return next(filter(None, (surface.self_intersection() for surface in self._surfaces)), None)
