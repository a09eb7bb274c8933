# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis of an exact surface in the 3D view: drawn beside its shape, which is not touched.

While something is shown, the faces are drawn from their own grid in front of the shape's coarser
triangles, in the same group of the scene. Nothing is stored in the document.
"""

import FreeCAD
import numpy as np
from pivy import coin

from pnsurfaces import analysis_nodes as nodes
from pnsurfaces.curvature import combs, curved_patches, smallest_radius
from pnsurfaces.face_grid import face_grid, lines
from pnsurfaces.shape import own_shape
from pnsurfaces.spline_grid import points_at

translate = FreeCAD.Qt.translate

CURVATURE = "curvature"
GAUSS = "gauss"
ZEBRA = "zebra"
COMBS = "combs"
CONTROL_NET = "control net"
PARAMETER_LINES = "parameter lines"

# Of these only one can colour the faces.
_COLOURINGS = (CURVATURE, GAUSS, ZEBRA)

# The grid of a face; many faces together get no more points than so many single ones.
_ROWS, _COLUMNS = 64, 128
_FACES_IN_FULL = 8
_LEAST_ROWS = 8

# Lines of a face in each direction with combs or as parameter lines, at least, points of each, and
# teeth of a comb.
_LINES = 9
_POINTS_OF_LINE = 65
_LINES_WITH_COMBS = 4
_TEETH = 65

# The longest tooth of all combs, as part of the size of the shape.
_TOOTH = 0.15

# A scale ends at so many times what nine tenths of the points stay below: near a singular point
# curvature has no bound.
_MOST, _LARGEST_RATIO = 90, 10

# The radii of a map differ by a factor between these: less would show noise, more is flat.
_LEAST_SPAN, _LARGEST_SPAN = 1.5, 1000

_EDGE_COLOUR = (0.1, 0.1, 0.1)
_LINE_COLOURS = ((0.1, 0.3, 0.6), (0.6, 0.2, 0.1))
_NET_COLOUR = (0.75, 0.2, 0.6)
_COMB_COLOUR = (0.05, 0.45, 0.25)
_WHITE = (1.0, 1.0, 1.0)
_POINTS_OF_EDGE = 60

# Of the triangles of faces on no B-spline, as part of their size.
_DEFLECTION = 1e-3


class Analysis:
    """What is shown of the surface of one view object. `shown` are the names of it."""

    def __init__(self, view_object):
        self.shown = frozenset()
        self._view_object = view_object
        self._switch = None
        self._backdrop = None

    def show(self, names):
        """Shows just these, of two colourings the one that was not there before."""
        added = [name for name in names if name in _COLOURINGS and name not in self.shown]
        replaced = set(_COLOURINGS) - set(added) if added else set()
        self.shown = frozenset(names) - replaced
        self.update()

    def has_legend(self):
        """Whether a legend of it is in the view."""
        is_coloured = not self.shown.isdisjoint({CURVATURE, GAUSS})
        return is_coloured and self._view_object.Visibility

    def update(self):
        """Draws anew, after the shape or the colour has changed."""
        self._remove()
        shape = self._view_object.Object.Shape
        if self.shown and not shape.isNull():
            self._insert(_Picture(self._view_object, self.shown).nodes())
            self.follow_visibility()

    def follow_visibility(self):
        """Hides or shows the analysis with the object."""
        if self._switch:
            is_shown = self._view_object.Visibility
            self._switch.whichChild = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE

    def _insert(self, children):
        self._switch = coin.SoSwitch()
        self._switch.addChild(nodes.group(nodes.not_pickable(), nodes.own_colours(), *children))
        self._backdrop = nodes.behind()
        root = self._view_object.RootNode
        # Behind the placement and before the shape.
        root.insertChild(self._switch, 1)
        root.insertChild(self._backdrop, 2)

    def _remove(self):
        if self._switch:
            for node in (self._switch, self._backdrop):
                self._view_object.RootNode.removeChild(node)
            self._switch = self._backdrop = None


class _Picture:
    """The nodes for one shape as it is now."""

    def __init__(self, view_object, shown):
        self._view_object = view_object
        self._shown = shown
        self._shape = own_shape(view_object.Object)
        grids = [(face, face_grid(face)) for face in self._shape.Faces]
        self._grids = [grid for _, grid in grids if grid]
        self._others = [face for face, grid in grids if not grid]
        share = min(1, np.sqrt(_FACES_IN_FULL / max(1, len(self._grids))))
        rows, columns = (max(_LEAST_ROWS, int(share * count)) for count in (_ROWS, _COLUMNS))
        self._patches = [
            patch for grid in self._grids for patch in curved_patches(grid, rows, columns)
        ]

    def nodes(self):
        yield from self._faces()
        for face in self._others:
            yield nodes.triangles(*_triangles(face), self._view_object.ShapeColor[:3])
        yield nodes.lines(_edges(self._shape), _EDGE_COLOUR, self._view_object.LineWidth)
        for name, layer in (
            (PARAMETER_LINES, self._parameter_lines),
            (CONTROL_NET, self._control_net),
            (COMBS, self._combs),
        ):
            if name in self._shown and self._grids:
                yield from layer()

    def _faces(self):
        if not self._patches:
            return
        if CURVATURE in self._shown:
            yield from self._by_curvature()
        elif GAUSS in self._shown:
            yield from self._by_gauss()
        elif ZEBRA in self._shown:
            yield nodes.group(nodes.zebra(), *self._in_one_colour(_WHITE))
        else:
            yield from self._in_one_colour(self._view_object.ShapeColor[:3])

    def _in_one_colour(self, colour):
        return [nodes.surface(p.points, p.normals, colour) for p in self._patches]

    def _in_scale(self, scale, parts):
        return [
            nodes.surface(patch.points, patch.normals, nodes.colours(scale, part))
            for patch, part in zip(self._patches, parts)
        ]

    def _by_curvature(self):
        found = smallest_radius(self._patches)
        if not np.isfinite(found.radius):
            yield from self._in_one_colour(nodes.STRENGTH[0])
            yield self._legend(nodes.STRENGTH, "flat", [(0, "r = ∞")])
            return
        values = [patch.strongest() for patch in self._patches]
        top, low = _top(values), min(value.min() for value in values)
        low = np.clip(low, top / _LARGEST_SPAN, top / _LEAST_SPAN)
        # By the logarithm: a tight bend and a wide one are told apart as well as two tight ones.
        octaves = np.log(top / low)
        yield from self._in_scale(
            nodes.STRENGTH, [np.log(np.maximum(value, low) / low) / octaves for value in values]
        )
        text = translate("PNSurfaces", "smallest radius {} mm").format(f"{found.radius:.4g}")
        yield nodes.label(found.point, text)
        radii = [(part, np.exp(-part * octaves) / low) for part in np.linspace(0, 1, 5)]
        marks = [(part, f"r = {radius:.4g} mm") for part, radius in radii]
        yield self._legend(nodes.STRENGTH, text, marks)

    def _by_gauss(self):
        values = [patch.gauss() for patch in self._patches]
        top = _top([np.abs(value) for value in values])
        # By the square root, which is one over a radius.
        yield from self._in_scale(
            nodes.SIGNED, [0.5 + np.sign(value) * np.sqrt(np.abs(value) / top) / 2 for value in values]
        )
        marks = [(0.5 + part / 2, f"{part * abs(part) * top:+.3g}") for part in (-1, -0.5, 0.5, 1)]
        title = translate("PNSurfaces", "Gauss curvature, 1/mm²")
        yield self._legend(nodes.SIGNED, title, [(0.5, "0"), *marks])

    def _legend(self, scale, title, marks):
        label = self._view_object.Object.Label
        return nodes.legend(scale, (label, title), marks, self._number_of_legend())

    def _number_of_legend(self):
        """How many objects of the document before this one have a legend."""
        number = 0
        for obj in self._view_object.Object.Document.Objects:
            if obj is self._view_object.Object:
                break
            proxy = getattr(obj.ViewObject, "Proxy", None)
            analysis = getattr(proxy, "analysis", None)
            number += bool(analysis and analysis.has_legend())
        return number

    def _parameter_lines(self):
        for axis, colour in enumerate(_LINE_COLOURS):
            yield nodes.lines(
                [
                    _along(grid, line)
                    for grid in self._grids
                    for line in lines(grid, axis, _LINES, _POINTS_OF_LINE)
                ],
                colour,
            )

    def _control_net(self):
        poles = [grid.surface.poles for grid in self._grids]
        poles = [pole[..., :3] / pole[..., 3:] for pole in poles]
        rows = [row for net in poles for way in (net, net.swapaxes(0, 1)) for row in way]
        yield nodes.lines(rows, _NET_COLOUR)
        yield nodes.markers(np.concatenate([net.reshape(-1, 3) for net in poles]), _NET_COLOUR)

    def _combs(self):
        every = [
            comb
            for grid in self._grids
            for axis in (0, 1)
            for comb in combs(grid, _thinned(lines(grid, axis, _LINES_WITH_COMBS, _TEETH)))
        ]
        roots = [points for points, _, _ in every]
        largest = _top([np.abs(curvature) for _, _, curvature in every])
        size = np.linalg.norm(np.ptp(np.concatenate(roots), axis=0))
        reach = _TOOTH * size / largest
        # Teeth stand on the outside of the bend.
        tips = [
            points - reach * np.clip(curvature, -largest, largest)[:, None] * normals
            for points, normals, curvature in every
        ]
        teeth = np.stack([np.concatenate(roots), np.concatenate(tips)], axis=1)
        yield nodes.lines(teeth, _COMB_COLOUR)
        yield nodes.lines(tips, _COMB_COLOUR, 2.0)


def _along(grid, line):
    """The points (k, 3) at parameters (k, 2)."""
    return points_at(grid.surface, line[:, 0], line[:, 1:])[:, 0]


def _thinned(every):
    """Of many lines, as a surface of many spans has them, as many as a picture can bear."""
    return every[:: max(1, len(every) // _LINES)]


def _top(values):
    """The end of a scale for arrays of values >= 0; 1 where all are zero."""
    every = np.concatenate([value.ravel() for value in values])
    positive = every[every > 0]
    if not positive.size:
        return 1.0
    return min(positive.max(), _LARGEST_RATIO * np.percentile(positive, _MOST))


def _triangles(face):
    """Points (n, 3) and corners (t, 3) of triangles of a face on no B-spline, such as a flat end."""
    points, corners = face.tessellate(_DEFLECTION * face.BoundBox.DiagonalLength)
    return np.array([tuple(point) for point in points]), np.array(corners)


def _edges(shape):
    edges = [edge for edge in shape.Edges if not edge.Degenerated]
    return [np.array([tuple(p) for p in edge.discretize(_POINTS_OF_EDGE)]) for edge in edges]
