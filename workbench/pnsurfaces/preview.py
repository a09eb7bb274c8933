# SPDX-License-Identifier: LGPL-2.1-or-later
"""A feature that follows its inputs while they are edited, without holding up the window.

Reading the inputs and assigning the shape are done in FreeCAD's thread, which alone may touch
documents; what lies between is done in another one, and only the latest of it counts. While the
distance changes the surface is drawn from points that are known already.
"""

import contextlib
import functools
from typing import Any, NamedTuple

import FreeCAD

from pnsurfaces.compat import QtCore, connect
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.latest_computation import LatestComputation
from pnsurfaces.section_mesh import section_mesh
from pnsurfaces.surface_sketch import SurfaceSketch

# The pause in typing after which the surface follows, in milliseconds: more than between two events
# of one movement, less than what is felt as waiting.
DELAY = 40

# The same where the surface is drawn already: FreeCAD holds up its window for a tenth of a second
# and more to draw a shape, so this waits until the hand rests.
REST = 250

# How often it is looked for results, in milliseconds: less than a frame of the screen.
_POLLING = 8

# A computation of more milliseconds shows that it runs, and how to stop it.
LONG = 500

# FreeCAD's names of the Report view and the status bar among the observers of its console.
_LOGS = ("ReportOutput", "StatusBar")


class Made(NamedTuple):
    """A surface at distance 0 (feature.Base) and the FeatureInputs that it was made from.

    With its SectionMesh, and the pnkernel.FocalPoints where its offsets become singular first.
    """

    inputs: Any
    base: Any
    mesh: Any
    focal_points: list


class Outcome(NamedTuple):
    """What FeatureBase.outcome has computed."""

    shape: Any
    results: dict


class Preview:
    """Recomputes one feature, and no other, whenever `request` says that its inputs changed.

    It calls changed() when there is something new to show, made(Made) when there is another surface,
    and settled() when the shape is that of the inputs, or there is none.
    """

    def __init__(self, feature, changed, made, settled):
        self._feature = feature
        self._changed = changed
        self._has_made = made
        self._settled = settled
        self._is_preparing = False
        self._computation = LatestComputation()
        self._sketch = SurfaceSketch(feature.ViewObject)
        self._made = None
        self._is_stopped = False
        self._pause = _timer(DELAY, True, self.start)
        self._polling = _timer(_POLLING, False, self._fetch)
        self._patience = _timer(LONG, True, self._tell)

    def prepare(self):
        """Finds out what can be drawn, and changes nothing."""
        try:
            self._computation.start(functools.partial(_make, self._feature.Proxy, self._inputs()))
        except KernelMissing:
            return  # The first change of an input says so.
        self._is_preparing = True
        self._polling.start()

    def request(self):
        """The surface follows after a pause; what was being computed is out of date."""
        self._rest()
        made = self._made_from(self._inputs())
        self._draw(made)
        self._pause.start(REST if made else DELAY)

    def start(self):
        """The surface follows now."""
        self._pause.stop()
        self._is_stopped = False
        inputs = self._inputs()
        stages = functools.partial(_stages, self._feature.Proxy, inputs, self._made_from(inputs))
        try:
            self._computation.start(stages)
        except KernelMissing as error:
            self._finish(functools.partial(_raise, error))
            self._settled()
            return
        self._polling.start()
        if not self._patience.isActive():
            self._patience.start()

    def is_pending(self):
        """Whether the shape is not yet, or will not be, that of the inputs."""
        is_computing = self._computation.is_running() and not self._is_preparing
        return self._pause.isActive() or is_computing or self._is_stopped

    def is_long(self):
        """Whether something is computed, and has been for so long that it should be said."""
        is_computing = self._computation.is_running() and not self._is_preparing
        return is_computing and not self._patience.isActive()

    def is_stopped(self):
        """Whether the user has stopped the last computation."""
        return self._is_stopped

    def stop(self):
        """Leaves the shape as it is until the next request."""
        self._is_stopped = True
        self._rest()
        self._sketch.hide()
        self._changed()

    def close(self):
        """Ends it for good, without waiting."""
        self._rest()
        self._computation.close()
        self._sketch.hide()
        # In a circle of references the widgets would outlive their other half in C++, to be
        # mistaken for later widgets at the same address.
        self._changed = self._has_made = self._settled = _nothing

    def _tell(self):
        # The timer would keep what it calls, and so the widgets of the panel.
        self._changed()

    def _inputs(self):
        return self._feature.Proxy.inputs_of(self._feature)

    def _made_from(self, inputs):
        """What was made last if it was made from these inputs, else None."""
        made = self._made
        same = made and self._feature.Proxy.has_same_base(inputs, made.inputs)
        return made if same else None

    def _draw(self, made):
        """Draws the surface at the present distance, if it is known."""
        if made:
            self._sketch.show(made.mesh, self._feature.Proxy.distances(self._feature))

    def _rest(self):
        for timer in (self._pause, self._polling, self._patience):
            timer.stop()
        self._computation.stop()
        self._is_preparing = False

    def _fetch(self):
        is_running = self._computation.is_running()
        for arrived in self._computation.take():
            self._take(arrived)
        if is_running:
            return
        has_settled = not self._is_preparing
        self._rest()
        if has_settled:
            self._changed()
            self._settled()

    def _take(self, arrived):
        if isinstance(arrived, Made):
            self._made = arrived
            self._has_made(arrived)
            if not self._is_preparing:
                self._draw(arrived)
        elif isinstance(arrived, Outcome):
            self._finish(lambda: arrived)
        elif not self._is_preparing:
            self._finish(functools.partial(_raise, arrived))

    def _finish(self, arrived):
        with _silent_logs():
            self._feature.Proxy.finish(self._feature, arrived)
        self._sketch.hide()
        self._changed()


def _stages(proxy, inputs, made):
    """What arrives of a computation, in order."""
    if made is None:
        for made in _make(proxy, inputs):
            yield made
    yield Outcome(*proxy.outcome(inputs, made.base))


def _make(proxy, inputs):
    base = proxy.sound_base(inputs)
    focal_points = [focal for focal in base.surface.focal_points if focal]
    yield Made(inputs, base, section_mesh(base.surface), focal_points)


def _raise(error):
    raise error


def _nothing(*_):
    pass


def _timer(interval, is_single, slot):
    timer = QtCore.QTimer(singleShot=is_single, interval=interval)
    connect(timer, "timeout()", slot)
    return timer


@contextlib.contextmanager
def _silent_logs():
    """Keeps the logs from showing a traceback at an unfinished number: the panel says all."""
    console = FreeCAD.Console
    spoken = [(log, kind) for log in _LOGS for kind in ("Err", "Wrn") if console.GetStatus(log, kind)]
    for log, kind in spoken:
        console.SetStatus(log, kind, False)
    try:
        yield
    finally:
        for log, kind in spoken:
            console.SetStatus(log, kind, True)
