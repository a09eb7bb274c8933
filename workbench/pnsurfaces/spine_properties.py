# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties that every feature along a spine has: how places are named, how well fits follow."""

from pnsurfaces.feature import QT_TRANSLATE_NOOP, Property, result
from pnsurfaces.position import MEASURES
from pnsurfaces.spline_fit import FIT_TOLERANCE


def position_by(group):
    return Property(
        "App::PropertyEnumeration",
        "PositionBy",
        group,
        QT_TRANSLATE_NOOP("App::Property", "What positions on the spine count"),
        MEASURES,
    )


def fit_tolerance(group):
    # The property editor would show it as 0.00.
    return Property(
        "App::PropertyLength",
        "FitTolerance",
        group,
        QT_TRANSLATE_NOOP("App::Property", "How far a fit may be from what has no exact form"),
        FIT_TOLERANCE,
    )


FIT_DEVIATION = result(
    "App::PropertyString",
    "FitDeviation",
    QT_TRANSLATE_NOOP(
        "App::Property", "How far fits are off, part of the deviation; proven or measured"
    ),
)
