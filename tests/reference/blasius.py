#!/usr/bin/python3
"""Write blasius.csv, the constants of Blasius' boundary layer f''' + f f''/2
= 0, f(0) = f'(0) = 0, f'(infinity) = 1, without any code of Libration.

    /usr/bin/python3 tests/reference/blasius.py        (about 10 s, one core)

needs Debian's python3-mpmath (1.2.1), no network; README.md says what the
table holds.

The solution g with g''(0) = 1 gives f(x) = c g(c x), c = g'(infinity)^(-1/2),
so f''(0) = c^3 and the radius of convergence of f is that of g divided by c.
Both are integrated by Taylor steps: g along the positive axis until g'' is
nothing, and along the negative axis, where g is real and runs into the
singularity, by steps of a fixed part of the remaining distance u.

There g = 6/u + a u^(1+i sqrt 2) + conjugate + O(u^3): in g, g', g'' along
s = -x the two oscillating terms cancel out of
    u^3 g'' + u^2 g' + 3 u g - 36 = 0,
whose root u then is wrong by O(u^5).

Everything is done twice, with other digits, steps and last distances, and the
texts of 100 digits must be equal, f''(0) to the 63 known digits
[OEIS A256522] and the radius to the 5.6900380545 of [Boyd1999].
"""
import pathlib

import mpmath
from mpmath import mp, mpf

DIGITS = 100
HERE = pathlib.Path(__file__).resolve().parent
CURVATURE = '0.33205733621519629893718006201058296654709356141267981810044756'
RADIUS = '5.6900380545'


def expand(g, slope, curvature, order):
    """Taylor coefficients of the solution through a state."""
    a = [g, slope, curvature / 2]
    second = [curvature]
    for n in range(order - 2):
        third = -mp.fdot(a[:n + 1], second[::-1]) / 2
        second.append(third / (n + 1))
        a.append(second[-1] / ((n + 3) * (n + 2)))
    return a


def state(a, h):
    """g, g', g'' at the distance h."""
    slope = [n * c for n, c in enumerate(a)][1:]
    second = [n * c for n, c in enumerate(slope)][1:]
    return [mp.polyval(c[::-1], h) for c in (a, slope, second)]


def order_for(ratio):
    """The order whose term ratio^n is below the working precision."""
    return int((mp.dps + 10) / -mp.log10(ratio)) + 10


def speed_far_out(step):
    """g'(infinity): g'' falls like exp(-g'(infinity) x^2/4)."""
    at = [mpf(0), mpf(0), mpf(1)]
    order = order_for(step / mpf(3))     # singularities keep a distance of 3.4
    while abs(at[2]) > mpf(10)**-(mp.dps + 5):
        at = state(expand(*at, order), step)
    return at[1]


def distance_left(g, slope, curvature):
    """The root u of the equation above, from u = 6/g."""
    return mp.findroot(lambda u: ((u * curvature + slope) * u + 3 * g) * u - 36,
                       6 / g)


def distance_of_singularity(part, last):
    """Where g ends on the negative axis; steps of u times part."""
    at, s, left = [mpf(0), mpf(0), mpf(1)], mpf(0), mpf(4)
    order = order_for(part)
    step = 2 * part
    while True:
        # Along s = -x the odd derivatives change sign.
        a = [c * (-1)**n for n, c in enumerate(
            expand(at[0], -at[1], at[2], order))]
        at, s = state(a, step), s + step
        if at[0] > 6:
            left = distance_left(*at)
            if left < last:
                return s + left
        else:
            left = mpf(4) - s
        step = left * part


def constants(digits, step, part, last):
    with mp.workdps(digits):
        c = speed_far_out(step)**mpf('-0.5')
        found = c**3, distance_of_singularity(part, last) / c
        return [mp.nstr(x, DIGITS, strip_zeros=False) for x in found]


def main():
    curvature, radius = constants(DIGITS + 25, mpf(1) / 2, mpf(1) / 4,
                                  mpf(10)**-22)
    again = constants(DIGITS + 35, mpf(1) / 3, mpf(1) / 5, mpf(10)**-24)
    assert [curvature, radius] == again, (curvature, radius, again)
    assert curvature.startswith(CURVATURE[:-1]), curvature
    assert radius.startswith(RADIUS), radius
    (HERE / 'blasius.csv').write_text(
        f'quantity,value\ncurvature,{curvature}\nradius,{radius}\n')


if __name__ == '__main__':
    main()
