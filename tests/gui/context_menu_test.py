# SPDX-License-Identifier: LGPL-2.1-or-later
"""The context menu of a surface in the tree."""

import FreeCADGui
import main_window
from support import GuiTest, wait_for_preview

import pnsurfaces
from pnsurfaces.compat import QtWidgets


class ContextMenu(GuiTest):
    def setUp(self):
        super().setUp()
        self.pipe = pnsurfaces.make_canal_surface(self.line, 5, name="Pipe")
        self.select(self.pipe)

    def test_edit_opens_the_panel(self):
        menu = QtWidgets.QMenu()
        self.pipe.ViewObject.Proxy.setupContextMenu(self.pipe.ViewObject, menu)
        (action,) = menu.actions()
        self.assertEqual(action.text(), "Edit Pipe")
        action.trigger()
        wait_for_preview()
        panel = self.pipe.ViewObject.Proxy.panel
        self.assertTrue(FreeCADGui.Control.activeDialog())
        main_window.cancel(panel)
        self.assert_nothing_open()

    def test_the_workbench_adds_registered_commands(self):
        added = []
        workbench = FreeCADGui.activeWorkbench()
        workbench.appendContextMenu = lambda _, names: added.extend(names)
        self.addCleanup(delattr, workbench, "appendContextMenu")
        workbench.ContextMenu("Tree")
        self.assertIn("PNSurfaces_Certificate", added)
        self.assertIn("PNSurfaces_ExportStep", added)
        self.assertLessEqual(set(added), set(FreeCADGui.listCommands()))
        FreeCADGui.Selection.clearSelection()
        added.clear()
        workbench.ContextMenu("Tree")
        self.assertEqual(added, [])
