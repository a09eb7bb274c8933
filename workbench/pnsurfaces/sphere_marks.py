# SPDX-License-Identifier: LGPL-2.1-or-later
"""The control spheres of a mid-surface and the net between them, drawn while they are edited."""

import numpy as np
from pivy import coin

from pnsurfaces.shown_node import ShownNode

# How they are found among the nodes of their object.
NODE_NAME = "PNSurfacesSpheres"

# The yellow of what is created, seen through.
_COLOUR = (0.99, 0.91, 0.31)
_TRANSPARENCY = 0.6

# The net A-AB-B-BC-C-CA-A with the inner triangle AB-BC-CA, by numbers of spheres.
_NET = (0, 3, 1, 4, 2, 5, 0, -1, 3, 4, 5, 3, -1)


class SphereMarks:
    """Draws six spheres (6, 4), centre and radius, in the coordinates of a view object."""

    def __init__(self, view_object):
        self._node = coin.SoSeparator()
        self._shown = ShownNode(view_object, self._node, NODE_NAME)

    def show(self, spheres):
        """Draws these spheres and no others."""
        self._node.removeAllChildren()
        for child in (_unpickable(), _material(), *map(_sphere, spheres), *_net(spheres[:, :3])):
            self._node.addChild(child)
        self._shown.show()

    def hide(self):
        self._shown.hide()


def _unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def _material():
    material = coin.SoMaterial()
    material.diffuseColor = _COLOUR
    material.transparency = _TRANSPARENCY
    return material


def _sphere(sphere):
    node, place, ball = coin.SoSeparator(), coin.SoTranslation(), coin.SoSphere()
    place.translation = tuple(map(float, sphere[:3]))
    ball.radius = abs(float(sphere[3]))
    node.addChild(place)
    node.addChild(ball)
    return node


def _net(centres):
    points, lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
    points.point.setValues(0, len(centres), np.ascontiguousarray(centres, dtype=np.float32))
    lines.coordIndex.setValues(0, len(_NET), _NET)
    return points, lines
