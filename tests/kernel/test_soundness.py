# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every certificate against the truth: no point farther off than it says, and no idle bound.

PN_SOUNDNESS_SURFACES says how many surfaces are made, 2,000 unless it is set; scripts/soundness makes
a hundred thousand.
"""

import math
import os

import numpy as np
import pnkernel as pn
import pytest
from soundness import SHAPES

SURFACES = int(os.environ.get("PN_SOUNDNESS_SURFACES", "2000"))
BLOCK = 20  # surfaces of one test
POINTS = (3, 6, 18, 54, 162, 486, 1458, 4374)  # more are tried only while the bound seems idle
IDLE = 100  # times the largest error that was seen
# Surfaces of the long run with a looser bound, by shape and seed: poles far beyond the surface, whose
# rounding the bound counts in full and the surface hardly.
LOOSE = {("triangulated_skins", 440): 300}
# Times as long as others take: so many fewer are made.
EFFORT = {"triangulated_skins": 8, "envelopes": 8}
REFUSED = BLOCK // 4  # degenerate inputs may be refused, but not as a rule


def blocks():
    share = SURFACES / (sum(1 / EFFORT.get(shape, 1) for shape in SHAPES) * BLOCK)
    return [
        (shape, BLOCK * block)
        for shape in SHAPES
        for block in range(math.ceil(share / EFFORT.get(shape, 1)))
    ]


def made(shape, seed):
    """The specimen of a seed, or none where the kernel refuses it with a declared error."""
    try:
        specimen = SHAPES[shape](np.random.default_rng(seed))
        return specimen, specimen.surface.certificate.deviation
    except pn.GeometryError:
        return None


def assert_sound(specimen, bound, shape, seed):
    random = np.random.default_rng([seed, 1])
    idle = LOOSE.get((shape, seed), IDLE)
    error = 0.0
    for count in POINTS:
        error = max(error, specimen.largest_error(random, count))
        assert error <= bound
        if bound <= idle * error:
            return
    pytest.fail(f"the bound {bound} is idle: no point is farther off than {error}")


@pytest.mark.parametrize(("shape", "first"), blocks())
def test_no_point_is_farther_off_than_the_certificate_says(shape, first):
    refused = 0
    for seed in range(first, first + BLOCK):
        found = made(shape, seed)
        if found is None:
            refused += 1
            continue
        print(f"{shape}, seed {seed}")  # shown when the test fails
        assert_sound(*found, shape, seed)
    assert refused <= REFUSED
