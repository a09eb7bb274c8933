# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's progress bar for work that tells which part of it is done."""

import contextlib

import FreeCAD

# Steps of the bar, which counts in whole ones.
_STEPS = 100


@contextlib.contextmanager
def progress_bar(text, given=None):
    """A function that shows a part of the work, from 0 to 1, as done; `given` if there is one.

    Esc in FreeCAD's window makes it raise FreeCAD.Base.FreeCADAbort. Without the window it is None.
    """
    if given or not FreeCAD.GuiUp:
        yield given
        return
    bar = FreeCAD.Base.ProgressIndicator()
    bar.start(text, _STEPS)
    try:
        yield _Bar(bar)
    finally:
        bar.stop()


class _Bar:
    def __init__(self, bar):
        self._bar = bar
        self._shown = 0

    def __call__(self, part):
        while self._shown < int(part * _STEPS):
            self._bar.next(True)
            self._shown += 1
