# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wheel of pnkernel: CMake compiles it, setuptools packs what CMake installs."""

import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
# Beside what scripts/build makes. Setuptools does not create the folder of its egg-info.
BUILD = ROOT / "build" / "wheel"
BUILD.mkdir(parents=True, exist_ok=True)


class CMakeBuild(build_ext):
    """Builds the modules with CMake and installs them where setuptools expects extensions."""

    def build_extension(self, extension):
        build = BUILD / "cmake"
        options = {
            "Python3_EXECUTABLE": sys.executable,
            "PN_PYTHON_DIR": ".",
            "PN_WITH_OCCT": "OFF",
            "PN_WITH_TESTS": "OFF",
            "PN_WITH_BENCHMARKS": "OFF",
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        self._run("cmake", "--preset", "release", "-B", build, *definitions)
        self._run("cmake", "--build", build, "--target", extension.name)
        folder = pathlib.Path(self.get_ext_fullpath(extension.name)).parent.resolve()
        self._run("cmake", "--install", build, "--component", "python", "--strip", "--prefix", folder)

    def _run(self, *command):
        subprocess.run(command, cwd=ROOT, check=True)


setup(
    version=ElementTree.parse(ROOT / "package.xml").getroot().findtext("{*}version"),
    ext_modules=[Extension("pnkernel", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
