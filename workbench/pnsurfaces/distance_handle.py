# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrow in the 3D view that drags the distance of an offset along a normal of the surface."""

import math
import weakref

import numpy as np
from pivy import coin

from pnsurfaces.shown_node import ShownNode

# How the handle is found among the nodes of its object.
NODE_NAME = "PNSurfacesHandle"

# The length of the arrow, as part of the size of the surface.
_LENGTH = 1 / 8

# Dragging stops at round distances: powers of ten apart, at least so many over the surface's size.
_STEPS = 1000


class DistanceHandle:
    """Calls dragged(distance) while the user drags its arrow."""

    def __init__(self, view_object, dragged):
        self._dragged = dragged
        node = coin.SoSeparator()
        self._shown = ShownNode(view_object, node, NODE_NAME)
        self._frame = coin.SoTransform()
        dragger = coin.SoTranslate1Dragger()
        # In lengths of the arrow. Each reading of a field from its node would cost a little memory.
        self._translation = dragger.translation
        self._length = 1.0
        node.addChild(self._frame)
        node.addChild(dragger)
        # Coin never lets go of what it is given to hand back.
        self._sensor = coin.SoFieldSensor(_moved, weakref.ref(self))
        # At once, not when the view is idle.
        self._sensor.setPriority(0)
        self._sensor.attach(self._translation)
        self._distance = 0.0
        self._step = 1.0
        self._is_placed = False

    def place(self, mesh, up):
        """Stands on the point of a SectionMesh that is furthest in the direction `up`.

        With the direction upwards on the screen, the arrow points there, so it is dragged well.
        """
        index = np.argmax(mesh.points @ np.asarray(up))
        size = float(np.ptp(mesh.points, axis=0).max())
        normal = coin.SbVec3f(*map(float, mesh.normals[index]))
        self._length = _LENGTH * size
        self._frame.translation = tuple(map(float, mesh.points[index]))
        self._frame.rotation = coin.SbRotation(coin.SbVec3f(1, 0, 0), normal)
        self._frame.scaleFactor = (self._length,) * 3
        self._step = 10 ** math.floor(math.log10(size / _STEPS))
        self._is_placed = True
        self.follow(self._distance)

    def follow(self, distance):
        """Stands on the section at a distance."""
        self._distance = distance
        self._sensor.detach()
        self._translation.setValue(distance / self._length, 0, 0)
        self._sensor.attach(self._translation)

    def show(self):
        """Shows it, once there is a surface to stand on."""
        if self._is_placed:
            self._shown.show()

    def hide(self):
        self._shown.hide()

    def close(self):
        """Hides it for good."""
        self.hide()
        self._sensor.detach()
        self._dragged = None

    def moved(self):
        """What follows when the arrow has been moved."""
        along = self._translation.getValue()[0] * self._length
        distance = float(f"{round(along / self._step) * self._step:.12g}")
        if distance != self._distance:
            self._distance = distance
            self._dragged(distance)


def _moved(reference, _):
    handle = reference()
    if handle:
        handle.moved()
