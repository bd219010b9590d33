#!/usr/bin/env python3
"""The ground state energy of p^2/2 + x^2/2 + g x^4 at g = 1 and 1/10, by mpmath.

    python3 tests/reference/quartic_oscillator.py

Prints 25 digits for tests/convergence/sum_test.cpp (1 minute): the lowest eigenvalue of the matrix of the even states of the
harmonic oscillator. Two sizes of the matrix that agree to more digits than are printed confirm it.
"""

from mpmath import mp, mpf, matrix, eigsy, sqrt


def energy(g, states):
    h = matrix(states, states)
    for i in range(states):
        k = 2 * i
        h[i, i] = k + mpf(1) / 2 + g * mpf(6 * k * k + 6 * k + 3) / 4
        if i + 1 < states:
            h[i, i + 1] = h[i + 1, i] = g * (2 * k + 3) * sqrt((k + 1) * (k + 2)) / 2
        if i + 2 < states:
            h[i, i + 2] = h[i + 2, i] = g * sqrt((k + 1) * (k + 2) * (k + 3) * (k + 4)) / 4
    return eigsy(h, eigvals_only=True)[0]


mp.dps = 40
for g in (mpf(1), mpf(1) / 10):
    values = [energy(g, states) for states in (100, 120)]
    assert abs(values[0] - values[1]) < mpf(10) ** -27, values
    print(mp.nstr(g, 3), mp.nstr(values[1], 25))
