#!/usr/bin/env python3
"""Perturbation series in exact fractions: the lists of problems/series that are no enumerations.

    python3 tests/reference/perturbation_series.py [DIRECTORY]

Writes blasius.csv, kepler_eccentricity.csv, mathieu_a0.csv, quartic_oscillator.csv, stokes_wave.csv and van_der_pol_frequency.csv into
DIRECTORY (problems/series), in about a minute. Each recurrence is the one of the paper that its header names; the
first coefficients are compared with the printed ones.
"""

import sys
from fractions import Fraction
from math import comb, factorial, lcm
from pathlib import Path


def blasius(order):
    """f/x^2 in powers of x^3: f''' + f f''/2 = 0, f(0) = f'(0) = 0, f''(0) = 1."""
    a = [1]
    for k in range(1, order + 1):
        a.append(sum(comb(3 * k - 1, 3 * r) * a[r] * a[k - 1 - r] for r in range(k)))
    assert a[:5] == [1, 1, 11, 375, 27897]
    return [Fraction((-1) ** k * a[k], 2**k * factorial(3 * k + 2)) for k in range(order + 1)]


def kepler_eccentricity(order):
    """E in powers of e for M = pi/2: E - pi/2 = d with d = e cos d; here d. Lagrange's inversion formula."""
    cosine = [Fraction((-1) ** (k // 2), factorial(k)) if k % 2 == 0 else Fraction(0) for k in range(order)]
    power = [Fraction(1)] + [Fraction(0)] * (order - 1)
    d = [Fraction(0)]
    for n in range(1, order + 1):
        power = [sum(power[j] * cosine[k - j] for j in range(k % 2, k + 1, 2)) for k in range(order)]
        d.append(power[n - 1] / n)
    assert d[:6] == [0, 1, 0, Fraction(-1, 2), 0, Fraction(13, 24)]
    return d


def mathieu_a0(order):
    """The characteristic value a_0 in powers of q^2, from a_0 A_0 = q A_2, (a_0 - 4 r^2) A_2r = q (A_2r-2 + A_2r+2)."""
    top = 2 * order
    a = [Fraction(0)] * (top + 1)  # in powers of q
    c = [[Fraction(0)] * (top + 1) for _ in range(order + 2)]  # A_2r; A_0 = 1/2 stands for both of its neighbours
    c[0][0] = Fraction(1)
    for n in range(1, top + 1):
        for r in range(1, order + 1):
            before = 2 * c[0][n - 1] if r == 1 else c[r - 1][n - 1]
            known = sum(a[j] * c[r][n - j] for j in range(2, n + 1))
            c[r][n] = (known - before - c[r + 1][n - 1]) / (4 * r * r)
        a[n] = c[1][n - 1]
    assert a[:9:2] == [0, Fraction(-1, 2), Fraction(7, 128), Fraction(-29, 2304), Fraction(68687, 18874368)]
    return a[::2]


def quartic_oscillator(order):
    """E in powers of g. psi'/psi = -sum_n g^n f_n(x), f_n odd polynomials: f' - f^2 + x^2 + 2 g x^4 = 2 E."""
    f = [{1: Fraction(1)}]
    energy = [Fraction(1, 2)]
    for n in range(1, order + 1):
        source = {4: Fraction(2)} if n == 1 else {}
        for i in range(1, n):
            for p, u in f[i].items():
                for q, v in f[n - i].items():
                    source[p + q] = source.get(p + q, 0) - u * v
        # f_n' - 2 x f_n + source = 2 E_n, from the highest power down.
        of_n = {}
        for p in range(max(source), 0, -2):
            of_n[p - 1] = Fraction(source.get(p, 0) + (p + 1) * of_n.get(p + 1, 0)) / 2
        f.append(of_n)
        energy.append((of_n[1] + source.get(0, 0)) / 2)
    assert energy[:4] == [Fraction(1, 2), Fraction(3, 4), Fraction(-21, 8), Fraction(333, 16)]
    return energy


def whole(x):
    """The numerators over the least common denominator, and that denominator."""
    common = lcm(*(value.denominator for value in x.values()))
    return {k: value.numerator * (common // value.denominator) for k, value in x.items()}, common


def van_der_pol_frequency(order):
    """The frequency w of the limit cycle in powers of e^2: w^2 x'' + x = e w (1 - x^2) x'.

    x = sum_n (i e)^n sum_k r[n][k] exp(i k tau), r[n][-k] = (-1)^n r[n][k], r[n][1] = 0 for odd n.
    """
    top = 2 * order
    r = [{1: Fraction(1), -1: Fraction(1)}]
    squares, cubes = [], []
    w, w2 = [Fraction(1)], [Fraction(1)]  # the coefficients of e^2j = (-1)^j (i e)^2j: signs are kept in w and w2

    def product(x, y, n):
        total = {}
        for i in range(n + 1):
            (u, of_u), (v, of_v) = whole(x[i]), whole(y[n - i])
            of_pair = {}
            for p, up in u.items():
                for q, vq in v.items():
                    of_pair[p + q] = of_pair.get(p + q, 0) + up * vq
            for k, value in of_pair.items():
                total[k] = total.get(k, 0) + Fraction(value, of_u * of_v)
        return total

    def right_side(n, k):
        """k^2 sum_j w2_j r[n-2j][k] + k sum_j w_j (r - c/3)[n-1-2j][k], with what is known of w."""
        known = sum(w2[j] * r[n - 2 * j].get(k, 0) for j in range(1, min(len(w2) - 1, n // 2) + 1))
        forcing = sum(
            w[j] * (r[n - 1 - 2 * j].get(k, 0) - Fraction(cubes[n - 1 - 2 * j].get(k, 0), 3))
            for j in range(min(len(w) - 1, (n - 1) // 2) + 1)
        )
        return Fraction(k * k * known + k * forcing)

    for n in range(1, top + 1):
        squares.append(product(r, r, n - 1))
        cubes.append(product(squares, r, n - 1))
        if n % 2 == 1 and n > 1:
            # The amplitude of e^(n-1): r[n-1][1] = s changes (r - c/3)[n-1][1] by -2 s.
            s = right_side(n, 1) / 2
            r[n - 1][1] = r[n - 1][-1] = s
            squares[n - 1] = product(r, r, n - 1)
            cubes[n - 1] = product(squares, r, n - 1)
            assert right_side(n, 1) == 0
        if n % 2 == 0:
            square = -right_side(n, 1)  # w2_j r[0][1]
            w2.append(square)
            j = n // 2
            w.append((square - sum(w[i] * w[j - i] for i in range(1, j))) / 2)
        r.append({k: right_side(n, k) / (1 - k * k) for k in range(-2 * n - 1, 2 * n + 2, 2) if abs(k) != 1})
        r[n] = {k: v for k, v in r[n].items() if v != 0}
    frequency = [(-1) ** j * each for j, each in enumerate(w)]
    assert frequency[:4] == [1, Fraction(-1, 16), Fraction(17, 3072), Fraction(35, 884736)], frequency[:4]
    return frequency


def stokes_wave(order):
    """c^2 k/g of gravity waves on deep water in powers of e^2, e = k (crest - trough)/2.

    Babenko's equation c^2 |D| y = y + y |D| y + |D| y^2/2 (g = k = 1) for the elevation y = sum_n y_n exp(i n x) at the
    conformal abscissa x, |D| exp(i n x) = |n| exp(i n x); first in powers of a = 2 y_1, then of e = 2 (y_1 + y_3 + ..).
    """
    top = 2 * order + 1
    y = {n: {} for n in range(top + 1)}  # y[n][m]: the coefficient of a^m, y_-n = y_n
    y[1][1] = Fraction(1, 2)
    c2 = {0: Fraction(1)}

    def products(n, m):
        """The coefficient of a^m in the mode n of y |D| y + |D| y^2/2."""
        total = Fraction(0)
        for k in range(n - top, top + 1):
            u, v = y[abs(k)], y[abs(n - k)]
            factor = abs(k) + Fraction(n, 2)
            if factor:
                total += factor * sum(each * v[m - i] for i, each in u.items() if m - i in v)
        return total

    for m in range(2, top + 1):
        for n in range(m % 2, m + 1, 2):
            if n == 0:
                y[0][m] = -products(0, m)
            elif n == 1:
                c2[m - 1] = 2 * (products(1, m) - sum(c2[j] * y[1].get(m - j, 0) for j in c2 if j > 0))
            else:
                known = products(n, m) - n * sum(c2[j] * y[n].get(m - j, 0) for j in range(2, m, 2))
                y[n][m] = known / (n - 1)
    # e = a s(a^2), in powers of b = a^2; then c^2 by powers of e^2 = b s(b)^2, from the lowest one up.
    s = [2 * sum((y[n].get(2 * j + 1, Fraction(0)) for n in range(1, top + 1, 2)), Fraction(0)) for j in range(order + 1)]

    def times(u, v):
        return [sum(u[i] * v[j - i] for i in range(j + 1)) for j in range(order + 1)]

    square = [Fraction(0)] + times(s, s)[:order]
    rest = [c2.get(2 * j, Fraction(0)) for j in range(order + 1)]
    power = [Fraction(1)] + [Fraction(0)] * order
    result = []
    for n in range(order + 1):
        result.append(rest[n] / power[n])
        rest = [r - result[n] * p for r, p in zip(rest, power)]
        power = times(power, square)
    assert result[:5] == [1, 1, Fraction(1, 2), Fraction(1, 4), Fraction(-22, 45)], result[:5]
    return result


LISTS = {
    blasius: (60, "f/x^2 in powers of x^3, f''' + f f''/2 = 0, f''(0) = 1 [Blasius 1908]"),
    kepler_eccentricity: (60, "E - pi/2 in powers of the eccentricity for the mean anomaly pi/2 [Lagrange 1771]"),
    mathieu_a0: (40, "characteristic value a_0 of Mathieu's equation in powers of q^2"),
    quartic_oscillator: (60, "ground state energy of p^2/2 + x^2/2 + g x^4 in powers of g [Bender and Wu 1969]"),
    stokes_wave: (30, "squared speed of Stokes' waves on deep water in powers of the squared steepness [Schwartz 1974]"),
    van_der_pol_frequency: (30, "frequency of the limit cycle of van der Pol's equation in powers of epsilon^2"),
}


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2] / "problems" / "series")
    for function, (order, title) in LISTS.items():
        lines = [f"# {title}: exact, by tests/reference/perturbation_series.py"]
        lines += [f"{n},{a}" for n, a in enumerate(function(order))]
        (directory / f"{function.__name__}.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
