# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of FreeCAD as clamped B-splines, every pole kept."""

import Part


def clamped_bspline(surface):
    """A copy of a B-spline or Bezier surface as a clamped B-spline; None for another surface."""
    if isinstance(surface, Part.BezierSurface):
        return _of_bezier(surface)
    if not isinstance(surface, Part.BSplineSurface):
        return None
    clamped = surface.copy()
    if surface.isUPeriodic() or surface.isVPeriodic():
        clamped.setUNotPeriodic()
        clamped.setVNotPeriodic()
        # It is not periodic any more, but still without the multiple knots at its ends.
        clamped.segment(*surface.bounds())
    return clamped


def _of_bezier(bezier):
    orders = bezier.UDegree + 1, bezier.VDegree + 1
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(
        bezier.getPoles(),
        [orders[0]] * 2,
        [orders[1]] * 2,
        [0.0, 1.0],
        [0.0, 1.0],
        False,
        False,
        bezier.UDegree,
        bezier.VDegree,
        bezier.getWeights(),
    )
    return surface
