# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands of the workbench have in common."""

import FreeCAD

translate = FreeCAD.Qt.translate


class Command:
    """A command of FreeCAD, with an icon of its name and a page of the documentation.

    A subclass, or an instance, has the texts of its menu entry and its tooltip, marked for
    translation in the context that its name is.
    """

    name = ""
    menu_text = ""
    tooltip = ""
    page = ""

    def GetResources(self):
        return {
            "Pixmap": self.name,
            "MenuText": self.menu_text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
            "WhatsThis": self._whats_this(),
        }

    def _whats_this(self):
        # FreeCAD shows this text as it is where the user points with Shift+F1.
        title = translate(self.name, self.menu_text).rstrip("…")
        sentence = translate(self.name, self.tooltip)
        where = translate("PNSurfaces", "More: menu PN Surfaces, Documentation, page {}.")
        return f"<p><b>{title}</b></p><p>{sentence}.</p><p>{where.format(self.page)}</p>"
