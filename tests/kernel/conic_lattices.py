# SPDX-License-Identifier: LGPL-2.1-or-later
"""The least degree of all points of a family of conics, by steps at single zeros with 60 digits.

Nothing here is taken from the kernel: it solves one linear system for all zeros, or takes conjugate
zeros together over Q; here each zero, or pair, changes the basis of the lattice once for each of its
conditions, and every choice of lines is tried. The rules are those of docs/rational_conic_families.md.

Polynomials are ascending arrays of Fractions, or of real numbers of mpmath; a conic is a symmetric
3 x 3 list of them.
"""

import itertools
import random
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np
from mpmath import mpf
from numpy.polynomial import polynomial as poly

DIGITS = 60
ZERO = mpf(10) ** -25  # of lines with largest coordinate 1: others are above 1e-6 or exactly zero
INDICES = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]


class NoRealPoints(Exception):
    """The conics on one side of a zero have none."""


def exact(coefficients):
    return poly.polytrim(np.array([Fraction(c) for c in coefficients], dtype=object))


def is_zero(p):
    return len(p) == 1 and p[0] == 0


def degree(p):
    return -1 if is_zero(p) else len(p) - 1


def quotient(a, b):
    return poly.polytrim(poly.polydiv(a, b)[0])


def gcd(a, b):
    while not is_zero(b):
        a, b = b / b[-1], poly.polytrim(poly.polydiv(a, b)[1]) if len(a) >= len(b) else a
    return a


def minors(c):
    return [
        [
            poly.polytrim(
                poly.polysub(poly.polymul(c[i1][j1], c[i2][j2]), poly.polymul(c[i1][j2], c[i2][j1]))
            )
            for _, j1, j2 in INDICES
        ]
        for _, i1, i2 in INDICES
    ]


def determinant(c):
    terms = [poly.polymul(a, b) for a, b in zip(c[0], minors(c)[0])]
    return poly.polytrim(poly.polyadd(poly.polyadd(terms[0], terms[1]), terms[2]))


def without_zeros_at_infinity(c):
    """The family, free of a common factor, in another parameter, and its degree kappa."""
    common = exact([0])
    for entry in itertools.chain(*c):
        common = gcd(common, entry)
    c = [[quotient(entry, common) for entry in row] for row in c]
    kappa = max(degree(entry) for entry in itertools.chain(*c))
    for number in itertools.count(1):
        top, bottom = exact([1, number]), exact([-1, number + 2])  # t = top / bottom

        def moved(p, top=top, bottom=bottom):
            total = exact([0])
            for i, coefficient in enumerate(p):
                term = poly.polymul(poly.polypow(top, i), poly.polypow(bottom, kappa - i))
                total = poly.polyadd(total, coefficient * term)
            return poly.polytrim(total)

        turned = [[moved(entry) for entry in row] for row in c]
        if degree(determinant(turned)) == 3 * kappa:
            return turned, kappa


def parts_by_multiplicity(p):
    """(squarefree p_k, k): p is a constant times the product of all p_k^k."""
    derivative = poly.polytrim(poly.polyder(p)) if len(p) > 1 else exact([0])
    rest = gcd(p, derivative)
    squarefree = quotient(p, rest)
    k = 1
    while degree(squarefree) > 0:
        following = gcd(squarefree, rest)
        yield quotient(squarefree, following), k
        squarefree, rest, k = following, quotient(rest, following), k + 1


def places(c):
    """(zero, a, b) of det C for each real zero and one of each pair, diag(1, tau^a, tau^b) there."""
    common = exact([0])
    for minor in itertools.chain(*minors(c)):
        common = gcd(common, minor)
    for part, total in parts_by_multiplicity(determinant(c)):
        a = 0
        while degree(part) > 0:
            following = gcd(part, common)
            for zero in zeros(quotient(part, following)):
                yield zero, a, total - a
            part, common, a = following, quotient(common, following), a + 1


def zeros(squarefree):
    """Real zeros as mpf, one of each pair as mpc."""
    if degree(squarefree) < 1:
        return []
    with mpmath.workdps(3 * DIGITS):  # zeros may be close to each other
        descending = [mpf(x.numerator) / x.denominator for x in squarefree[::-1]]
        found = mpmath.polyroots(descending, maxsteps=500, extraprec=12 * DIGITS)
        tiny = mpf(10) ** -DIGITS
        real = [z.real for z in found if abs(z.imag) < tiny]
        return real + [z for z in found if z.imag >= tiny]


def line_of_rank_one(matrix):
    return max(matrix, key=lambda row: max(map(abs, row)))


def lines(matrix):
    """Both lines of a conic of rank 2: M + [v]_x and M - [v]_x have rank 1, v v^T = -adj M."""
    m = matrix
    adjugate = [
        [m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1] for _, j1, j2 in INDICES]
        for _, i1, i2 in INDICES
    ]
    k = max(range(3), key=lambda i: abs(adjugate[i][i]))
    root = mpmath.sqrt(-adjugate[k][k])
    for sign in (1, -1):
        v = [-sign * adjugate[i][k] / root for i in range(3)]
        cross = [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]
        yield line_of_rank_one([[m[i][j] + cross[i][j] for j in range(3)] for i in range(3)])


def real_multiples(value, first, second):
    """Real a, b with a first + b second = value."""
    det = first.real * second.imag - first.imag * second.real
    return (
        (value.real * second.imag - value.imag * second.real) / det,
        (first.real * value.imag - first.imag * value.real) / det,
    )


def identity():
    return [[real_polynomial(int(i == j)) for j in range(3)] for i in range(3)]


def real_polynomial(*ascending):
    return np.array([mpf(x) for x in ascending], dtype=object)


def product(a, b):
    result = [[real_polynomial(0)] * 3 for _ in range(3)]
    for i, j, k in itertools.product(range(3), repeat=3):
        result[i][j] = poly.polyadd(result[i][j], poly.polymul(a[i][k], b[k][j]))
    return result


def transposed(matrix):
    return [list(row) for row in zip(*matrix)]


@dataclass
class Lattice:
    """Q = P^T C P divided by the steps so far, and the degrees of the columns of P."""

    conic: list
    degrees: list

    def at(self, zero):
        values = [[poly.polyval(zero, entry) for entry in row] for row in self.conic]
        largest = max(abs(x) for row in values for x in row)
        return [[x / largest for x in row] for row in values]

    def step(self, zero, line, divisions=1):
        """To the points with line . y = 0 at the zero, and at its conjugate; the change of basis."""
        largest = max(line, key=abs)
        line = [x / largest for x in line]
        off = [j for j in range(3) if abs(line[j]) > ZERO]
        low = min(self.degrees[j] for j in off)
        lowest = [j for j in off if self.degrees[j] == low]
        if isinstance(zero, mpmath.mpc):
            change = self._change_at_pair(zero, line, off, lowest)
            modulus = real_polynomial(abs(zero) ** 2, -2 * zero.real, 1)
        else:
            change = self._change_at_real_zero(zero, line, off, lowest)
            modulus = real_polynomial(-zero, 1)
        self.conic = product(transposed(change), product(self.conic, change))
        for _ in range(divisions):
            self.conic = [[divided(entry, modulus) for entry in row] for row in self.conic]
        return change

    def _change_at_real_zero(self, zero, line, off, lowest):
        change = identity()
        j = max(lowest, key=lambda i: abs(line[i]))
        for i in off:
            if i != j:
                change[j][i] = real_polynomial(-mpmath.re(line[i] / line[j]))
        change[j][j] = real_polynomial(-zero, 1)
        self.degrees[j] += 1
        return change

    def _change_at_pair(self, zero, line, off, lowest):
        change = identity()
        i, j = max(
            itertools.combinations(lowest * 2, 2),
            key=lambda pair: abs((line[pair[0]] * mpmath.conj(line[pair[1]])).imag),
        )
        if abs((line[i] * mpmath.conj(line[j])).imag) > ZERO:
            for k in off:
                if k not in (i, j):
                    a, b = real_multiples(line[k], line[i], line[j])
                    change[i][k], change[j][k] = real_polynomial(-a), real_polynomial(-b)
            for k in (i, j):
                a, b = real_multiples(zero * line[k], line[i], line[j])
                change[i][k], change[j][k] = real_polynomial(-a), real_polynomial(-b)
                change[k][k] = poly.polyadd(change[k][k], real_polynomial(0, 1))
                self.degrees[k] += 1
            return change
        j = max(lowest, key=lambda k: abs(line[k]))
        for k in off:
            ratio = line[k] / line[j]
            if k in lowest:
                change[j][k] = real_polynomial(-ratio.real)
            else:
                a, b = real_multiples(ratio, mpmath.mpc(1), zero)
                change[j][k] = real_polynomial(-a, -b)
        change[j][j] = real_polynomial(abs(zero) ** 2, -2 * zero.real, 1)
        self.degrees[j] += 2
        return change


def divided(p, modulus):
    if len(p) < len(modulus):
        return real_polynomial(0)
    return poly.polydiv(p, modulus)[0]


def has_real_lines(matrix):
    """By the trace of the adjugate, which is not zero at rank 2."""
    trace = sum(matrix[i][i] * matrix[j][j] - matrix[i][j] ** 2 for i, j, _ in INDICES)
    return trace < 0


def splitting(conic, zeros_with_types, kappa, choose):
    """a after all steps, with choose() = 0 or 1 for one of two lines; and m."""
    entries = [[real_polynomial(*map(real, entry)) for entry in row] for row in conic]
    lattice = Lattice(entries, [0, 0, 0])
    divisions = 0
    for zero, a, b in zeros_with_types:
        is_real = not isinstance(zero, mpmath.mpc)
        divisions += (b + a % 2) * (1 if is_real else 2)
        for _ in range(a // 2):
            lattice.step(zero, line_of_rank_one(lattice.at(zero)), divisions=2)
        b -= a // 2 * 2
        if a % 2 == 1:
            for _ in range(b):
                lattice.step(zero, line_of_rank_one(lattice.at(zero)))
            b = 1
        if b > 0 and is_real and not has_real_lines(lattice.at(zero)):
            if b % 2 == 1:
                raise NoRealPoints
            for _ in range(b // 2):
                step_onto_double_point(lattice, zero)
            continue
        for _ in range(b):
            lattice.step(zero, list(lines(lattice.at(zero)))[choose()])
    m = (divisions - kappa) // 2
    assert sum(lattice.degrees) == 3 * m
    return max(lattice.degrees) - m, m


def step_onto_double_point(lattice, zero):
    """The real and the imaginary part of one line meet there; Q is divisible after both."""
    line = next(lines(lattice.at(zero)))
    largest = max(line, key=abs)
    line = [x / largest for x in line]
    change = lattice.step(zero, [mpmath.re(x) for x in line], divisions=0)
    second = [mpmath.im(x) for x in line]
    lattice.step(
        zero,
        [sum(second[k] * poly.polyval(zero, change[k][j]) for k in range(3)) for j in range(3)],
        divisions=2,
    )


def least_degree_of_points(conic, most_choices=64):
    """(m, a) with the least a of all choices of lines, or of as many random ones if there are more.
    Raises NoRealPoints where an odd place has no real lines."""
    with mpmath.workdps(DIGITS):
        turned, kappa = without_zeros_at_infinity([[exact(entry) for entry in row] for row in conic])
        zeros_with_types = list(places(turned))
        first = []

        def count():
            first.append(0)
            return 0

        best, m = splitting(turned, zeros_with_types, kappa, count)
        if 2 ** len(first) <= most_choices:
            choices = itertools.product((0, 1), repeat=len(first))
        else:
            numbers = random.Random(1)
            choices = ([numbers.randrange(2) for _ in first] for _ in range(most_choices))
        for choice in choices:
            if best == 0:
                break
            best = min(best, splitting(turned, zeros_with_types, kappa, iter(choice).__next__)[0])
        return m, best


def real(x):
    return mpf(x.numerator) / x.denominator
