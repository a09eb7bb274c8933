# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canal surface in the tree: the envelope of spheres along a spine."""

from pnsurfaces import kernel
from pnsurfaces.edge_chain import ChainError
from pnsurfaces.feature import (
    QT_TRANSLATE_NOOP,
    Base,
    FeatureBase,
    Property,
    make_feature,
    show_only,
)
from pnsurfaces.linked_shape import as_link
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    CONSTANT,
    INPUTS_OF_LAW,
    LINEAR,
    VALUES_AT_VERTICES,
    radius_law,
)
from pnsurfaces.spine import read_spine

GROUP = "Canal surface"


class CanalSurface(FeatureBase):
    """Proxy of a canal surface: a spine and the law of the radius along it."""

    inputs = (
        Property("App::PropertyLinkSub", "Spine", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Edges through the centres of the spheres")),
        Property("App::PropertyEnumeration", "RadiusLaw", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "How the radius runs along the spine"),
                 list(INPUTS_OF_LAW)),
        Property("App::PropertyLength", "Radius", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Radius, or radius at the start"),
                 1.0),
        Property("App::PropertyLength", "EndRadius", GROUP,
                 QT_TRANSLATE_NOOP("App::Property", "Radius at the end"),
                 1.0),
        Property("App::PropertyFloatList", "Radii", GROUP,
                 QT_TRANSLATE_NOOP("App::Property",
                                   "Radii at the vertices, or Bezier coefficients, in mm")),
    )

    def base(self, obj):
        return Base(kernel.pnkernel().canal_surface(*read_spheres(obj)))

    def onChanged(self, obj, name):
        # While a document is read, other properties may not be there yet.
        if name == "RadiusLaw" and not obj.Document.Restoring:
            _show_inputs_of_law(obj)


def read_spheres(obj):
    """Spine (pnkernel.Curve) and radius (pnkernel.Law) of a feature CanalSurface.

    Raises ChainError, LinkError or RadiusLawError with a sentence for the user.
    """
    if obj.Spine is None:
        raise ChainError("The spine is missing. Choose an edge, a wire or a sketch.")
    source, names = obj.Spine
    spine = read_spine(source, names, container=obj.getParentGeoFeatureGroup())
    return spine.curve, radius_law(obj, spine)


def make_canal_surface(spine, radius, distance=0, *, document=None, name="CanalSurface",
                       **properties):
    """A canal surface in the tree, computed. Lengths are millimetres or strings with a unit.

    Parameters
    ----------
    spine : document object (all its edges), (object, "Edge1") or (object, ["Edge1", "Edge2"])
    radius : number (constant), (start, end) (linear), or (law, list of radii) with the law
        "Values at vertices" or "Bezier coefficients"
    distance : signed offset, positive away from the spine
    document : the document of the spine unless given
    name : wanted internal name and label
    properties : values of further properties, such as Output="Solid" or Sides="Both sides"

    Returns the document object. A surface that cannot be computed is there all the same, as in the
    tree, with the reason in getStatusString() and the property Status.

    Raises AttributeError or TypeError for a property that does not exist or cannot have the value;
    nothing is then left in the document.
    """
    source, names = as_link(spine)
    values = {
        "Spine": (source, names),
        "Distance": distance,
        **_radius_values(radius),
        **properties,
    }
    return make_feature(CanalSurface, document or source.Document, name, values)


def _radius_values(radius):
    """The property values that a radius argument stands for."""
    if not isinstance(radius, (tuple, list)):
        return {"RadiusLaw": CONSTANT, "Radius": radius}
    first, second = radius
    if first in (VALUES_AT_VERTICES, BEZIER_COEFFICIENTS):
        return {"RadiusLaw": first, "Radii": list(second)}
    return {"RadiusLaw": LINEAR, "Radius": first, "EndRadius": second}


def _show_inputs_of_law(obj):
    show_only(obj, INPUTS_OF_LAW[obj.RadiusLaw], set().union(*INPUTS_OF_LAW.values()))
