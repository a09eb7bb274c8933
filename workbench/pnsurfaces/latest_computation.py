# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in another thread of which only the latest counts."""

import queue
from concurrent.futures import ThreadPoolExecutor

from pnsurfaces import kernel

# One for the latest work, and one for work that was stopped and may not have noticed yet.
_THREADS = 2


class LatestComputation:
    """Runs one piece of work at a time; a new one stops the one before, of which nothing is heard.

    Work is a function that returns an iterator: what that yields arrives one by one, and an
    exception as the last. It is fetched by `take`, by whoever asks from time to time: so nothing of
    another thread ever calls into FreeCAD or Qt.
    """

    def __init__(self):
        self._pool = ThreadPoolExecutor(_THREADS)
        self._stop = None
        self._arrived = queue.SimpleQueue()
        self._future = None

    def start(self, work):
        """Raises KernelMissing without the kernel, which does the stopping."""
        self.stop()
        cancellation = kernel.pnkernel().Cancellation()
        self._stop = cancellation.request
        self._future = self._pool.submit(_run, work, cancellation, self._arrived)

    def stop(self):
        """Drops the work that is under way, and what has arrived of it."""
        if self._stop:
            self._stop()
        self._arrived = queue.SimpleQueue()
        self._stop = self._future = None

    def is_running(self):
        """Whether anything may still arrive."""
        return self._future is not None and not (self._future.done() and self._arrived.empty())

    def take(self):
        """What has arrived since the last time, in order."""
        arrived = []
        while not self._arrived.empty():
            arrived.append(self._arrived.get())
        return arrived

    def close(self):
        """Stops without waiting. Nothing can be started any more."""
        self.stop()
        self._pool.shutdown(wait=False)


def _run(work, cancellation, arrived):
    try:
        cancellation.run(lambda: _collect(work(), cancellation, arrived))
    except kernel.pnkernel().Cancelled:
        pass  # Nobody waits for it any more.
    except Exception as error:
        arrived.put(error)


def _collect(values, cancellation, arrived):
    for value in values:
        if cancellation.is_requested:
            return
        arrived.put(value)
