# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gauss image against the theorem of the spinor factorization, by linear algebra at 60 digits.

Take one root c of every conjugate pair of D = |M|^2 - R^2. The polynomial spinors a with
H(c) a(c) = 0 for all of these roots form a lattice of index h; a reduced basis of it is the matrix
A of the theorem, with column degrees d0 + d1 = h. The kernel reaches A by steps from root to root;
here the lattice is the null space of a linear system.
"""

import itertools

import mpmath
import numpy as np
import pnkernel as pn
import pytest
from canal import random_canal
from mpmath import mpc, mpf
from numpy.polynomial.polynomial import polyadd, polyder, polymul, polyval
from splines import in_digits, norm, surface_point

RANK_GAP = mpf(10) ** -40  # the null space is known to 60 digits less the conditioning of the roots


class SpinorLattice:
    """The Hermitian matrix H = R + M.sigma of a polynomial canal surface and the roots of its D."""

    def __init__(self, canal):
        *centre, _ = canal.spine.span_polynomials[0]
        radius, _ = canal.radius.span_polynomials[0]
        self.m = [polyder(component) for component in centre]
        self.r = polyder(radius)
        self.discriminant = -polymul(self.r, self.r)
        for component in self.m:
            self.discriminant = polyadd(self.discriminant, polymul(component, component))
        roots = mpmath.polyroots(list(in_digits(self.discriminant)[::-1]), 500, extraprec=400)
        self.upper_roots = [root for root in roots if mpmath.im(root) > 0]
        self.index = len(roots) // 2

    @property
    def has_only_simple_pairs(self):
        return len(self.upper_roots) == self.index

    def circle(self, t):
        """M and R at t."""
        return (
            np.array([polyval(t, in_digits(component)) for component in self.m]),
            polyval(t, in_digits(self.r)),
        )

    def hermitian(self, t):
        (m1, m2, m3), r = self.circle(t)
        i = mpc(0, 1)
        return np.array([[r + m3, m1 - i * m2], [m1 + i * m2, r - m3]])

    def root_choices(self):
        """One root of every pair; the first one upper, since conjugate choices are equivalent."""
        first, *others = self.upper_roots
        for choice in itertools.product(*((c, mpmath.conj(c)) for c in others)):
            yield first, *choice

    def spinors(self, choice, degree):
        """A basis of the lattice's spinors up to this degree: arrays (degree + 1, 2)."""
        rows = []
        for c in choice:
            kernel_row = max(self.hermitian(c), key=lambda row: abs(row[0]) + abs(row[1]))
            powers = [c**j for j in range(degree + 1)]
            row = [power * entry for power in powers for entry in kernel_row]
            length = mpmath.sqrt(sum(abs(x) ** 2 for x in row))
            rows.append([x / length for x in row])
        system = mpmath.matrix(rows)
        values, vectors = mpmath.eighe(system.H * system)
        return [
            np.array(vectors[:, j]).reshape(degree + 1, 2)
            for j in range(len(values))
            if values[j] < RANK_GAP
        ]

    def larger_column_degree(self, choice):
        least = next(e for e in range(self.index + 1) if self.spinors(choice, e))
        return self.index - least


def generic_canals(degrees, seeds):
    """Canal surfaces of one span whose D has no real root."""
    for degree in degrees:
        for seed in seeds:
            canal = random_canal(seed, degree)
            if SpinorLattice(canal).has_only_simple_pairs:
                yield canal


def value(spinor, t):
    return np.array([polyval(t, spinor[:, 0]), polyval(t, spinor[:, 1])])


def spinor_of(n):
    """A spinor a with n = (2 Re(conj(a0) a1), 2 Im(conj(a0) a1), |a0|^2 - |a1|^2) / |a|^2."""
    return np.array([1 + n[2], mpc(n[0], n[1])])


@pytest.mark.parametrize("degree", [2, 3, 4, 5])
def test_degree_is_that_of_the_best_lattice(degree):
    canals = list(generic_canals([degree], range(8)))
    assert canals
    for canal in canals:
        lattice = SpinorLattice(canal)
        least = min(lattice.larger_column_degree(choice) for choice in lattice.root_choices())
        assert list(canal.surface().degree) == [degree + 2 * least, 2]
        assert least == (degree - 1 + 1) // 2


@pytest.mark.parametrize(("degree", "seed"), [(3, 0), (3, 3), (5, 2), (5, 3)])
def test_lines_of_lowest_degree_are_rational_in_one_lattice(degree, seed):
    # On the faces of lowest degree the spinor of n is A(t) u with u constant along v = const: for
    # the kernel's choice of roots, and for no other, u computed by our own A does not move.
    canal = random_canal(seed, degree)
    lattice = SpinorLattice(canal)
    surface = canal.surface()
    face = surface.bsplines("lowest_degree")[0]
    assert face.u_degree == surface.degree[0]
    begin, end = (mpf(face.u_knots[i]) for i in (0, -1))
    places = [begin + (end - begin) * share for share in (mpf(0), mpf(1) / 3, mpf(4) / 5, mpf(1))]
    lines = [mpf(face.v_knots[0]) + mpf(share) for share in (0, 0.25, 0.625, 1)]
    normals = {(t, v): normal_of(canal, face, t, v) for t in places for v in lines}

    def movement(choice):
        basis = lattice.spinors(choice, lattice.index // 2)
        assert len(basis) == 2
        worst = 0
        for v in lines:
            ratios = []
            for t in places:
                a = np.transpose([value(column, t) for column in basis])
                (p, q), (r, s) = a
                x, y = spinor_of(normals[t, v])
                u = np.array([s * x - q * y, p * y - r * x])  # adj(A) a, projectively A^-1 a
                ratios.append(u / mpmath.sqrt(sum(abs(z) ** 2 for z in u)))
            worst = max(worst, *(abs(ratios[0][0] * u[1] - ratios[0][1] * u[0]) for u in ratios))
        return float(worst)

    moved = sorted(movement(choice) for choice in both_orientations(lattice))
    assert moved[0] < 1e-11
    assert moved[1] > 1e-6


def both_orientations(lattice):
    """All choices of roots, conjugate ones too: the lines of c and conj(c) are different lines."""
    for choice in lattice.root_choices():
        yield choice
        yield tuple(mpmath.conj(c) for c in choice)


def normal_of(canal, face, t, v):
    (m, _, _), _ = canal.spheres(t, 0)
    arm = surface_point(face, t, v) - m
    return arm / norm(arm)


def test_lattice_obeys_the_theorem():
    # A* H A = D K with K constant and indefinite, so that suitable real u give all of the circle.
    canal = next(generic_canals([3], range(8)))
    lattice = SpinorLattice(canal)
    basis = lattice.spinors(next(lattice.root_choices()), 1)

    def form(t):
        a = np.transpose([value(column, t) for column in basis])
        adjoint = np.vectorize(mpmath.conj, otypes=[object])(a.T)
        return adjoint @ lattice.hermitian(t) @ a / polyval(t, in_digits(lattice.discriminant))

    first = form(mpf(0))
    for t in (mpf(1) / 3, mpf(2), mpf(-7)):
        assert np.max(np.abs(form(t) - first)) < mpf(10) ** -40
    assert mpmath.re(first[0, 0] * first[1, 1] - first[0, 1] * first[1, 0]) < 0


@pytest.mark.parametrize("seed", range(6))
def test_normals_turn_once_around_their_circle(seed):
    canal = random_canal(seed, degree=1 + seed, rational=seed % 2 == 1)
    surface = canal.surface()
    begin, end = canal.spine.knots
    around = np.linspace(0, 4, 65)
    for t in np.linspace(begin, end, 5):
        _, normals = surface.evaluate(np.full(around.shape, t), around)
        (_, m1, _), (_, r1, _) = canal.spheres(mpf(t), 0)
        m1, r1 = np.array(m1, dtype=float), float(r1)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=0, atol=1e-14)
        np.testing.assert_allclose(normals @ m1 + r1, 0, rtol=0, atol=1e-13 * np.linalg.norm(m1))
        radial = normals + np.outer(np.full(len(around), r1 / (m1 @ m1)), m1)
        turns = np.cross(radial[:-1], radial[1:]) @ m1 / np.linalg.norm(m1)
        angles = np.arctan2(turns, np.sum(radial[:-1] * radial[1:], axis=1))
        assert np.all(angles > 0) or np.all(angles < 0)
        assert abs(angles.sum()) == pytest.approx(2 * np.pi, abs=1e-12)


@pytest.mark.parametrize("degree", [1, 2, 3, 4])
def test_degree_of_rational_input(degree):
    assert list(random_canal(0, degree, rational=True).surface().degree) == [3 * degree - 2, 2]


def test_no_isotropic_basis_of_low_degree():
    # M = (f, 0, c/2), R = c/2 gives H = [[c, f], [f, 0]]: with f real-rooted only column degrees
    # (h, 0) exist. f = 3 (1 + t) (2 + t) is positive on the spine and h = 2: degree k + 2 h = 7.
    f = np.array([6.0, 9, 3])
    c = np.array([0.0, 0, 0.75])  # prime to f
    poles = [np.zeros(4) for _ in range(3)]
    poles[0], poles[2] = (integral_poles(p) for p in (f, c / 2))
    radius = 3 + integral_poles(c / 2)
    surface = pn.canal_surface(pn.Curve.bezier(np.transpose(poles)), pn.Law.bezier(radius))
    assert list(surface.degree) == [7, 2]


def integral_poles(taylor):
    """The cubic Bezier coefficients of the integral from 0 of a quadratic polynomial."""
    a, b, c = taylor[0], taylor[1] / 2, taylor[2] / 3
    return np.array([0, a / 3, (2 * a + b) / 3, a + b + c])
