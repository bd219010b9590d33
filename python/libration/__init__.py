"""Libration: power-series solutions of ordinary differential equations to arbitrary precision, with rigorous error bounds.

    import libration as lb
    swing = lb.motion(theta0="150deg", omega0=0)
    swing.theta("1e12", digits=50)
    lb.problem("x' = 1 + x^2; x(0) = 0").reference(1, digits=40)
    lb.problem("lorenz").solution().states([1, 2])  # a solution that keeps its steps for further questions
    lb.odefun(lambda t, y: y, 0, 1)(1)              # as mpmath's, proved
    lb.solve_ivp(lambda t, y: -y, [0, 5], [1])      # as SciPy's, in double

Numbers are exact as they are written: texts, int, Fraction, Decimal, numbers of mpmath and SymPy. A float is refused
where it would stand for a number that a person meant, and is data in radius(), trajectory(), odefun() and solve_ivp().
Results are Balls: digits, a bound of their error, and their rigour: 'proved', 'two-method' or 'heuristic'. Errors are
LibrationError: UndefinedError (ArgumentError, a ValueError, and RangeError), UnableError (UndecidedError), Fault.
"""

from . import _libration
from .ball import Ball, ball
from .certificates import check
from .errors import ArgumentError, Fault, LibrationError, RangeError, UnableError, UndecidedError, UndefinedError
from .infinity import ConnectingSolution, at_infinity, eigenvalues
from .ivp import OdeResult, OdeSolution, solve_ivp
from .laws import Law
from .motions import Motion, Samples, motion
from .odefun import OdeFunction, odefun
from .progress import show_progress
from .problems import Branch, Derivatives, Problem, Radius, Singularities, catalogue, problem, radius
from .solutions import Solution
from .studies import Study, study, table
from .tables import Row, Table
from .texts import exact
from .trajectories import Trajectory
from .verification import Verdicts, verify

__version__: str = _libration.version()

__all__ = [
    "ArgumentError",
    "Ball",
    "Branch",
    "ConnectingSolution",
    "Derivatives",
    "Fault",
    "Law",
    "LibrationError",
    "Motion",
    "OdeFunction",
    "OdeResult",
    "OdeSolution",
    "Problem",
    "Radius",
    "RangeError",
    "Row",
    "Samples",
    "Singularities",
    "Solution",
    "Study",
    "Table",
    "Trajectory",
    "UnableError",
    "UndecidedError",
    "UndefinedError",
    "Verdicts",
    "at_infinity",
    "ball",
    "catalogue",
    "check",
    "eigenvalues",
    "exact",
    "motion",
    "odefun",
    "problem",
    "radius",
    "show_progress",
    "solve_ivp",
    "study",
    "table",
    "verify",
]
