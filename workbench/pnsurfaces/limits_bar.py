# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar of distances: those without a singular point, red beyond, and where the surface is now."""

import math
from typing import NamedTuple

import FreeCAD

from pnsurfaces.compat import QtCore, QtGui, QtWidgets

translate = FreeCAD.Qt.translate

# What is shown beyond a limit, as part of the bar.
_BEYOND = 0.15

# Half-way along an endless bar without any limit, in millimetres.
_ENDLESS = 10.0

# A limit so many times as far as the other one is drawn like none: the bar would show nothing else.
_FARTHEST = 1e6

# Pixels: the bar, the space above it for the marks and the text under it.
_HEIGHT = 10
_MARK = 7

# Readable on light and on dark panels, and apart for those who see no difference of red and green.
_REGULAR = QtGui.QColor(87, 160, 211)
_SINGULAR = QtGui.QColor(224, 27, 36)


class Zone(NamedTuple):
    """A part of the bar, from 0 to 1."""

    start: float
    end: float
    is_regular: bool


class Mark(NamedTuple):
    """A distance on the bar, at a place from 0 to 1."""

    distance: float
    place: float
    is_regular: bool


class Scale:
    """Places from 0 to 1 for all distances, about the limits `low` and `high` in millimetres.

    Between two limits the scale is even. An infinite end lies at the end of the bar, whose half is
    as far from the limit as that is from zero. No distance is regular when low >= high.
    """

    def __init__(self, low, high):
        self.low = low
        self.high = high
        self._ends_below = _counts(low, high)
        self._ends_above = _counts(high, low)
        ends = [x for x, counts in ((low, self._ends_below), (high, self._ends_above)) if counts]
        self._half = next((abs(x) for x in ends if x), _ENDLESS)

    def place(self, distance):
        """Where a distance lies; one too far beyond a limit lies at the end of the bar."""
        if self.low >= self.high:
            return self._endless(distance)
        below, above = self._ends_below, self._ends_above
        if below and above:
            part = (distance - self.low) / (self.high - self.low)
            return _clipped(_BEYOND + (1 - 2 * _BEYOND) * part)
        if below:
            return _half_endless((distance - self.low) / self._half)
        if above:
            return 1 - _half_endless((self.high - distance) / self._half)
        return self._endless(distance)

    def mark(self, distance):
        return Mark(distance, self.place(distance), self.low < distance < self.high)

    def zones(self):
        """The parts of the bar in order."""
        if self.low >= self.high:
            return [Zone(0, 1, False)]
        start = _BEYOND if self._ends_below else 0
        end = 1 - _BEYOND if self._ends_above else 1
        zones = [Zone(0, start, False), Zone(start, end, True), Zone(end, 1, False)]
        return [zone for zone in zones if zone.start < zone.end]

    def _endless(self, distance):
        return (1 + distance / (abs(distance) + self._half)) / 2


def _counts(limit, other):
    """Whether a limit is there and not too far beside the other one."""
    return math.isfinite(limit) and not abs(limit) > _FARTHEST * abs(other) > 0


def _half_endless(steps):
    """The place of a distance that is so many steps from the one limit, upwards."""
    part = steps / (1 + steps) if steps > 0 else steps
    return _clipped(_BEYOND + (1 - _BEYOND) * part)


def _clipped(place):
    return min(max(place, 0.0), 1.0)


class LimitsBar(QtWidgets.QWidget):
    """Draws a Scale and the marks of the distances that are shown."""

    def __init__(self):
        super().__init__()
        self.scale = Scale(-math.inf, math.inf)
        self.marks = []
        height = _HEIGHT + _MARK + self.fontMetrics().height()
        self.setMinimumHeight(height)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)

    def show_distances(self, distances, low, high):
        self.scale = Scale(low, high)
        self.marks = [self.scale.mark(distance) for distance in distances]
        self.setToolTip(_description(self.scale))
        self.update()

    def sizeHint(self):
        return QtCore.QSize(self.minimumHeight() * 6, self.minimumHeight())

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        if not self.isEnabled():
            painter.setOpacity(0.4)
        for zone in self.scale.zones():
            self._draw_zone(painter, zone)
        self._draw_limits(painter)
        for mark in self.marks:
            self._draw_mark(painter, mark)
        painter.end()

    def _draw_zone(self, painter, zone):
        left, right = self._x(zone.start), self._x(zone.end)
        rectangle = QtCore.QRectF(left, _MARK, right - left, _HEIGHT)
        colour = _REGULAR if zone.is_regular else _SINGULAR
        shade = QtGui.QLinearGradient(left, 0, right, 0)
        shade.setColorAt(0, self._end_colour(colour, zone.start, 0))
        shade.setColorAt(0.3, colour)
        shade.setColorAt(0.7, colour)
        shade.setColorAt(1, self._end_colour(colour, zone.end, 1))
        painter.fillRect(rectangle, QtGui.QBrush(shade))

    def _end_colour(self, colour, place, end):
        """A bar fades where it has no end."""
        faded = QtGui.QColor(colour)
        if place == end:
            faded.setAlpha(40)
        return faded

    def _draw_limits(self, painter):
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        baseline = _MARK + _HEIGHT + painter.fontMetrics().ascent()
        texts = [(0.0, "−∞"), (1.0, "∞")] if self.scale.low < self.scale.high else []
        for (end, infinite), limit in zip(texts, (self.scale.low, self.scale.high)):
            text = f"{limit:.4g}" if math.isfinite(limit) else infinite
            place = self.scale.place(limit) if math.isfinite(limit) else end
            width = painter.fontMetrics().boundingRect(text).width()
            left = min(max(self._x(place) - width / 2, 0), self.width() - width)
            painter.drawText(QtCore.QPointF(left, baseline), text)

    def _draw_mark(self, painter, mark):
        x = self._x(mark.place)
        ink = self.palette().color(QtGui.QPalette.WindowText) if mark.is_regular else _SINGULAR
        painter.setPen(QtGui.QPen(ink, 2))
        painter.setBrush(ink)
        painter.drawLine(QtCore.QPointF(x, _MARK), QtCore.QPointF(x, _MARK + _HEIGHT))
        corners = [(x - _MARK / 2, 0), (x + _MARK / 2, 0), (x, _MARK)]
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(*corner) for corner in corners]))

    def _x(self, place):
        return _MARK / 2 + place * (self.width() - _MARK)


def _description(scale):
    if scale.low >= scale.high:
        return translate("PNSurfaces", "No distance is proved to be free of singular points.")
    return translate("PNSurfaces", "Distances without singular points; beyond the surface folds.")
