# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rational functions of one parameter, span by span."""

import numpy as np


class PiecewiseRational:
    """A function of one parameter, from the spans that pnkernel gives."""

    def __init__(self, spans, domain=None):
        """`domain` is where the function is moved to, as pnkernel does with a second curve."""
        self.breaks = np.array([spans[0][0], *(last for _, last, _ in spans)])
        self._coefficients = [coefficients for _, _, coefficients in spans]
        if domain is not None:
            part = (self.breaks - self.breaks[0]) / (self.breaks[-1] - self.breaks[0])
            self.breaks = domain[0] + (domain[-1] - domain[0]) * part

    def with_derivative(self, t, inside):
        """Values and derivatives (..., dimension) at parameters (...), of the spans `inside`."""
        t, inside = np.broadcast_arrays(t, inside)
        spans = np.searchsorted(self.breaks, inside) - 1
        shape = t.shape + (self._coefficients[0].shape[1] - 1,)
        value, derivative = np.empty(shape), np.empty(shape)
        for span in np.unique(spans):
            here = spans == span
            value[here], derivative[here] = self._of_span(span, t[here])
        return value, derivative

    def _of_span(self, span, t):
        width = self.breaks[span + 1] - self.breaks[span]
        s = ((t - self.breaks[span]) / width)[:, None]
        coefficients = self._coefficients[span]
        homogeneous = bernstein(coefficients, s)
        slope = (len(coefficients) - 1) / width * bernstein(np.diff(coefficients, axis=0), s)
        value = homogeneous[:, :-1] / homogeneous[:, -1:]
        return value, (slope[:, :-1] - slope[:, -1:] * value) / homogeneous[:, -1:]


def bernstein(coefficients, s):
    """Values (n, c) of Bernstein coefficients (k + 1, c) at s (n, 1), by de Casteljau's steps."""
    rows = [row[None] for row in coefficients] or [np.zeros((1, coefficients.shape[1]))]
    while len(rows) > 1:
        rows = [(1 - s) * a + s * b for a, b in zip(rows, rows[1:])]
    return rows[0] + 0 * s
