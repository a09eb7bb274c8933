# SPDX-License-Identifier: LGPL-2.1-or-later
"""Newton's method, from places that are near already."""


# Such steps give all digits from there.
NEWTON_STEPS = 8


def improved(u, v, values, derivatives):
    """The zero of the linear functions of (u, v) with these values, one for each variable.

    Their derivatives form a symmetric matrix: (uu, uv, vv).
    """
    j_uu, j_uv, j_vv = derivatives
    determinant = j_uu * j_vv - j_uv**2
    return (
        u - (j_vv * values[0] - j_uv * values[1]) / determinant,
        v - (j_uu * values[1] - j_uv * values[0]) / determinant,
    )
