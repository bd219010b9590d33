#!/usr/bin/env python3
"""Solutions of y'' + k y'/t = F(y), y(0) = a, y'(0) = 0, at a time, by their power series in mpmath with 60 digits.

    tests/reference/singular_functions.py > tests/reference/singular_functions.txt

A row has a problem, a time, an unknown and its value there. The series is taken to so many terms that the last ones are
less than 10^-45; n (n - 1 + k) y_n is coefficient n - 2 of F(y), by the recurrences of powers, exponentials and sines."""
import mpmath as mp

mp.mp.dps = 60
TERMS = 1500


def power(y, r, p, n):
    """Coefficient n of y^r from the lower ones p."""
    if n == 0:
        return mp.power(y[0], r)
    return sum((r * j - (n - j)) * y[j] * p[n - j] for j in range(1, n + 1) if y[j] and p[n - j]) / (n * y[0])


def exponential(y, sign, e, n):
    if n == 0:
        return mp.exp(sign * y[0])
    return sum(j * sign * y[j] * e[n - j] for j in range(1, n + 1) if y[j] and e[n - j]) / n


def solution(k, start, right, time):
    """`right(y, kept, n)` is coefficient n of F(y); it keeps its own series."""
    y = [mp.mpf(start), mp.mpf(0)]
    kept = {}
    total = y[0]
    scale = mp.mpf(1)
    for n in range(2, TERMS):
        y.append(right(y, kept, n - 2) / (n * (n - 1 + k)) if n % 2 == 0 else mp.mpf(0))
        term = y[n] * mp.mpf(time)**n
        total += term
        if n % 2 == 0 and n > 20 and abs(term) < mp.mpf(10)**-48:
            return total
    raise ValueError("the series has not converged")


def kept_series(kept, name, make, n):
    """Odd coefficients are 0."""
    series = kept.setdefault(name, [])
    while len(series) <= n:
        series.append(make(series, len(series)) if len(series) % 2 == 0 else mp.mpf(0))
    return series[n]


def powers(r, sign=-1):
    return lambda y, kept, n: sign * kept_series(kept, "p", lambda p, m: power(y, mp.mpf(r), p, m), n)


def boltzmann(y, kept, n):
    return kept_series(kept, "e", lambda e, m: exponential(y, -1, e, m), n)


def white_dwarf(c):
    def right(y, kept, n):
        shifted = [sum(y[j] * y[m - j] for j in range(m + 1)) - (c if m == 0 else 0) for m in range(n + 1)]
        return -kept_series(kept, "w", lambda p, m: power(shifted, mp.mpf(3) / 2, p, m), n)

    return right


def sine(y, kept, n):
    pair = kept.setdefault("sc", ([], []))
    s, c = pair
    while len(s) <= n:
        m = len(s)
        if m == 0:
            s.append(mp.sin(y[0]))
            c.append(mp.cos(y[0]))
        else:
            s.append(sum(j * y[j] * c[m - j] for j in range(1, m + 1)) / m)
            c.append(-sum(j * y[j] * s[m - j] for j in range(1, m + 1)) / m)
    return -s[n]


PROBLEMS = [
    ("y'' + 2*y'/x = exp(-y); y(0) = 0; y'(0) = 0", "1", 2, 0, boltzmann),
    ("y'' + 2/t*y' + y^(3/2) = 0; y(0) = 1; y'(0) = 0", "1", 2, 1, powers(1.5)),
    ("y'' + 2/t*y' + y^m = 0; y(0) = 1; y'(0) = 0; m = 1/2", "1", 2, 1, powers(0.5)),
    ("y'' + 2/t*y' + y^(-2) = 0; y(0) = 1; y'(0) = 0", "1", 2, 1, powers(-2)),
    ("y'' + 2/t*y' + (y^2 - C)^(3/2) = 0; y(0) = 1; y'(0) = 0; C = 1/5", "1", 2, 1, white_dwarf(mp.mpf(1) / 5)),
    ("y'' + y'/t + sin(y) = 0; y(0) = 2; y'(0) = 0", "1", 1, 2, sine),
    ("y'' + 3*y'/t = sqrt(y); y(0) = 1; y'(0) = 0", "1", 3, 1, powers(0.5, 1)),
]

if __name__ == "__main__":
    for text, time, k, start, right in PROBLEMS:
        print(f"{text} | {time} | y | {mp.nstr(solution(k, start, right, time), 40, strip_zeros=False)}")
