# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples that come with the workbench: scripts that make documents.

They are made anew when they are opened, not read: so they are always in the present format, and
what a designer opens is what the script says.
"""

import contextlib
import importlib
import sys

from pnsurfaces import resources


def gallery():
    """The examples (gallery.Example in resources/examples), in the order in which they are shown."""
    with _importable():
        return importlib.import_module("gallery").EXAMPLES


def open_example(name):
    """A new document with the example `name`, such as "reflector", computed.

    Raises KeyError with the names that there are when there is no such example.
    """
    names = [example.name for example in gallery()]
    if name not in names:
        raise KeyError(f"There is no example {name!r}, but {', '.join(names)}.")
    with _importable():
        return getattr(importlib.import_module(name), f"make_{name}")()


@contextlib.contextmanager
def _importable():
    """The scripts import one another, as macros do that lie in one folder."""
    sys.path.insert(0, resources.EXAMPLES)
    try:
        yield
    finally:
        sys.path.remove(resources.EXAMPLES)
