# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same input gives the same bits: in many threads, in every run, whatever was asked before."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from bits import digest
from canal import random_canal
from soundness import SHAPES

SEED = 1
ONE_PROCESSOR = 1


def in_own_process(seed, processors):
    """The digests of all kinds, computed by another process on so many processors."""
    chosen = sorted(os.sched_getaffinity(0))[:processors]
    run = subprocess.run(
        [sys.executable, Path(__file__).parent / "bits.py", str(seed)],
        capture_output=True,
        check=True,
        text=True,
        preexec_fn=lambda: os.sched_setaffinity(0, chosen),
    )
    return dict(line.rsplit(" ", 1) for line in run.stdout.splitlines())


def test_threads_and_processes_give_the_same_bits():
    """All kinds at once, each in two threads; in another process, which has one processor only."""
    alone = in_own_process(SEED, ONE_PROCESSOR)
    assert len(set(alone.values())) == len(SHAPES)
    kinds = [*SHAPES, *reversed(SHAPES)]
    with ThreadPoolExecutor(len(kinds)) as pool:
        together = list(pool.map(lambda kind: digest(kind, SEED), kinds))
    for kind, found in zip(kinds, together, strict=True):
        assert found == alone[f"{kind} {SEED}"], kind


def cancelling_distance(surface):
    """That at which a coordinate of a pole is all but zero, so that it takes more bits to round it."""
    (face,), (moved,) = surface.bsplines(), surface.offset(1).bsplines()
    start, change = face.poles[1, 1, 0], moved.poles[1, 1, 0] - face.poles[1, 1, 0]
    return -start / change


def rounded(surface):
    (face,) = surface.bsplines()
    certificate = surface.certificate
    return (
        face.poles.tobytes(),
        face.weights.tobytes(),
        certificate.deviation,
        certificate.precision_bits,
    )


@pytest.mark.parametrize("seed", [0, 2, 7])
def test_a_distance_that_needs_more_bits_changes_no_other(seed):
    canal = random_canal(seed, 6)
    difficult = cancelling_distance(canal.surface())
    shared = canal.surface()
    assert shared.offset(difficult).certificate.precision_bits > shared.certificate.precision_bits
    for distance in (0.0, 0.25, difficult, -0.5):
        found, alone = (rounded(s.offset(distance)) for s in (shared, canal.surface()))
        assert found == alone
