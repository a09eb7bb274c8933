# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the workbench's Python package and its built kernel on the path of FreeCAD's Python."""


def _extend_path():
    import os
    import sys

    # FreeCAD executes this file without defining __file__, with its folder already on the path.
    root = next(
        folder
        for folder in sys.path
        if os.path.isfile(os.path.join(folder, "workbench", "pnsurfaces", "__init__.py"))
    )
    for folder in (os.path.join(root, "workbench"), os.path.join(root, "build", "python")):
        if os.path.isdir(folder) and folder not in sys.path:
            sys.path.append(folder)


_extend_path()
