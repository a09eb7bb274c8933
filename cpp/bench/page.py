# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a page of the results of pn_bench: tables in Markdown and plots in SVG.

python page.py results.json docs/benchmark.md: the plots go to docs/images/benchmark_*.svg.
"""

import sys
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from tables import arguments, below, cases, failed, machine, medians, milliseconds, results_in, tables

# The same results give the same file.
matplotlib.rcParams["svg.hashsalt"] = "pn-surfaces"
SIZE = (7, 4)

INTRODUCTION = """# Benchmark

Written by `scripts/bench page`. {machine}

Every case is built by PN Surfaces and by OpenCASCADE in one run, and both results are measured in the
same way: the largest distance of a dense grid of points to the true surface, before and after a STEP
file. *Stated* is the deviation that the maker gives: ours is proven, that of OpenCASCADE estimated.
Ratios in brackets are theirs over ours. What failed says so.
"""


def as_markdown(table):
    def line(cells):
        return f"| {' | '.join(cells)} |"

    rule = line(["---", *["---:"] * (len(table.header) - 1)])
    return "\n".join([f"## {table.title}", "", line(table.header), rule, *map(line, table.rows)])


def plotted(file, title, x_label, y_label, draw):
    figure = Figure(figsize=SIZE)
    axes = figure.subplots()
    draw(axes)
    axes.set(title=title, xlabel=x_label, ylabel=y_label, xscale="log", yscale="log")
    axes.grid(visible=True, which="both", alpha=0.2)
    axes.legend(fontsize="small")
    figure.savefig(file, metadata={"Date": None}, bbox_inches="tight")


def growth(entries, key):
    """(spans, entry) of the long canal surface, by threads."""
    by_threads = {}
    for name, entry in below(entries, "many_spans").items():
        given = arguments(name)
        by_threads.setdefault(given["threads"], []).append((given["spans"], key(entry)))
    return {threads: sorted(points) for threads, points in by_threads.items()}


def draw_times(entries, axes):
    for threads, points in growth(entries, milliseconds).items():
        spans, times = zip(*points)
        axes.plot(spans, times, marker="o", label=f"{threads} thread{'s' if threads > 1 else ''}")


def draw_memory(entries, axes):
    for key, label in (("kept_bytes_per_span", "kept"), ("peak_bytes_per_span", "at most")):
        points = growth(entries, lambda entry: entry[key])[1]
        axes.plot(
            [n for n, _ in points], [n * size / 2**20 for n, size in points], marker="o", label=label
        )


def draw_deviations(entries, axes):
    """Every way to every case: poles against the true deviation."""
    families = [f"offset_case/{case}" for case in cases(entries, "offset_case")]
    ours, theirs = [], []
    for family in ("case_c1", "case_c2", *families):
        for name, entry in below(entries, family).items():
            if failed(entry) or not entry.get("poles") or not entry.get("deviation"):
                continue
            (ours if name == "exact" else theirs).append((entry["poles"], entry["deviation"]))
    for points, label, marker in ((theirs, "OpenCASCADE", "x"), (ours, "PN Surfaces", "o")):
        if points:
            axes.plot(*zip(*points), marker, label=label)


def main(results_path, page_path):
    results, page = results_in(results_path), Path(page_path)
    entries = medians(results)
    images = page.parent / "images"
    images.mkdir(exist_ok=True)
    plots = [
        ("time", "Time of a long canal surface", "spans", "ms", draw_times),
        ("memory", "Memory of a long canal surface", "spans", "MiB", draw_memory),
        ("deviation", "All cases and ways", "poles", "true deviation, mm", draw_deviations),
    ]
    parts = [INTRODUCTION.format(machine=machine(results))]
    for name, title, x_label, y_label, draw in plots:
        file = images / f"benchmark_{name}.svg"
        plotted(file, title, x_label, y_label, lambda axes, draw=draw: draw(entries, axes))
        parts.append(f"![{title}](images/{file.name})\n")
    parts += [f"{as_markdown(table)}\n" for table in tables(entries)]
    page.write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
