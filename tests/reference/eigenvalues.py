"""Eigenvalues of psi'' = (V(x) - E) psi on the line, by the Rayleigh-Ritz method in a basis of oscillator functions:

    python3 tests/reference/eigenvalues.py > tests/reference/eigenvalues.csv

The matrix of p^2 + V in the first N functions of p^2 + w^2 x^2 has eigenvalues above the exact ones that converge as N
grows; printed are the digits in which two sizes agree, less two. It shares nothing with the library, which integrates the equation.
"""
from mpmath import mp, mpf, matrix, eigsy, sqrt, log10, floor, nstr

mp.dps = 50
WELLS = [("x^2", {2: 1}, 1), ("x^4", {4: 1}, 3), ("x^6", {6: 1}, 4), ("(x^2-4)^2", {4: 1, 2: -8, 0: 16}, 3),
         ("x^4+x", {4: 1, 1: 1}, 3), ("x^4-3*x^3+x/2", {4: 1, 3: -3, 1: mpf(1) / 2}, 3), ("x^6-7*x^2", {6: 1, 2: -7}, 4)]


def multiplied_by_x(columns, w):
    """x times a symmetric band matrix in the oscillator basis, as lists of rows"""
    n = len(columns)
    step = [sqrt(mpf(k + 1) / (2 * w)) for k in range(n)]
    return [[(step[i - 1] * columns[i - 1][k] if i > 0 else 0) + (step[i] * columns[i + 1][k] if i + 1 < n else 0)
             for k in range(n)] for i in range(n)]


def spectrum(potential, w, size, count):
    n = size + max(potential) + 2              # the truncation of products stays outside
    power = [[mpf(int(i == k)) for k in range(n)] for i in range(n)]
    total = matrix(size, size)
    w = mpf(w)
    for order in range(max(max(potential), 2) + 1):
        factor = mpf(potential.get(order, 0)) - (w * w if order == 2 else 0)
        if factor != 0:
            for i in range(size):
                for k in range(size):
                    total[i, k] += factor * power[i][k]
        power = multiplied_by_x(power, w)
    for i in range(size):
        total[i, i] += w * (2 * i + 1)         # p^2 = (p^2 + w^2 x^2) - w^2 x^2
    return list(eigsy(total, eigvals_only=True))[:count]


if __name__ == "__main__":
    print("potential,index,value")
    for text, potential, w in WELLS:
        first = spectrum(potential, w, 76, 5)
        second = spectrum(potential, w, 88, 5)
        for index, (a, b) in enumerate(zip(first, second)):
            digits = int(floor(-log10(abs(a - b) / abs(b)))) - 2 if a != b else 40
            print(f"{text},{index},{nstr(b, min(digits, 40), strip_zeros=False)}", flush=True)
