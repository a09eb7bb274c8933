# SPDX-License-Identifier: LGPL-2.1-or-later
"""The skins of a mid-surface over a triangulation in the tree: a sphere at every point."""

import FreeCAD
import numpy as np

from pnsurfaces import kernel
from pnsurfaces.feature import QT_TRANSLATE_NOOP, SOLID, Base, FeatureBase, Property, make_feature
from pnsurfaces.mid_surface_skins import GROUP, SKINS
from pnsurfaces.slopes import estimated_slopes


class TriangulationError(ValueError):
    """The spheres and triangles do not fit together. The text is a sentence for the user."""


class TriangulatedSkins(FeatureBase):
    """Proxy of the skins of a mid-surface over a triangulation of the plane z = 0."""

    inputs = (
        Property(
            "App::PropertyVectorList",
            "Centres",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Centres of the spheres: points of the mid-surface, a graph over" " the plane z = 0",
            ),
        ),
        Property(
            "App::PropertyFloatList",
            "Radii",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Radii of the spheres in mm: half the thickness there"),
        ),
        Property(
            "App::PropertyIntegerList",
            "Triangles",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Three points of every triangle, counterclockwise seen from" " above, counted from 0",
            ),
        ),
        Property(
            "App::PropertyFloatList",
            "Slopes",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "How fast height and radius change along x, then along y, four"
                " numbers for every point; none to have them estimated",
            ),
        ),
        Property(
            "App::PropertyEnumeration",
            "Skins",
            GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Which of the two skins are made"),
            list(SKINS),
        ),
    )

    def base(self, inputs):
        if inputs.Output == SOLID:
            raise TriangulationError("Skins over a triangulation enclose no solid. Choose a surface.")
        family = read_family(inputs)
        return Base(SKINS[inputs.Skins](*family.skins), notes=tuple(family.notes))


def read_family(inputs):
    """The kernel's family over the triangulation.

    Raises TriangulationError when lists do not fit together, GeometryError as the kernel does.
    """
    centres = np.array([tuple(point) for point in inputs.Centres]).reshape(-1, 3)
    radii = np.array(inputs.Radii, dtype=float)
    if len(radii) != len(centres):
        raise TriangulationError(f"There are {len(centres)} centres, but {len(radii)} radii.")
    if len(inputs.Triangles) % 3:
        raise TriangulationError(
            f"Triangles have three points each: {len(inputs.Triangles)} is no number of points."
        )
    triangles = np.array(inputs.Triangles, dtype=np.int64).reshape(-1, 3)
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(centres):
        raise TriangulationError(f"The points of triangles are counted from 0 to {len(centres) - 1}.")
    slopes = _slopes(inputs, centres, radii, triangles)
    return kernel.pnkernel().sphere_family_powell_sabin(centres, radii, slopes, triangles)


def _slopes(inputs, centres, radii, triangles):
    """The derivatives (n, 2, 4) of (x, y, z, r) by x and y."""
    count = len(centres)
    slopes = np.zeros((count, 2, 4))
    slopes[:, 0, 0] = slopes[:, 1, 1] = 1
    if not inputs.Slopes:
        heights_and_radii = np.column_stack([centres[:, 2], radii])
        if np.isfinite(centres).all() and np.isfinite(radii).all():  # else the kernel says so
            slopes[:, :, 2:] = estimated_slopes(centres[:, :2], heights_and_radii, triangles)
        return slopes
    if len(inputs.Slopes) != 4 * count:
        raise TriangulationError(
            f"The {count} points have {4 * count} slopes, four each, not {len(inputs.Slopes)}."
        )
    slopes[:, :, 2:] = np.reshape(inputs.Slopes, (count, 2, 2))
    return slopes


def make_triangulated_skins(
    points,
    radii,
    triangles,
    distance=0,
    *,
    slopes=(),
    document=None,
    name="TriangulatedSkins",
    **properties,
):
    """The skins of a mid-surface over a triangulation in the tree, computed. Lengths are mm.

    Parameters
    ----------
    points : (n, 3), points of the mid-surface, which is a graph over the plane z = 0
    radii : (n,), half the thickness at each of them, or one number for all
    triangles : (m, 3), numbers of points, counterclockwise seen from above
    distance : signed offset of both skins, positive makes the part thicker
    slopes : (n, 2, 2), the derivatives of height and radius by x and by y; estimated when empty
    document : the active document, unless given
    name : wanted internal name and label
    properties : values of further properties, such as Skins="Outer skin"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    document = document or FreeCAD.ActiveDocument or FreeCAD.newDocument()
    values = {
        "Centres": [FreeCAD.Vector(*map(float, point)) for point in points],
        "Radii": np.broadcast_to(np.asarray(radii, dtype=float), len(points)).tolist(),
        "Triangles": np.ravel(triangles).astype(int).tolist(),
        "Slopes": np.ravel(slopes).astype(float).tolist(),
        "Distance": distance,
        **properties,
    }
    return make_feature(TriangulatedSkins, document, name, values)
