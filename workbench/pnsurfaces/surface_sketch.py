# SPDX-License-Identifier: LGPL-2.1-or-later
"""A surface drawn from a mesh of points in place of its shape, which is not there yet.

FreeCAD takes a tenth of a second and more to draw a shape, since it divides it into triangles again.
Points of another distance only take the place of those that are drawn.
"""

import numpy as np
from pivy import coin

# How the drawing is found among the nodes of its object.
NODE_NAME = "PNSurfacesSketch"

# What hides all children of a switch.
_NONE = -1


class SurfaceSketch:
    """Draws sections of one SectionMesh while the shape of a view object is hidden."""

    def __init__(self, view_object):
        self._view_object = view_object
        self._node = coin.SoSeparator()
        self._node.setName(NODE_NAME)
        self._points = []
        self._mesh = None
        self._hidden = None

    def show(self, mesh, distances):
        """Draws the sections of a mesh at these distances."""
        if mesh is not self._mesh or len(distances) != len(self._points):
            self._build(mesh, len(distances))
        for node, distance in zip(self._points, distances):
            points = mesh.section(distance).astype(np.float32)
            node.point.setValues(0, len(points), points)
        self._hide_shape()

    def hide(self):
        """Shows the shape again."""
        if self._hidden is None:
            return
        self._view_object.SwitchNode.whichChild = self._hidden
        self._hidden = None
        self._view_object.RootNode.removeChild(self._node)

    def is_shown(self):
        return self._hidden is not None

    def _hide_shape(self):
        if self.is_shown():
            return
        switch = self._view_object.SwitchNode
        self._hidden = switch.whichChild.getValue()
        switch.whichChild = _NONE
        self._view_object.RootNode.addChild(self._node)

    def _build(self, mesh, count):
        self._mesh = mesh
        self._points = [coin.SoCoordinate3() for _ in range(count)]
        self._node.removeAllChildren()
        for node in (_unpickable(), _two_sided(), self._material(), *_normals(mesh)):
            self._node.addChild(node)
        faces = _triangles(mesh)
        for points in self._points:
            self._node.addChild(points)
            self._node.addChild(faces)

    def _material(self):
        material = coin.SoMaterial()
        material.diffuseColor = self._view_object.ShapeColor[:3]
        material.transparency = self._view_object.Transparency / 100
        return material


def _unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def _two_sided():
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    return hints


def _normals(mesh):
    """The same for all distances."""
    binding = coin.SoNormalBinding()
    binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
    normals = coin.SoNormal()
    normals.vector.setValues(0, len(mesh.normals), mesh.normals.astype(np.float32))
    return binding, normals


def _triangles(mesh):
    faces = coin.SoIndexedFaceSet()
    ends = np.full((len(mesh.triangles), 1), coin.SO_END_FACE_INDEX)
    indices = np.hstack([mesh.triangles, ends]).astype(np.int32).ravel()
    faces.coordIndex.setValues(0, len(indices), indices)
    return faces
