# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the offset of a quadric: kind, half-axes and region, or a face."""

import FreeCAD
import FreeCADGui

from pnsurfaces.compat import connect
from pnsurfaces.feature import deviation_text
from pnsurfaces.panel import TaskPanel, load_form, offer, title
from pnsurfaces.quadric_offset import (
    CHANGING,
    KINDS,
    OF_FACE,
    describe,
    read_face,
    shown_inputs,
    suitable_bounds,
)
from pnsurfaces.selection import selected_face

translate = FreeCAD.Qt.translate


class QuadricOffsetPanel(TaskPanel):
    """Edits the offset of a quadric (quadric_offset.QuadricOffset)."""

    def __init__(self, feature):
        self._inputs = load_form("quadric_offset")
        super().__init__(feature, self._inputs)
        self.record("Face")
        connect(self._inputs.use_selection, "clicked()", self.use_selection)
        connect(self._inputs.Kind, "currentTextChanged(QString)", self._show_kind)
        connect(self._inputs.Region, "currentTextChanged(QString)", self._show_inputs)
        self._offer_regions()
        self._show_inputs()

    def use_selection(self):
        """Makes the selected face the one on which the quadric lies."""
        face = selected_face(FreeCADGui.Selection.getSelectionEx())
        if face is None or face[0] == self.feature:
            self._inputs.face.setText(translate("PNSurfaces", "Select one face."))
            return
        self.assign("Face", face)
        self._show_face()

    def _show_kind(self):
        kind = KINDS.get(self.feature.Kind)
        if kind:
            if self.feature.Region not in kind.regions:
                self.assign("Region", kind.regions[0])
            for name, bound in suitable_bounds(self.feature).items():
                self.assign(name, bound)
                self.fill(getattr(self._inputs, name), name)
        self._offer_regions()
        self._show_inputs()

    def _offer_regions(self):
        """Offers the regions of the kind, and the one that there is."""
        kind, region = KINDS.get(self.feature.Kind), self.feature.Region
        regions = kind.regions if kind else ()
        combo_box = self._inputs.Region
        combo_box.blockSignals(True)
        offer(combo_box, dict.fromkeys([*regions, region]), region)
        combo_box.blockSignals(False)

    def _show_inputs(self):
        shown = shown_inputs(self.feature)
        of_face = self.feature.Kind == OF_FACE
        for name in set(CHANGING) - {"Face"}:
            for widget in (name, f"{name}_title"):
                getattr(self._inputs, widget).setVisible(name in shown)
        for widget in ("face", "face_title", "use_selection"):
            getattr(self._inputs, widget).setVisible(of_face)
        self._inputs.equation.setVisible(not of_face)
        if of_face:
            self._show_face()
        else:
            self._inputs.equation.setText(KINDS[self.feature.Kind].equation)

    def _show_face(self):
        try:
            found = read_face(self.feature)
            distance = translate("PNSurfaces", "{} away from the face")
            away = distance.format(deviation_text(found.deviation))
            recognised = f"{describe(found).capitalize()}<br>{away}"
        except ValueError as error:
            recognised = str(error)
        link = self.feature.Face
        text = f"<b>{title(link)}</b><br>{recognised}" if link else recognised
        self._inputs.face.setText(text)
