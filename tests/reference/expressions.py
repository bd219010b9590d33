#!/usr/bin/python3
"""Write expressions.csv, formulas of numbers and their values, without any
code of Libration.

    /usr/bin/python3 tests/reference/expressions.py     (a second)

needs Debian's python3-mpmath (1.2.1), no network; README.md says what the
table holds. Each formula stands here twice: as Libration takes it, and as
mpmath computes it. Every value is computed at 200 and at 300 digits, and the
two texts of 60 digits must be equal.
"""
import csv
import pathlib

import mpmath
from mpmath import mp

DIGITS, WORK, MORE = 60, 200, 300
HERE = pathlib.Path(__file__).resolve().parent
FORMULAS = [
    ('pi-1e-10', lambda: mp.pi - mpmath.mpf('1e-10')),
    ('pi-1e-80', lambda: mp.pi - mpmath.mpf('1e-80')),
    ('355/113-pi', lambda: mpmath.mpf(355) / 113 - mp.pi),
    ('sqrt(2)', lambda: mpmath.sqrt(2)),
    ('2-sqrt(2)', lambda: 2 - mpmath.sqrt(2)),
    ('acos(1/3)', lambda: mpmath.acos(mpmath.mpf(1) / 3)),
    ('acos(1-1e-30)', lambda: mpmath.acos(1 - mpmath.mpf('1e-30'))),
    ('90deg-1e-5', lambda: mp.pi / 2 - mpmath.mpf('1e-5')),
    ('-2^0.5', lambda: -mpmath.sqrt(2)),
    ('2**(1/3)*3', lambda: 3 * mpmath.cbrt(2)),
    ('(1+sqrt(5))/2', lambda: (1 + mpmath.sqrt(5)) / 2),
    ('sqrt(2)^-3', lambda: mpmath.mpf(1) / (2 * mpmath.sqrt(2))),
    ('(1-sqrt(2))^3', lambda: (1 - mpmath.sqrt(2)) ** 3),
    ('(1-sqrt(2))^-2', lambda: 1 / (1 - mpmath.sqrt(2)) ** 2),
    ('exp(pi*sqrt(163))-640320^3-744', lambda: mpmath.exp(mp.pi * mpmath.sqrt(163)) - 640320 ** 3 - 744),
    ('exp(-1)', lambda: mpmath.exp(-1)),
    ('exp(1e3)', lambda: mpmath.exp(1000)),
    ('log(10)', lambda: mpmath.log(10)),
    ('log(1+1e-20)', lambda: mpmath.log(1 + mpmath.mpf('1e-20'))),
    ('sin(1)', lambda: mpmath.sin(1)),
    ('sin(1e20)', lambda: mpmath.sin(10 ** 20)),
    ('cos(2)+tan(3)', lambda: mpmath.cos(2) + mpmath.tan(3)),
    ('tan(pi/2-1e-20)', lambda: mpmath.tan(mp.pi / 2 - mpmath.mpf('1e-20'))),
    ('asin(0.3)-atan(7)', lambda: mpmath.asin(mpmath.mpf(3) / 10) - mpmath.atan(7)),
    ('sinh(1/2)*cosh(-1/2)', lambda: mpmath.sinh(mpmath.mpf(1) / 2) * mpmath.cosh(mpmath.mpf(1) / 2)),
    ('cosh(sqrt(2)-3/2)', lambda: mpmath.cosh(mpmath.sqrt(2) - mpmath.mpf(3) / 2)),
    ('1-tanh(40)', lambda: 1 - mpmath.tanh(40)),
    ('1+cos(pi-1e-10)', lambda: 1 + mpmath.cos(mp.pi - mpmath.mpf('1e-10'))),
    ('2pi^2/(3pi)^0.5', lambda: 2 * mp.pi ** 2 / mpmath.sqrt(3 * mp.pi)),
    ('sqrt(sqrt(sqrt(3)))', lambda: mpmath.mpf(3) ** (mpmath.mpf(1) / 8)),
    ('sin(36deg)', lambda: mpmath.sin(mp.pi / 5)),
    ('2^(sqrt(2)/2)', lambda: mpmath.mpf(2) ** (mpmath.sqrt(2) / 2)),
]


def text_of(value, digits):
    with mp.workdps(digits):
        return mpmath.nstr(value(), DIGITS, strip_zeros=False, min_fixed=-5, max_fixed=DIGITS)


def main():
    rows = []
    for formula, value in FORMULAS:
        text = text_of(value, WORK)
        if text != text_of(value, MORE):
            raise SystemExit(f'{formula} is not right to {DIGITS} digits')
        rows.append((formula, text))
    with open(HERE / 'expressions.csv', 'w', newline='', encoding='ascii') as out:
        writer = csv.writer(out, lineterminator='\n')
        writer.writerow(('expression', 'value'))
        writer.writerows(rows)


main()
