# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt under one name in every version of FreeCAD, and without a trap of its Python binding."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    # FreeCAD 0.20 keeps the widgets in QtGui.
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets", "connect", "is_alive", "number_of"]


def connect(widget, signal, slot):
    """Connects the signal of a widget, written as in C++: "clicked()".

    Reading it as an attribute (widget.clicked) would keep the Python half of the widget for ever
    in PySide 5.15 under Python 3.11, to be mistaken for a later widget at the same address.
    """
    QtCore.QObject.connect(widget, QtCore.SIGNAL(signal), slot)


def is_alive(widget):
    """Whether Qt has deleted neither a widget nor anything in it."""
    try:
        for part in [widget, *widget.findChildren(QtCore.QObject)]:
            part.objectName()
    except RuntimeError:
        return False
    return True


def number_of(flag):
    """A flag of Qt as the number that FreeCAD's task panels return.

    In PySide6, from FreeCAD 1.0 on, flags are enumerations that int() does not take.
    """
    return flag.value if hasattr(flag, "value") else int(flag)
