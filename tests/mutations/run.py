# SPDX-License-Identifier: LGPL-2.1-or-later
"""Breaks each formula of mutations.json in a copy of the last commit and runs the tests about it.

python run.py FOLDER: where the copy is built; it is made once and kept.
"""

import json
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


class Mutation(NamedTuple):
    formula: str
    file: str
    text: str
    broken: str
    tests: str  # of pn_tests: names or [tags], separated by commas


def run(*command, cwd=ROOT):
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True)


def succeeded(*command, cwd=ROOT):
    done = run(*command, cwd=cwd)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")


def copy_last_commit(folder):
    """A work tree at HEAD, without what an interrupted run has left broken in it."""
    if not folder.exists():
        succeeded("git", "clone", "--quiet", "--no-checkout", ROOT, folder)
    head = run("git", "rev-parse", "HEAD").stdout.strip()
    succeeded("git", "fetch", "--quiet", "origin", "HEAD", cwd=folder)
    succeeded("git", "checkout", "--quiet", "--force", "--detach", head, cwd=folder)


class Copy:
    """The copy, its build and its tests."""

    def __init__(self, folder):
        self._folder, self._build = folder, folder / "build"
        copy_last_commit(folder)
        if not (self._build / "build.ninja").exists():
            succeeded("cmake", "--preset", "release", cwd=folder)

    def passes(self, tests):
        """Whether these tests pass, compiled from what the copy holds now."""
        succeeded("cmake", "--build", self._build, "--target", "pn_tests")
        return run(self._build / "tests/cpp/pn_tests", tests).returncode == 0

    def survives(self, mutation):
        """Whether the tests pass with the broken formula, too. Without it they do."""
        file = self._folder / mutation.file
        whole = file.read_text()
        if whole.count(mutation.text) != 1:
            sys.exit(f"{mutation.file} does not hold once: {mutation.text}")
        if not self.passes(mutation.tests):
            sys.exit(f"The tests {mutation.tests} fail without any mutation.")
        file.write_text(whole.replace(mutation.text, mutation.broken))
        try:
            return self.passes(mutation.tests)
        finally:
            file.write_text(whole)


def main(folder):
    copy = Copy(Path(folder))
    mutations = [Mutation(**entry) for entry in json.loads((HERE / "mutations.json").read_text())]
    survivors = 0
    for mutation in mutations:
        survived = copy.survives(mutation)
        survivors += survived
        print(f"{'SURVIVED' if survived else 'killed':8}  {mutation.formula}", flush=True)
    print(f"{len(mutations) - survivors} of {len(mutations)} broken formulas make a test fail.")
    sys.exit(survivors > 0)


if __name__ == "__main__":
    main(sys.argv[1])
