# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes for pictures of surfaces: coloured grids, lines, texts and legends."""

import numpy as np
from pivy import coin

from pnsurfaces.compat import QtGui

# From the lowest to the highest value, each in equal parts: red, green, blue.
STRENGTH = np.array(
    [[0.15, 0.25, 0.75], [0.1, 0.65, 0.85], [0.3, 0.8, 0.35], [0.98, 0.85, 0.2], [0.85, 0.1, 0.1]]
)
SIGNED = np.array(
    [[0.1, 0.3, 0.8], [0.55, 0.7, 0.95], [0.95, 0.95, 0.92], [0.97, 0.65, 0.45], [0.8, 0.1, 0.1]]
)

# Stripes of the zebra around the sphere of directions, and pixels of each.
_STRIPES = 16
_PIXELS_OF_STRIPE = 16

# The legend in a window from -1 to 1 in both directions: left, right, bottom and top of its bar,
# the step to the next legend and that to the next line.
_LEGEND = (-0.97, -0.935, -0.9, -0.35)
_NEXT_LEGEND = 0.48
_LINE_OF_TEXT = 0.06

# A shape's own triangles are up to a thousandth of the size of its poles off the surface, which may
# be ten times its own: a few times as much of the depth of a view, in units of a buffer of 24 bits.
_UNITS_BEHIND = 0.05 * 2**24

_TEXT_SIZE = 14
_INK = (0.1, 0.1, 0.1)
_PAPER = (0.95, 0.95, 0.93)


def group(*children):
    """A separator with these children."""
    node = coin.SoSeparator()
    for child in children:
        node.addChild(child)
    return node


def colours(scale, parts):
    """Colours (..., 3) of a scale at values from 0 to 1."""
    stops = np.linspace(0, 1, len(scale))
    return np.stack([np.interp(parts, stops, channel) for channel in scale.T], axis=-1)


def surface(points, normals, colour):
    """A grid of points (m, k, 3) with a colour, or one (m, k, 3) for each of its points."""
    rows, columns = points.shape[:2]
    mesh = coin.SoQuadMesh()
    mesh.verticesPerColumn = rows
    mesh.verticesPerRow = columns
    binding = coin.SoMaterialBinding()
    colour = np.asarray(colour, dtype=float)
    binding.value = "OVERALL" if colour.ndim == 1 else "PER_VERTEX"
    return group(*_facing(), _coordinates(points), _normals(normals), _material(colour), binding, mesh)


def triangles(points, corners, colour):
    """Flat triangles with these corners (t, 3), numbers of points (n, 3)."""
    faces = coin.SoIndexedFaceSet()
    indices = np.insert(corners, 3, -1, axis=1).ravel()
    faces.coordIndex.setValues(0, len(indices), indices.tolist())
    return group(*_facing(), _coordinates(points), _material(colour), faces)


def zebra():
    """The stripes that a surface behind it reflects."""
    light = np.tile(np.repeat([0, 255], _PIXELS_OF_STRIPE), _STRIPES // 2).astype(np.uint8)
    picture = coin.SoSFImage()
    picture.setValue(coin.SbVec2s(1, len(light)), 1, light.tobytes())
    texture = coin.SoTexture2()
    texture.image = picture
    node = coin.SoGroup()
    node.addChild(coin.SoTextureCoordinateEnvironment())
    node.addChild(texture)
    return node


def lines(polylines, colour, width=1.0):
    """Lines, each an array of points (n, 3), all of one colour and width in pixels."""
    style = coin.SoDrawStyle()
    style.lineWidth = width
    line_set = coin.SoLineSet()
    line_set.numVertices.setValues(0, len(polylines), [len(line) for line in polylines])
    return group(_unlit(), _material(colour), style, _coordinates(np.concatenate(polylines)), line_set)


def markers(points, colour):
    """Small squares at points (n, 3)."""
    squares = coin.SoMarkerSet()
    squares.markerIndex = coin.SoMarkerSet.SQUARE_FILLED_5_5
    return group(_unlit(), _material(colour), _coordinates(points), squares)


def label(point, text):
    """A marker and a framed text at a point, in front of everything."""
    marker = coin.SoMarkerSet()
    marker.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
    place = coin.SoTranslation()
    place.translation = tuple(map(float, point))
    framed = coin.SoType.fromName("SoFrameLabel").createInstance()
    framed.set(f'string "{text}" textColor {_triple(_INK)} backgroundColor {_triple(_PAPER)}')
    return _in_front(_unlit(), _material(_INK), place, _coordinates(np.zeros((1, 3))), marker, framed)


def legend(scale, titles, marks, number):
    """A bar of colours at the left of the window under its titles, with texts at parts of it.

    `marks` are pairs (part from 0 to 1, text). `number` counts the legends of a view, which stand
    side by side.
    """
    left, right, bottom, top = _LEGEND
    shift = number * _NEXT_LEGEND
    left, right = left + shift, right + shift
    heights = np.linspace(bottom, top, 64)
    grid = np.array([[(x, y, 0) for y in heights] for x in (left, right)])
    shades = np.broadcast_to(colours(scale, np.linspace(0, 1, 64)), grid.shape)
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.height = 2
    camera.position = (0, 0, 1)
    camera.nearDistance, camera.farDistance = 0.1, 2
    numbered = enumerate(reversed(titles), start=1)
    texts = [(left, top + row * _LINE_OF_TEXT, title) for row, title in numbered]
    texts += [(right + 0.015, bottom + part * (top - bottom) - 0.012, text) for part, text in marks]
    sheet = _sheet(
        left - 0.02, left + _NEXT_LEGEND - 0.04, bottom - 0.05, top + (len(titles) + 1) * _LINE_OF_TEXT
    )
    bar = surface(grid, np.zeros(grid.shape) + (0, 0, 1), shades)
    rows = [_text_at(*entry) for entry in texts]
    return _in_front(camera, _unlit(), sheet, bar, _material(_INK), _font(), *rows)


def not_pickable():
    """Lets the mouse through what follows in its group."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def own_colours():
    """Lets what follows in its group keep its colours while its object is selected."""
    node = coin.SoCallback()
    node.setCallback(_end_colour_overrides)
    return node


def behind():
    """Draws the faces that follow in its group behind others in the same place, however coarse."""
    offset = coin.SoPolygonOffset()
    offset.factor = 2
    offset.units = _UNITS_BEHIND
    offset.setOverride(True)
    return offset


def _end_colour_overrides(_, action):
    # FreeCAD draws a selected object in one colour by overriding what materials say.
    if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        override, state = coin.SoOverrideElement, action.getState()
        override.setEmissiveColorOverride(state, None, False)
        override.setDiffuseColorOverride(state, None, False)
        override.setMaterialBindingOverride(state, None, False)


def _in_front(*children):
    """Draws nodes in front of everything; their size is that of the window, not of the scene."""
    node = coin.SoAnnotation()
    for child in children:
        node.addChild(child)
    # The view may make no room for it.
    outside = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    outside.set("mode EXCLUDE_BBOX")
    outside.addChild(node)
    return outside


def _facing():
    """Lights both sides of surfaces, and moves them back a little so that lines are seen."""
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    return hints, coin.SoPolygonOffset()


def _unlit():
    model = coin.SoLightModel()
    model.model = coin.SoLightModel.BASE_COLOR
    return model


def _coordinates(points):
    node = coin.SoCoordinate3()
    node.point.setValues(0, points.size // 3, points.reshape(-1, 3))
    return node


def _normals(normals):
    node = coin.SoNormal()
    node.vector.setValues(0, normals.size // 3, normals.reshape(-1, 3))
    return node


def _material(colour):
    node = coin.SoMaterial()
    values = np.asarray(colour, dtype=float).reshape(-1, 3)
    node.diffuseColor.setValues(0, len(values), values)
    return node


def _font():
    node = coin.SoFont()
    # The font of the window also has ∞ and ².
    node.name = QtGui.QFont().defaultFamily()
    node.size = _TEXT_SIZE
    return node


def _text(string):
    node = coin.SoText2()
    node.string = string
    return node


def _sheet(left, right, bottom, top):
    """What a legend is written on, readable whatever is behind it."""
    corners = np.array([[(x, y, -0.1) for y in (bottom, top)] for x in (left, right)])
    return surface(corners, np.zeros(corners.shape) + (0, 0, 1), _PAPER)


def _triple(colour):
    return " ".join(map(str, colour))


def _text_at(x, y, string):
    place = coin.SoTranslation()
    place.translation = (float(x), float(y), 0.0)
    return group(place, _text(string))
