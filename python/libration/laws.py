"""The law of all Taylor coefficients of a solution, proved."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _libration
from .ball import Ball
from .progress import with_progress
from .tables import Table
from .texts import text_of

if TYPE_CHECKING:
    from .problems import Problem


class Law:
    """The law of the coefficients a_n of (t - t0)^n of one unknown or derivative; made by Problem.law(). All
    singularities in |t - t0| <= rho are proved, and a_n = their terms + E_n with a proved bound of E_n for every
    n >= n0. Any number of threads may ask it: one waits for the other.

        law = libration.problem("y' = y^3 + t; y(0) = 1").law()
        law.singularities
        law.coefficient(10**6, digits=30)
        law.ratio(10**6)
    """

    def __init__(self, problem: Problem, show: str | None = None, within: Any = None) -> None:
        self._of = problem
        self._show = show
        self._within = None if within is None else text_of(within, "within")
        self._law = _libration.Law(problem._problem, show, self._within)

    def __repr__(self) -> str:
        return f"{self._of!r}.law({self._show!r}, {self._within!r})"

    def __str__(self) -> str:
        return "\n".join(f"{row['name']}: {row['text']}" for row in Table._of(self._law.words()))

    def __reduce__(self) -> tuple[Any, ...]:
        return Law, (self._of, self._show, self._within)

    @property
    def problem(self) -> Problem:
        """The problem that it is the law of."""
        return self._of

    @property
    def rho(self) -> float:
        """The distance from the initial point up to which all singularities are known, exactly this double."""
        return self._law.rho()

    @property
    def n0(self) -> int:
        """The law holds for all n >= n0."""
        return self._law.first()

    @property
    def stride(self) -> int:
        """p: by symmetry a_n = 0 unless n = residue mod p."""
        return self._law.stride()

    @property
    def residue(self) -> int:
        return self._law.residue()

    @property
    def singularities(self) -> Table:
        """Those within rho, proved: position_re, position_im, modulus, kind, exponent, coefficient_re, coefficient_im;
        the coefficient is that of (t - t*)^exponent or log(t - t*), at branch points and singular points of linear
        equations of x^exponent log(x)^m, x = 1 - (t - t0)/(t* - t0)."""
        return self.table(30)

    def table(self, digits: int) -> Table:
        """The singularities with so many digits."""
        return Table._of(self._law.singularities(digits))

    @with_progress
    def coefficient(self, n: int, digits: int = 30) -> Ball:
        """a_n, proved, without the ones before: by the law where it gives the digits, else by the recurrence up to
        n = 20000. Raises UndecidedError if neither gives a digit."""
        return Ball._of(self._law.coefficient(n, digits))

    @with_progress
    def ratio(self, n: int, digits: int = 30) -> Ball:
        """a_n/a_(n-p), p the stride: the ratio of the Domb-Sykes plot, proved. Raises ArgumentError where a_n is 0
        by symmetry."""
        return Ball._of(self._law.ratio(n, digits))
