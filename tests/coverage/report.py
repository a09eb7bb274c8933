# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which lines no test runs: report.py GCOVR.json COVERAGE.json, of what gcovr and coverage.py counted.

First the lines of each folder, then those that never ran, file by file."""

import collections
import itertools
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def of_gcovr(path):
    """{file: {line: whether it ran}} of C++."""
    return {
        pathlib.PurePath(file["file"]): {
            line["line_number"]: line["count"] > 0
            for line in file["lines"]
            if not line["gcovr/noncode"]
        }
        for file in json.loads(path.read_text())["files"]
    }


def of_coverage(path):
    """{file: {line: whether it ran}} of Python."""
    return {
        pathlib.Path(file)
        .resolve()
        .relative_to(ROOT): {
            **dict.fromkeys(lines["executed_lines"], True),
            **dict.fromkeys(lines["missing_lines"], False),
        }
        for file, lines in json.loads(path.read_text())["files"].items()
    }


def ranges(numbers):
    """3, 4, 5, 9 as "3-5 9"."""
    runs = itertools.groupby(enumerate(sorted(numbers)), lambda pair: pair[1] - pair[0])
    ends = [[number for _, number in run] for _, run in runs]
    return " ".join(str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in ends)


def main():
    files = {**of_gcovr(pathlib.Path(sys.argv[1])), **of_coverage(pathlib.Path(sys.argv[2]))}
    folders = collections.defaultdict(list)
    for file, lines in files.items():
        folders[file.parent].extend(lines.values())
    print(f"{'folder':<28}{'lines':>8}{'run':>8}")
    for folder, ran in sorted(folders.items()):
        print(f"{str(folder):<28}{len(ran):>8}{sum(ran) / max(len(ran), 1):>8.1%}")
    print("\nLines that no test runs")
    for file, lines in sorted(files.items()):
        never = [number for number, ran in lines.items() if not ran]
        if never:
            print(f"{file}: {ranges(never)}")


main()
