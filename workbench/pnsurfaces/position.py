# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a place on a spine is named by a number, and which parameter of the spine that is."""

from pnsurfaces.edge_chain import CONFUSION

RELATIVE_LENGTH = "Relative length"
ARC_LENGTH = "Arc length"
PARAMETER = "Parameter"
VERTEX = "Vertex"


class PositionError(ValueError):
    """A number names no place on the spine. The text is a sentence for the user."""


class _LengthMeasure:
    """Positions are lengths of the spine from its start, in units of `unit` millimetres."""

    start = 0.0

    def __init__(self, spine, unit):
        self._spine = spine
        self._unit = unit
        self.end = spine.length / unit
        self.confusion = CONFUSION / unit

    def parameter(self, position):
        return self._spine.parameter_at(position * self._unit)

    def position(self, stretch, t):
        return stretch.length_at(t) / self._unit

    def rate(self, stretch, t):
        """The derivative of the position by the parameter."""
        return stretch.velocity(t).Length / self._unit


class _ParameterMeasure:
    """Positions are shares of the spine's parameter."""

    start = 0.0
    end = 1.0
    confusion = 0.0

    def __init__(self, spine):
        self._first, self._last = spine.curve.domain

    def parameter(self, position):
        # Exactly the ends at 0 and 1.
        return self._first * (1 - position) + self._last * position

    def position(self, stretch, t):
        return (t - self._first) / (self._last - self._first)

    def rate(self, stretch, t):
        return 1 / (self._last - self._first)


class _VertexMeasure:
    """Positions are the numbers of the spine's vertices, from 1 on."""

    start = 1
    confusion = 0.0

    def __init__(self, spine):
        self._breaks = spine.curve.breaks
        self.end = len(self._breaks)

    def parameter(self, position):
        if position != int(position):
            raise PositionError(f"Position {position:.6g} is not the number of a vertex.")
        return self._breaks[int(position) - 1]

    def position(self, stretch, t):
        raise PositionError(
            "Between vertices there are no positions. Choose the position by arc length or"
            " parameter."
        )


_MEASURES = {
    RELATIVE_LENGTH: lambda spine: _LengthMeasure(spine, spine.length),
    ARC_LENGTH: lambda spine: _LengthMeasure(spine, 1.0),
    PARAMETER: _ParameterMeasure,
    VERTEX: _VertexMeasure,
}

MEASURES = list(_MEASURES)


def measure(spine, name):
    """The measure of positions on a spine.

    It has `start`, `end` and `confusion` (positions as near as that are the same), `parameter` of a
    position, and `position` and `rate` at a parameter of a stretch.
    """
    return _MEASURES[name](spine)
