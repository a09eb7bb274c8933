# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays of vectors, the last axis theirs."""

import numpy as np


def dot(a, b):
    return np.sum(a * b, axis=-1)


def cross(a, b):
    """Of vectors in the plane: the area between them, with its sign."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def length(a):
    return np.linalg.norm(a, axis=-1)
