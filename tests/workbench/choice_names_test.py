# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every choice that a panel offers has a name in the window."""

from support import DocumentTest

from pnsurfaces.canal_surface import CanalSurface
from pnsurfaces.choice_names import CHOICES
from pnsurfaces.mid_surface_skins import MidSurfaceSkins
from pnsurfaces.mirror_wavefront import MirrorWavefront
from pnsurfaces.moving_conic_section import MovingConicSection
from pnsurfaces.quadric_offset import QuadricOffset
from pnsurfaces.ruled_offset import RuledOffset
from pnsurfaces.squared_radius_canal import SquaredRadiusCanal
from pnsurfaces.triangulated_skins import TriangulatedSkins


class ChoiceNames(DocumentTest):
    def test_all_choices_have_names(self):
        offered = set()
        for proxy in (
            CanalSurface,
            RuledOffset,
            QuadricOffset,
            MidSurfaceSkins,
            TriangulatedSkins,
            MirrorWavefront,
            MovingConicSection,
            SquaredRadiusCanal,
        ):
            obj = self.document.addObject("Part::FeaturePython", proxy.__name__)
            proxy(obj)
            for name in obj.PropertiesList:
                group = obj.getGroupOfProperty(name)
                if obj.getTypeIdOfProperty(name) == "App::PropertyEnumeration" and group != "Base":
                    offered.update(obj.getEnumerationsOfProperty(name))
        self.assertEqual(offered, set(CHOICES))
