# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve without a polynomial form, such as an offset curve, as a C2 quintic spline."""

import FreeCAD
import numpy as np
import Part

from pnsurfaces.spline_fit import (
    Fit,
    halved_until_close,
    hermite_segments,
    measured_deviations,
    quintic_spline,
)

# Intervals to begin with: a whole turn of a conic has a knot for every fourth of it.
_FIRST_INTERVALS = 4


def fitted_curve(curve, domain, tolerance):
    """A C2 quintic spline (Part.BSplineCurve) over the domain (first, last), and its Fit.

    It has the points, slopes and bends of the curve at its knots; how far it is off between them
    is measured. Raises FitError when the curve is not smooth.
    """
    what = f"the curve {curve.TypeId}"

    def deviations(knots):
        segments = hermite_segments(knots, *_derivatives(curve, knots))
        return measured_deviations(lambda t: tuple(curve.value(t)), knots, segments)

    first_knots = np.linspace(*domain, _FIRST_INTERVALS + 1)
    knots, deviation = halved_until_close(first_knots, deviations, tolerance, what)
    return bspline_curve(knots, *_derivatives(curve, knots)), Fit(what, deviation, proven=False)


def bspline_curve(knots, values, slopes, bends):
    """The quintic spline with these derivatives (n, 3) as a Part.BSplineCurve."""
    multiplicities, poles = quintic_spline(knots, values, slopes, bends)
    spline = Part.BSplineCurve()
    vectors = [FreeCAD.Vector(*pole) for pole in poles]
    spline.buildFromPolesMultsKnots(vectors, multiplicities, list(knots), False, 5)
    return spline


def _derivatives(curve, knots):
    """Points, first and second derivatives at the knots, each (n, 3)."""
    jets = np.array([[tuple(vector) for vector in curve.getD2(knot)] for knot in knots])
    return jets[:, 0], jets[:, 1], jets[:, 2]
