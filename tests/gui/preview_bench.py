# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speed and calm of the preview, from a property to what is drawn. See scripts/bench_preview."""

import resource
import time

import main_window
import Part
from FreeCAD import Vector
from support import GuiTest, wait_for_preview

from pnsurfaces.compat import QtCore, QtWidgets, connect

# Previews of each measurement.
_FRAMES = 300
_PREVIEWS = 10_000
_PREVIEWS_WITH_SHAPES = 200

# Edges of the long spine.
_EDGES = 1000


class Pauses:
    """The longest time for which the window has handled no timer, in milliseconds."""

    def __init__(self):
        self._last = time.perf_counter()
        self._longest = 0.0
        self._timer = QtCore.QTimer(interval=1)
        connect(self._timer, "timeout()", self._beat)
        self._timer.start()

    def longest(self):
        self._beat()
        self._timer.stop()
        return self._longest * 1e3

    def _beat(self):
        now = time.perf_counter()
        self._longest = max(self._longest, now - self._last)
        self._last = now


class PreviewBench(GuiTest):
    def test_dragging_a_pipe_of_four_spans(self):
        self._drag("pipe of 4 spans", self.open_panel(self.spline, "Edge1"))

    def test_dragging_a_pipe_of_one_span(self):
        curve = Part.BezierCurve()
        curve.setPoles([Vector(0, 0, 0), Vector(60, 20, 0), Vector(80, 60, 20), Vector(80, 80, 0)])
        self._drag("pipe of 1 span", self.open_panel(self._curve_object(curve, "Arc"), "Edge1"))

    def test_dragging_an_ellipsoid(self):
        self._drag("ellipsoid", self.run_creation("PNSurfaces_QuadricOffset"))

    def test_long_spine(self):
        points = [Vector(10 * i, i % 2 * 5, i % 3 * 3) for i in range(_EDGES + 1)]
        source = self.shape_object(Part.makePolygon(points), "Long")
        feature, panel = self.open_panel(source)
        wait_for_preview()
        pauses = Pauses()
        start = time.perf_counter()
        panel.assign("Radius", 0.4)
        main_window.settle_until(lambda: main_window.drawn_points(feature), 0)
        drawn = time.perf_counter()
        pause_of_drawing = pauses.longest()
        pauses = Pauses()
        wait_for_preview()
        _report(
            f"{_EDGES} edges: drawn after {drawn - start:.2f} s, shape after"
            f" {time.perf_counter() - start:.2f} s; longest pause of the window"
            f" {pause_of_drawing:.0f} ms while drawing, {pauses.longest():.0f} ms with the shape"
        )

    def test_memory(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        wait_for_preview()
        for i in range(_PREVIEWS + 1):
            panel.assign("Distance", i % 50 / 50)
            if i % 50 == 0:
                QtWidgets.QApplication.processEvents()
            if i % (_PREVIEWS // 5) == 0:
                _report(f"memory after {i} previews: {_memory():.1f} MB")
        wait_for_preview()

    def test_memory_with_shapes(self):
        _, panel = self.open_panel(self.line, "Edge1")
        for i in range(_PREVIEWS_WITH_SHAPES + 1):
            panel.assign("Radius", 2 + i % 50 / 50)
            main_window.settle_until(lambda: not panel.is_busy(), 0)
            if i % (_PREVIEWS_WITH_SHAPES // 4) == 0:
                _report(f"memory after {i} previews with their shapes: {_memory():.1f} MB")

    def _drag(self, title, opened):
        feature, panel = opened
        wait_for_preview()
        panel.assign("Distance", 0.01)
        wait_for_preview()
        pauses = Pauses()
        start, computed, assigning = time.perf_counter(), time.thread_time(), 0.0
        for i in range(_FRAMES):
            before = time.thread_time()
            panel.assign("Distance", i / _FRAMES)
            assigning += time.thread_time() - before
            # Everything that is due, painting included.
            QtWidgets.QApplication.processEvents()
        seconds = time.perf_counter() - start
        computed = time.thread_time() - computed
        rate, pause = _FRAMES / seconds, pauses.longest()
        pauses = Pauses()
        wait_for_preview()
        _report(
            f"{title}: {rate:.0f} previews a second, {assigning / _FRAMES * 1e3:.2f} ms of a"
            f" processor without and {computed / _FRAMES * 1e3:.2f} ms with painting; longest"
            f" pause {pause:.0f} ms, {pauses.longest():.0f} ms when the shape follows"
        )


def _report(text):
    # The test runner has begun a line.
    print(f"\n  {text}", flush=True)


def _memory():
    """Resident memory of this process in megabytes."""
    pages = int(open("/proc/self/statm").read().split()[1])
    return pages * resource.getpagesize() / 1e6
