# SPDX-License-Identifier: LGPL-2.1-or-later
"""The skins of a mid-surface in the tree: a quadratic triangle of spheres, and its envelope."""

import FreeCAD
import numpy as np

from pnsurfaces import kernel
from pnsurfaces.feature import QT_TRANSLATE_NOOP, SOLID, Base, FeatureBase, Property, make_feature
from pnsurfaces.linked_shape import as_link, linked_shapes
from pnsurfaces.several_surfaces import SeveralSurfaces

GROUP = "Mid-surface"

BOTH_SKINS = "Both skins"

# The surfaces of a family (outer, inner) that each choice shows.
SKINS = {
    BOTH_SKINS: lambda outer, inner: SeveralSurfaces([inner, outer]),
    "Outer skin": lambda outer, inner: outer,
    "Inner skin": lambda outer, inner: inner,
}

# A net has so many spheres: the corners A, B, C, then those between A and B, B and C, C and A.
SPHERES = 6

# The same in the order of the kernel: b200, b110, b020, b101, b011, b002.
_KERNEL_ORDER = (0, 3, 1, 5, 4, 2)

# The corners between which the last three lie.
_SIDES = ((0, 1), (1, 2), (2, 0))


class NetError(ValueError):
    """The spheres are no net. The text is a sentence for the user."""


class MidSurfaceSkins(FeatureBase):
    """Proxy of the skins of a mid-surface with a thickness: six spheres."""

    inputs = (
        Property(
            "App::PropertyLinkSub",
            "Points",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Three or six vertices in place of the centres: the corners"
                " first, then those between them",
            ),
        ),
        Property(
            "App::PropertyVectorList",
            "Centres",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Centres of the spheres A, B, C, AB, BC, CA: the control points" " of the mid-surface",
            ),
        ),
        Property(
            "App::PropertyFloatList",
            "Radii",
            GROUP,
            QT_TRANSLATE_NOOP(
                "App::Property", "Radii of the spheres in mm: half the thickness, as control" " values"
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
        family = kernel.pnkernel().sphere_family(read_net(inputs)[list(_KERNEL_ORDER)])
        surface = _boundary(inputs, family) if inputs.Output == SOLID else _skins(inputs, family)
        return Base(surface, notes=tuple(family.notes))

    def has_same_base(self, inputs, others):
        return super().has_same_base(inputs, others) and inputs.Output == others.Output


def _skins(inputs, family):
    return SKINS[inputs.Skins](*family.skins)


def _boundary(inputs, family):
    """The skins with what closes them: strips along the edges, parts of the corner spheres."""
    if inputs.Skins != BOTH_SKINS:
        raise NetError("One skin encloses no solid. Choose both skins, or a surface.")
    return family.solid()


def read_net(inputs):
    """The six spheres (6, 4), centre and radius, in the order A, B, C, AB, BC, CA.

    Raises NetError when there are not as many points or radii, LinkError when a vertex is gone.
    """
    centres = _centres(inputs)
    radii = list(inputs.Radii)
    if len(radii) != SPHERES:
        raise NetError(f"A net has {SPHERES} radii, not {len(radii)}.")
    return np.column_stack([centres, radii])


def _centres(inputs):
    points = _linked_points(inputs) if inputs.Points else [tuple(p) for p in inputs.Centres]
    if len(points) == len(_SIDES):
        corners = np.array(points)
        return np.vstack([corners, [(corners[i] + corners[j]) / 2 for i, j in _SIDES]])
    if len(points) != SPHERES:
        raise NetError(
            f"A net has 6 points, or its 3 corners, not {len(points)}. Choose the corners first, then"
            " the points between them."
        )
    return np.array(points)


def _linked_points(inputs):
    source, names = inputs.Points
    container = inputs.getParentGeoFeatureGroup()
    shapes = linked_shapes(source, names, container)
    return [tuple(vertex.Point) for shape in shapes for vertex in shape.Vertexes]


def make_mid_surface_skins(
    points, radii, distance=0, *, document=None, name="MidSurfaceSkins", **properties
):
    """The skins of a mid-surface in the tree, computed. Lengths are millimetres.

    Parameters
    ----------
    points : the net of the quadratic mid-surface: six points A, B, C, AB, BC, CA, corners first, or
        the three corners of a flat one; or (object, ["Vertex1", ...]) with as many vertices
    radii : half the thickness at each of the six, as control values, or one number for all
    distance : signed offset of both skins, positive makes the part thicker
    document : the document of the vertices, or the active one, unless given
    name : wanted internal name and label
    properties : values of further properties, such as Skins="Outer skin" or Output="Solid", the
        union of all balls, rounded along its edges

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError, TypeError or ValueError for a property that does not exist or cannot have
    the value; nothing is then left in the document.
    """
    if _is_link(points):
        link = as_link(points)
        document = document or link[0].Document
        source = {"Points": link}
    else:
        document = document or FreeCAD.ActiveDocument or FreeCAD.newDocument()
        source = {"Centres": [FreeCAD.Vector(*point) for point in points]}
    values = {
        **source,
        "Radii": list(np.broadcast_to(np.asarray(radii, dtype=float), SPHERES)),
        "Distance": distance,
        **properties,
    }
    return make_feature(MidSurfaceSkins, document, name, values)


def _is_link(points):
    first = points[0] if isinstance(points, (tuple, list)) else points
    return isinstance(first, FreeCAD.DocumentObject)
