# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every class of features is entered where classes are looked up by their name."""

import pathlib
import unittest

from support import feature_classes

from pnsurfaces import resources
from pnsurfaces.certificate_text import TITLES
from pnsurfaces.definition import DEFINITIONS


class FeatureClasses(unittest.TestCase):
    def test_each_has_a_definition(self):
        self.assertEqual(set(DEFINITIONS), set(feature_classes()))

    def test_each_has_a_title_in_certificates(self):
        self.assertEqual(set(TITLES), {kind.__name__ for kind in feature_classes()})

    def test_each_has_an_icon_in_the_tree(self):
        for kind in feature_classes():
            icon = pathlib.Path(resources.icon(f"PNSurfaces_{kind.__name__}"))
            self.assertTrue(icon.is_file(), icon)
