# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python face of pn/occt: arrays in, BREP text out, errors as exceptions."""

import contextlib
import os
import pathlib
import resource
import tempfile
from types import SimpleNamespace

import numpy as np
import pnkernel as pn
import pnocct
import pytest

ATTRIBUTES = (
    "u_degree",
    "v_degree",
    "u_knots",
    "u_multiplicities",
    "v_knots",
    "v_multiplicities",
    "poles",
    "weights",
    "trims",
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
        u_degree=1,
        v_degree=4,
        u_knots=[0.0, 1.0],
        u_multiplicities=[2, 2],
        v_knots=np.arange(5.0),
        v_multiplicities=[5, 3, 3, 3, 5],
        poles=np.array(rows),
        weights=np.array([w, w]),
        trims=[],
    )


def trim(*poles):
    """A Bezier curve in the parameter plane."""
    n = len(poles)
    return SimpleNamespace(
        degree=n - 1, knots=[0.0, 1.0], multiplicities=[n, n], poles=np.array(poles, dtype=float)
    )


def trimmed(face, *loops):
    return SimpleNamespace(**{**vars(face), "trims": list(loops)})


def around(*corners):
    return [trim(a, b) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]


def torus(radius):
    """A closed tube around a circle of radius 5."""
    poles = [
        [5, 0, 0],
        [5, 5, 0],
        [0, 5, 0],
        [-5, 5, 0],
        [-5, 0, 0],
        [-5, -5, 0],
        [0, -5, 0],
        [5, -5, 0],
        [5, 0, 0],
    ]
    spine = pn.Curve.bspline(2, [0, 1, 2, 3, 4], [3, 2, 2, 2, 3], poles, [1, 1, 2, 1, 1, 1, 2, 1, 1])
    return pn.canal_surface(spine, pn.Law.constant(radius)).bsplines()


def shell_count(brep):
    """Shells of a BREP text, which begins each shape with a line of its kind."""
    return brep.splitlines().count("Sh")


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


def test_face_and_hole_add_up():
    outside = around((0, 0), (1, 0), (1, 4), (0, 4))
    patch = [
        trim((0.3, 1), (0.6, 1)),
        trim((0.6, 1), (0.9, 2), (0.6, 3)),
        trim((0.6, 3), (0.3, 3)),
        trim((0.3, 3), (0.3, 1)),
    ]
    hole = [trim(*curve.poles[::-1]) for curve in patch[::-1]]
    rest, part = (
        pnocct.shell([trimmed(cylinder(0, 5), *loops)]) for loops in ([outside, hole], [patch])
    )
    for brep in (rest, part):
        assert pnocct.check(brep, boolean=True) == []
        assert pnocct.trim_deviation(brep) < 1e-9
    assert pnocct.area(rest) + pnocct.area(part) == pytest.approx(20 * np.pi, rel=1e-12)


def test_trimmed_neighbours_share_a_piece_of_a_side():
    lower = trimmed(cylinder(0, 1), around((0, 0.5), (1, 0.5), (1, 2.5), (0, 2.5)))
    upper = trimmed(cylinder(1, 2), around((0, 0.5), (1, 0.5), (1, 2.5), (0, 2.5)))
    assert pnocct.check(pnocct.shell([lower, upper]), boolean=True) == []
    assert shell_count(pnocct.shell([lower, upper])) == 1
    other = trimmed(cylinder(1, 2), around((0, 0.5), (1, 0.5), (1, 3), (0, 3)))
    assert shell_count(pnocct.shell([lower, other])) == 2


def test_thick_solid_between_two_offsets():
    solid = pnocct.thick_solid(torus(1), torus(2))
    assert pnocct.check(solid, boolean=True) == []
    assert pnocct.volume(solid) == pytest.approx(2 * np.pi**2 * 5 * (4 - 1), rel=1e-12)
    pipe = pnocct.thick_solid([cylinder(0, 5, 2)], [cylinder(0, 5, 3)])
    assert pnocct.check(pipe, boolean=True) == []
    assert pnocct.volume(pipe) == pytest.approx(5 * np.pi * (9 - 4), rel=1e-12)
    with pytest.raises(ValueError, match="inside"):
        pnocct.thick_solid(torus(2), torus(1))
    with pytest.raises(ValueError, match="open"):
        pnocct.thick_solid([cylinder(0, 1)], torus(1))


def test_trims_that_bound_nothing():
    good = around((0.2, 1), (0.8, 1), (0.5, 2))
    bad_knots = around((0.2, 1), (0.8, 1), (0.5, 2))
    bad_knots[1].knots = [1.0, 0.0]
    space_poles = around((0.2, 1), (0.8, 1), (0.5, 2))
    space_poles[1].poles = np.zeros((2, 3))
    for loop in (good[:2], [], bad_knots, space_poles):
        with pytest.raises(ValueError):
            pnocct.shell([trimmed(cylinder(0, 1), loop)])


def test_arrays_that_are_no_face():
    for change in (
        {"poles": np.zeros((2, 14))},
        {"weights": np.ones(28)},
        {"v_knots": [0.0, 1.0]},
        {"poles": np.full((2, 14, 3), np.nan)},
    ):
        with pytest.raises(ValueError):
            pnocct.shell([SimpleNamespace(**{**vars(cylinder(0, 1)), **change})])


def test_faces_of_several_parts_make_compounds():
    parts = [cylinder(0, 1), cylinder(2, 3), cylinder(1, 1.5)]
    shells = pnocct.shell(parts)
    assert shell_count(shells) == 2
    assert pnocct.check(shells, boolean=True) == []
    solids = pnocct.capped_solid(parts)
    assert pnocct.check(solids, boolean=True) == []
    assert pnocct.volume(solids) == pytest.approx(4 * np.pi * 2.5, rel=1e-12)


def test_no_face_is_no_shell():
    for make in (pnocct.shell, pnocct.capped_solid):
        with pytest.raises(ValueError, match="at least one"):
            make([])


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


def test_report_of_a_step_file(tmp_path):
    solid = pnocct.capped_solid([cylinder(0, 2), cylinder(2, 5)])
    path = tmp_path / "x.step"
    report = pnocct.write_step(path, [solid], ["x"])
    assert report["bytes"] == path.stat().st_size
    assert (report["faces"], report["bspline_faces"]) == (4, 2)
    assert report["poles"] == 2 * cylinder(0, 1).weights.size
    assert report["volume"] == pytest.approx(20 * np.pi, rel=1e-12)


def test_measures_with_their_error():
    solid = pnocct.capped_solid([cylinder(0, 2), cylinder(2, 5)])
    for (value, error), exact in (
        (pnocct.measured_volume(solid), 20 * np.pi),
        (pnocct.measured_area(solid), 28 * np.pi),
    ):
        assert abs(value - exact) <= error <= 1e-10 * exact


def test_export_can_be_broken_off(tmp_path):
    shell = pnocct.shell([cylinder(0, 1)])
    path = tmp_path / "x.step"
    path.write_text("old")

    class Stop(Exception):
        pass

    def stop(part):
        if part > 0.3:
            raise Stop

    with pytest.raises(Stop):
        pnocct.write_step(path, [shell], ["x"], progress=stop)
    assert path.read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["x.step"]


@contextlib.contextmanager
def full_disk():
    """No file can grow beyond 2000 bytes, as on a disk with that much left."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


@contextlib.contextmanager
def without_privileges():
    """Root may write everywhere; another user may not."""
    user = os.geteuid()
    if user == 0:
        os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(user)


def test_full_disk_leaves_the_old_file(tmp_path):
    shell = pnocct.shell([cylinder(0, 1)])
    path = tmp_path / "x.step"
    path.write_text("old")
    with full_disk(), pytest.raises(OSError, match="x.step"):
        pnocct.write_step(path, [shell], ["x"])
    assert path.read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["x.step"]


def test_read_only_folder_leaves_the_old_file():
    shell = pnocct.shell([cylinder(0, 1)])
    with tempfile.TemporaryDirectory() as name:
        path = pathlib.Path(name) / "x.step"
        path.write_text("old")
        path.parent.chmod(0o555)
        with without_privileges(), pytest.raises(PermissionError):
            pnocct.write_step(path, [shell], ["x"])
        assert path.read_text() == "old"
        assert [file.name for file in path.parent.iterdir()] == ["x.step"]
        path.parent.chmod(0o755)


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
