# SPDX-License-Identifier: LGPL-2.1-or-later
"""A STEP export that is killed: the old file is whole, or the next one is."""

import signal
import subprocess
import sys

import pnocct
import pytest
from test_pnocct import assert_equal, cylinder

EXPORT = """
import sys
import pnocct
from test_pnocct import cylinder
shell = pnocct.shell([cylinder(i, i + 1, float(sys.argv[2])) for i in range(20)])
print("begun", flush=True)
for _ in range(1000):
    pnocct.write_step(sys.argv[1], [shell], ["tube"], progress=lambda part: print(part, flush=True))
"""
OLD, NEXT = 2.0, 3.0


def tubes(radius):
    return [cylinder(i, i + 1, radius) for i in range(20)]


def is_whole(path, radius):
    (shell,) = pnocct.read_step(path)
    faces = pnocct.faces(shell)
    if len(faces) != 20 or (faces[0].poles != tubes(radius)[0].poles).any():
        return False
    for face, tube in zip(faces, tubes(radius), strict=True):
        assert_equal(face, tube)
    return True


@pytest.mark.parametrize("steps", [1, 2, 5, 20, 80])
def test_a_killed_export_leaves_a_whole_file(steps, tmp_path, request):
    """Killed after so many steps of its progress, somewhere in the next one."""
    path = tmp_path / "tube.step"
    pnocct.write_step(path, [pnocct.shell(tubes(OLD))], ["tube"])
    with subprocess.Popen(
        [sys.executable, "-c", EXPORT, path, str(NEXT)],
        stdout=subprocess.PIPE,
        text=True,
        cwd=request.path.parent,
    ) as process:
        for _ in range(steps):
            assert process.stdout.readline()
        process.kill()
    assert process.returncode == -signal.SIGKILL
    assert is_whole(path, OLD) or is_whole(path, NEXT)
    # What is left aside does no harm: the next export takes its place.
    pnocct.write_step(path, [pnocct.shell(tubes(NEXT))], ["tube"])
    assert is_whole(path, NEXT)
    assert [file.name for file in tmp_path.iterdir()] == ["tube.step"]
