# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of docs/ in a window of their own."""

import FreeCAD
import FreeCADGui

from pnsurfaces import resources
from pnsurfaces.compat import QtCore, QtGui, QtWidgets, connect

translate = FreeCAD.Qt.translate

# In pixels: lines of the pages are 100 characters long.
_SIZE = (900, 760)


class Pages(QtWidgets.QTextBrowser):
    """Shows pages in Markdown, with pictures no wider than itself."""

    def loadResource(self, kind, name):
        resource = super().loadResource(kind, name)
        if kind != QtGui.QTextDocument.ImageResource:
            return resource
        picture = QtGui.QPixmap(self.source().resolved(name).toLocalFile())
        width = self.viewport().width() - 2 * int(self.document().documentMargin())
        if picture.width() <= width:
            return picture
        return picture.scaledToWidth(width, QtCore.Qt.SmoothTransformation)


class Documentation(QtWidgets.QDialog):
    """Shows pages of the documentation; links lead from one to another, and back."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setWindowTitle(translate("PNSurfaces", "PN Surfaces: documentation"))
        self.setWindowIcon(QtGui.QIcon(resources.icon("PNSurfaces")))
        self.resize(*_SIZE)
        self.pages = Pages(self)
        self.pages.setOpenExternalLinks(True)
        back = QtWidgets.QPushButton(translate("PNSurfaces", "&Back"), self)
        close = QtWidgets.QPushButton(translate("PNSurfaces", "&Close"), self)
        connect(back, "clicked()", self.pages.backward)
        connect(close, "clicked()", self.accept)
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(back)
        buttons.addStretch()
        buttons.addWidget(close)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(self.pages)
        layout.addLayout(buttons)

    def show_page(self, name):
        """Shows docs/<name>."""
        self.pages.setSource(QtCore.QUrl.fromLocalFile(resources.page(name)))
        self.show()
        self.raise_()


def show_documentation(page):
    """Opens docs/<page> in the window of the documentation, and returns it."""
    window = Documentation(FreeCADGui.getMainWindow())
    window.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    window.show_page(page)
    return window
