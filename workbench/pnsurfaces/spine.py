# SPDX-License-Identifier: LGPL-2.1-or-later
"""From edges, wires and sketches to the spine of a canal surface, without approximation."""

import itertools
from typing import Any, NamedTuple

import FreeCAD
import Part

from pnsurfaces import kernel

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


class SpineError(ValueError):
    """The edges form no spine. The text is a sentence for the user."""


class Spine(NamedTuple):
    """One curve (pnkernel.Curve), and whether it ends where it starts."""

    curve: Any
    closed: bool


def read_spine(source, names, container=None):
    """The spine made of the sub-elements `names` of the document object `source`.

    No name stands for the whole object: all its edges. A single edge keeps its own parameter.
    Several edges are chained as they join, and the parameter runs with the length of each edge in
    millimetres, so that a radius law is spread evenly over them. End points that OpenCASCADE takes
    for one point become equal bit for bit. Coordinates are those of `container` (a part or body,
    None for the document itself).

    Raises SpineError when there is no edge, an edge has no exact form, or the edges are no chain.
    """
    edges = [
        edge
        for shape in _shapes(source, names)
        for edge in _in_container(shape, source, container).Edges
        if not edge.Degenerated
    ]
    if not edges:
        raise SpineError(f"{source.Label} has no edge that could be a spine.")
    curves = _chain([_bspline(edge) for edge in edges])
    closed = _distance(_start(curves[0]), _end(curves[-1])) <= CONFUSION
    _join(curves, closed)
    return Spine(_kernel_curve(curves), closed)


def _shapes(source, names):
    shapes = [Part.getShape(source, name, needSubElement=True) for name in names or [""]]
    for name, shape in zip(names, shapes):
        if shape.isNull():
            raise SpineError(f"{source.Label} has no {name} any more.")
    return [shape for shape in shapes if not shape.isNull()]


def _in_container(shape, source, container):
    source_frame = _frame(source.getParentGeoFeatureGroup())
    target_frame = _frame(container)
    # The usual case keeps every double of the source.
    if source_frame == target_frame:
        return shape
    moved = shape.copy(False)
    moved.Placement = target_frame.inverse() * source_frame * shape.Placement
    return moved


def _frame(container):
    return container.getGlobalPlacement() if container else FreeCAD.Placement()


def _bspline(edge):
    """The clamped B-spline curve that is the edge, over its range and in its direction."""
    if not isinstance(edge.Curve, _RATIONAL_CURVES):
        kind = edge.Curve.TypeId
        raise SpineError(f"An edge of the spine ({kind}) has no exact B-spline form.")
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
        raise SpineError(_separation(chains))
    return [edge.Curve for edge in chains[0]]


def _separation(chains):
    ends = [[end(edge.Curve) for edge in chain for end in (_start, _end)] for chain in chains]
    gap = min(
        _distance(p, q)
        for one, other in itertools.combinations(ends, 2)
        for p, q in itertools.product(one, other)
    )
    # Chains that touch could not be joined: their edges do not follow one another.
    if gap <= CONFUSION:
        return "The edges of the spine branch. A spine is one chain of edges."
    return f"The edges of the spine have a gap of {gap:.3g} mm. A spine is one chain of edges."


def _join(curves, closed):
    for before, after in zip(curves, curves[1:]):
        after.setPole(1, _end(before))
    if closed:
        curves[-1].setPole(curves[-1].NbPoles, _start(curves[0]))
    if len(curves) > 1:
        for curve in curves:
            scale = curve.length() / (curve.LastParameter - curve.FirstParameter)
            curve.setKnots([scale * (knot - curve.FirstParameter) for knot in curve.getKnots()])


def _kernel_curve(curves):
    pn = kernel.pnkernel()
    converted = [_kernel_bspline(pn, curve) for curve in curves]
    return converted[0] if len(converted) == 1 else pn.Curve.chain(converted)


def _kernel_bspline(pn, curve):
    weights = [curve.getWeights()] if curve.isRational() else []
    poles = [tuple(pole) for pole in curve.getPoles()]
    return pn.Curve.bspline(
        curve.Degree, curve.getKnots(), curve.getMultiplicities(), poles, *weights
    )


def _start(curve):
    return curve.getPole(1)


def _end(curve):
    return curve.getPole(curve.NbPoles)


def _distance(p, q):
    return p.distanceToPoint(q)
