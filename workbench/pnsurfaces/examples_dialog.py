# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery of examples: pictures to choose from."""

import FreeCAD

from pnsurfaces import resources
from pnsurfaces.compat import QtCore, QtGui, QtWidgets, connect
from pnsurfaces.examples import gallery

translate = FreeCAD.Qt.translate

# In pixels: three pictures side by side.
_THUMBNAIL = (220, 150)
_CELL = (250, 190)
_SIZE = (830, 700)


class ExamplesDialog(QtWidgets.QDialog):
    """Shows the examples; Open, Enter or a double-click takes the one that is selected."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setWindowTitle(translate("PNSurfaces", "PN Surfaces: examples"))
        self.setWindowIcon(QtGui.QIcon(resources.icon("PNSurfaces_Examples")))
        self.resize(*_SIZE)
        self.pictures = QtWidgets.QListWidget(self)
        self.pictures.setViewMode(QtWidgets.QListView.IconMode)
        self.pictures.setMovement(QtWidgets.QListView.Static)
        self.pictures.setResizeMode(QtWidgets.QListView.Adjust)
        self.pictures.setIconSize(QtCore.QSize(*_THUMBNAIL))
        self.pictures.setGridSize(QtCore.QSize(*_CELL))
        self.sentence = QtWidgets.QLabel(self)
        self.sentence.setWordWrap(True)
        self.buttons = QtWidgets.QDialogButtonBox(
            QtWidgets.QDialogButtonBox.Open | QtWidgets.QDialogButtonBox.Cancel, parent=self
        )
        layout = QtWidgets.QVBoxLayout(self)
        for widget in (self.pictures, self.sentence, self.buttons):
            layout.addWidget(widget)
        connect(self.pictures, "currentRowChanged(int)", self._explain)
        connect(self.pictures, "itemActivated(QListWidgetItem*)", self._take)
        connect(self.buttons, "accepted()", self.accept)
        connect(self.buttons, "rejected()", self.reject)
        for example in gallery():
            self.pictures.addItem(_item(example))
        self.pictures.setCurrentRow(0)

    def chosen(self):
        """The name of the example that is selected."""
        return gallery()[self.pictures.currentRow()].name

    def _explain(self, row):
        self.sentence.setText(translate("PNSurfaces", gallery()[row].sentence))

    def _take(self, _item):
        self.accept()


def ask_example(parent):
    """The name of the example that the user chooses, or None."""
    dialog = ExamplesDialog(parent)
    name = dialog.chosen() if dialog.exec_() else None
    dialog.deleteLater()
    return name


def _item(example):
    picture = QtGui.QPixmap(resources.page(f"images/{example.name}.png"))
    thumbnail = picture.scaled(*_THUMBNAIL, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
    return QtWidgets.QListWidgetItem(QtGui.QIcon(thumbnail), translate("PNSurfaces", example.title))
