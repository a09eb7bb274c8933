# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a ruled face to the two curves between which its rulings run, without approximation."""

from typing import NamedTuple

import numpy as np
import Part

from pnsurfaces.bspline_surface import clamped_bspline
from pnsurfaces.edge_chain import CONFUSION, EdgeChain, end, start

# Points at which it is looked whether an edge runs along a side of its face.
_POINTS_OF_EDGE = 5

# The sides of a face in its parameters are met to this part of their length: OpenCASCADE's own
# parametric confusion for a face of a metre's size.
_PARAMETRIC_CONFUSION = 1e-9


class NotRuled(ValueError):
    """The face is not made of straight lines from one edge to the other. The text is a sentence."""

    code = "not_ruled"


class RuledFace(NamedTuple):
    """The curves (edge_chain.EdgeChain) of a face; its rulings join equal parameters."""

    first: EdgeChain
    last: EdgeChain


def read_ruled_face(face):
    """The two curves of a ruled face: exactly the first and the last row of its poles.

    Planes, cylinders, cones and extrusions are ruled, and B-splines of degree 1 and two poles in
    one direction.

    Raises NotRuled for other surfaces and for a face that ends along other lines.
    """
    _require_own_sides(face)
    surface = _bspline(face)
    poles, weights = surface.getPoles(), surface.getWeights()
    if surface.NbVPoles == 2:
        sides = [([row[j] for row in poles], [row[j] for row in weights]) for j in (0, -1)]
        spline = surface.UDegree, surface.getUKnots(), surface.getUMultiplicities()
    elif surface.NbUPoles == 2:
        sides = [(poles[i], weights[i]) for i in (0, -1)]
        spline = surface.VDegree, surface.getVKnots(), surface.getVMultiplicities()
    else:
        raise NotRuled(
            f"The face has degree {surface.UDegree} x {surface.VDegree}: its parameter lines are"
            " curved in both directions, so it is not ruled."
        )
    return RuledFace(*(_chain(*side, *spline) for side in sides))


def _require_own_sides(face):
    u_first, u_last, v_first, v_last = face.ParameterRange
    for edge in face.Edges:
        line, first, last = face.curveOnSurface(edge)
        points = [line.value(t) for t in np.linspace(first, last, _POINTS_OF_EDGE)]
        along_v = _run_along([point.x for point in points], u_first, u_last)
        along_u = _run_along([point.y for point in points], v_first, v_last)
        if not (along_u or along_v):
            raise NotRuled(
                "The face ends along other lines than its rulings and the curves between which"
                " they run. Choose its two edges instead."
            )


def _run_along(values, first, last):
    """Whether all parameters are the first one, or all the last one, of a range."""
    confusion = _PARAMETRIC_CONFUSION * (last - first)
    return any(all(abs(v - side) <= confusion for v in values) for side in (first, last))


def _bspline(face):
    """The clamped B-spline surface that is the face, over its range."""
    converted = face.toNurbs().Faces[0]
    surface = clamped_bspline(converted.Surface)
    if surface is None:
        raise NotRuled(f"The face ({face.Surface.TypeId}) has no exact B-spline form.")
    if surface.bounds() != converted.ParameterRange:
        surface.segment(*converted.ParameterRange)
    return surface


def _chain(poles, weights, degree, knots, multiplicities):
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(poles, multiplicities, knots, False, degree, weights)
    closed = start(curve).distanceToPoint(end(curve)) <= CONFUSION
    if closed:
        curve.setPole(curve.NbPoles, start(curve))
    return EdgeChain([curve], closed)
