#!/usr/bin/env python3
"""Closed forms for tests/query/shooting/periodic_orbit_test.cpp, by mpmath: periods and multipliers."""
from mpmath import mp, mpf, ellipk, sin, pi, gamma, sqrt, exp

mp.dps = 40
print("pendulum from rest at 1, 4 K(sin^2(1/2)):", 4 * ellipk(sin(mpf(1) / 2) ** 2))
quartic = 4 * sqrt(mpf(2)) * gamma(mpf(1) / 4) ** 2 / (4 * sqrt(2 * pi))
print("x'' = -x^3 from rest at 1, 4 sqrt(2) K_lemniscate:", quartic)
print("its start for T = 7.5:", quartic / mpf("7.5"))
print("multiplier of r' = r (1 - r^2), exp(-4 pi):", exp(-4 * pi))
