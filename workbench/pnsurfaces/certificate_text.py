# SPDX-License-Identifier: LGPL-2.1-or-later
"""A certificate as Markdown, for the panel and for files."""

# What a class of features is called for the user.
TITLES = {
    "CanalSurface": "canal surface",
    "MidSurfaceSkins": "skins of a mid-surface",
    "MirrorWavefront": "wavefront of a mirror",
    "MovingConicSection": "surface of a moving conic section",
    "RuledOffset": "offset of a ruled surface",
    "QuadricOffset": "offset of a quadric",
    "SquaredRadiusCanal": "canal surface from r²",
    "TriangulatedSkins": "skins over a triangulation",
}

# What is known of them; None where there is no range of distances to look in.
_SINGULAR_POINTS = {True: "none, proved", False: "not excluded", None: "not looked for"}


def as_markdown(report):
    """The Markdown text of what certificate_report.certificate returned."""
    parts = [_of_object(entry) for entry in report["objects"]]
    head = f"# Certificate\n\n{report['program']}, PN Surfaces, {report['date']}. Lengths in mm."
    return "\n\n".join([head, *parts]) + "\n"


def _of_object(entry):
    title = f"## {_escaped(entry['label'])}"
    if "answer" in entry:
        return f"{title}\n\n{_escaped(entry['answer'])}"
    kind = TITLES.get(entry["kind"], entry["kind"])
    sides = f", {entry['sides'].lower()}" if entry["sides"] else ""
    shown = f"{kind}{sides}, as {entry['output'].lower()}"
    rows = [
        ("Status", _escaped(entry["status"])),
        ("Exact", "yes: rounding to doubles is all that deviates" if entry["exact"] else "no"),
        ("Regular distances", _regular_distances(entry["regular_range"])),
        *(("Fitted", _escaped(note)) for note in entry["fitted"]),
        *_rows_of_fits(entry),
        *_rows_of_shape(entry["shape"]),
    ]
    parts = [title, f"{shown[0].upper()}{shown[1:]}.", _table(("Object", ""), rows)]
    return "\n\n".join([*parts, *map(_of_section, entry["sections"])])


def _regular_distances(limits):
    return "none: these surfaces have no exact offsets" if limits is None else _range(*limits)


def _rows_of_fits(entry):
    """What fits add to the deviation of each section, if there are any."""
    if entry["fit_deviation"]:
        rounding = max(section["deviation"] for section in entry["sections"])
        yield "Deviation by fits", f"{entry['fit_deviation']:.2g} mm"
        yield "Deviation in all", f"{entry['fit_deviation'] + rounding:.2g} mm"


def _rows_of_shape(shape):
    yield "Shape", shape["type"]
    yield "Faces", str(shape["faces"])
    yield "Faults", _escaped("; ".join(shape["faults"])) or "none"
    yield "Area", f"{_measure(shape['area'])} mm²"
    if "volume" in shape:
        yield "Volume", f"{_measure(shape['volume'])} mm³"


def _of_section(section):
    sampling = section["sampling"]
    rows = [
        ("Proven deviation", f"{section['deviation']:.2g} mm"),
        ("Degree", _degree(section)),
        ("Faces, poles", f"{section['faces']}, {section['poles']}"),
        ("Exact", "yes" if section["exact"] else "no"),
        ("Singular points", _SINGULAR_POINTS[section["regular"]]),
        ("Cut edges", _trims(section["trim_deviation"])),
        ("Working precision", f"{section['precision_bits']} bits"),
        (
            "Sampled",
            f"{sampling['points']} points, worst {sampling['worst']:.2g} mm"
            f" (own rounding {sampling['rounding']:.1g} mm)",
        ),
        ("Sampled against", sampling["against"]),
        *(("Note", _escaped(note)) for note in section["notes"]),
        *_rows_of_comparison(section),
    ]
    return _table((f"At {section['distance']:.10g} mm", ""), rows)


def _rows_of_comparison(section):
    offset = section.get("freecad_offset")
    if offset is None:
        return
    if "fails" in offset:
        yield "FreeCAD's own offset", f"fails: {_escaped(offset['fails'])}"
        return
    ratio = offset["poles"] / section["poles"]
    yield "FreeCAD's own offset", (
        f"degree {_degree(offset)}, {offset['poles']} poles"
        f" ({ratio:.3g} times as many), worst deviation {offset['deviation']:.2g} mm"
        f" at {offset['points']} points"
    )


def _degree(entry):
    return "{} × {}".format(*entry["bidegree"])


def _range(low, high):
    if low is not None and high is not None and low >= high:
        return "none is proved"
    low_text = "−∞" if low is None else f"{low:.7g}"
    high_text = "∞" if high is None else f"{high:.7g}"
    return f"{low_text} to {high_text} mm, proved"


def _trims(deviation):
    return f"within {deviation:.2g} mm of the boundary, measured" if deviation else "none"


def _measure(measure):
    return f"{measure['value']:.12g} ± {measure['error']:.1g}"


def _table(head, rows):
    lines = [head, ("---", "---"), *rows]
    return "\n".join(f"| {left} | {right} |" for left, right in lines)


def _escaped(text):
    """Text of a user in which no sign is taken for Markdown."""
    for sign in "\\`*_{}[]<>#|":
        text = text.replace(sign, f"\\{sign}")
    return " ".join(text.split())
