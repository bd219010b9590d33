#!/usr/bin/env python3
"""Heat carried by Blasius's layer, by Taylor steps of mpmath: T'(0) for T'' = -c f T', T(0) = 1, T(inf) = 0.

f''(0) is that of another program [INFINITY, section 7]. T'(0) = -1/J, J' = E, E' = -c f E, to a time where E < 1e-40.
"""

from mpmath import mp, mpf

mp.dps = 45
ORDER = 60
STEP = mpf(1) / 4
SLOPE = mpf("0.46959998836101330450933365344758845872")


def step(f, f1, f2, e, j, c):
    """The state after STEP, by the coefficients of f''' = -f f'', E' = -c f E, J' = E."""
    a = [f, f1, f2 / 2]
    b = [e]
    g = [j]
    for n in range(ORDER):
        product = sum(a[k] * (n - k + 2) * (n - k + 1) * a[n - k + 2] for k in range(n + 1))
        a.append(-product / ((n + 3) * (n + 2) * (n + 1)))
        b.append(-c * sum(a[k] * b[n - k] for k in range(n + 1)) / (n + 1))
        g.append(b[n] / (n + 1))

    def value(of):
        return sum(x * STEP**k for k, x in enumerate(of))

    slope = [(k + 1) * x for k, x in enumerate(a[1:])]
    bend = [(k + 1) * x for k, x in enumerate(slope[1:])]
    return value(a), value(slope), value(bend), value(b), value(g)


for text in ["1/10", "7/10", "1"]:
    numerator, _, denominator = text.partition("/")
    c = mpf(numerator) / mpf(denominator or 1)
    state = (mpf(0), mpf(0), SLOPE, mpf(1), mpf(0))
    while state[3] > mpf(10) ** -40:
        state = step(*state, c)
    print(text, mp.nstr(-1 / state[4], 30))
