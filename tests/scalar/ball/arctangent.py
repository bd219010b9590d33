#!/usr/bin/python3
"""Write scalar/ball/arctangent_table.hpp, relations between the angles of the
Gaussian primes, without any code of Libration.

    /usr/bin/python3 tests/scalar/ball_arctangent.py    (under a second)

needs Debian's python3-mpmath (1.2.1), no network.

A relation is an integer vector v whose angle, the sum of v_j arg p_j, is
small and positive. Short vectors of the lattices
    (weight_j v_j) and 2^k (sum of v_j arg p_j),    k = 1, 2, ...
found by LLL, their sums and differences are candidates [Johansson2022]; from
those with an angle within a factor of sqrt 2 of 2^-1, 2^-3, 2^-5, ..., the
one with the smallest product of |p_j|^|v_j| is kept. The weight of p_j is
log2 |p_j|, but small for 1+i, whose square is 2i and costs nothing.
"""
import itertools
import math
import pathlib

from mpmath import mp, mpf, atan, nint

PRIMES = [(1, 1), (1, 2), (2, 3), (1, 4), (2, 5), (1, 6), (4, 5), (2, 7),
          (5, 6), (3, 8), (5, 8), (4, 9), (1, 10)]
BITS = 200                  # of the angles here
COARSE, FINE = 61, 97       # units 2^-61 and 2^-97 of the two tables
ROWS, COARSE_ROWS = 35, 22
HERE = pathlib.Path(__file__).resolve().parent
HEADER = HERE.parents[1] / 'include/libration/scalar/ball_arctangent_table.hpp'

mp.prec = BITS + 100
ANGLES = [int(nint(atan(mpf(b) / a) * 2**BITS)) for a, b in PRIMES]
COST = [0.1] + [math.log2(a * a + b * b) / 2 for a, b in PRIMES[1:]]
WEIGHTS = [2] + [round(16 * cost) for cost in COST[1:]]


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def lll(basis):
    """A reduced basis, in integers alone: Gram determinants d, and lam[i][j]
    = d[j+1] mu_ij."""
    n = len(basis)
    d = [1] + [0] * n
    lam = [[0] * n for _ in range(n)]
    for k in range(n):
        for j in range(k + 1):
            u = dot(basis[k], basis[j])
            for i in range(j):
                u = (d[i + 1] * u - lam[k][i] * lam[j][i]) // d[i]
            if j < k:
                lam[k][j] = u
            else:
                d[k + 1] = u

    def reduce(k, j):
        q = (2 * lam[k][j] + d[j + 1]) // (2 * d[j + 1])
        if q:
            basis[k] = [a - q * b for a, b in zip(basis[k], basis[j])]
            lam[k][j] -= q * d[j + 1]
            for i in range(j):
                lam[k][i] -= q * lam[j][i]

    k = 1
    while k < n:
        reduce(k, k - 1)
        mu = lam[k][k - 1]
        if 100 * d[k + 1] * d[k - 1] >= 99 * d[k]**2 - 100 * mu**2:
            for j in range(k - 2, -1, -1):
                reduce(k, j)
            k += 1
            continue
        basis[k], basis[k - 1] = basis[k - 1], basis[k]
        for j in range(k - 1):
            lam[k][j], lam[k - 1][j] = lam[k - 1][j], lam[k][j]
        swapped = (d[k - 1] * d[k + 1] + mu * mu) // d[k]
        for i in range(k + 1, n):
            t = lam[i][k]
            lam[i][k] = (d[k + 1] * lam[i][k - 1] - mu * t) // d[k]
            lam[i][k - 1] = (swapped * t + mu * lam[i][k]) // d[k + 1]
        d[k] = swapped
        k = max(1, k - 1)
    return basis


def candidates(most):
    """{vector: angle}, angles > 0 in units 2^-BITS."""
    n = len(PRIMES)
    vectors = [tuple(int(i == j) for j in range(n)) for i in range(n)]
    found = {}
    for k in range(1, most):
        basis = lll([[w * x for w, x in zip(WEIGHTS, v)]
                     + [dot(v, ANGLES) >> (BITS - k)] for v in vectors])
        vectors = [tuple(x // w for x, w in zip(row, WEIGHTS)) for row in basis]
        pairs = list(itertools.combinations(vectors, 2))
        for v in (vectors
                  + [tuple(a + b for a, b in zip(*pair)) for pair in pairs]
                  + [tuple(a - b for a, b in zip(*pair)) for pair in pairs]):
            angle = dot(v, ANGLES)
            if angle < 0:
                v, angle = tuple(-x for x in v), -angle
            found[v] = angle
    return found


def chosen():
    found = candidates(2 * ROWS + 14)
    for row in range(ROWS):
        size = BITS - (2 * row + 1)
        near = [v for v, a in found.items()
                if a and abs(math.log2(a) - size) < 0.5]
        best = min(near, key=lambda v: (dot(map(abs, v), COST), v))
        yield found[best], best


def line(angle, vector, unit):
    units = (angle + (1 << (BITS - unit - 1))) >> (BITS - unit)
    return '    {%d, {%s}},' % (units, ', '.join(map(str, vector)))


def array(name, rows, unit):
    return ['inline constexpr std::array<angle_relation, %d> %s{{'
            % (len(rows), name)] + [line(*row, unit) for row in rows] + ['}};']


def main():
    rows = list(chosen())
    primes = ['{%d, %d}' % p for p in PRIMES]
    text = f'''\
// Relations between the angles of the Gaussian primes p_j, 1 + i and the twelve a + i b, 0 < a < b, of least norm:
// integers v_j whose sum of v_j arg p_j is small [Johansson2022]. Made by tests/scalar/ball_arctangent.py, not by hand.
#pragma once

#include <array>
#include <cstdint>

namespace libration {{

inline constexpr std::size_t gaussian_count = {len(PRIMES)};

/// The primes, in the order of the angles that FLINT keeps.
inline constexpr std::array<std::array<std::int64_t, 2>, gaussian_count> gaussian_primes{{
    {{{', '.join(primes)}}}}};

/// The sum of v_j arg p_j, rounded to a multiple of 2^-scale, and v.
struct angle_relation {{
    std::int64_t size;
    std::array<std::int64_t, gaussian_count> v;
}};

/// From 2^-1 to 2^-{2 * COARSE_ROWS - 1}, a factor of about 4 from row to row; scale {COARSE}.
inline constexpr int coarse_scale = {COARSE};
'''
    text += '\n'.join(array('coarse_relations', rows[:COARSE_ROWS], COARSE))
    text += f'''

/// From there to 2^-{2 * ROWS - 1}; scale {FINE}.
inline constexpr int fine_scale = {FINE};
'''
    text += '\n'.join(array('fine_relations', rows[COARSE_ROWS:], FINE))
    text += '\n\n}  // namespace libration\n'
    HEADER.write_text(text)


if __name__ == '__main__':
    main()
