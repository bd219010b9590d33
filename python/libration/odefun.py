"""Solutions of differential equations with the signature of mpmath's odefun, every digit proved."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .ball import Ball
from .problems import Problem
from .symbols import constant_text
from .tracing import text_of_system, unknown_names


class OdeFunction:
    """y(t) of y' = F(t, y), made by odefun(): at a time a number of mpmath, or a list of them if y0 was a list."""

    #: Digits of the balls in addition to those of mpmath, so that a number is correct after rounding.
    _more_digits = 3

    def __init__(self, problem: Problem, size: int, is_vector: bool, digits: int | None) -> None:
        self.problem = problem
        self._size = size
        self._is_vector = is_vector
        self._digits = digits
        self._known: dict[tuple[str, int], list[Ball]] = {}

    def __repr__(self) -> str:
        return f"libration.odefun of\n{self.problem.text}"

    def balls(self, t: Any, digits: int) -> list[Ball]:
        """The unknowns at a time with so many proved digits. Raises UndecidedError as Problem.reference."""
        time = constant_text(t)
        if (time, digits) not in self._known:
            row = self.problem.reference(time, digits)
            self._known[time, digits] = [row[name] for name in unknown_names(self._size)]  # type: ignore[misc]
        return self._known[time, digits]

    def __call__(self, t: Any) -> Any:
        """At the precision of mpmath.mp, correct to one unit in the last of its digits; earlier than t0 as well. A float
        is the double that it is. Raises UndecidedError for a time that is not reached."""
        from mpmath import mp

        digits = (self._digits or mp.dps) + self._more_digits
        values = [+ball.mpmath() for ball in self.balls(t, digits)]
        return values if self._is_vector else values[0]


def odefun(
    F: Callable[..., Any],
    t0: Any,
    y0: Any,
    tol: Any = None,
    degree: int | None = None,
    method: str = "taylor",
    verbose: bool = False,
) -> OdeFunction:
    """The solution of y' = F(t, y), y(t0) = y0, with the arguments of mpmath.odefun; y0 is a number or a list.

    F is called once with symbols (libration.tracing) and may not branch on them. Its numbers are exact: floats and numbers
    of mpmath are the binary numbers that they are, except pi and e of mpmath; a Fraction, or a text for t0 and y0, is
    exact as written. tol sets the number of digits; degree, method and verbose do not change a proved result.

    >>> f = odefun(lambda t, y: y, 0, 1)
    >>> f(1)                                    # mpf('2.7182818284590451')
    """
    if method != "taylor":
        raise ValueError(f"method is {method!r}: only 'taylor' exists")
    is_vector = hasattr(y0, "__len__") and not isinstance(y0, str)
    starts = list(y0) if is_vector else [y0]
    traced = F if is_vector else (lambda t, y: [F(t, y[0])])
    text = text_of_system(traced, t0, starts, of_arrays=False)
    return OdeFunction(Problem(text), len(starts), is_vector, None if not tol else _digits_of(tol))


def _digits_of(tolerance: Any) -> int:
    from mpmath import ceil, log10

    return max(1, int(ceil(-log10(tolerance))))
