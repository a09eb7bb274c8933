# SPDX-License-Identifier: LGPL-2.1-or-later
"""The laws of a moving conic section, from the properties of a feature. Lengths are millimetres.

Its half-axes run along the spine by laws of one kind, each as the radius of a canal surface does.
"""

from types import SimpleNamespace
from typing import NamedTuple

from pnsurfaces.radius_error import RadiusLawError
from pnsurfaces.radius_law import CONSTANT, EXPRESSION, LINEAR, TABLE, radius_law

# The properties of a feature that each law reads, "{}" standing for the name of a half-axis.
INPUTS_OF_LAW = {
    CONSTANT: ("{}",),
    LINEAR: ("{}", "End{}"),
    TABLE: ("PositionBy", "Positions", "{}s"),
    EXPRESSION: ("PositionBy", "{}Expression"),
}


class HalfAxis(NamedTuple):
    """The name of a half-axis in properties, and in sentences."""

    name: str
    words: str


HALF_AXES = (
    HalfAxis("HalfWidth", "The half-axis to the side"),
    HalfAxis("HalfHeight", "The half-axis upwards"),
)


class SectionLawError(ValueError):
    """A law does not fit the spine. The text is a sentence for the user."""


def inputs_of_law(law):
    """The names of the properties that a choice of the law reads, without repetition."""
    names = [pattern.format(axis.name) for axis in HALF_AXES for pattern in INPUTS_OF_LAW[law]]
    return list(dict.fromkeys(names))


def half_axis_law(obj, axis, spine):
    """The radius_law.RadiusLaw of a HalfAxis of feature `obj` over the whole of `spine`.

    Raises SectionLawError.
    """
    name = axis.name
    inputs = SimpleNamespace(
        RadiusLaw=obj.SectionLaw,
        Radius=getattr(obj, name),
        EndRadius=getattr(obj, f"End{name}"),
        Radii=getattr(obj, f"{name}s"),
        RadiusExpression=getattr(obj, f"{name}Expression"),
        PositionBy=obj.PositionBy,
        Positions=obj.Positions,
        FitTolerance=obj.FitTolerance,
    )
    try:
        return radius_law(inputs, spine)
    except RadiusLawError as error:
        raise SectionLawError(f"{axis.words}: {error}") from error
