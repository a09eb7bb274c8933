# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a task panel has for the distance of a surface: numbers, bar, arrow and marks; or nothing."""

import math

import FreeCAD
import FreeCADGui

from pnsurfaces.compat import connect
from pnsurfaces.distance_handle import DistanceHandle
from pnsurfaces.feature import TWO_OFFSETS
from pnsurfaces.limits_bar import LimitsBar
from pnsurfaces.singular_marks import SingularMarks

translate = FreeCAD.Qt.translate

# Under the distance.
_ROW_OF_LIMITS = 1


class OffsetRows:
    """The rows of the forms `offset` and `result` of a panel for a feature that has offsets."""

    def __init__(self, feature, offset, result, dragged):
        self._feature = feature
        self._offset = offset
        self._result = result
        self.bar = LimitsBar()
        offset.layout().insertRow(_ROW_OF_LIMITS, self.bar)
        self._handle = DistanceHandle(feature.ViewObject, dragged)
        self._marks = SingularMarks(feature.ViewObject)

    def connect(self, changed):
        """Calls changed() when other rows are to be shown."""
        connect(self._offset.Sides, "currentTextChanged(QString)", changed)

    def show_rows(self):
        """Shows the second distance of two offsets."""
        has_second = self._feature.Sides == TWO_OFFSETS
        for widget in (self._offset.second_distance_label, self._offset.SecondDistance):
            widget.setVisible(has_second)

    def show_range(self):
        """Shows the regular distances, if the surface has offsets."""
        self._result.regular_range.setText(_range(*self._limits()))
        has_offsets = self._has_offsets()
        for widget in (self._result.regular_range_label, self._result.regular_range, self.bar):
            widget.setVisible(has_offsets)

    def show_distance(self):
        """Shows where the distance is, and the arrow that drags it unless an expression gives it."""
        self.bar.show_distances(self._feature.Proxy.distances(self._feature), *self._limits())
        self._handle.follow(self._feature.Distance.Value)
        if "Distance" in dict(self._feature.ExpressionEngine) or not self._has_offsets():
            self._handle.hide()
        else:
            self._handle.show()

    def place(self, made):
        """Shows the arrow and the marks of a surface that was made (preview.Made)."""
        self._marks.show(made.focal_points)
        self._handle.place(made.mesh, _up(self._feature))

    def close(self):
        self._handle.close()
        self._marks.hide()

    def _has_offsets(self):
        return self._feature.Proxy.has_offsets(self._feature)

    def _limits(self):
        return self._feature.MinOffset.Value, self._feature.MaxOffset.Value


class NoOffsetRows:
    """The same for a feature without offsets: a sentence says so, where the rows would be."""

    bar = None

    def __init__(self, offset, result):
        offset.setWindowTitle(translate("PNSurfaces", "Output"))
        for widget in (
            offset.distance_label,
            offset.Distance,
            offset.sides_label,
            offset.Sides,
            offset.second_distance_label,
            offset.SecondDistance,
            result.regular_range_label,
            result.regular_range,
        ):
            widget.hide()
        offset.no_offsets.show()

    def connect(self, changed):
        pass

    def show_rows(self):
        pass

    def show_range(self):
        pass

    def show_distance(self):
        pass

    def place(self, made):
        pass

    def close(self):
        pass


def _up(feature):
    """The direction upwards on the screen, in the coordinates of a feature."""
    view = FreeCADGui.getDocument(feature.Document.Name).mdiViewsOfType("Gui::View3DInventor")
    camera = view[0].getCameraOrientation() if view else FreeCAD.Rotation()
    placement = feature.getGlobalPlacement()
    return placement.Rotation.inverted().multVec(camera.multVec(FreeCAD.Vector(0, 1, 0)))


def _range(low, high):
    """The distances between two limits in millimetres, which may be infinite."""
    if low >= high:
        return translate("PNSurfaces", "empty")
    limits = [_limit(limit) for limit in (low, high)]
    return translate("PNSurfaces", "{} to {} mm").format(*limits)


def _limit(limit):
    if math.isfinite(limit):
        return f"{limit:.6g}"
    return "∞" if limit > 0 else "−∞"
