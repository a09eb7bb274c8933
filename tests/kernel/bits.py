# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that is exported of surfaces of every kind, as digests that are equal when the bits are.

`python bits.py SEED ...` prints one line for each kind and seed.
"""

import hashlib
import sys

import numpy as np
import pnkernel as pn
import pnocct
from soundness import SHAPES

LINES = ("even", "lowest_degree")
FACE_ARRAYS = ("u_knots", "u_multiplicities", "v_knots", "v_multiplicities", "poles", "weights")
CERTIFICATE = ("deviation", "trim_deviation", "precision_bits", "exact", "bidegree", "poles", "notes")


def digest(kind, seed):
    """Of one random surface: faces, certificate, limits, points, an offset and a shape."""
    entries = []
    try:
        surface = SHAPES[kind](np.random.default_rng(seed)).surface
    except pn.GeometryError as error:
        return _hash([str(error)])
    for moved in _offsets(surface):
        entries += [or_error(faces_of, moved, lines) for lines in LINES]
        entries += [or_error(part, moved) for part in (_certificate, _points, shell_of, _solid)]
    entries.append(or_error(limits_of, surface))
    return _hash(entries)


def _hash(entries):
    return hashlib.sha256(repr(entries).encode()).hexdigest()


def or_error(part, *arguments):
    """What is refused, or no solid, is part of the result: in the same words."""
    try:
        return part(*arguments)
    except (ValueError, pnocct.OcctError) as error:
        return type(error).__name__, str(error)


def _offsets(surface):
    """The surface, and another one where it has offsets."""
    yield surface
    if surface.has_offsets:
        yield surface.offset(0.125 * np.ptp(surface.bsplines()[0].poles))


def _bits(array):
    return np.asarray(array, dtype=float).tobytes()


def faces_of(surface, lines):
    return [
        [_bits(getattr(face, name)) for name in FACE_ARRAYS] + [_loops(face)]
        for face in surface.bsplines(lines)
    ]


def _loops(face):
    return [[(_bits(curve.knots), _bits(curve.poles)) for curve in loop] for loop in face.trims]


def _certificate(surface):
    certificate = surface.certificate
    return [getattr(certificate, name) for name in CERTIFICATE]


def limits_of(surface):
    return surface.regular_range


def _points(surface):
    face = surface.bsplines()[-1]
    t, v = (np.linspace(knots[0], knots[-1], 5) for knots in (face.u_knots, face.v_knots))
    return [_bits(part) for part in surface.evaluate(t, v)]


def shell_of(surface):
    return pnocct.shell(surface.bsplines())


def _solid(surface):
    return pnocct.capped_solid(surface.bsplines())


if __name__ == "__main__":
    for number in sys.argv[1:]:
        for name in SHAPES:
            print(name, number, digest(name, int(number)))
