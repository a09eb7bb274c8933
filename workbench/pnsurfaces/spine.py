# SPDX-License-Identifier: LGPL-2.1-or-later
"""From edges, wires and sketches to the spine of a canal surface."""

from typing import Any, NamedTuple

from pnsurfaces.edge_chain import read_edge_chain


class Spine(NamedTuple):
    """One curve (pnkernel.Curve), and whether it ends where it starts."""

    curve: Any
    closed: bool


def read_spine(source, names, container=None):
    """The spine made of the sub-elements `names` of `source`, as edge_chain.read_edge_chain.

    The parameter of several edges runs with their length, so that a radius law is spread evenly
    over them.
    """
    chain = read_edge_chain(source, names, container)
    return Spine(chain.kernel_curve(), chain.closed)
