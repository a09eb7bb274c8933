# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that shows the certificate of objects, to read, copy and save."""

import FreeCAD

from pnsurfaces import resources
from pnsurfaces.certificate_report import certificate, save_certificate
from pnsurfaces.certificate_text import as_markdown
from pnsurfaces.compat import QtCore, QtGui, QtWidgets, connect, number_of
from pnsurfaces.export_path import ask_export_path
from pnsurfaces.panel import load_form

translate = FreeCAD.Qt.translate


class CertificatePanel:
    """Shows the certificate of objects as they are when it opens or is asked to compare."""

    def __init__(self, objects):
        self.form = load_form("certificate")
        self.form.setWindowIcon(QtGui.QIcon(resources.icon("PNSurfaces_Certificate")))
        self._objects = objects
        connect(self.form.compare, "toggled(bool)", self.refresh)
        connect(self.form.copy, "clicked()", self.copy)
        connect(self.form.save, "clicked()", self.save)
        self.refresh(False)

    def refresh(self, compare):
        """Computes the certificate anew, with FreeCAD's own offset if `compare`."""
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            self._report = certificate(self._objects, compare)
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        self.form.report.setMarkdown(as_markdown(self._report))

    def copy(self):
        QtWidgets.QApplication.clipboard().setText(as_markdown(self._report))

    def save(self):
        path = ask_export_path(
            translate("PNSurfaces", "Certificate"),
            f"{self._objects[0].Label}.md",
            translate("PNSurfaces", "Markdown (*.md);;JSON (*.json)"),
        )
        try:
            if path:
                save_certificate(self._report, path)
        except OSError as error:
            QtWidgets.QMessageBox.information(self.form, "PN Surfaces", str(error))

    def getStandardButtons(self):
        return number_of(QtWidgets.QDialogButtonBox.Close)
