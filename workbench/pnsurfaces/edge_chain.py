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
    """Clamped B-spline curves (Part.BSplineCurve) end to end, and whether they end at the start."""

    curves: list
    closed: bool

    def reversed(self):
        """The same chain from its end to its start."""
        curves = [curve.copy() for curve in reversed(self.curves)]
        for curve in curves:
            curve.reverse()
        return EdgeChain(curves, self.closed)

    def kernel_curve(self):
        """The chain as one pnkernel.Curve."""
        pn = kernel.pnkernel()
        converted = [_kernel_bspline(pn, curve) for curve in self.curves]
        return converted[0] if len(converted) == 1 else pn.Curve.chain(converted)


def read_edge_chain(source, names, container=None):
    """The chain of the sub-elements `names` of the document object `source`.

    No name stands for the whole object: all its edges. A single edge keeps its own parameter.
    Several edges are chained as they join, and the parameter runs with the length of each edge in
    millimetres. End points that OpenCASCADE takes for one point become equal bit for bit.
    Coordinates are those of `container` (a part or body, None for the document itself).

    Raises ChainError when there is no edge, an edge has no exact form, or the edges are no chain,
    LinkError when a sub-element does not exist any more.
    """
    edges = [
        edge
        for shape in linked_shapes(source, names, container)
        for edge in shape.Edges
        if not edge.Degenerated
    ]
    if not edges:
        raise ChainError(f"{source.Label} has no edge.")
    curves = _chain([_bspline(edge) for edge in edges])
    closed = _distance(start(curves[0]), end(curves[-1])) <= CONFUSION
    _join(curves, closed)
    return EdgeChain(curves, closed)


def start(curve):
    """The first point of a clamped curve."""
    return curve.getPole(1)


def end(curve):
    """The last point of a clamped curve."""
    return curve.getPole(curve.NbPoles)


def _bspline(edge):
    """The clamped B-spline curve that is the edge, over its range and in its direction."""
    if not isinstance(edge.Curve, _RATIONAL_CURVES):
        raise ChainError(f"An edge ({edge.Curve.TypeId}) has no exact B-spline form.")
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
    gap = min(
        _distance(p, q)
        for one, other in itertools.combinations(ends, 2)
        for p, q in itertools.product(one, other)
    )
    # Chains that touch could not be joined: their edges do not follow one another.
    if gap <= CONFUSION:
        return "The edges branch. Choose edges that form one chain."
    return f"The edges have a gap of {gap:.3g} mm. Choose edges that form one chain."


def _join(curves, closed):
    for before, after in zip(curves, curves[1:]):
        after.setPole(1, end(before))
    if closed:
        curves[-1].setPole(curves[-1].NbPoles, start(curves[0]))
    if len(curves) > 1:
        for curve in curves:
            scale = curve.length() / (curve.LastParameter - curve.FirstParameter)
            curve.setKnots([scale * (knot - curve.FirstParameter) for knot in curve.getKnots()])


def _kernel_bspline(pn, curve):
    weights = [curve.getWeights()] if curve.isRational() else []
    poles = [tuple(pole) for pole in curve.getPoles()]
    return pn.Curve.bspline(
        curve.Degree, curve.getKnots(), curve.getMultiplicities(), poles, *weights
    )


def _distance(p, q):
    return p.distanceToPoint(q)
