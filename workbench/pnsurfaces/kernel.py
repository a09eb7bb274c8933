# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled modules, or one clear sentence when they are absent."""

import importlib
import pathlib

_ROOT = pathlib.Path(__file__).resolve().parents[2]


class KernelMissing(RuntimeError):
    """A compiled module is absent or cannot be loaded. The text tells the user what to do."""


def pnkernel():
    """The module pnkernel: curves, radius laws and exact surfaces."""
    return _load("pnkernel")


def pnocct():
    """The module pnocct: faces, shells, solids and STEP files."""
    return _load("pnocct")


def _load(name):
    remedy = f"Run scripts/build in {_ROOT} and restart FreeCAD."
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        raise KernelMissing(f"The PN Surfaces kernel is not built. {remedy}") from error
    except ImportError as error:
        sentence = f"The PN Surfaces kernel cannot be loaded ({error})."
        raise KernelMissing(f"{sentence} {remedy}") from error
