# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by scripts/freecad and scripts/freecadcmd: a FreeCAD home of its own for each in build/, apart
# from the user's settings, with this folder as its only addon. The addon has to find its package by
# itself: FreeCAD opens documents of installed addons only, not of packages on PYTHONPATH.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
FREECAD_USER_HOME="$build/$(basename "$0")-home"
export FREECAD_USER_HOME
mkdir -p "$FREECAD_USER_HOME/Mod"
ln -sfn "$root" "$FREECAD_USER_HOME/Mod/PNSurfaces"
