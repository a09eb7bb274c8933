# SPDX-License-Identifier: LGPL-2.1-or-later
"""Without memory: MemoryError where the kernel asks for it, and an end of the process where GMP does.

Each trial is a process of its own, which may have so many megabytes more than it has already.
"""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

TRIAL = """
import resource, sys
import numpy as np
import pnkernel as pn
from test_cancellation import long_spine

def surface(spans):
    return pn.canal_surface(long_spine(spans), pn.Law.constant(0.5))

def faces(spans):
    return [(face.poles.tobytes(), face.weights.tobytes()) for face in surface(spans).bsplines()]

small = surface(3)
places = np.zeros(5 * 10**6)
before = faces(3)  # the threads are there from now on
pages = int(open("/proc/self/statm").read().split()[0])
limit = pages * resource.getpagesize() + int(sys.argv[1]) * 2**20
unlimited = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (limit, unlimited[1]))
try:
    eval(sys.argv[2])
    print("computed")
except (MemoryError, RuntimeError) as error:
    print(type(error).__name__)
resource.setrlimit(resource.RLIMIT_AS, unlimited)
print("the same" if faces(3) == before else "another")
"""

# How GMP and the C library end a process for which they have no memory. They say why, unless there is
# no memory for that either.
ENDED = (-signal.SIGABRT, 127)


def trial(megabytes, work):
    return subprocess.run(
        [sys.executable, "-c", TRIAL, str(megabytes), work],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parent,
    )


@pytest.mark.parametrize("megabytes", [1, 20, 40])
def test_memory_that_runs_out_is_told(megabytes):
    """Or the process ends; nothing wrong is returned. RuntimeError: no thread could be started."""
    run = trial(megabytes, "faces(1000)")
    if run.returncode in ENDED:
        return
    assert run.returncode == 0, run.stderr
    outcome, after = run.stdout.splitlines()
    assert outcome in ("MemoryError", "RuntimeError", "computed")
    assert after == "the same"


def test_a_result_that_is_too_large_is_a_memory_error():
    run = trial(16, "small.evaluate(places, places)")
    assert run.returncode == 0, run.stderr
    assert run.stdout.splitlines() == ["MemoryError", "the same"]
