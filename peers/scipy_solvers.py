#!/usr/bin/env python3
# Initial value problems by SciPy's solve_ivp, for the study `solvers`: see equation_code.hpp.
import math
import sys

sys.dont_write_bytecode = True

try:
    import numpy
    import scipy
    from scipy.integrate import solve_ivp
except ImportError:
    sys.exit(3)
import warnings

from equation_code import answer

warnings.simplefilter("ignore")  # a step that is too small is reported by its outcome


def solve(equations, method, tolerance):
    found = solve_ivp(
        equations, (equations.begin, equations.times[-1]), equations.start, method=method, t_eval=equations.times,
        rtol=tolerance, atol=tolerance * numpy.array(equations.scale))
    good = found.success and numpy.isfinite(found.y).all() and found.y.shape[1] == len(equations.times)
    return found.y.T.tolist() if good else None


answer("SciPy " + scipy.__version__, math, float, solve)
