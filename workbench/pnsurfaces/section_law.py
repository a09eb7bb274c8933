# SPDX-License-Identifier: LGPL-2.1-or-later
"""The laws of a moving conic section, from the properties of a feature. Lengths are millimetres.

The quantities of its conics run along the spine by laws of one kind, each as the radius of a canal
surface does.
"""

import itertools
from types import SimpleNamespace
from typing import Any, NamedTuple

import FreeCAD
import numpy as np

from pnsurfaces.canal_surface import lengths
from pnsurfaces.radius_error import RadiusLawError
from pnsurfaces.radius_expression import LENGTH, NUMBER
from pnsurfaces.radius_law import CONSTANT, EXPRESSION, LINEAR, TABLE, fitted_expression, radius_law
from pnsurfaces.spline_grid import spread

ELLIPSE = "Ellipse"
FROM_THE_VERTEX = "From the vertex"

# The properties of a feature that each law reads of a Quantity.
INPUTS_OF_LAW = {
    CONSTANT: ("{0.name}",),
    LINEAR: ("{0.name}", "End{0.name}"),
    TABLE: ("PositionBy", "Positions", "{0.plural}"),
    EXPRESSION: ("PositionBy", "{0.name}Expression"),
}

# So many places along the spine tell how far fits move the points.
_PLACES = 257


class Quantity(NamedTuple):
    """What a conic has: its name in properties, one and many, its words in sentences, and the power
    of length that it is."""

    name: str
    plural: str
    words: str
    dimension: int


class Section(NamedTuple):
    """A way to give conics: by the quantities of the keyword `argument` of the kernel.

    `displacements` gives the Fits (spline_fit.Fit) of laws as what they move the points by, in mm.
    """

    argument: str
    quantities: tuple
    displacements: Any


class SectionLawError(ValueError):
    """A law does not fit the spine. The text is a sentence for the user."""


def inputs_of_law(section, law):
    """The names of the properties that a choice of section and law reads, without repetition."""
    names = [
        pattern.format(quantity)
        for quantity in SECTIONS[section].quantities
        for pattern in INPUTS_OF_LAW[law]
    ]
    return list(dict.fromkeys(names))


def inputs_of_all_laws():
    """The names of the properties that some choice of section and law reads."""
    choices = itertools.product(SECTIONS, INPUTS_OF_LAW)
    return set(itertools.chain.from_iterable(inputs_of_law(*choice) for choice in choices))


def section_laws(obj, spine):
    """The radius_law.RadiusLaw of each quantity of feature `obj` over the whole of `spine`.

    Raises SectionLawError.
    """
    return [_law(obj, quantity, spine) for quantity in SECTIONS[obj.Section].quantities]


def number_of_property(obj, name):
    """The value of a property as a quantity, whether or not it has a unit."""
    return FreeCAD.Units.Quantity(getattr(obj, name))


def values_of_law(section, given):
    """The property values that an argument half_axes or vertex of a script stands for.

    Raises ValueError when it has not as many quantities as the section.
    """
    quantities = SECTIONS[section].quantities
    first = given[0]
    if first == TABLE:
        _, rows = given
        positions, *columns = zip(*rows) if rows else ((), *((),) * len(quantities))
        columns = [lengths(column) for column in columns]
        return {
            "SectionLaw": TABLE,
            "Positions": lengths(positions),
            **_named("{0.plural}", quantities, columns),
        }
    if first == EXPRESSION:
        _, texts = given
        return {"SectionLaw": EXPRESSION, **_named("{0.name}Expression", quantities, texts)}
    if isinstance(first, (tuple, list)):
        _, last = given
        return {
            "SectionLaw": LINEAR,
            **_named("{0.name}", quantities, first),
            **_named("End{0.name}", quantities, last),
        }
    return {"SectionLaw": CONSTANT, **_named("{0.name}", quantities, given)}


def _named(pattern, quantities, values):
    if len(values) != len(quantities):
        words = ", ".join(quantity.words for quantity in quantities)
        raise ValueError(f"There are {len(values)} values for {words}.")
    return {pattern.format(quantity): value for quantity, value in zip(quantities, values)}


def _law(obj, quantity, spine):
    try:
        if obj.SectionLaw == EXPRESSION:
            text = getattr(obj, f"{quantity.name}Expression")
            return fitted_expression(text, obj, spine, quantity.words, quantity.dimension)
        return radius_law(_as_radius(obj, quantity), spine)
    except RadiusLawError as error:
        raise SectionLawError(f"{quantity.words.capitalize()}: {error}") from error


def _as_radius(obj, quantity):
    """The properties of a quantity under the names of those of a radius."""
    return SimpleNamespace(
        RadiusLaw=obj.SectionLaw,
        Radius=number_of_property(obj, quantity.name),
        EndRadius=number_of_property(obj, f"End{quantity.name}"),
        Radii=getattr(obj, quantity.plural),
        PositionBy=obj.PositionBy,
        Positions=obj.Positions,
    )


def _fits_of_half_axes(laws):
    """A point moves by no more than its half-axes together."""
    return [fit for law in laws for fit in law.fits]


def _fits_from_the_vertex(laws):
    """In the direction that has the cosine c to the axis, a point is rho = 2 R c / (1 + K c^2) from
    the vertex. To first order it moves by rho dR / R and rho z dK / (2 R), where z <= h and
    rho^2 = 2 R z - K z^2. By dh the end of an arc is too high or low.
    """
    t = spread(np.concatenate([law.knots for law in laws]), _PLACES)
    radius, constant, depth = (law.values(t) for law in laws)
    far = np.sqrt(2 * radius * depth + np.maximum(-constant, 0) * depth**2)
    effects = (far / radius, far * depth / (2 * radius), np.ones_like(t))
    return [
        fit._replace(deviation=fit.deviation * effect.max())
        for law, effect in zip(laws, effects)
        for fit in law.fits
    ]


SECTIONS = {
    ELLIPSE: Section(
        "half_axes",
        (
            Quantity("HalfWidth", "HalfWidths", "the half-axis to the side", LENGTH),
            Quantity("HalfHeight", "HalfHeights", "the half-axis upwards", LENGTH),
        ),
        _fits_of_half_axes,
    ),
    FROM_THE_VERTEX: Section(
        "vertex",
        (
            Quantity("Radius", "Radii", "the radius of curvature at the vertex", LENGTH),
            Quantity("ConicConstant", "ConicConstants", "the conic constant", NUMBER),
            Quantity("Depth", "Depths", "the depth", LENGTH),
        ),
        _fits_from_the_vertex,
    ),
}
