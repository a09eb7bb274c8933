# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computations that are asked to stop, from another thread."""

import threading
import time

import numpy as np
import pnkernel as pn
import pnocct
import pytest


def long_spine(spans=2000):
    """A wavy cubic spine: seconds of work."""
    places = np.arange(spans + 3)
    poles = np.stack([4.0 * places, np.sin(places), np.cos(0.7 * places)], axis=1)
    knots = np.arange(spans + 1.0)
    return pn.Curve.bspline(3, knots, [4, *[1] * (spans - 1), 4], poles)


def test_the_result_comes_back():
    cancellation = pn.Cancellation()
    surface = cancellation.run(
        lambda: pn.canal_surface(long_spine(3), pn.Law.constant(0.5)).offset(0.125)
    )
    assert surface.distance == 0.125
    assert not cancellation.is_requested


def test_errors_pass_through():
    with pytest.raises(pn.GeometryError):
        pn.Cancellation().run(lambda: pn.quadric("ellipsoid", 0, 1, 1))
    with pytest.raises(ZeroDivisionError):
        pn.Cancellation().run(lambda: 1 / 0)


def test_the_work_of_opencascade_stops():
    """Another module than the one of the request throws, and this one has to know what."""
    cancellation = pn.Cancellation()
    faces = pn.canal_surface(long_spine(3), pn.Law.constant(0.5)).bsplines()

    def work():
        cancellation.request()
        pnocct.shell(faces)

    with pytest.raises(pn.Cancelled, match="The computation was cancelled."):
        cancellation.run(work)


def test_a_long_computation_stops():
    cancellation = pn.Cancellation()
    surface = pn.canal_surface(long_spine(), pn.Law.constant(0.5))
    started = threading.Event()
    stopped = []

    def work():
        started.set()
        with pytest.raises(pn.Cancelled):
            cancellation.run(surface.bsplines)
        stopped.append(True)

    thread = threading.Thread(target=work)
    thread.start()
    started.wait()
    time.sleep(0.05)
    cancellation.request()
    thread.join(timeout=60)
    assert stopped == [True]
    # The surface is none the worse for it.
    assert len(surface.bsplines()) == 1
