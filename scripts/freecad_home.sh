# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by scripts/freecad and scripts/freecadcmd: a FreeCAD home of its own in build/, apart from
# the user's settings, with this folder as its only addon. The addon has to find its package by
# itself: FreeCAD opens documents of installed addons only, not of packages on PYTHONPATH.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
export FREECAD_USER_HOME="$build/freecad-home"
mkdir -p "$FREECAD_USER_HOME/Mod"
ln -sfn "$root" "$FREECAD_USER_HOME/Mod/PNSurfaces"
