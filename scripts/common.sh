# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by the other scripts: the folders, the interpreter of FreeCAD, and the build.
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$root/build"
python=/usr/bin/python3
export PYTHONDONTWRITEBYTECODE=1
# What the compiler cache holds serves every copy of the project, with precompiled headers, too.
export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros

# Configures a preset of CMakePresets.json in folder $2, once, and builds the targets that follow.
build_preset() {
  (
    cd "$root"
    [ -f "$2/build.ninja" ] || cmake --preset "$1"
    cmake --build "$2" --target "${@:3}"
  )
}

build_all() {
  "$root/scripts/setup"
  build_preset release "$build" all
}

# What FreeCAD needs, without tests and benchmarks.
build_modules() {
  "$root/scripts/setup"
  build_preset release "$build" pnkernel pnocct
}
