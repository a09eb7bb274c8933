# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a surface crosses itself: two parameters of one point."""

import numpy as np
import pnkernel as pn
import pytest


def helix(radius, pitch, turns=3, per_turn=12):
    angle = np.arange(turns * per_turn + 3) * 2 * np.pi / per_turn
    poles = np.c_[radius * np.cos(angle), radius * np.sin(angle), pitch * angle / (2 * np.pi)]
    spans = len(poles) - 3
    return pn.Curve.bspline(3, range(spans + 1), [4] + [1] * (spans - 1) + [4], poles)


def check_crossing(surface, found):
    assert max(found.faces) < len(surface.bsplines())
    (u, v), (s, t) = found.parameters
    assert found.faces[0] != found.faces[1] or np.hypot(u - s, v - t) > 1e-6
    points, normals = surface.evaluate([u, s], [v, t])
    np.testing.assert_allclose(points, [found.point] * 2, rtol=0, atol=1e-9)
    assert abs(normals[0] @ normals[1]) == pytest.approx(np.cos(found.angle), abs=1e-9)


def test_the_turns_of_a_helix():
    coil = pn.canal_surface(helix(8, 3), pn.Law.constant(1))
    assert coil.self_intersection() is None
    assert coil.offset(0.4).self_intersection() is None
    thick = coil.offset(0.6)
    check_crossing(thick, thick.self_intersection())


def test_a_radius_that_grows():
    spine = helix(8, 3)
    law = pn.Law.bspline(1, spine.domain, [2, 2], [1, 2])
    horn = pn.canal_surface(spine, law)
    found = horn.self_intersection()
    check_crossing(horn, found)
    # The sum of the radii of both turns exceeds the distance of the turns.
    (t, _), (s, _) = found.parameters
    radii = [1 + x / spine.domain[1] for x in (t, s)]
    assert sum(radii) > 2.9
    assert (
        pn.canal_surface(
            spine, pn.Law.bspline(1, spine.domain, [2, 2], [0.8, 1.3])
        ).self_intersection()
        is None
    )


@pytest.mark.parametrize("d", [0, 5, -3])
def test_poles_and_seams_of_an_ellipsoid_do_not_alarm(d):
    assert pn.quadric("ellipsoid", 30, 20, 10).offset(d).self_intersection() is None


def test_beyond_the_regular_range_of_an_ellipsoid():
    # By symmetry sheets of the sharp ends meet in the planes of symmetry.
    found = pn.quadric("ellipsoid", 30, 20, 10).offset(-5).self_intersection()
    assert min(abs(found.point)) < 1e-9
