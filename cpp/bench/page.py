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


def growth(entries, family, argument, value):
    """(argument, value of the entry) for a family on one thread, and on others if it was run there:
    by the number of threads."""
    by_threads = {}
    for name, entry in below(entries, family).items():
        given = arguments(name)
        by_threads.setdefault(given.get("threads", 1), []).append((given[argument], value(entry)))
    return {threads: sorted(points) for threads, points in by_threads.items()}


def draw_times(family, argument):
    def draw(entries, axes):
        for threads, points in growth(entries, family, argument, milliseconds).items():
            label = f"{threads} thread{'s' if threads > 1 else ''}"
            axes.plot(*zip(*points), marker="o", label=label)

    return draw


def draw_memory(family, argument):
    def draw(entries, axes):
        for key, label in (("kept_bytes", "kept"), ("peak_bytes", "at most")):
            points = growth(entries, family, argument, lambda entry: entry[key] / 2**20)[1]
            axes.plot(*zip(*points), marker="o", label=label)

    return draw


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
        (
            f"{name}_{quantity}",
            f"{quantity.capitalize()} of {what}",
            axis,
            unit,
            draw(family, argument),
        )
        for name, what, axis, family, argument in (
            ("spans", "a long canal surface", "spans", "many_spans", "spans"),
            ("degree", "a canal surface of one span", "degree of the spine", "by_degree", "spine"),
            (
                "distances",
                "offsets of a cubic canal surface",
                "distances",
                "by_distances",
                "distances",
            ),
        )
        for quantity, unit, draw in (("time", "ms", draw_times), ("memory", "MiB", draw_memory))
    ] + [("deviation", "All cases and ways", "poles", "true deviation, mm", draw_deviations)]
    parts = [INTRODUCTION.format(machine=machine(results))]
    for name, title, x_label, y_label, draw in plots:
        file = images / f"benchmark_{name}.svg"
        plotted(file, title, x_label, y_label, lambda axes, draw=draw: draw(entries, axes))
        parts.append(f"![{title}](images/{file.name})\n")
    parts += [f"{as_markdown(table)}\n" for table in tables(entries)]
    page.write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
