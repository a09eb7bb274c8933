# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said when a compiled module is there but cannot be loaded."""

import unittest
from unittest import mock

from pnsurfaces import kernel


class UnloadableKernel(unittest.TestCase):
    def test_the_reason_and_the_remedy_are_named(self):
        # A module that was linked to a library which the machine no longer has.
        reason = "libtbb.so.12: cannot open shared object file"
        for module in (kernel.pnkernel, kernel.pnocct):
            with self.subTest(module=module.__name__):
                with mock.patch("importlib.import_module", side_effect=ImportError(reason)):
                    with self.assertRaises(kernel.KernelMissing) as caught:
                        module()
                self.assertIn(f"cannot be loaded ({reason})", str(caught.exception))
                self.assertIn("scripts/build", str(caught.exception))
