# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of pn_bench, a JSON file of Google Benchmark, as tables of medians.

python tables.py results.json prints them; page.py makes a page of them.
"""

import json
import sys
from typing import NamedTuple

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}


def medians(results):
    """The median of every benchmark, in the order of the source: name -> its entry. One that throws
    has no median, but an entry with its error."""
    entries = sorted(
        results["benchmarks"], key=lambda e: (e["family_index"], e["per_family_instance_index"])
    )
    return {
        entry["run_name"]: entry
        for entry in entries
        if entry.get("aggregate_name") == "median" or failed(entry)
    }


def failed(entry):
    return entry.get("error_occurred", False)


def milliseconds(entry):
    """Wall time per call."""
    return entry["real_time"] * MILLISECONDS[entry["time_unit"]]


def arguments(name):
    """'spring/spans:100/threads:2' -> {'spans': 100, 'threads': 2}."""
    pairs = (part.split(":") for part in name.split("/") if ":" in part)
    return {key: int(value) for key, value in pairs}


def below(entries, prefix):
    """'offset_step/Q1p' -> {'chain': its entry, ...}."""
    return {
        name.removeprefix(f"{prefix}/"): entry
        for name, entry in entries.items()
        if name.startswith(f"{prefix}/")
    }


class Table(NamedTuple):
    """Cells of text: the first column names the row."""

    title: str
    header: list
    rows: list


def as_text(table):
    """Columns as wide as they need; the first one is text, the others stand right."""
    cells = [table.header, *table.rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(table.header))]
    lines = [table.title, ""]
    for row in cells:
        first, *others = (cell.rjust(width) for cell, width in zip(row, widths))
        lines.append("  ".join([first.strip().ljust(widths[0]), *others]))
    return "\n".join(lines)


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
    return Table("Canal surface, one span, ms", ["", *(f"degree {d}" for d in degrees)], rows)


def many_spans(entries, family, title):
    """Times on one and two threads and memory, by the number of spans."""
    runs = {}
    for name, entry in below(entries, family).items():
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
                f"{on[1]['kept_bytes'] / spans / 1024:.1f}",
                f"{on[1]['peak_bytes'] / spans / 1024:.1f}",
                f"{on[1]['poles'] / spans:.1f}",
            ]
        )
    header = ["spans", "1 thread, ms", "2 threads, ms", "speedup", "us/span", "kept kB/span"]
    return Table(title, [*header, "peak kB/span", "poles/span"], rows)


def cell(entry, form, value):
    """A number of an entry, if there is one that did not fail."""
    if entry is None:
        return "-"
    return "failed" if failed(entry) else form.format(value(entry))


def offset_steps(entries):
    """Times of the steps to an offset, a row for each case."""
    steps = ["chain", "numbers_to_whole_faces", "another_distance", "edges", "limits"]
    rows = []
    for case in cases(entries, "offset_step"):
        runs = below(entries, f"offset_step/{case}")
        whole, edges = runs.get("numbers_to_whole_faces"), runs.get("edges")
        rows.append(
            [
                case,
                *(cell(runs.get(step), "{:.3f}", milliseconds) for step in steps),
                cell(whole, "{:.0f}", lambda entry: entry["poles"]),
                cell(whole, "{:.1e}", lambda entry: entry["stated_deviation"]),
                cell(edges, "{:.1e}", lambda entry: entry["trim_deviation"]),
            ]
        )
    names = [step.replace("_", " ") for step in steps]
    header = ["", *names, "poles", "proven, mm", "edges off, mm"]
    return Table("Offsets by steps, ms", header, rows)


def cases(entries, family):
    """'offset_step/Q1p/chain', ... -> ['Q1p', ...]."""
    return list(dict.fromkeys(name.split("/")[0] for name in below(entries, family)))


SIDE_BY_SIDE = ["", "ms", "", "degree", "poles", "", "deviation, mm", "stated, mm", "STEP, kB"]


def ratio(entry, exact, value):
    """Theirs over ours, where both were made."""
    if exact is None or failed(exact) or entry is exact or value(entry) == 0:
        return ""
    return f"({value(entry) / value(exact):.3g}x)"


def read_back(entry):
    if entry["read_faces"] == 0:
        return "LOST"
    return f"{entry['read_faces']:.0f} of {entry['faces']:.0f}, {entry['read_deviation']:.1e}"


def net_types(entries):
    """Both skins of a family of each type of nets."""
    rows = [
        [
            entry["label"],
            cell(entry, "{:.1f}", milliseconds),
            cell(entry, "{0[0]:.0f} x {0[1]:.0f}", lambda e: (e["degree_u"], e["degree_v"])),
            cell(entry, "{:.0f}", lambda e: e["poles"]),
        ]
        for entry in below(entries, "net_type").values()
    ]
    return Table("Both skins of six spheres, by type of net", ["", "ms", "degree", "poles"], rows)


def points_of_conics(entries):
    """The degree reached, its bound by the theorem, and that of a projection from one point."""
    rows = []
    for name, entry in below(entries, "points_of_conics").items():
        given = arguments(name)
        case = ", ".join(str(2 * given[key]) for key in "lmn")
        degrees = (f"{entry[key]:.0f}" for key in ("degree", "bound", "projected"))
        rows.append([case, f"{milliseconds(entry):.2f}", *degrees])
    title = "Points of the conics L x^2 + M y^2 = N z^2"
    return Table(title, ["degrees of L, M, N", "ms", "degree", "bound", "by projection"], rows)


def side_by_side_row(entry, exact):
    """One way to a shape; what only a shape has is missing for bare poles."""
    if failed(entry):
        row = [entry["label"], "failed", *[""] * (len(SIDE_BY_SIDE) - 2)]
        return [*row, entry["error_message"]]

    def number(key, form, scale=1):
        return format(entry[key] / scale, form) if key in entry else "-"

    has_poles = entry["poles"] > 0
    degree = f"{entry['degree_along']:.0f} x {entry['degree_around']:.0f}"
    return [
        entry["label"],
        f"{milliseconds(entry):.2f}",
        ratio(entry, exact, milliseconds),
        degree if has_poles else "-",
        number("poles", ".0f") if has_poles else "none",
        ratio(entry, exact, lambda of: of["poles"]),
        number("deviation", ".1e"),
        number("stated_deviation", ".1e"),
        number("step_bytes", ".1f", 1000),
        read_back(entry) if "read_faces" in entry else "-",
    ]


def side_by_side(runs, title):
    """One case, ours and OpenCASCADE's; ratios are theirs over ours. Stated is the deviation that
    the maker gives: ours proven, OpenCASCADE's estimated."""
    exact = runs.get("exact")
    rows = [side_by_side_row(entry, exact) for entry in runs.values()]
    return Table(title, [*SIDE_BY_SIDE, "faces read back, mm"], rows)


def offset_side_by_side(entries, case):
    """The same for an offset; above the shapes, the poles alone."""
    whole = entries.get(f"offset_step/{case}/numbers_to_whole_faces")
    shape = f": {whole['label']}" if whole else ""
    poles = {"poles": {**whole, "label": "PN Surfaces, poles only"}} if whole else {}
    runs = {**poles, **below(entries, f"offset_case/{case}")}
    return side_by_side(runs, f"Case {case}{shape}")


def tables(entries):
    """All that have rows, in the order of a reader's interest."""
    found = [
        one_span(entries),
        many_spans(entries, "many_spans", "Canal surface along a cubic C2 B-spline"),
        many_spans(
            entries, "many_ruled_spans", "Offset of a ruled surface between cubic C2 B-splines"
        ),
        offset_steps(entries),
        points_of_conics(entries),
        net_types(entries),
        side_by_side(below(entries, "case_c1"), "Case C1: constant radius along a cubic"),
        side_by_side(below(entries, "case_c2"), "Case C2: cubic radius along a cubic"),
        *(offset_side_by_side(entries, case) for case in cases(entries, "offset_case")),
    ]
    return [table for table in found if table.rows]


def results_in(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def machine(results):
    """A sentence on what was measured on."""
    context = results["context"]
    return (
        f"{context['num_cpus']} processors of {context['mhz_per_cpu']} MHz, load"
        f" {context['load_avg'][0]:.1f} at the start; medians of wall time."
    )


def main(path):
    results = results_in(path)
    print(machine(results))
    for table in tables(medians(results)):
        print(f"\n{as_text(table)}")


if __name__ == "__main__":
    main(sys.argv[1])
