#!/usr/bin/env python3
"""Checks the CSV of `libration-attack print N`: descending Landen transformation in mpmath, without Arb.

    libration-attack print 2000 | python3 tests/attack/by_integers.py

A digit is wrong if the error of the printed decimal is at least one unit of its last digit. Exits with 1 if one is.
"""

import csv
import sys
from fractions import Fraction

from mpmath import atan2, cos, mp, mpf, pi, sin, sqrt


def landen(u, k, complement):
    """sn, cn, dn by the descending transformation [DLMF 22.7(i)] on the chain of means, |u| < K."""
    chain = [(mpf(1), complement)]
    while abs(chain[-1][0] - chain[-1][1]) > mpf(2) ** (-mp.prec // 2 - 8) * chain[-1][0]:
        a, b = chain[-1]
        chain.append(((a + b) / 2, sqrt(a * b)))
    # At the last level sin equals sn up to k^2, which is below the precision.
    angle = u * chain[-1][0]
    tangent, dn = sin(angle) / cos(angle), mpf(1)
    for (a, b), (mean, _) in zip(chain[-2::-1], chain[:0:-1]):
        square = tangent * tangent
        tangent *= a / (mean * dn)
        dn = (mean + b * square) / (mean + a * square)
    cn = 1 / sqrt(1 + tangent * tangent)
    return tangent * cn, cn, dn


def mean_of(x):
    a, b = mpf(1), x
    while abs(a - b) > mpf(2) ** (-mp.prec + 8) * a:
        a, b = (a + b) / 2, sqrt(a * b)
    return a


def number(fraction):
    return mpf(fraction.numerator) / fraction.denominator


def nearest(x):
    return int(mp.nint(x))


def state(energy, time):
    """theta and omega from the top, by quarters of the period from the next bottom."""
    turning = energy > 2
    rate = sqrt(number(energy / 2)) if turning else mpf(1)
    k = 1 / rate if turning else sqrt(number(energy / 2))
    complement = sqrt(number((energy - 2) / energy if turning else (2 - energy) / 2))
    quarter = pi / (2 * mean_of(complement))
    if time.endswith("T") or "T" in time:
        head, _, tail = time.partition("T")
        periods = Fraction(head or 1) / Fraction(tail[1:] or 1)
        quarters = periods * (2 if turning else 4) + 1
        whole = round(quarters)
        offset = number(quarters - whole) * quarter
    else:
        u = number(Fraction(time)) * rate
        whole = nearest(u / quarter)
        offset = u - whole * quarter
        whole += 1
    sn, cn, dn = landen(offset, k, complement)
    if whole % 2:
        sn, cn, dn = cn / dn, -complement * sn / dn, complement / dn
    if turning:
        half_turns = (whole - whole % 2) // 2
        return 2 * (half_turns * pi + atan2(sn, cn)), 2 * rate * dn
    if whole % 4 >= 2:
        sn, cn = -sn, -cn
    return 2 * atan2(k * sn, dn), 2 * k * cn


def main():
    sys.set_int_max_str_digits(0)
    values = wrong = 0
    for row in csv.DictReader(sys.stdin):
        digits = int(row["digits"])
        energy = Fraction(row["energy"])
        mp.dps = digits + 1000 + 2 * abs(len(str(energy.numerator)) - len(str(energy.denominator)))
        truths = dict(zip(("theta", "omega"), state(energy, row["time"])))
        for name, truth in truths.items():
            values += 1
            printed = Fraction(row[name])
            size = abs(number(printed))
            unit = mpf(10) ** (mp.floor(mp.log10(size)) + 1 - digits) if size else mpf(10) ** -900
            if abs(truth - number(printed)) >= unit:
                wrong += 1
                print(f"wrong: {name} of {row}", file=sys.stderr)
    print(f"{values} values by integers, {wrong} wrong")
    sys.exit(1 if wrong or not values else 0)


if __name__ == "__main__":
    main()
