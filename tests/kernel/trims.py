# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trim loops as curves in the parameter plane, evaluated by their definition."""

import numpy as np
from scipy.interpolate import BSpline
from splines import flat_knots

POINTS_PER_CURVE = 400


def points(curve, count=POINTS_PER_CURVE):
    """So many points of a curve, its ends among them, as an array (count, 2)."""
    knots = flat_knots(curve.knots, curve.multiplicities)
    places = np.linspace(curve.knots[0], curve.knots[-1], count)
    return BSpline(knots, curve.poles, curve.degree)(places)


def polygon(loop):
    """The corners of a closed polygon on a loop."""
    return np.concatenate([points(curve)[:-1] for curve in loop])


def area(corners):
    """The signed area inside, positive counterclockwise."""
    x, y = corners.T
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


def winding_number(corners, point):
    """How often a polygon runs around a point."""
    arms = corners - point
    angles = np.arctan2(arms[:, 1], arms[:, 0])
    turns = np.diff(np.append(angles, angles[0]))
    return round(((turns + np.pi) % (2 * np.pi) - np.pi).sum() / (2 * np.pi))


def is_on_face(face, place):
    """Inside the loops, which have the face on their left."""
    return not face.trims or sum(winding_number(polygon(loop), place) for loop in face.trims) == 1


def places_on(face, count, random):
    """So many random places on a trimmed face."""
    corners = polygon(face.trims[0])
    low, high = corners.min(axis=0), corners.max(axis=0)
    found = []
    while len(found) < count:
        place = random.uniform(low, high)
        if is_on_face(face, place):
            found.append(place)
    return found


def points_and_normals(surface, number, curve, count=9):
    """Those of a surface along a curve of its face of this number, an array (count, 6)."""
    # Within the face in doubles: at its end the next one's parameters begin.
    places = np.clip(points(curve, count), [number, 0], [np.nextafter(number + 1, number), 1])
    return np.hstack(surface.evaluate(*places.T))


def clearance(face, place):
    """How far a place is from the loops, in parameters."""
    return min(
        (np.linalg.norm(polygon(loop) - place, axis=1).min() for loop in face.trims), default=np.inf
    )
