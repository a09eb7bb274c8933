# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features whose computation is stopped at random moments: the old shape, or the new one, whole.

PN_TEST_SEED chooses the moments.
"""

import os
import random
import threading
import time

import Part
from FreeCAD import Vector
from support import DocumentTest, shape_data

from pnsurfaces import kernel, make_canal_surface, make_quadric_offset, make_ruled_offset
from pnsurfaces.latest_computation import LatestComputation

SEED = int(os.environ.get("PN_TEST_SEED", "1"))
TIMES = 3


class CancelledFeatures(DocumentTest):
    def test_canal_surface(self):
        self.check(make_canal_surface(self.spline_object(), 1.5), "Radius", 1.25)

    def test_ruled_offset(self):
        rail = self.shape_object(Part.makeLine(Vector(6, 0, 0), Vector(6, 3, 10)), "Rail")
        self.check(make_ruled_offset(self.line_object(), rail, 1), "Distance", 0.5)

    def test_quadric_offset(self):
        self.check(make_quadric_offset("Ellipsoid", 30, 20, 10), "HalfAxisA", 25)

    def check(self, obj, name, value):
        """A new value of the property `name` is computed in part only, in either way there is."""
        choose = random.Random(SEED)
        old_value, old = getattr(obj, name), shape_data(obj.Shape)
        start = time.perf_counter()
        new = self._recomputed(obj, name, value)
        seconds = time.perf_counter() - start
        self.assertNotEqual(new, old)
        objects = self.document.Objects
        for number in range(TIMES):
            for compute in (self._preview, self._recompute):
                with self.subTest(f"PN_TEST_SEED={SEED}, number {number}", way=compute.__name__):
                    self.assertEqual(self._recomputed(obj, name, old_value), old)
                    setattr(obj, name, value)
                    has_new = compute(obj, choose.uniform(0, seconds))
                    self.assertEqual(shape_data(obj.Shape), new if has_new else old)
                    self.document.recompute()
                    self.assert_valid(obj)
                    self.assertEqual(obj.Status, "Valid")
                    self.assertEqual(shape_data(obj.Shape), new)
                    self.assertEqual(self.document.Objects, objects)

    def _recomputed(self, obj, name, value):
        setattr(obj, name, value)
        self.document.recompute()
        return shape_data(obj.Shape)

    def _preview(self, obj, seconds):
        """As the panel computes, for so many seconds. Whether it came to an end."""
        inputs = obj.Proxy.inputs_of(obj)
        computation = LatestComputation()
        computation.start(lambda: iter([obj.Proxy.outcome(inputs, obj.Proxy.base(inputs))]))
        time.sleep(seconds)
        arrived = computation.take()
        computation.close()
        for outcome in arrived:
            self.assertNotIsInstance(outcome, Exception)
            obj.Proxy.finish(obj, lambda found=outcome: found)
        return bool(arrived)

    def _recompute(self, obj, seconds):
        """The document's recompute, stopped after so many seconds. Whether it came to an end."""
        cancellation = kernel.pnkernel().Cancellation()
        timer = threading.Timer(seconds, cancellation.request)
        timer.start()
        try:
            cancellation.run(self.document.recompute)
        except kernel.pnkernel().Cancelled:
            pass  # The last step of all may have been over by then.
        timer.cancel()
        if not obj.isValid():
            self.assert_error(obj, "The computation was cancelled.")
        return obj.isValid()
