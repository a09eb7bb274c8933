# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that all exact surfaces share: offset, live result, one undo step."""

import FreeCAD
import FreeCADGui

from pnsurfaces import resources
from pnsurfaces.choice_names import shown_choice
from pnsurfaces.compat import QtGui, QtWidgets, connect, is_alive
from pnsurfaces.feature import SOLID, VALID
from pnsurfaces.offset_rows import NoOffsetRows, OffsetRows
from pnsurfaces.preview import Preview

translate = FreeCAD.Qt.translate

# A sentence in the narrow panel has about so many lines, and its label grows after it has it.
_LINES_OF_STATUS = 6

# How a status that opens with this word is shown, readable on light and on dark panels.
_STYLES = {"Error": "color: #e01b24", "Warning": "color: #c86400"}


def load_form(name):
    """The widget of resources/ui/<name>.ui.

    PySide 5.15 takes the Python half of a deleted widget for that of a later one at the same address,
    as long as somebody holds it. Such a form is left where it is, so that the next one lies elsewhere.
    """
    form = FreeCADGui.PySideUic.loadUi(resources.form(name))
    return form if is_alive(form) else load_form(name)


def title(link):
    """What a link property leads to, for the user: "Box, Edge1"."""
    source, names = link
    return ", ".join([source.Label, *names])


def offer(combo_box, choices, chosen):
    """Fills a box with choices, under the names that they have in the window."""
    combo_box.clear()
    combo_box.addItems([shown_choice(choice) for choice in choices])
    combo_box.setCurrentText(shown_choice(chosen))


class TaskPanel:
    """Edits a feature from opening to OK or Cancel: one undo step, or nothing left behind.

    An input widget named like a property of the feature edits that property, a result label named
    like one shows it.
    """

    def __init__(self, feature, inputs):
        """`inputs` is the form with the inputs of this kind of surface."""
        self.feature = feature
        self._result = load_form("result")
        self._offset = load_form("offset")
        self._offset_rows = (
            OffsetRows(feature, self._offset, self._result, self._drag)
            if feature.Proxy.offset_inputs
            else NoOffsetRows(self._offset, self._result)
        )
        self.limits = self._offset_rows.bar
        self.form = [inputs, self._offset, self._result]
        self._document = feature.Document
        self._was_touched = "Touched" in feature.State
        self._before = {}
        self._preview = Preview(feature, self.show_result, self._show_surface, self._settle)
        self._is_accepted = False
        connect(self._result.stop, "clicked()", self._stop)
        self._open_transaction()
        icon = QtGui.QIcon(feature.ViewObject.Proxy.getIcon())
        for form in self.form:
            form.setWindowIcon(icon)
        for form in self.form[:-1]:
            self._bind(form)
        self._offset_rows.connect(self._show_rows_of_offset)
        connect(self._offset.Output, "currentTextChanged(QString)", self._show_rows_of_offset)
        self._show_rows_of_offset()
        self.show_result()
        if self._was_touched:
            self._preview.start()
        else:
            self._preview.prepare()

    def assign(self, name, value):
        """Gives a property a value; the surface follows after a pause."""
        setattr(self.feature, name, value)
        self._offset_rows.show_distance()
        self._preview.request()

    def fill(self, spin_box, name):
        """Shows the value of a property in its box, which rounds and may not write that back."""
        spin_box.blockSignals(True)
        spin_box.setProperty("value", getattr(self.feature, name))
        spin_box.blockSignals(False)

    def record(self, name):
        """Has the property `name` in the recorded macro when it differs at the end."""
        self._before[name] = _state(self.feature, name)

    def show_result(self):
        """Shows the results of the feature, greyed when they are those of an earlier shape."""
        self._result.progress.setVisible(self._preview.is_long())
        valid = self.feature.isValid()
        status = self._status()
        kind, _, _ = status.partition(":")
        self._result.status.setText(status)
        self._result.status.setStyleSheet(_STYLES.get(kind, ""))
        if kind in _STYLES:
            _scroll_to(self._result.status)
        self._result.values.setEnabled(valid)
        for label in self._result.values.findChildren(QtWidgets.QLabel):
            if label.objectName() in self.feature.PropertiesList:
                label.setText(_display(getattr(self.feature, label.objectName())))
        self._offset_rows.show_range()
        self._offset_rows.show_distance()

    def explain(self, sentence):
        """Says what is wrong with what the user did, where the status is shown."""
        self._result.status.setText(f"Error: {sentence}")
        self._result.status.setStyleSheet(_STYLES["Error"])

    def accept(self):
        """OK: keeps the surface, once it is there. Without a surface the panel stays and says why."""
        if self._preview.is_pending():
            self._preview.start()
            self._wait_for_surface(True)
            return False
        return self._keep()

    def is_busy(self):
        """Whether the surface still has to follow the inputs."""
        return self._preview.is_pending()

    def reject(self):
        """Cancel: restores what was there when the panel opened."""
        name = self.feature.Name
        FreeCAD.closeActiveTransaction(True)
        if self._document.getObject(name):
            self._restore_state()
        FreeCADGui.getDocument(self._document.Name).resetEdit()
        return True

    def close(self):
        """Ends the live preview. The view provider calls it whatever closes the panel."""
        self._preview.close()
        self._offset_rows.close()
        for form in self.form:
            # A number box that loses the focus reports its value once more.
            for widget in form.findChildren(QtWidgets.QWidget):
                widget.blockSignals(True)

    def _show_rows_of_offset(self):
        """Shows the distances that are needed, and the caps of a solid that can have them."""
        self._offset_rows.show_rows()
        has_caps = "Caps" in self.feature.PropertiesList and self.feature.Output == SOLID
        for widget in (self._offset.caps_label, self._offset.Caps):
            widget.setVisible(has_caps)

    def _show_surface(self, made):
        self._offset_rows.place(made)
        self._offset_rows.show_distance()

    def _drag(self, distance):
        self.assign("Distance", distance)
        self.fill(self._offset.Distance, "Distance")

    def _settle(self):
        """Closes the panel if OK has waited for the surface."""
        if self._is_accepted:
            self._wait_for_surface(False)
            self._keep()

    def _stop(self):
        self._preview.stop()
        self._wait_for_surface(False)

    def _wait_for_surface(self, is_accepted):
        self._is_accepted = is_accepted
        for form in self.form[:-1]:
            form.setEnabled(not is_accepted)

    def _keep(self):
        if not self.feature.isValid():
            return False
        self._record_macro()
        FreeCAD.closeActiveTransaction()
        FreeCADGui.getDocument(self._document.Name).resetEdit()
        return True

    def _status(self):
        if self._preview.is_stopped():
            return translate("PNSurfaces", "Stopped. The surface is that of earlier values.")
        if self._preview.is_long():
            return translate("PNSurfaces", "Computing…")
        if self.feature.Status == VALID:
            return translate("PNSurfaces", "Valid")
        if self.feature.isValid():
            return self.feature.Status
        return f"Error: {self.feature.getStatusString()}"

    def _open_transaction(self):
        # The command that creates a surface has opened its own.
        if not self._document.HasPendingTransaction:
            name = translate("PNSurfaces", "Edit {}").format(self.feature.Label)
            self._document.openTransaction(name)

    def _bind(self, form):
        for widget in form.findChildren(QtWidgets.QWidget):
            name = widget.objectName()
            if name not in self.feature.PropertiesList:
                continue
            self.record(name)
            documentation = self.feature.getDocumentationOfProperty(name)
            widget.setToolTip(translate("App::Property", documentation))
            if isinstance(widget, QtWidgets.QComboBox):
                self._bind_enumeration(widget, name)
            elif isinstance(widget, QtWidgets.QCheckBox):
                self._bind_switch(widget, name)
            elif isinstance(widget, QtWidgets.QLineEdit):
                self._bind_text(widget, name)
            else:
                self._bind_quantity(widget, name)

    def _bind_enumeration(self, combo_box, name):
        choices = self.feature.getEnumerationsOfProperty(name)
        offer(combo_box, choices, getattr(self.feature, name))
        chosen = {shown_choice(choice): choice for choice in choices}
        connect(combo_box, "currentTextChanged(QString)", lambda text: self.assign(name, chosen[text]))

    def _bind_switch(self, check_box, name):
        check_box.setChecked(getattr(self.feature, name))
        connect(check_box, "toggled(bool)", lambda checked: self.assign(name, checked))

    def _bind_text(self, line_edit, name):
        line_edit.setText(getattr(self.feature, name))
        connect(line_edit, "textChanged(QString)", lambda text: self.assign(name, text))

    def _bind_quantity(self, spin_box, name):
        FreeCADGui.ExpressionBinding(spin_box).bind(self.feature, name)
        self.fill(spin_box, name)
        connect(spin_box, "valueChanged(double)", lambda value: self.assign(name, value))

    def _restore_state(self):
        if not self.feature.isValid():
            self.feature.recompute()
        if not self._was_touched:
            self.feature.purgeTouched()

    def _record_macro(self):
        document = f"App.getDocument({self._document.Name!r})"
        feature = f"{document}.getObject({self.feature.Name!r})"
        for name, (old_expression, old_value) in self._before.items():
            expression, value = _state(self.feature, name)
            if expression != old_expression:
                FreeCADGui.doCommand(f"{feature}.setExpression({name!r}, {expression!r})")
            elif value != old_value:
                FreeCADGui.doCommand(f"{feature}.{name} = {value}")
        FreeCADGui.doCommand(f"{document}.recompute()")


def _scroll_to(widget):
    """Brings a widget into view where the panel is longer than the window.

    From a widget to its parents there is no way in PySide that leaves the widget alive.
    """
    for area in FreeCADGui.getMainWindow().findChildren(QtWidgets.QScrollArea):
        if area.isAncestorOf(widget):
            area.ensureWidgetVisible(widget, 0, _LINES_OF_STATUS * widget.fontMetrics().height())


def _state(feature, name):
    """Expression of a property, or None, and its value as Python source."""
    return dict(feature.ExpressionEngine).get(name), literal(getattr(feature, name))


def literal(value):
    """Python source of the value of a property, lengths in millimetres. Tuples are pairs."""
    if isinstance(value, FreeCAD.Units.Quantity):
        return repr(value.Value)
    if isinstance(value, FreeCAD.DocumentObject):
        return f"App.getDocument({value.Document.Name!r}).getObject({value.Name!r})"
    if isinstance(value, (list, tuple)):
        items = ", ".join(literal(item) for item in value)
        return f"[{items}]" if isinstance(value, list) else f"({items})"
    return repr(value)


def _display(value):
    if isinstance(value, bool):
        return translate("PNSurfaces", "Yes") if value else translate("PNSurfaces", "No")
    if isinstance(value, FreeCAD.Units.Quantity):
        return value.UserString if value else translate("PNSurfaces", "none")
    return str(value)
