# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python face of pn/occt: arrays in, BREP text out, errors as exceptions."""

from types import SimpleNamespace

import numpy as np
import pnkernel as pn
import pnocct
import pytest

ATTRIBUTES = (
    "u_degree", "v_degree", "u_knots", "u_multiplicities", "v_knots", "v_multiplicities",
    "poles", "weights", "trims",
)


def cylinder(bottom, top, radius=2.0):
    """A tube about the z-axis: one face, C1 around, its normal outwards."""
    half_angles = np.arange(6) * np.pi / 4
    p = np.stack([np.cos(half_angles), np.sin(half_angles)], axis=1)
    joints = (p[:-1] + p[1:]) / 2

    def product(a, b):
        return np.array([a[0] * b[0] - a[1] * b[1], -a[0] * b[1] - a[1] * b[0], a @ b])

    columns = [product(joints[0], joints[0])]
    for start, middle, end in zip(joints, p[1:], joints[1:]):
        columns.append(product(start, middle))
        columns.append((product(start, end) + 2 * product(middle, middle)) / 3)
        columns.append(product(middle, end))
    columns.append(columns[0])
    x, y, w = np.array(columns).T
    circle = radius * np.stack([x / w, y / w], axis=1)
    rows = [np.column_stack([circle, np.full_like(w, z)]) for z in (bottom, top)]
    return SimpleNamespace(
        u_degree=1, v_degree=4, u_knots=[0.0, 1.0], u_multiplicities=[2, 2],
        v_knots=np.arange(5.0), v_multiplicities=[5, 3, 3, 3, 5],
        poles=np.array(rows), weights=np.array([w, w]), trims=[],
    )


def assert_equal(face, other):
    for attribute in ATTRIBUTES:
        np.testing.assert_array_equal(getattr(face, attribute), getattr(other, attribute))


def test_shell_keeps_every_number():
    tubes = [cylinder(0.1, 1 / 3), cylinder(1 / 3, 0.7)]
    brep = pnocct.shell(tubes)
    assert pnocct.check(brep) == []
    assert pnocct.check(brep, boolean=True) == []
    for face, tube in zip(pnocct.faces(brep), tubes, strict=True):
        assert_equal(face, tube)
    assert_equal(pnocct.faces(pnocct.shell(pnocct.faces(brep)))[1], tubes[1])


def test_capped_solid_is_a_cylinder():
    solid = pnocct.capped_solid([cylinder(0, 2), cylinder(2, 5)])
    assert pnocct.check(solid, boolean=True) == []
    assert pnocct.volume(solid) == pytest.approx(20 * np.pi, rel=1e-12)
    assert pnocct.area(solid) == pytest.approx(28 * np.pi, rel=1e-12)


def test_step_keeps_every_number(tmp_path):
    tube = cylinder(0.1, 1 / 3)
    path = tmp_path / "tube.step"
    pnocct.write_step(path, [pnocct.shell([tube])], ["tube"], schema="AP242", pcurves=False)
    (shell,) = pnocct.read_step(str(path))
    (face,) = pnocct.faces(shell)
    assert_equal(face, tube)
    assert [file.name for file in tmp_path.iterdir()] == ["tube.step"]


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_canal_surface_becomes_a_clean_solid(lines, tmp_path):
    spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0], [20, 10, 5], [30, 10, 20]])
    faces = pn.canal_surface(spine, pn.Law.bezier([2, 3, 1.5, 2])).offset(0.25).bsplines(lines)
    solid = pnocct.capped_solid(faces)
    assert pnocct.check(solid, boolean=True) == []
    path = tmp_path / "canal.step"
    pnocct.write_step(path, [pnocct.shell(faces)], ["canal"])
    (shell,) = pnocct.read_step(path)
    for face, original in zip(pnocct.faces(shell), faces, strict=True):
        assert_equal(face, original)


def test_both_kinds_of_lines_bound_the_same_volume():
    spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0], [20, 10, 5], [30, 10, 20]])
    surface = pn.canal_surface(spine, pn.Law.bezier([2, 3, 1.5, 2]))
    even, lowest = (
        pnocct.volume(pnocct.capped_solid(surface.bsplines(lines)))
        for lines in ("even", "lowest_degree")
    )
    assert even == pytest.approx(lowest, rel=1e-11)


def test_arrays_that_are_no_face():
    for change in (
        {"poles": np.zeros((2, 14))},
        {"weights": np.ones(28)},
        {"v_knots": [0.0, 1.0]},
        {"poles": np.full((2, 14, 3), np.nan)},
        {"trims": [object()]},
    ):
        with pytest.raises(ValueError):
            pnocct.shell([SimpleNamespace(**{**vars(cylinder(0, 1)), **change})])


def test_faces_that_are_no_shell():
    with pytest.raises(ValueError, match="at least one"):
        pnocct.shell([])
    with pytest.raises(ValueError, match="do not hang together"):
        pnocct.shell([cylinder(0, 1), cylinder(2, 3)])


def test_shapes_without_the_quantity_asked_for():
    with pytest.raises(ValueError, match="no volume"):
        pnocct.volume(pnocct.shell([cylinder(0, 1)]))
    with pytest.raises(ValueError, match="B-spline"):
        pnocct.faces(pnocct.capped_solid([cylinder(0, 1)]))
    with pytest.raises(ValueError, match="BREP"):
        pnocct.area("no shape")


def test_opencascade_failure_has_its_message():
    tube = cylinder(0, 1)
    tube.weights = -tube.weights
    with pytest.raises(pnocct.OcctError, match="Standard_ConstructionError"):
        pnocct.shell([tube])
    assert issubclass(pnocct.OcctError, RuntimeError)


def test_files_that_cannot_be_written_or_read(tmp_path):
    shell = pnocct.shell([cylinder(0, 1)])
    with pytest.raises(FileNotFoundError):
        pnocct.write_step(tmp_path / "missing" / "x.step", [shell], ["x"])
    with pytest.raises(FileNotFoundError):
        pnocct.read_step(tmp_path / "missing.step")
    with pytest.raises(ValueError, match="one name"):
        pnocct.write_step(tmp_path / "x.step", [shell], [])
    with pytest.raises(ValueError, match="AP209"):
        pnocct.write_step(tmp_path / "x.step", [shell], ["x"], schema="AP209")
    assert list(tmp_path.iterdir()) == []
