#!/usr/bin/env python3
"""Values of solutions that cross removable singularities: quadrature and root finding of mpmath with 40 digits.

    tests/reference/removable.py > tests/reference/removable.txt

A row has a problem, a time, an unknown and its value there."""
import mpmath as mp

mp.mp.dps = 45


def extended(f, limit):
    return lambda u: limit if u == 0 else f(u)


def with_more_digits(f):
    """Of a quotient of differences near 0, where quadrature has nodes, but none at 0."""
    def value(u):
        with mp.workdps(400):
            return f(u)
    return value


bernoulli = extended(lambda u: u / mp.expm1(u), mp.mpf(1))
relative_sine = extended(lambda u: mp.sin(u) / u, mp.mpf(1))


def integral(f, a, b):
    return mp.quad(f, mp.linspace(a, b, 17))


def end_of(rate, start, time):
    """The solution of U' = rate(U), rate positive, by the time as an integral over U."""
    return mp.findroot(lambda end: integral(lambda u: 1 / rate(u), start, end) - time, (start + time / 2, start + time))


half = mp.mpf(1) / 2
PROBLEMS = [
    ("U' = 1; y' = U/(exp(U) - 1); U(0) = -1; y(0) = 0", 2, "y", lambda: integral(bernoulli, -1, 1)),
    ("U' = 1; y' = 1/(exp(U) - 1)*3*U; U(0) = 0; y(0) = 0", 2, "y", lambda: 3 * integral(bernoulli, 0, 2)),
    ("x' = cos(t); y' = sin(x)/x; x(0) = -1/2; y(0) = 0", 2, "y",
     lambda: integral(lambda t: relative_sine(mp.sin(t) - half), 0, 2)),
    ("U' = U/tan(U); U(0) = -1", 2, "U", lambda: end_of(extended(lambda u: u / mp.tan(u), mp.mpf(1)), -1, 2)),
    ("x' = v; v' = -x; y' = log(1 + x)/x; x(0) = 1/2; v(0) = 0; y(0) = 0", 3, "y",
     lambda: integral(lambda t: extended(lambda u: mp.log1p(u) / u, mp.mpf(1))(mp.cos(t) / 2), 0, 3)),
    ("y' = (exp(t) - 1)/t; y(0) = 0", 1, "y", lambda: integral(extended(lambda u: mp.expm1(u) / u, mp.mpf(1)), 0, 1)),
    ("y' = (exp(2*t) - exp(-t))/t; y(-1) = 0", 1, "y",
     lambda: integral(extended(lambda u: (mp.exp(2 * u) - mp.exp(-u)) / u, mp.mpf(3)), -1, 1)),
    ("y' = (1 - cos(t))/t^2; y(-1) = 0", 2, "y",
     lambda: integral(extended(lambda u: (1 - mp.cos(u)) / u**2, half), -1, 2)),
    ("x' = 1; y' = tanh(x)/x; x(0) = -1; y(0) = 0", 2, "y",
     lambda: 2 * integral(extended(lambda u: mp.tanh(u) / u, mp.mpf(1)), 0, 1)),
    ("x' = 1; y' = x/log(1 + x); x(0) = -1/2; y(0) = 0", 1, "y",
     lambda: integral(extended(lambda u: u / mp.log1p(u), mp.mpf(1)), -half, half)),
    ("x' = 1; y' = (sqrt(1 + x) - 1)/x; x(0) = -1/2; y(0) = 0", 1, "y",
     lambda: integral(lambda u: 1 / (mp.sqrt(1 + u) + 1), -half, half)),
    ("x' = -x - 1; y' = sin(x)/sinh(x); x(0) = 1; y(0) = 0", 2, "y",
     lambda: integral(lambda t: extended(lambda u: mp.sin(u) / mp.sinh(u), mp.mpf(1))(2 * mp.exp(-t) - 1), 0, 2)),
    ("x' = 1; y' = atan(x)/x + asin(x/2)/x; x(0) = -1; y(0) = 0", 2, "y",
     lambda: integral(extended(lambda u: (mp.atan(u) + mp.asin(u / 2)) / u, 3 * half), -1, 1)),
    ("x' = 1; y' = sinc(x); x(0) = -1; y(0) = 0", 2, "y", lambda: integral(relative_sine, -1, 1)),
    ("x' = 1; y' = lambertw(x)/x; x(0) = -1/4; y(0) = 0", 1, "y",
     lambda: integral(lambda u: mp.exp(-mp.re(mp.lambertw(u))), -half / 2, 3 * half / 2)),
    ("V' = 2 - (25 - V)/(exp(25 - V) - 1); V(0) = 24", 1, "V",
     lambda: 25 - mp.findroot(lambda end: integral(lambda u: 1 / (bernoulli(u) - 2), 1, end) - 1, (0, -half))),
    ("y' = log(x)/(x^3 - 1); x' = 1; x(0) = 1/2; y(0) = 0", 1, "y",
     lambda: integral(lambda u: extended(lambda h: mp.log1p(h) / h, mp.mpf(1))(u - 1) / (u * u + u + 1),
                      half, 3 * half)),
    ("x' = 1; y' = coth(x) - 1/x; x(0) = -1; y(0) = 0", 3, "y",
     lambda: mp.log(mp.sinh(2) / 2) - mp.log(mp.sinh(1))),
    ("y' = 1/tanh(t) - 1/t + cos(t); y(-1) = 0", 2, "y",
     lambda: mp.log(mp.sinh(2) / 2) - mp.log(mp.sinh(1)) + mp.sin(2) + mp.sin(1)),
    ("x' = 1; y' = 2*x - 1/x + 1/sin(x); x(0) = -1; y(0) = 0", 3, "y",
     lambda: 3 + mp.log(mp.tan(1) / 2) - mp.log(mp.tan(half))),
    ("x' = 1; y' = cos(3*x)/x - cos(x)/x; x(0) = -1; y(0) = 0", 3, "y",
     lambda: (mp.ci(6) - mp.log(3) - mp.ci(2)) - (mp.ci(3) - mp.log(3) - mp.ci(1))),
    ("x' = 1; y' = x^2/(x/tan(x) - 1); x(0) = -1; y(0) = 0", 2, "y",
     lambda: 2 * integral(with_more_digits(lambda u: u**2 * mp.sin(u) / (u * mp.cos(u) - mp.sin(u))), 0, 1)),
]

if __name__ == "__main__":
    for text, time, name, value in PROBLEMS:
        print(f"{text} | {time} | {name} | {mp.nstr(value(), 40, strip_zeros=False)}")
