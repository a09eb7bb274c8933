# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the offset of a ruled surface: two curves or a ruled face."""

import FreeCAD
import FreeCADGui

from pnsurfaces.compat import connect
from pnsurfaces.kernel import KernelMissing
from pnsurfaces.panel import TaskPanel, load_form, title
from pnsurfaces.ruled_offset import read_curves
from pnsurfaces.selection import selected_face, selected_pair

translate = FreeCAD.Qt.translate


class RuledOffsetPanel(TaskPanel):
    """Edits the offset of a ruled surface (ruled_offset.RuledOffset)."""

    def __init__(self, feature):
        self._inputs = load_form("ruled_offset")
        super().__init__(feature, self._inputs)
        for name in ("CurveA", "CurveB", "Face"):
            self.record(name)
        connect(self._inputs.use_selection, "clicked()", self.use_selection)
        self._show_source()

    def use_selection(self):
        """Makes the current selection the two curves or the face."""
        selection = FreeCADGui.Selection.getSelectionEx()
        face = selected_face(selection)
        pair = (None, None) if face else selected_pair(selection)
        if pair is None or self.feature in [link[0] for link in (*pair, face) if link]:
            self._inputs.source.setText(
                translate("PNSurfaces", "Select two edges, wires or sketches, or one ruled face.")
            )
            return
        for name, link in zip(("CurveA", "CurveB", "Face"), (*pair, face)):
            self.assign(name, link)
        self._show_source()

    def _show_source(self):
        links = (
            [self.feature.Face] if self.feature.Face else [self.feature.CurveA, self.feature.CurveB]
        )
        titles = "<br>".join(f"<b>{title(link)}</b>" for link in links if link)
        try:
            curves = read_curves(self.feature)
            recognised = " + ".join(_description(chain) for chain in curves)
        except (ValueError, KernelMissing) as error:
            recognised = str(error)
        self._inputs.source.setText("<br>".join(filter(None, [titles, recognised])))


def _description(chain):
    degree = max(curve.Degree for curve in chain.curves)
    spans = sum(curve.NbKnots - 1 for curve in chain.curves)
    text = (
        translate("PNSurfaces", "degree {}, spans {}, closed")
        if chain.closed
        else translate("PNSurfaces", "degree {}, spans {}")
    )
    return text.format(degree, spans)
