# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a canal surface: spine, radius law and wall."""

import FreeCAD
import numpy as np

from pnsurfaces.canal_surface import BORE, WALL, spine_of
from pnsurfaces.compat import connect
from pnsurfaces.panel import load_form, title
from pnsurfaces.position import ARC_LENGTH
from pnsurfaces.radius_law import (
    BEZIER_COEFFICIENTS,
    EXPRESSION,
    FITTED_LAWS,
    INPUTS_OF_LAW,
    LINEAR,
    PROFILE,
    TABLE,
    VALUES_AT_VERTICES,
)
from pnsurfaces.radius_table import length_column, number_column
from pnsurfaces.spine_panel import SpinePanel, show_if

translate = FreeCAD.Qt.translate


class CanalSurfacePanel(SpinePanel):
    """Edits a canal surface (canal_surface.CanalSurface)."""

    def __init__(self, feature):
        super().__init__(feature, load_form("canal_surface"))
        for name in ("Radii", "Profile"):
            self.record(name)
        for sender, signal, slot in (
            (self._inputs.use_profile, "clicked()", self.use_profile),
            (self._inputs.RadiusLaw, "currentTextChanged(QString)", self._show_law),
            (self._inputs.Hollow, "currentTextChanged(QString)", self._show_wall),
        ):
            connect(sender, signal, slot)
        self._show_profile()
        self._show_wall()
        self._show_law()

    def read_spine(self):
        return spine_of(self.feature, *self.feature.Spine)

    def has_fixed_rows(self):
        return self.feature.RadiusLaw == VALUES_AT_VERTICES

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
        self._show_spine()
        form, law = self._inputs, self.feature.RadiusLaw
        inputs = INPUTS_OF_LAW[law]
        show_if("Radius" in inputs, form.Radius)
        show_if(law == LINEAR, form.start, form.end, form.EndRadius)
        show_if("PositionBy" in inputs, form.position_label, form.PositionBy)
        show_if(law == EXPRESSION, form.RadiusExpression)
        show_if(law == PROFILE, form.profile_label, form.profile, form.use_profile)
        show_if("Radii" in inputs, form.radii)
        show_if(law in (BEZIER_COEFFICIENTS, TABLE), form.row_buttons)
        fitted = law in FITTED_LAWS or bool(self._spine and self._spine.fits)
        show_if(fitted, form.tolerance_label, form.FitTolerance)
        if "Radii" in inputs:
            self._fit_table()
            self._show_table()

    def _fit_table(self):
        """Keeps the shape of the law when it needs another number of radii, or positions."""
        radii = self.feature.Radii or [self.feature.Radius.Value] * 2
        if self.feature.RadiusLaw == VALUES_AT_VERTICES and self._spine:
            radii = _resampled(radii, len(self._spine.curve.breaks))
        if self._joins_first_vertex():
            radii = radii[:-1] + radii[:1]
        if radii != self.feature.Radii:
            self.assign("Radii", radii)
        if self.feature.RadiusLaw == TABLE and self._spine:
            self._fit_positions(len(radii))

    def _show_table(self):
        radius = length_column(translate("PNSurfaces", "Radius"))
        if self.feature.RadiusLaw == TABLE:
            is_length = self.feature.PositionBy == ARC_LENGTH
            column = length_column if is_length else number_column
            rows = zip(self.feature.Positions, self.feature.Radii)
            self.table.show(rows, [column(translate("PNSurfaces", "Position")), radius])
        elif self.feature.RadiusLaw == BEZIER_COEFFICIENTS:
            rows = [[coefficient] for coefficient in self.feature.Radii]
            self.table.show(rows, [radius], translate("PNSurfaces", "Coefficient {}"))
        else:
            # The last vertex of a closed spine is its first one.
            count = len(self.feature.Radii) - self._joins_first_vertex()
            rows = [[value] for value in self.feature.Radii[:count]]
            self.table.show(rows, [radius], translate("PNSurfaces", "Vertex {}"))

    def _joins_first_vertex(self):
        return (
            self.feature.RadiusLaw == VALUES_AT_VERTICES
            and self._spine is not None
            and self._spine.closed
        )

    def _assign_table(self):
        radii = self.table.column(-1)
        again = radii[:1] if self._joins_first_vertex() else []
        self.assign("Radii", radii + again)
        if self.feature.RadiusLaw == TABLE:
            self.assign("Positions", self.table.column(0))


def _resampled(radii, count):
    """As many radii along the polygon through the given ones."""
    if count == len(radii):
        return radii
    return list(np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(radii)), radii))
