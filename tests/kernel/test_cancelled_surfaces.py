# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces whose work is stopped at random moments: none the worse for it, bit for bit.

PN_TEST_SEED chooses the moments, PN_TEST_SCALE multiplies how many there are.
"""

import os
import threading
import time

import numpy as np
import pnkernel as pn
import pytest
from bits import faces_of, limits_of, or_error, shell_of
from soundness import SHAPES

SEED = int(os.environ.get("PN_TEST_SEED", "1"))
TIMES = max(1, int(8 * float(os.environ.get("PN_TEST_SCALE", "1"))))

# Seeds of surfaces that take long enough to be stopped and not longer.
SURFACES = {
    "canal": 1,
    "ruled": 3,
    "cones": 3,
    "quadrics": 2,
    "skins": 3,
    "translations": 3,
    "sections": 1,
    "squared_radii": 1,
    "wavefronts": 1,
}

# What is asked of a surface, each with its result as bits.
QUESTIONS = (
    lambda surface: faces_of(surface, "even"),
    lambda surface: or_error(faces_of, surface, "lowest_degree"),
    lambda surface: or_error(limits_of, surface),
    lambda surface: or_error(shell_of, surface),
)


def surface_of(kind):
    """A new surface of this kind, always the same one."""
    return SHAPES[kind](np.random.default_rng(SURFACES[kind])).surface


def duration(work):
    """How many seconds work() takes, and its result."""
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def stopped_after(seconds, work):
    """The result of work(), or None when the request after so many seconds has stopped it."""
    cancellation = pn.Cancellation()
    timer = threading.Timer(seconds, cancellation.request)
    timer.start()
    try:
        return cancellation.run(work)
    except pn.Cancelled:
        return None
    finally:
        timer.cancel()


@pytest.mark.parametrize("question", QUESTIONS, ids=("even", "lowest_degree", "limits", "shell"))
@pytest.mark.parametrize("kind", SURFACES)
def test_a_stopped_surface_is_as_good_as_a_new_one(kind, question):
    random = np.random.default_rng(SEED)
    new = surface_of(kind)
    seconds, expected = duration(lambda: question(new))
    for part in random.uniform(size=TIMES):
        surface = surface_of(kind)
        found = stopped_after(part * seconds, lambda asked=surface: question(asked))
        assert found in (None, expected), f"PN_TEST_SEED={SEED}"
        assert question(surface) == expected, f"PN_TEST_SEED={SEED}"


@pytest.mark.parametrize("kind", SURFACES)
def test_a_surface_is_made_whole_or_not_at_all(kind):
    """The function that makes it computes too."""
    random = np.random.default_rng(SEED)
    seconds, made = duration(lambda: surface_of(kind))
    expected = faces_of(made, "even")
    for part in random.uniform(size=TIMES):
        surface = stopped_after(part * seconds, lambda: surface_of(kind))
        assert surface is None or faces_of(surface, "even") == expected, f"PN_TEST_SEED={SEED}"
