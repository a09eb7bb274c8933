# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person does in the main window of FreeCAD, for tests: click, type, look."""

import pathlib
import time

import FreeCADGui
from pivy import coin

from pnsurfaces.compat import QtCore, QtGui, QtWidgets
from pnsurfaces.distance_handle import NODE_NAME as HANDLE
from pnsurfaces.singular_marks import NODE_NAME as MARKS
from pnsurfaces.sphere_marks import NODE_NAME as SPHERES
from pnsurfaces.surface_sketch import NODE_NAME as SKETCH

SCREENSHOTS = pathlib.Path(__file__).resolve().parents[2] / "build" / "screenshots"

EDIT_ROLE = QtCore.Qt.EditRole

# Time in which FreeCAD handles its pending events and paints, in milliseconds.
_SETTLING_TIME = 200

# Milliseconds between two looks, and seconds after which a test has hung.
_TICK = 10
_PATIENCE = 60


def show():
    """The main window, large enough for tree, task panel and 3D view."""
    window = FreeCADGui.getMainWindow()
    window.setGeometry(0, 0, 1200, 920)
    window.show()
    for log in ("Report view", "Python console"):
        _dock(log).hide()
    FreeCADGui.activateWorkbench("PNSurfacesWorkbench")
    settle()


def settle(milliseconds=_SETTLING_TIME):
    """Lets FreeCAD handle its events and timers for a while."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def settle_until(is_done, afterwards=_SETTLING_TIME):
    """Lets FreeCAD go on until is_done(), and then some milliseconds longer."""
    deadline = time.monotonic() + _PATIENCE
    while not is_done():
        if time.monotonic() > deadline:
            raise TimeoutError("FreeCAD's window never came to rest.")
        settle(_TICK)
    settle(afterwards)


def report_view_is_open():
    return _dock("Report view").isVisible()


def status_bar_text():
    """All that the status bar says."""
    bar = FreeCADGui.getMainWindow().statusBar()
    labels = bar.findChildren(QtWidgets.QLabel)
    return "\n".join([bar.currentMessage(), *(label.text() for label in labels)])


def type_text(widget, text):
    """Replaces the text of a widget by typing, key by key."""
    widget.setFocus()
    widget.selectAll()
    for character in text:
        press(widget, ord(character.upper()), character)


def press(widget, key, text=""):
    event = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, key, QtCore.Qt.NoModifier, text)
    QtWidgets.QApplication.sendEvent(widget, event)


def confirm(panel):
    """Enter, which is OK: the panel closes when the surface is there."""
    press(panel.form[0], QtCore.Qt.Key_Return)
    settle_until(lambda: not panel.is_busy())


def cancel(panel):
    """Escape, which is Cancel."""
    press(panel.form[0], QtCore.Qt.Key_Escape)
    settle()


def double_click_in_tree(label):
    tree, item = _tree_item(label)
    position = tree.visualItemRect(item).center()
    viewport = tree.viewport()
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    for kind, buttons in (
        (QtCore.QEvent.MouseButtonPress, left),
        (QtCore.QEvent.MouseButtonRelease, none),
        (QtCore.QEvent.MouseButtonDblClick, left),
        (QtCore.QEvent.MouseButtonRelease, none),
    ):
        event = QtGui.QMouseEvent(
            kind, position, viewport.mapToGlobal(position), left, buttons, QtCore.Qt.NoModifier
        )
        QtWidgets.QApplication.sendEvent(viewport, event)
    settle()


def hover_in_tree(label):
    """The tooltip that appears when the pointer enters an object in the tree."""
    tree, item = _tree_item(label)
    tree.itemEntered.emit(item, 0)
    return QtWidgets.QToolTip.text()


def answer_message_box(answers):
    """Closes the message box that opens next and appends its text to the list `answers`."""

    def close(box):
        answers.append(box.text())
        box.accept()

    _with_next_dialog(close)


def edit_preferences(group, edit):
    """Opens the preferences at a group, calls edit(widget_of_name) and closes them by OK."""
    failures = []

    def act(dialog):
        try:
            edit(lambda name: dialog.findChild(QtWidgets.QWidget, name))
        except Exception as error:
            # Raised in the event loop of the dialog it would not reach the test.
            failures.append(error)
        dialog.accept()

    _with_next_dialog(act)
    FreeCADGui.showPreferences(group, 0)
    if failures:
        raise failures[0]


def recorded_commands():
    """What FreeCAD has done, as a macro would record it: the commands in the Python console."""
    console = FreeCADGui.getMainWindow().findChild(QtWidgets.QPlainTextEdit, "Python console")
    lines = console.toPlainText().splitlines()
    return [line[4:] for line in lines if line.startswith(">>> ") and line[4:]]


def is_drawn(feature):
    """Whether the shape of a feature is drawn."""
    return feature.ViewObject.SwitchNode.whichChild.getValue() >= 0


def drawn_points(feature):
    """The points that are drawn instead of the shape of a feature."""
    return _points_in(_node(feature, SKETCH))


def singular_points(feature):
    """The ends of the lines to singular points, two of each, and those points again."""
    return _points_in(_node(feature, MARKS))


def sphere_radii(feature):
    """The radii of the spheres that are drawn with a feature."""
    node = _node(feature, SPHERES)
    return [ball.radius.getValue() for ball in _all_of_type(node, coin.SoSphere)] if node else []


def has_handle(feature):
    """Whether an arrow drags the distance of a feature."""
    return _node(feature, HANDLE) is not None


def handle_position(feature, along=0.0):
    """A point of the arrow, so many of its lengths from where it stands."""
    node = _node(feature, HANDLE)
    (frame,), (dragger,) = (
        _all_of_type(node, kind) for kind in (coin.SoTransform, coin.SoTranslate1Dragger)
    )
    point = coin.SbVec3f(dragger.translation.getValue()[0] + along, 0, 0)
    turned = frame.rotation.getValue().multVec(point * frame.scaleFactor.getValue()[0])
    return tuple(turned + frame.translation.getValue())


def drag_handle(feature, along):
    """Drags the arrow by so many of its lengths with the mouse."""
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    view = FreeCADGui.activeDocument().activeView()
    # Views of closed documents may still be there.
    widgets = FreeCADGui.getMainWindow().findChildren(QtWidgets.QGraphicsView)
    viewport = next(widget for widget in widgets if widget.isVisible()).viewport()

    # The view counts pixels of the screen, events those of a widget.
    scale = viewport.width() / view.getSize()[0]

    def pixel(lengths):
        x, y = view.getPointOnScreen(*handle_position(feature, lengths))
        return QtCore.QPoint(x * scale, viewport.height() - y * scale)

    grip = 0.9
    start, end = pixel(grip), pixel(grip + along)
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    for kind, place, button, buttons in (
        (QtCore.QEvent.MouseMove, start, none, none),
        (QtCore.QEvent.MouseButtonPress, start, left, left),
        (QtCore.QEvent.MouseMove, (start + end) / 2, none, left),
        (QtCore.QEvent.MouseMove, end, none, left),
        (QtCore.QEvent.MouseButtonRelease, end, left, none),
    ):
        event = QtGui.QMouseEvent(
            kind, place, viewport.mapToGlobal(place), button, buttons, QtCore.Qt.NoModifier
        )
        QtWidgets.QApplication.sendEvent(viewport, event)


def screenshot(name):
    """Keeps pictures of the whole window and of the 3D view."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    # A widget cannot grab the OpenGL part of itself, the screen can.
    window = FreeCADGui.getMainWindow()
    window.screen().grabWindow(window.winId()).save(str(SCREENSHOTS / f"{name}.png"))
    view = FreeCADGui.activeDocument().activeView()
    view.saveImage(str(SCREENSHOTS / f"{name}_3d.png"), 1200, 800, "White")


def _dock(name):
    return FreeCADGui.getMainWindow().findChild(QtWidgets.QDockWidget, name)


def _node(feature, name):
    """The node of this name that is drawn with a feature, or None."""
    nodes = feature.ViewObject.RootNode.getChildren()
    return next((node for node in nodes if node.getName() == name), None)


def _points_in(node):
    found = _all_of_type(node, coin.SoCoordinate3) if node else []
    return [tuple(point) for coordinates in found for point in coordinates.point.getValues()]


def _all_of_type(node, kind):
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(node)
    return [path.getTail() for path in search.getPaths()]


def _with_next_dialog(act):
    """Calls act(dialog) when the next modal dialog is open, which holds up its caller."""

    def look():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if dialog:
            act(dialog)
        else:
            QtCore.QTimer.singleShot(_SETTLING_TIME, look)

    QtCore.QTimer.singleShot(_SETTLING_TIME, look)


def _tree_item(label):
    for tree in FreeCADGui.getMainWindow().findChildren(QtWidgets.QTreeWidget):
        items = tree.findItems(label, QtCore.Qt.MatchRecursive | QtCore.Qt.MatchExactly)
        if items and tree.isVisible():
            return tree, items[0]
    raise LookupError(f"The tree has no {label}.")
