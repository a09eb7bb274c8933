# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inputs of a feature as a value, which another thread may read."""

from types import SimpleNamespace

from pnsurfaces.linked_shape import Source

_LINK = "App::PropertyLinkSub"
_ENUMERATION = "App::PropertyEnumeration"


class FeatureInputs(SimpleNamespace):
    """The values of properties, by name. A link leads to a linked_shape.Source, not an object.

    FreeCAD's documents may be touched in its own thread only: there all is read that the document
    has to say. What is made of it needs the document no more.
    """

    def getParentGeoFeatureGroup(self):
        """None: the shapes of the sources are in the coordinates of the feature already."""
        return None


def read_inputs(obj, names):
    """The FeatureInputs of the document object `obj` with the properties `names`.

    Raises ValueError when one is a choice that there is not, as a damaged document has it.
    """
    container = obj.getParentGeoFeatureGroup()
    return FeatureInputs(**{name: _value(obj, name, container) for name in names})


def agree(inputs, others, names):
    """Whether two FeatureInputs have the same values of `names`, and links lead to the same."""
    return all(getattr(inputs, name) == getattr(others, name) for name in names)


def _value(obj, name, container):
    value = getattr(obj, name)
    if value is None and obj.getTypeIdOfProperty(name) == _ENUMERATION:
        raise ValueError(f"{name} of {obj.Label} is none of the choices it has.")
    if value is None or obj.getTypeIdOfProperty(name) != _LINK:
        return value
    source, sub_elements = value
    return Source.read(source, sub_elements, container), sub_elements
