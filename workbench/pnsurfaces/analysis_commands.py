# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that show and hide the analysis of the selected surfaces."""

import FreeCADGui

from pnsurfaces import analysis
from pnsurfaces.command import Command
from pnsurfaces.compat import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


class AnalysisCommand(Command):
    """Shows one kind of analysis of the selected surfaces, or hides it where all show it."""

    page = "analysis_commands.md"

    def __init__(self, name, shown, menu_text, tooltip):
        self.name = name
        self.menu_text = menu_text
        self.tooltip = tooltip
        self._shown = shown

    def IsActive(self):
        return bool(selected_analyses())

    def Activated(self):
        analyses = selected_analyses()
        everywhere = all(self._shown in each.shown for each in analyses)
        for each in analyses:
            change = each.shown.difference if everywhere else each.shown.union
            each.show(change({self._shown}))


def selected_analyses():
    """The analyses (analysis.Analysis) of the selected surfaces of PN Surfaces."""
    views = [obj.ViewObject for obj in FreeCADGui.Selection.getSelection()]
    proxies = [getattr(view, "Proxy", None) for view in views]
    return [proxy.analysis for proxy in proxies if hasattr(proxy, "analysis")]


def analysis_commands():
    """The commands, in the order of the toolbar."""
    return [
        AnalysisCommand(
            "PNSurfaces_CurvatureMap",
            analysis.CURVATURE,
            QT_TRANSLATE_NOOP("PNSurfaces_CurvatureMap", "Curvature Map"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_CurvatureMap",
                "Colours the selected surfaces by their smallest radius of curvature, on and off",
            ),
        ),
        AnalysisCommand(
            "PNSurfaces_GaussMap",
            analysis.GAUSS,
            QT_TRANSLATE_NOOP("PNSurfaces_GaussMap", "Gauss Curvature Map"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_GaussMap",
                "Colours the selected surfaces by their Gauss curvature, on and off",
            ),
        ),
        AnalysisCommand(
            "PNSurfaces_Zebra",
            analysis.ZEBRA,
            QT_TRANSLATE_NOOP("PNSurfaces_Zebra", "Zebra"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_Zebra", "Shows the stripes that the selected surfaces reflect, on and off"
            ),
        ),
        AnalysisCommand(
            "PNSurfaces_Combs",
            analysis.COMBS,
            QT_TRANSLATE_NOOP("PNSurfaces_Combs", "Curvature Combs"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_Combs",
                "Shows combs of curvature along parameter lines of the selected surfaces,"
                " on and off",
            ),
        ),
        AnalysisCommand(
            "PNSurfaces_ControlNet",
            analysis.CONTROL_NET,
            QT_TRANSLATE_NOOP("PNSurfaces_ControlNet", "Control Net"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_ControlNet", "Shows the poles of the selected surfaces, on and off"
            ),
        ),
        AnalysisCommand(
            "PNSurfaces_ParameterLines",
            analysis.PARAMETER_LINES,
            QT_TRANSLATE_NOOP("PNSurfaces_ParameterLines", "Parameter Lines"),
            QT_TRANSLATE_NOOP(
                "PNSurfaces_ParameterLines",
                "Shows the parameter lines of the selected surfaces, on and off",
            ),
        ),
    ]
