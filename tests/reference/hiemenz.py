#!/usr/bin/env python3
"""The shear s = f''(0) of the stagnation point flow f''' + f f'' + 1 - f'^2 = 0, f(0) = f'(0) = 0, f'(inf) = 1, by mpmath.

    python3 tests/reference/hiemenz.py

Prints 60 digits for tests/problem/known_facts_test.cpp. The secant method makes f'(T) = 1, with Taylor series of order 60 in
steps of 1/8. f' - 1 falls like exp(-t^2/2), so that the condition at T instead of infinity changes s by less than
exp(-T^2/2): two values of T that agree to more digits than are printed confirm it.
"""

from mpmath import mp, mpf

ORDER = 60
STEPS_PER_UNIT = 8


def series(f, g, h):
    """Coefficients of f about a point with f, f' = g, f'' = h."""
    a = [f, g, h / 2] + [mpf(0)] * (ORDER - 2)
    for n in range(ORDER - 2):
        # n-th coefficients of f f'', f'^2
        ff = sum(a[k] * (n - k + 2) * (n - k + 1) * a[n - k + 2] for k in range(n + 1))
        gg = sum((k + 1) * a[k + 1] * (n - k + 1) * a[n - k + 1] for k in range(n + 1))
        a[n + 3] = (gg - ff - (1 if n == 0 else 0)) / ((n + 1) * (n + 2) * (n + 3))
    return a


def missed(s, last):
    f, g, h = mpf(0), mpf(0), s
    step = mpf(1) / STEPS_PER_UNIT
    for _ in range(last * STEPS_PER_UNIT):
        a = series(f, g, h)
        f = sum(c * step**n for n, c in enumerate(a))
        g = sum(n * c * step ** (n - 1) for n, c in enumerate(a) if n >= 1)
        h = sum(n * (n - 1) * c * step ** (n - 2) for n, c in enumerate(a) if n >= 2)
    return g - 1


def shear(last):
    low, high = mpf("1.2325876568"), mpf("1.2325876569")
    at_low = missed(low, last)
    while abs(high - low) > mpf(10) ** (-mp.dps + 15):
        at_high = missed(high, last)
        if at_high == at_low:
            break
        low, high, at_low = high, high - at_high * (high - low) / (at_high - at_low), at_high
    return high


mp.dps = 95
values = [shear(17), shear(19)]
assert abs(values[0] - values[1]) < mpf(10) ** -62, values
print(mp.nstr(values[1], 60))
