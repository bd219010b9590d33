"""One solution of a problem, for several questions."""

from __future__ import annotations

from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

from . import _libration
from .ball import Ball
from .errors import UndecidedError, with_partial
from .progress import with_progress
from .tables import Row, Table
from .texts import digits_and_rigour, rigour_of, text_of, times_text

if TYPE_CHECKING:
    from .laws import Law
    from .problems import Problem, Radius


class Solution:
    """One solution, which keeps the steps of its proved integrations, as far as they fit into 64 MiB in each direction of
    time; made by Problem.solution(). A question is answered from them as far as they lead, if it has no more digits than
    those before; then they are continued. `steps` counts them: states() of the same times makes none anew. Equations with
    events, piecewise right-hand sides or delays, and closed forms, have the same answers without kept steps. Any number of
    threads may ask it: one waits for the other.

        s = libration.problem("x'' = -x^3; x(0) = 1; x'(0) = 0").solution()
        s.states([1, 2, 3])
        s.events("x = 0", count=2)
        s.coefficients(20, at=2)
        s.radius()
        s.certificate("oscillator.cert", times=[1, 2, 3])
    """

    def __init__(self, problem: Problem) -> None:
        self._of = problem
        self._solution = _libration.Solution(problem._problem)

    def __repr__(self) -> str:
        return f"{self._of!r}.solution()"

    def __reduce__(self) -> tuple[Any, ...]:
        return Solution, (self._of,)

    @property
    def problem(self) -> Problem:
        """The problem that it solves."""
        return self._of

    @property
    def names(self) -> list[str]:
        """The unknowns and their lower derivatives, x, x'."""
        return self._of.names

    @property
    def steps(self) -> int:
        """The number of steps that have been made for all questions up to now."""
        return self._solution.steps()

    @with_progress
    def states(self, times: Any, digits: int = 50, rigour: str = "proved", exact: bool = True) -> Row | Table:
        """The unknowns and their lower derivatives at one time, or at a list of times as a Table: as
        Problem.reference(), which integrates anew each time."""
        texts, alone = times_text(times, exact)

        def form(parts: Any) -> Row | Table:
            found = Table._of(parts)
            found = found if exact else found.with_times_as_floats()
            return found[0] if alone else found

        try:
            return form(self._solution.states(texts, digits, rigour_of(rigour)))
        except UndecidedError as problem:
            raise with_partial(problem, form) from None

    @with_progress
    def events(
        self,
        condition: str,
        count: int = 1,
        digits: int = 50,
        crossing: str = "any",
        before: Any = None,
        from_start: bool = False,
        horizon: int | None = None,
    ) -> Table:
        """The first `count` times after the start at which a condition "x' = 1/2" holds, and the unknowns there: as
        Problem.events(). crossing: only where the difference of the two sides increases with time, "up", or decreases,
        "down". before: only events before or at this time, which may be before the start. from_start: the start as
        well if the condition holds there. horizon: the largest number of steps without an event."""
        settings = [f"crossing = {crossing}", f"from_start = {'yes' if from_start else 'no'}"]
        if before is not None:
            settings.append(f"before = {text_of(before, 'before')}")
        if horizon is not None:
            settings.append(f"horizon = {horizon}")
        try:
            return Table._of(self._solution.events(condition, "; ".join(settings), count, digits))
        except UndecidedError as problem:
            raise with_partial(problem, Table._of) from None

    @with_progress
    def coefficients(
        self, order: int, scalar: str = "ball:50", at: Any = None, via: Any = None, first: int = 0
    ) -> Table:
        """The Taylor coefficients first .. order of every unknown, as Problem.coefficients(); in balls about a time the
        kept steps lead there."""
        if scalar == "rational":
            return self._of.coefficients(order, scalar, at, via, first)
        digits, rigour = digits_and_rigour(scalar)
        point = None if at is None else text_of(at, "at")
        corners = None if via is None else times_text(via)[0]
        return Table._of(self._solution.coefficients(point, corners, first, order, digits, rigour))

    def law(self, show: str | None = None, within: Any = None) -> Law:
        """The law of all Taylor coefficients about the start, proved, as Problem.law()."""
        return self._of.law(show, within)

    def radius(self, order: int = 300, digits: int = 30) -> Radius:
        """The radius of convergence about the start from its coefficients, heuristic: as Problem.radius()."""
        return self._of.radius(order, digits)

    def radius_bounds(self, digits: int = 12) -> tuple[Ball, Ball]:
        """Proved bounds of the radius of convergence about the start, as Problem.radius_bounds()."""
        return self._of.radius_bounds(digits)

    @with_progress
    def certificate(
        self,
        path: str | PathLike[str],
        times: Any = None,
        condition: str | None = None,
        count: int = 1,
        digits: int = 50,
    ) -> Row | Table:
        """The states at times that are fractions, or the first `count` events of a condition; and in the file `path` a
        certificate, from which check() proves them again, in integers. The values are read from the kept steps; the
        certificate has other steps. Raises ValueError unless either times or a condition are given."""
        if (times is None) == (condition is None):
            raise ValueError("a certificate is of states or of events: give either times or a condition")
        if condition is not None:
            return Table._of(self._solution.event_certificate(condition, count, digits, fspath(path)))
        texts, alone = times_text(times)
        found = Table._of(self._solution.certificate(texts, digits, fspath(path)))
        return found[0] if alone else found
