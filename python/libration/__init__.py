"""Libration: power-series solutions of ordinary differential equations to arbitrary precision, with rigorous error bounds.

    import libration as lb
    swing = lb.motion(theta0="150deg", omega0=0)
    swing.theta("1e12", digits=50)
    lb.problem("x' = 1 + x^2; x(0) = 0").reference(1, digits=40)

Numbers are exact as they are written: texts, int, Fraction, Decimal, numbers of mpmath and SymPy. A float is refused
where it would stand for a number that a person meant. Results are Balls: digits, a bound of what they miss, and what
stands behind that. Errors are LibrationError: UndefinedError (ArgumentError, a ValueError, and RangeError), UnableError
(UndecidedError), Fault.
"""

from . import _libration
from .ball import Ball, ball
from .errors import ArgumentError, Fault, LibrationError, RangeError, UnableError, UndecidedError, UndefinedError
from .motions import Motion, Samples, motion
from .problems import Problem, Radius, Singularities, catalogue, problem, radius
from .studies import Study, study
from .tables import Row, Table
from .texts import exact
from .verification import Verdicts, verify

__version__: str = _libration.version()

__all__ = [
    "ArgumentError",
    "Ball",
    "Fault",
    "LibrationError",
    "Motion",
    "Problem",
    "Radius",
    "RangeError",
    "Row",
    "Samples",
    "Singularities",
    "Study",
    "Table",
    "UnableError",
    "UndecidedError",
    "UndefinedError",
    "Verdicts",
    "ball",
    "catalogue",
    "exact",
    "motion",
    "problem",
    "radius",
    "study",
    "verify",
]
