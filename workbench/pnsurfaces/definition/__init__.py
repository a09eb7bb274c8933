# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far points lie from the surface that a feature is defined as, with NumPy, in doubles.

No isotropic vector, no normal of the construction and no control point takes part: a point is
compared with spheres, lines or an equation, by a module for each kind of them. Its own rounding is
some units in the last place of the coordinates, so that a bound of 1e-14 mm on a surface of 100 mm is
met, but not measured.

Where a point is off the surface by a small distance e, it is on that at distance d + e, so that the
same equation finds d + e.

A definition has `words` for the report and deviations(points, normals, distance): by how much each of
the points (n, 3) is off the surface at a distance, in mm. `normals` (n, 3), unit, tell where to begin
to look, and are not believed.
"""

from pnsurfaces.canal_surface import CanalSurface, read_bore, read_spheres
from pnsurfaces.definition.conic_sections import Ellipse, Sections, VertexConic
from pnsurfaces.definition.envelopes import Rulings, Spheres, SquaredSpheres
from pnsurfaces.definition.huygens import Huygens
from pnsurfaces.definition.piecewise_rational import PiecewiseRational
from pnsurfaces.definition.quadric import Quadric
from pnsurfaces.definition.sphere_nets import BallNet, SphereNet, SphereNets
from pnsurfaces.feature import SOLID
from pnsurfaces.mid_surface_skins import MidSurfaceSkins, read_net
from pnsurfaces.mirror_wavefront import MirrorWavefront, light_of, read_mirror
from pnsurfaces.moving_conic_section import MovingConicSection, planes_of, read_section
from pnsurfaces.quadric_form import standard_equation
from pnsurfaces.quadric_offset import KINDS, OF_FACE, QuadricOffset, half_axes, read_face
from pnsurfaces.ruled_offset import RuledOffset, read_curves
from pnsurfaces.section_law import ELLIPSE, FROM_THE_VERTEX
from pnsurfaces.spline_grid import spline_surface
from pnsurfaces.squared_radius_canal import SquaredRadiusCanal, read_squared_spheres
from pnsurfaces.triangulated_skins import TriangulatedSkins, read_family


def definition_of(obj):
    """The definition of a feature: Spheres, SquaredSpheres, Rulings, Sections, Quadric, SphereNet,
    SphereNets, BallNet or Huygens; None for another object."""
    proxy = type(getattr(obj, "Proxy", None))
    return DEFINITIONS[proxy](obj) if proxy in DEFINITIONS else None


def definitions_of(obj, count):
    """The definitions of the `count` surfaces that a feature shows, the innermost first."""
    bore = read_bore(obj) if isinstance(obj.Proxy, CanalSurface) else None
    if bore:
        return [_spheres(*bore), definition_of(obj)]
    return [definition_of(obj)] * count


def _spheres(spine, radius):
    return Spheres(PiecewiseRational(spine.spans), PiecewiseRational(radius.spans_over(spine)))


def _squared_spheres(obj):
    spine, square = read_squared_spheres(obj)
    return SquaredSpheres(PiecewiseRational(spine.spans), PiecewiseRational(square.spans_over(spine)))


def _sections(obj):
    spine, laws = read_section(obj)
    laws = [PiecewiseRational(law.spans_over(spine)) for law in laws]
    conic = _CONICS[obj.Section]
    return Sections(PiecewiseRational(spine.spans), laws, conic, **planes_of(obj))


def _rulings(obj):
    first, last = (chain.kernel_curve() for chain in read_curves(obj))
    return Rulings(PiecewiseRational(first.spans), PiecewiseRational(last.spans, first.domain))


def _quadric(obj):
    if obj.Kind == OF_FACE:
        found = read_face(obj)
        return Quadric(*standard_equation(found.kind, found.axes))
    return Quadric(*standard_equation(KINDS[obj.Kind].name, half_axes(obj)))


def _nets(obj):
    corners, spheres = read_family(obj).pieces
    # In the kernel's order: A, AB, B, CA, BC, C.
    return SphereNets(corners, [SphereNet(net[[0, 2, 5, 1, 4, 3]]) for net in spheres])


_CONICS = {ELLIPSE: Ellipse, FROM_THE_VERTEX: VertexConic}

DEFINITIONS = {
    CanalSurface: lambda obj: _spheres(*read_spheres(obj)),
    SquaredRadiusCanal: _squared_spheres,
    RuledOffset: _rulings,
    QuadricOffset: _quadric,
    MovingConicSection: _sections,
    MirrorWavefront: lambda obj: Huygens(spline_surface(read_mirror(obj).surface), light_of(obj)),
    MidSurfaceSkins: lambda obj: (BallNet if obj.Output == SOLID else SphereNet)(read_net(obj)),
    TriangulatedSkins: _nets,
}
