# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user chose on the preferences page, and the choices before that."""

import os

import FreeCAD

from pnsurfaces.export import SCHEMAS
from pnsurfaces.feature import PARAMETER_LINES

# In the order of the boxes of resources/ui/preferences.ui, which store an index.
_PARAMETER_LINES = tuple(PARAMETER_LINES)


def distance():
    """Offset distance of a new surface, in millimetres."""
    return _parameters().GetFloat("Distance", 0.0)


def parameter_lines():
    """The choice of ParameterLines of a new surface."""
    return _PARAMETER_LINES[_parameters().GetInt("ParameterLines", 0)]


def step_schema():
    """The schema of exported STEP files: "AP203", "AP214" or "AP242"."""
    return SCHEMAS[_parameters().GetInt("StepSchema", 1)]


def step_parametric_curves():
    """Whether exported STEP files have the curves of edges in the parameters of their faces."""
    return _parameters().GetBool("StepParametricCurves", True)


def export_path(name):
    """A file of this name in the folder of the last export; the name alone before the first one."""
    return os.path.join(_parameters().GetString("ExportFolder", ""), name)


def remember_export_path(path):
    """Has the next export begin in the folder of this one."""
    _parameters().SetString("ExportFolder", os.path.dirname(path))


def _parameters():
    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/PNSurfaces")
