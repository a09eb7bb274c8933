# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of positions and radii, typed in the user's units or pasted from a spreadsheet."""

import re
from functools import partial
from typing import Any, NamedTuple

import FreeCAD

from pnsurfaces.compat import QtCore

translate = FreeCAD.Qt.translate

# What separates the cells that a spreadsheet or a text file puts on the clipboard.
_SEPARATOR = re.compile(r"\t|;")


class Column(NamedTuple):
    """How the numbers of a column are shown, put into the editor, and read from text.

    `read` raises ValueError when the text is no such number.
    """

    title: str
    shown: Any
    edited: Any
    read: Any


def length_column(title):
    """A column of lengths in millimetres, in the user's units on the screen."""
    return _column(title, FreeCAD.Units.Length)


def area_column(title):
    """The same of areas in square millimetres."""
    return _column(title, FreeCAD.Units.Area)


def short_length_column(title):
    """A column of lengths without the unit, where there is little room."""
    return length_column(title)._replace(shown=partial(_without_unit, unit=FreeCAD.Units.Length))


def number_column(title):
    """A column of plain numbers."""
    return Column(title, lambda value: f"{value:.6g}", repr, float)


class RadiusTable(QtCore.QAbstractTableModel):
    """Rows of numbers, in millimetres where they are lengths, square millimetres where areas."""

    edited = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.rows = []
        self._columns = []
        self._row_name = "{}"
        self._names = ()

    def show(self, rows, columns, row_name="{}", names=()):
        """Replaces the table. `row_name` has a {} for the number of a row that has no name."""
        self.beginResetModel()
        self.rows = [list(row) for row in rows]
        self._columns = columns
        self._row_name = row_name
        self._names = names
        self.endResetModel()

    def column(self, index):
        """The numbers of one column."""
        return [row[index] for row in self.rows]

    def read_rows(self, text):
        """The rows in a text from the clipboard; a heading above them is left out.

        Raises ValueError when something else is no number, or there are not as many columns.
        """
        lines = [_SEPARATOR.split(line) for line in text.splitlines() if line.strip()]
        try:
            return [self._read(line) for line in lines]
        except ValueError:
            return [self._read(line) for line in lines[1:]]

    def rowCount(self, parent=QtCore.QModelIndex()):
        return len(self.rows)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return len(self._columns)

    def flags(self, index):
        return super().flags(index) | QtCore.Qt.ItemIsEditable

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        if role != QtCore.Qt.DisplayRole:
            return None
        if orientation == QtCore.Qt.Horizontal:
            return self._columns[section].title
        if section < len(self._names):
            return self._names[section]
        return self._row_name.format(section + 1)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        column, value = self._columns[index.column()], self.rows[index.row()][index.column()]
        if role == QtCore.Qt.DisplayRole:
            return column.shown(value)
        if role == QtCore.Qt.EditRole:
            return column.edited(value)
        return None

    def setData(self, index, value, role=QtCore.Qt.EditRole):
        """Takes a typed number, refuses all else."""
        try:
            number = self._columns[index.column()].read(value)
        except ValueError:
            return False
        self.rows[index.row()][index.column()] = number
        self.dataChanged.emit(index, index)
        self.edited.emit()
        return True

    def _read(self, cells):
        if len(cells) != len(self._columns):
            raise ValueError(f"There are {len(cells)} columns, not {len(self._columns)}.")
        return [column.read(cell.strip()) for column, cell in zip(self._columns, cells)]


def _column(title, unit):
    def shown(value):
        return FreeCAD.Units.Quantity(value, unit).UserString

    return Column(title, shown, partial(_in_full, unit=unit), partial(_read_quantity, unit=unit))


def _read_quantity(text, unit):
    """The value of a typed quantity. A bare number is one in the unit that is shown.

    Raises ValueError when the text is no quantity of `unit`.
    """
    quantity = FreeCAD.Units.Quantity(text)
    if quantity.Unit == unit:
        return quantity.Value
    return float(text) * _shown_unit(1, unit)[0]


def _without_unit(value, unit):
    return f"{value / _shown_unit(value, unit)[0]:.6g}"


def _in_full(value, unit):
    """All digits, in the unit that is shown."""
    factor, symbol = _shown_unit(value, unit)
    return f"{value / factor!r} {symbol}"


def _shown_unit(value, unit):
    """The unit that a value is shown in: how much it is, and its symbol."""
    _, factor, symbol = FreeCAD.Units.Quantity(value, unit).getUserPreferred()
    return factor, symbol
