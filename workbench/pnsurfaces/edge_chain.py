# SPDX-License-Identifier: LGPL-2.1-or-later
"""From edges, wires and sketches to a chain of curves, without approximation."""

import itertools
from typing import NamedTuple

import Part

from pnsurfaces import kernel
from pnsurfaces.linked_shape import linked_shapes

# Two points nearer than this, in millimetres, are one point to OpenCASCADE (its "confusion").
CONFUSION = 1e-7

# The curves that have an exact B-spline form, polynomial or rational.
_RATIONAL_CURVES = (
    Part.Line,
    Part.Circle,
    Part.Ellipse,
    Part.Hyperbola,
    Part.Parabola,
    Part.BezierCurve,
    Part.BSplineCurve,
)


class ChainError(ValueError):
    """The edges form no chain. The text is a sentence for the user."""


class EdgeChain(NamedTuple):
    """Clamped B-spline curves (Part.BSplineCurve) end to end, and whether they end at the start.

    `fits` (spline_fit.Fit) are those of the edges that have no exact form.
    """

    curves: list
    closed: bool
    fits: tuple = ()

    def reversed(self):
        """The same chain from its end to its start."""
        curves = [curve.copy() for curve in reversed(self.curves)]
        for curve in curves:
            curve.reverse()
        return self._replace(curves=curves)

    def kernel_curve(self):
        """The chain as one pnkernel.Curve."""
        pn = kernel.pnkernel()
        converted = [_kernel_bspline(pn, curve) for curve in self.curves]
        return converted[0] if len(converted) == 1 else pn.Curve.chain(converted)


def exact_curve(edge):
    """The edge as a clamped B-spline curve, over its range and in its direction; and no Fit.

    Raises ChainError when the edge has no exact form.
    """
    if not has_exact_form(edge):
        raise ChainError(f"An edge ({edge.Curve.TypeId}) has no exact B-spline form.")
    return _bspline(edge), None


def has_exact_form(edge):
    """Whether the curve of an edge is a polynomial or rational one."""
    return isinstance(edge.Curve, _RATIONAL_CURVES)


def read_edge_chain(source, names, container=None, curve_of=exact_curve):
    """The chain of the sub-elements `names` of the document object `source`.

    No name stands for the whole object: all its edges. A single edge keeps its own parameter.
    Several edges are chained as they join, and the parameter runs with the length of each edge in
    millimetres. End points that OpenCASCADE takes for one point become equal bit for bit.
    Coordinates are those of `container` (a part or body, None for the document itself).
    `curve_of` turns an edge into its curve and a Fit or None.

    Raises ChainError when there is no edge, an edge has no length or no curve, or the edges are no
    chain, LinkError when a sub-element does not exist any more.
    """
    edges = [
        edge
        for shape in linked_shapes(source, names, container)
        for edge in shape.Edges
        if not edge.Degenerated
    ]
    if not edges:
        raise ChainError(f"{source.Label} has no edge.")
    for edge in edges:
        _require_length(edge, source)
    curves, fits = zip(*(curve_of(edge) for edge in edges))
    curves = _chain(list(curves))
    closed = _distance(start(curves[0]), end(curves[-1])) <= CONFUSION
    _join(curves, closed)
    return EdgeChain(curves, closed, tuple(fit for fit in fits if fit))


def place(point):
    """A point as text, for sentences."""
    return f"({point.x:.6g}, {point.y:.6g}, {point.z:.6g})"


def start(curve):
    """The first point of a clamped curve."""
    return curve.getPole(1)


def end(curve):
    """The last point of a clamped curve."""
    return curve.getPole(curve.NbPoles)


def _require_length(edge, source):
    if edge.Length <= CONFUSION:
        raise ChainError(
            f"An edge of {source.Label} near {place(edge.valueAt(edge.FirstParameter))} has no"
            f" length ({edge.Length:.2g} mm). Remove it."
        )


def _bspline(edge):
    # BSplineCurve.toBSpline would fit circles with 1e-8; this keeps them exact.
    converted = edge.toNurbs().Edges[0]
    curve = converted.Curve
    bounds = (curve.FirstParameter, curve.LastParameter)
    if bounds != converted.ParameterRange or curve.isPeriodic():
        curve.segment(*converted.ParameterRange)
    if isinstance(curve, Part.BezierCurve):
        curve = _of_bezier(curve)
    if converted.Orientation == "Reversed":
        curve.reverse()
    return curve


def _of_bezier(bezier):
    # BezierCurve.toBSpline would round the poles.
    order = bezier.Degree + 1
    weights = bezier.getWeights()
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(
        bezier.getPoles(), [order, order], [0.0, 1.0], False, bezier.Degree, weights
    )
    return curve


def _chain(curves):
    """The curves in the order and direction in which they join, from the first one's side."""
    if len(curves) == 1:
        return curves
    chains = Part.sortEdges([curve.toShape() for curve in curves])
    if len(chains) > 1:
        raise ChainError(_separation(chains))
    return [edge.Curve for edge in chains[0]]


def _separation(chains):
    ends = [[at(edge.Curve) for edge in chain for at in (start, end)] for chain in chains]
    gap, p, q = min(
        (
            (_distance(p, q), p, q)
            for one, other in itertools.combinations(ends, 2)
            for p, q in itertools.product(one, other)
        ),
        key=lambda found: found[0],
    )
    # Chains that touch could not be joined: their edges do not follow one another.
    if gap <= CONFUSION:
        meeting = sum(_distance(p, other) <= CONFUSION for other in itertools.chain(*ends))
        return (
            f"The edges branch: {meeting} edges meet at {place(p)}."
            " Choose edges that form one chain."
        )
    return (
        f"The edges have a gap of {gap:.3g} mm, from {place(p)} to {place(q)}."
        " Choose edges that form one chain."
    )


def _join(curves, closed):
    for before, after in zip(curves, curves[1:]):
        after.setPole(1, end(before))
    if closed:
        curves[-1].setPole(curves[-1].NbPoles, start(curves[0]))
    if len(curves) > 1:
        lay_end_to_end(curves, [curve.length() / _range(curve) for curve in curves])


def lay_end_to_end(curves, factors):
    """Scales the parameter of each curve by a factor and starts it where the one before ends.

    The knots are those of the whole chain, so that none is rounded any more when it is put
    together: a curve that is C2 over its knots stays so.
    """
    first = 0.0
    for curve, factor in zip(curves, factors):
        begin = curve.FirstParameter
        curve.setKnots([first + factor * (knot - begin) for knot in curve.getKnots()])
        first = curve.LastParameter


def _range(curve):
    return curve.LastParameter - curve.FirstParameter


def _kernel_bspline(pn, curve):
    weights = [curve.getWeights()] if curve.isRational() else []
    poles = [tuple(pole) for pole in curve.getPoles()]
    return pn.Curve.bspline(curve.Degree, curve.getKnots(), curve.getMultiplicities(), poles, *weights)


def _distance(p, q):
    return p.distanceToPoint(q)
