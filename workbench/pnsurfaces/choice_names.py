# SPDX-License-Identifier: LGPL-2.1-or-later
"""What choices are called in the window. In documents and scripts they keep their English names."""

import FreeCAD

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

# All values of enumerations of all features.
CHOICES = (
    QT_TRANSLATE_NOOP("PNSurfaces", "Offset"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Base and offset"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Both sides"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Two offsets"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Surface"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Solid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Even"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Lowest degree"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Flat"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Spherical"),
    QT_TRANSLATE_NOOP("PNSurfaces", "None"),
    QT_TRANSLATE_NOOP("PNSurfaces", "No"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Wall thickness"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Inner radius"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Constant"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Linear"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Values at vertices"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Bezier coefficients"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Table"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Expression"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Profile"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Relative length"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Arc length"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Parameter"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Vertex"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Both skins"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Outer skin"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Inner skin"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Perpendicular"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Parallel"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Upright"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Ellipse"),
    QT_TRANSLATE_NOOP("PNSurfaces", "From the vertex"),
    QT_TRANSLATE_NOOP("PNSurfaces", "From a point"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Ellipsoid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "One-sheet hyperboloid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Two-sheet hyperboloid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Elliptic paraboloid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Hyperbolic paraboloid"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Cylinder"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Cone"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Parabolic cylinder"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Of a face"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Whole"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Heights"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Rectangle"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Box"),
    QT_TRANSLATE_NOOP("PNSurfaces", "Sector"),
)


def shown_choice(choice):
    """The name of a choice in the language of the window."""
    return translate("PNSurfaces", choice)
