# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by the other scripts: the folders, the interpreter of FreeCAD, and the build.
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$root/build"
python=/usr/bin/python3
export PYTHONPATH="$build/python:$root/workbench${PYTHONPATH:+:$PYTHONPATH}"
export PYTHONDONTWRITEBYTECODE=1

# Configures build folder $1 with the CMake arguments that follow, once, and builds it.
build_in() {
  local folder="$1"
  shift
  if [ ! -f "$folder/build.ninja" ]; then
    cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
      -DPython3_EXECUTABLE="$python" "$@"
  fi
  cmake --build "$folder"
}

build_all() {
  "$root/scripts/setup"
  build_in "$build" -DCMAKE_BUILD_TYPE=Release
}
