# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a canal surface: spine, radius law and wall."""

import FreeCAD

from pnsurfaces.canal_surface import BORE, WALL, spine_of
from pnsurfaces.compat import connect
from pnsurfaces.panel import load_form, title
from pnsurfaces.radius_law import INPUTS_OF_LAW, PROFILE
from pnsurfaces.radius_law_panel import LawNames, RadiusLawPanel
from pnsurfaces.radius_table import length_column
from pnsurfaces.spine_panel import show_if

translate = FreeCAD.Qt.translate


class CanalSurfacePanel(RadiusLawPanel):
    """Edits a canal surface (canal_surface.CanalSurface)."""

    names = LawNames("RadiusLaw", "Radius", "Radii")
    inputs_of_law = INPUTS_OF_LAW

    def __init__(self, feature):
        super().__init__(feature, load_form("canal_surface"))
        self.record("Profile")
        for sender, signal, slot in (
            (self._inputs.use_profile, "clicked()", self.use_profile),
            (self._inputs.Hollow, "currentTextChanged(QString)", self._show_wall),
        ):
            connect(sender, signal, slot)
        self._show_profile()
        self._show_wall()

    def read_spine(self):
        return spine_of(self.feature, *self.feature.Spine)

    def value_column(self):
        return length_column(translate("PNSurfaces", "Radius"))

    def use_profile(self):
        """Makes the current selection the profile."""
        profile = self._selected(self._inputs.profile)
        if profile:
            self.assign("Profile", profile)
            self._show_profile()

    def _show_profile(self):
        profile = self.feature.Profile
        name = f"<b>{title(profile)}</b>" if profile else translate("PNSurfaces", "No profile")
        self._inputs.profile.setText(name)

    def _show_wall(self):
        form, hollow = self._inputs, self.feature.Hollow
        show_if(hollow == WALL, form.wall_label, form.WallThickness)
        show_if(hollow == BORE, form.bore_label, form.InnerRadius)

    def _show_law(self):
        super()._show_law()
        form, follows_profile = self._inputs, self.feature.RadiusLaw == PROFILE
        show_if(follows_profile, form.profile_label, form.profile, form.use_profile)
