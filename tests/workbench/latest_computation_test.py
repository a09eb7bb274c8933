# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in another thread of which only the latest counts."""

import threading
import time
import unittest

import numpy as np

from pnsurfaces import kernel
from pnsurfaces.latest_computation import LatestComputation

# Seconds after which a test has hung.
_PATIENCE = 30


class LatestComputationTest(unittest.TestCase):
    def setUp(self):
        self.computation = LatestComputation()
        self.addCleanup(self.computation.close)

    def test_values_arrive_in_order(self):
        self.computation.start(lambda: iter(range(100)))
        self.assertEqual(self._all(), list(range(100)))

    def test_work_is_done_in_another_thread(self):
        self.computation.start(lambda: iter([threading.get_ident()]))
        (thread,) = self._all()
        self.assertNotEqual(thread, threading.get_ident())

    def test_an_error_arrives_last(self):
        self.computation.start(_failing)
        first, error = self._all()
        self.assertEqual(first, 1)
        self.assertIsInstance(error, ValueError)
        self.assertEqual(str(error), "Too wide.")

    def test_nothing_is_heard_of_earlier_work(self):
        gate = threading.Event()
        self.computation.start(lambda: _waiting(gate, "earlier"))
        self.computation.start(lambda: iter(["later"]))
        gate.set()
        self.assertEqual(self._all(), ["later"])

    def test_stopped_work_yields_no_more(self):
        gate, past = threading.Event(), threading.Event()

        def work():
            yield from _waiting(gate, "first")
            past.set()
            yield "second"

        self.computation.start(work)
        self.computation.stop()
        self.assertFalse(self.computation.is_running())
        self.assertEqual(self.computation.take(), [])
        gate.set()
        self.assertFalse(past.wait(0.2))

    def test_the_kernel_stops_within_its_work(self):
        # More than a minute of work, unless it is stopped.
        pn = kernel.pnkernel()
        count = 100_000
        turns = np.arange(count + 3) / 20
        poles = np.column_stack([40 * np.cos(turns), 40 * np.sin(turns), 10 * turns])
        multiplicities = [4] + [1] * (count - 1) + [4]
        spine = pn.Curve.bspline(3, np.arange(count + 1.0), multiplicities, poles)
        begun, ended = threading.Event(), threading.Event()

        def work():
            begun.set()
            try:
                yield pn.canal_surface(spine, pn.Law.constant(1)).bsplines()
            finally:
                ended.set()

        self.computation.start(work)
        self.assertTrue(begun.wait(_PATIENCE))
        time.sleep(0.1)
        self.computation.stop()
        self.assertTrue(ended.wait(_PATIENCE))
        self.assertEqual(self.computation.take(), [])

    def _all(self):
        arrived = []
        deadline = time.monotonic() + _PATIENCE
        while self.computation.is_running():
            self.assertLess(time.monotonic(), deadline)
            arrived += self.computation.take()
        return arrived


def _failing():
    yield 1
    raise ValueError("Too wide.")


def _waiting(gate, value):
    gate.wait(_PATIENCE)
    yield value
