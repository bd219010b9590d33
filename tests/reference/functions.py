#!/usr/bin/python3
"""Write functions.txt, "problem | time | value": solutions of equations with special functions, without any code of Libration.

    /usr/bin/python3 tests/reference/functions.py      (about 4 min, one core)

needs Debian's python3-mpmath. Each value is an integral, y(T) = y(0) + integral of f(t, y(t)), found by Picard's
iteration on Chebyshev points of intervals of length 1/2, with mpmath's functions. It is computed with NODES and with
MORE points, and both must agree in one digit more than is written.
"""
import pathlib

from mpmath import mp

DIGITS, NODES, MORE = 40, 76, 92
HERE = pathlib.Path(__file__).resolve().parent


def cbrt(x):
    return mp.sign(x) * mp.cbrt(abs(x))


def quotient(a, b):
    return mp.mpf(a) / b


# text of the problem, time, right side, start
PROBLEMS = [
    ("x' = erf(x) + airy_ai(t); x(0) = 1/2", 1, lambda t, x: mp.erf(x) + mp.airyai(t), (1, 2)),
    ("y' = lambertw(t)*bessel_j(0, y); y(0) = 1", 2, lambda t, y: mp.lambertw(t).real * mp.besselj(0, y), (1, 1)),
    ("y' = erfc(y)*bessel_y(0, 1 + t); y(0) = 1/3", 1, lambda t, y: mp.erfc(y) * mp.bessely(0, 1 + t), (1, 3)),
    ("y' = bessel_i(1, y)/(1 + bessel_k(1/3, y)); y(0) = 1", 1,
     lambda t, y: mp.besseli(1, y) / (1 + mp.besselk(quotient(1, 3), y)), (1, 1)),
    ("y' = airy_bi(-y) + airy_ai_prime(y)*airy_bi_prime(t/2); y(0) = 1/2", 1,
     lambda t, y: mp.airybi(-y) + mp.airyai(y, derivative=1) * mp.airybi(t / 2, derivative=1), (1, 2)),
    ("y' = asinh(y) + acosh(2 + t)*atanh(y/4); y(0) = 1/2", 1,
     lambda t, y: mp.asinh(y) + mp.acosh(2 + t) * mp.atanh(y / 4), (1, 2)),
    ("y' = log10(1 + y^2) + log2(2 + t) - exp2(-y); y(0) = 1/4", 1,
     lambda t, y: mp.log(1 + y * y, 10) + mp.log(2 + t, 2) - mp.power(2, -y), (1, 4)),
    ("y' = cbrt(y - 2)*sinc(y + 1) - expm1(-t)*log1p(y); y(0) = 1/2", 1,
     lambda t, y: cbrt(y - 2) * mp.sinc(y + 1) - mp.expm1(-t) * mp.log1p(y), (1, 2)),
    ("y' = bessel_j(-5/2, 1 + y) - bessel_i(-3, 1 + y) + bessel_y(3/2, 1 + y); y(0) = 1", 1,
     lambda t, y: mp.besselj(quotient(-5, 2), 1 + y) - mp.besseli(-3, 1 + y) + mp.bessely(quotient(3, 2), 1 + y),
     (1, 1)),
    ("y' = bessel_k(2, y) - lambertw(y - 1); y(0) = 1", 1,
     lambda t, y: mp.besselk(2, y) - mp.lambertw(y - 1).real, (1, 1)),
]


def integration(count):
    """Chebyshev points x_j of [-1, 1] and the weights of the integrals from -1 to x_i."""
    points = [-mp.cos(mp.pi * j / (count - 1)) for j in range(count)]
    # The cardinal function of x_j is sum_k c_k T_k(x), c_k = 2/(N p_j p_k) T_k(x_j), p = 2 at both ends, else 1.
    last = count - 1
    chebyshev = [[mp.cos(k * mp.acos(x)) for k in range(count + 1)] for x in points]

    def primitive(k, i):  # of T_k from -1 to x_i
        def at(row):
            if k == 0:
                return row[1]
            if k == 1:
                return row[2] / 4
            return row[k + 1] / (2 * (k + 1)) - row[k - 1] / (2 * (k - 1))
        start = [mp.mpf((-1) ** j) for j in range(count + 1)]
        return at(chebyshev[i]) - at(start)

    ends = [2 if j in (0, last) else 1 for j in range(count)]
    primitives = [[primitive(k, i) for k in range(count)] for i in range(count)]
    weights = [[mp.fsum(mp.mpf(2) / (last * ends[j] * ends[k]) * chebyshev[j][k] * primitives[i][k]
                        for k in range(count)) for j in range(count)] for i in range(count)]
    return points, weights


def value(time, right, start, count):
    points, weights = integration(count)
    half = mp.mpf(1) / 4
    y = mp.mpf(start[0]) / start[1]
    for piece in range(2 * time):
        times = [mp.mpf(piece) / 2 + half * (1 + x) for x in points]
        values = [y] * count
        while True:
            slopes = [right(t, v) for t, v in zip(times, values)]
            found = [y + half * mp.fdot(row, slopes) for row in weights]
            change = max(abs(a - b) for a, b in zip(found, values))
            values = found
            if change < mp.mpf(10) ** (-DIGITS - 8):
                break
        y = values[-1]
    return y


def row(text, time, right, start):
    with mp.workdps(DIGITS + 15):
        a = value(time, right, start, NODES)
        b = value(time, right, start, MORE)
        agree = -mp.log10(abs(a - b) / abs(b)) if a != b else DIGITS + 8
        if agree < DIGITS + 1:
            raise SystemExit(f"{text}: only {mp.nstr(agree, 5)} digits agree")
        return [text, time, mp.nstr(b, DIGITS, strip_zeros=False)]


def main():
    with open(HERE / "functions.txt", "w") as out:
        for problem in PROBLEMS:
            out.write(" | ".join(map(str, row(*problem))) + "\n")
            out.flush()


if __name__ == "__main__":
    main()
