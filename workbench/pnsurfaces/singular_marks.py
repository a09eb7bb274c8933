# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the offsets of a surface become singular first, marked in the 3D view."""

import numpy as np
from pivy import coin

from pnsurfaces.shown_node import ShownNode

# How the marks are found among the nodes of their object.
NODE_NAME = "PNSurfacesSingularPoints"

# The red of the bar in the panel.
_COLOUR = (0.88, 0.11, 0.14)


class SingularMarks:
    """Marks the focal points (pnkernel.FocalPoint) of a view object's surface, each with a line to
    the point of the surface at distance 0 that moves there.
    """

    def __init__(self, view_object):
        self._node = coin.SoAnnotation()
        self._shown = ShownNode(view_object, self._node, NODE_NAME)

    def show(self, focal_points):
        """Marks these points and no others."""
        self._node.removeAllChildren()
        if focal_points:
            for child in _nodes(focal_points):
                self._node.addChild(child)
        self._shown.show()

    def hide(self):
        self._shown.hide()


def _nodes(focal_points):
    ends = np.array([(focal.base, focal.point) for focal in focal_points], dtype=np.float32)
    pick, model = coin.SoPickStyle(), coin.SoLightModel()
    pick.style = coin.SoPickStyle.UNPICKABLE
    model.model = coin.SoLightModel.BASE_COLOR
    colour = coin.SoBaseColor()
    colour.rgb = _COLOUR
    lines = coin.SoLineSet()
    lines.numVertices.setValues(0, len(ends), [2] * len(ends))
    marks = coin.SoMarkerSet()
    marks.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
    return pick, model, colour, _points(ends.reshape(-1, 3)), lines, _points(ends[:, 1]), marks


def _points(points):
    node = coin.SoCoordinate3()
    node.point.setValues(0, len(points), np.ascontiguousarray(points))
    return node
