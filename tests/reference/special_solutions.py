#!/usr/bin/python3
"""Write special_solutions.csv, "problem | time | value": solutions by special functions, without any code of Libration.

    /usr/bin/python3 tests/reference/special_solutions.py      (about 10 s, one core)

needs Debian's python3-mpmath. The value is that of the first unknown. Each is computed with 300 and with 400 digits by
mpmath's functions, and both must agree in the DIGITS that are written.
"""
import pathlib
from fractions import Fraction

from mpmath import mp

DIGITS = 240
HERE = pathlib.Path(__file__).resolve().parent


def number(q):
    return mp.mpf(q.numerator) / q.denominator


def fractions(*texts):
    return [Fraction(text) for text in texts]


def typed(q):
    return str(q) if q.denominator == 1 and q >= 0 else f"({q})"


def airy(a, b, t0):
    a_text, b_text = typed(a), typed(b)
    text = (f"y'' = t*y; y({t0}) = {a_text}*airy_ai({t0}) + {b_text}*airy_bi({t0}); "
            f"y'({t0}) = {a_text}*airy_ai_prime({t0}) + {b_text}*airy_bi_prime({t0})")
    return text, lambda t: number(a) * mp.airyai(t) + number(b) * mp.airybi(t)


def airy_quotient(slope):  # y = -u'/u with u'' = -t u, u(0) = 1, u'(0) = -slope
    def value(t):
        wronskian = 1 / mp.pi
        ai, bi = mp.airyai(0), mp.airybi(0)
        ai1, bi1 = mp.airyai(0, derivative=1), mp.airybi(0, derivative=1)
        # u(t) = a Ai(-t) + b Bi(-t)
        s = number(slope)
        a = (bi1 - bi * s) / wronskian
        b = (ai * s - ai1) / wronskian
        u = a * mp.airyai(-t) + b * mp.airybi(-t)
        u1 = -a * mp.airyai(-t, derivative=1) - b * mp.airybi(-t, derivative=1)
        return -u1 / u
    return f"y' = t + y^2; y(0) = {slope}", value


def weierstrass(p, q, g2):
    """y = P(t + z0) with P(z0) = p, P'(z0) = q < 0: g3 follows. The three roots of 4x^3 - g2 x - g3 may be complex."""
    def value(t):
        p0, q0, g = number(p), number(q), number(g2)
        g3 = 4 * p0 ** 3 - g * p0 - q0 ** 2
        roots = mp.polyroots([4, 0, -g, -g3], maxsteps=500, extraprec=2000)
        e3 = min(roots, key=lambda e: abs(mp.im(e)))  # a real root
        e1, e2 = [e for e in roots if e is not e3]
        m = (e2 - e3) / (e1 - e3)
        scale = mp.sqrt(e1 - e3)
        # P = e3 + (e1 - e3)/sn^2(scale z); scale z0 = sn^-1, by Carlson's integral P^-1(p) = R_F(p - e1, p - e2, p - e3)
        z0 = mp.elliprf(p0 - e1, p0 - e2, p0 - e3)
        u = scale * (z0 + t)
        return mp.re(e3 + (e1 - e3) / mp.ellipfun("sn", u, m=m) ** 2)
    return f"y'' = 6*y^2 - {typed(g2)}/2; y(0) = {p}; y'(0) = {q}", value


def jacobi(m):
    text = f"x' = y*z; y' = -x*z; z' = -{typed(m)}*x*y; x(0) = 0; y(0) = 1; z(0) = 1"
    return text, lambda t: mp.re(mp.ellipfun("sn", t, m=number(m)))


def lambert(w, branch):
    def value(t):
        return mp.re(mp.lambertw(t + number(w) * mp.exp(number(w)), branch))
    return f"y' = exp(-y)/(1 + y); y(0) = {w}", value


def bessel(n, t0):
    text = (f"y'' = ({typed(n)}^2/t^2 - 1)*y - y'/t; y({t0}) = bessel_j({n}, {t0}); "
            f"y'({t0}) = (bessel_j({n - 1}, {t0}) - bessel_j({n + 1}, {t0}))/2")
    return text, lambda t: mp.besselj(number(n), t)


def dawson(y0):  # y = e^(-t^2) (y0 + sqrt(pi)/2 erfi t)
    return f"y' = 1 - 2*t*y; y(0) = {y0}", lambda t: mp.exp(-t * t) * (number(y0) + mp.sqrt(mp.pi) / 2 * mp.erfi(t))


def error_integral(a):
    text = f"y' = erf({typed(a)}*t); y(0) = 1/sqrt(pi)/{typed(a)}"
    return text, lambda t: t * mp.erf(number(a) * t) + mp.exp(-(number(a) * t) ** 2) / mp.sqrt(mp.pi) / number(a)


def fresnel(y0):
    return f"y' = sin(pi*t^2/2); y(0) = {y0}", lambda t: number(y0) + mp.fresnels(t)


def incomplete_gamma(a):
    return f"y' = t^({a - 1})*exp(-t); y(1) = 0", lambda t: mp.gammainc(number(a), 1, t)


def bessel_integral(y0):
    return f"y' = -bessel_j(1, t); y(1) = {y0}", lambda t: number(y0) - mp.besselj(0, 1) + mp.besselj(0, t)


# Texts and values, with the times at which they are asked.
FAMILIES = [
    (airy, [fractions("1", "0", "0"), fractions("0", "1", "0"), fractions("1", "-1/3", "-2"), fractions("2", "7", "1/2")],
     fractions("-9", "-3", "1/3", "4")),
    (airy_quotient, [fractions("0"), fractions("1/2"), fractions("-1"), fractions("1e-30")],
     fractions("1/8", "3/5", "1", "-1/2")),
    (weierstrass, [fractions("1", "-1", "2"), fractions("2", "-3", "1/2"), fractions("1/2", "-1/4", "-1"),
                   fractions("3", "-1/7", "0")], fractions("1/100", "1/10", "1/4", "2/5")),
    (jacobi, [fractions("1/2"), fractions("-3"), fractions("1/1000"), fractions("999999999999/1000000000000")],
     fractions("1/7", "2", "-11", "40")),
    (lambert, [(Fraction("0"), 0), (Fraction("1"), 0), (Fraction("-1/2"), 0), (Fraction("-2"), -1)],
     fractions("-1/20", "1/100", "1/16", "1/9")),
    (bessel, [fractions("0", "1"), fractions("1/3", "2"), fractions("2", "1"), fractions("5/2", "3")],
     fractions("1/10", "9/4", "7", "30")),
    (dawson, [fractions("0"), fractions("1"), fractions("-1/3")], fractions("-2", "1/2", "3", "12")),
    (error_integral, [fractions("1"), fractions("3"), fractions("1/7")], fractions("-2", "1/1000", "1", "5")),
    (fresnel, [fractions("0"), fractions("-1/2")], fractions("-3/2", "1/9", "1", "4")),
    (incomplete_gamma, [fractions("1/2"), fractions("-1/3"), fractions("5/2")], fractions("1/10", "3/2", "4", "25")),
    (bessel_integral, [fractions("1"), fractions("0")], fractions("1/9", "1/2", "2", "20")),
]


def printed(value, t, digits):
    with mp.workdps(digits):
        return mp.nstr(value(number(t)), DIGITS, min_fixed=0, max_fixed=0, strip_zeros=False)


def main():
    rows = []
    for family, parameters, times in FAMILIES:
        for these in parameters:
            text, value = family(*these)
            for t in times:
                once, again = printed(value, t, 300), printed(value, t, 400)
                if once != again:
                    raise SystemExit(f"{text} at {t}: {once} and {again}")
                rows.append(f"{text} | {t} | {once}\n")
    (HERE / "special_solutions.csv").write_text("".join(rows))


if __name__ == "__main__":
    main()
