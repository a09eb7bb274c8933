# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every choice that a panel offers has a name in the window."""

from support import DocumentTest, feature_classes

from pnsurfaces.choice_names import CHOICES


class ChoiceNames(DocumentTest):
    def test_all_choices_have_names(self):
        offered = set()
        for proxy in feature_classes():
            obj = self.document.addObject("Part::FeaturePython", proxy.__name__)
            proxy(obj)
            for name in obj.PropertiesList:
                group = obj.getGroupOfProperty(name)
                if obj.getTypeIdOfProperty(name) == "App::PropertyEnumeration" and group != "Base":
                    offered.update(obj.getEnumerationsOfProperty(name))
        self.assertEqual(offered, set(CHOICES))
