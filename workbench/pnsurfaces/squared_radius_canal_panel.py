# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a canal surface from r^2: spine and law of the squared radius."""

import FreeCAD

from pnsurfaces.panel import load_form
from pnsurfaces.radius_law_panel import LawNames, RadiusLawPanel
from pnsurfaces.radius_table import area_column
from pnsurfaces.squared_radius_canal import spine_of
from pnsurfaces.squared_radius_law import INPUTS_OF_LAW

translate = FreeCAD.Qt.translate


class SquaredRadiusCanalPanel(RadiusLawPanel):
    """Edits a canal surface from r^2 (squared_radius_canal.SquaredRadiusCanal)."""

    names = LawNames("SquaredRadiusLaw", "SquaredRadius", "SquaredRadii")
    inputs_of_law = INPUTS_OF_LAW

    def __init__(self, feature):
        super().__init__(feature, load_form("squared_radius_canal"))

    def read_spine(self):
        return spine_of(self.feature, *self.feature.Spine)

    def value_column(self):
        return area_column(translate("PNSurfaces", "Squared radius"))
