#!/usr/bin/env python3
# Initial value problems by mpmath's odefun in the precision of double, for the study `solvers`: see equation_code.hpp.
import sys

sys.dont_write_bytecode = True

try:
    import mpmath
except ImportError:
    sys.exit(3)

from equation_code import answer


def solve(equations, method, tolerance):
    solution = mpmath.odefun(equations, equations.begin, equations.start, tol=mpmath.mpf(tolerance))
    return [solution(t) for t in equations.times]


mpmath.mp.prec = 53
answer("mpmath " + mpmath.__version__, mpmath, mpmath.mpf, solve)
