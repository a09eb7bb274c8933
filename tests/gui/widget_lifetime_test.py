# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forms of panels, loaded where earlier ones have been.

This is the last of the tests: what it leaves in PySide must not meet the widgets of others.
"""

from support import GuiTest

from pnsurfaces.compat import QtCore, QtWidgets, is_alive
from pnsurfaces.panel import load_form

ROUNDS = 30


class FormTest(GuiTest):
    def test_a_form_is_alive_though_the_halves_of_deleted_ones_are_held(self):
        held = []
        for _ in range(ROUNDS):
            form = load_form("canal_surface")
            self.assertTrue(is_alive(form))
            held += [form, *form.findChildren(QtWidgets.QWidget)]
            _delete(form)
            self.assertFalse(is_alive(form))


def _delete(widget):
    """As FreeCAD deletes the form of a panel: in C++, whatever Python holds."""
    widget.deleteLater()
    QtCore.QCoreApplication.sendPostedEvents(widget, QtCore.QEvent.DeferredDelete)
