# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the results of pn_bench, a JSON file of Google Benchmark, as tables of medians."""

import json
import sys

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}


def medians(results):
    """The median of every benchmark, in the order of the source: name -> its entry."""
    entries = [e for e in results["benchmarks"] if e.get("aggregate_name") == "median"]
    entries.sort(key=lambda e: (e["family_index"], e["per_family_instance_index"]))
    return {entry["run_name"]: entry for entry in entries}


def milliseconds(entry):
    """Wall time per call."""
    return entry["real_time"] * MILLISECONDS[entry["time_unit"]]


def arguments(name):
    """'spring/spans:100/threads:2' -> {'spans': 100, 'threads': 2}."""
    pairs = (part.split(":") for part in name.split("/") if ":" in part)
    return {key: int(value) for key, value in pairs}


def print_table(title, header, rows):
    """Columns as wide as they need; the first one is text, the others stand right."""
    if not rows:
        return
    cells = [header] + rows
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    print(f"\n{title}\n")
    for row in cells:
        first, *others = (cell.rjust(width) for cell, width in zip(row, widths))
        print("  ".join([first.strip().ljust(widths[0]), *others]))


def one_span(entries):
    """Times of a single span, the degrees side by side."""
    by_step = {}
    for name, entry in entries.items():
        degree = arguments(name).get("degree")
        if degree is not None:
            by_step.setdefault(name.split("/")[0], {})[degree] = f"{milliseconds(entry):.3f}"
    degrees = sorted({degree for at in by_step.values() for degree in at})
    rows = [
        [step.replace("_", " "), *(at.get(degree, "-") for degree in degrees)]
        for step, at in by_step.items()
    ]
    print_table("One span, ms", ["", *(f"degree {degree}" for degree in degrees)], rows)


def many_spans(entries):
    """Times on one and two threads and memory, by the number of spans."""
    runs = {}
    for name, entry in entries.items():
        if name.startswith("many_spans/"):
            given = arguments(name)
            runs.setdefault(given["spans"], {})[given["threads"]] = entry
    rows = []
    for spans, on in runs.items():
        one, two = milliseconds(on[1]), milliseconds(on[2])
        rows.append(
            [
                f"{spans}",
                f"{one:.1f}",
                f"{two:.1f}",
                f"{one / two:.2f}",
                f"{1e3 * one / spans:.0f}",
                f"{on[1]['kept_bytes_per_span'] / 1024:.1f}",
                f"{on[1]['peak_bytes_per_span'] / 1024:.1f}",
                f"{on[1]['poles'] / spans:.1f}",
            ]
        )
    header = ["spans", "1 thread, ms", "2 threads, ms", "speedup", "us/span", "kept kB/span"]
    print_table("Cubic C2 B-spline", [*header, "peak kB/span", "poles/span"], rows)


def side_by_side(entries, case, title):
    """One case, ours and OpenCASCADE's; ratios are theirs over ours."""
    runs = {name: entry for name, entry in entries.items() if name.startswith(f"{case}/")}
    if f"{case}/exact" not in runs:
        return
    exact = runs[f"{case}/exact"]
    rows = []
    for entry in runs.values():

        def ratio(key):
            return f"({entry[key] / exact[key]:.3g}x)"

        rows.append(
            [
                entry["label"],
                f"{milliseconds(entry):.2f}",
                f"({milliseconds(entry) / milliseconds(exact):.3g}x)",
                f"{entry['degree_along']:.0f} x {entry['degree_around']:.0f}",
                f"{entry['poles']:.0f}",
                ratio("poles"),
                f"{entry['deviation']:.1e}",
                ratio("deviation"),
                f"{entry['step_bytes'] / 1000:.1f}",
                ratio("step_bytes"),
            ]
        )
    header = ["", "ms", "", "degree", "poles", "", "deviation, mm", "", "STEP, kB", ""]
    print_table(title, header, rows)


def main(path):
    with open(path, encoding="utf-8") as file:
        entries = medians(json.load(file))
    one_span(entries)
    many_spans(entries)
    side_by_side(entries, "case_c1", "Case C1: constant radius along a cubic")
    side_by_side(entries, "case_c2", "Case C2: cubic radius along a cubic")


if __name__ == "__main__":
    main(sys.argv[1])
