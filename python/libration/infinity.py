"""Solutions with limits at infinity: boundary layers, fronts, solitons, and eigenvalues of wells."""

from __future__ import annotations

from collections.abc import Sequence

from . import _libration
from .ball import Ball
from .problems import Values, values_of
from .progress import with_progress
from .tables import Table
from .texts import times_text


class ConnectingSolution(Values):
    """The proved unknowns by name, and what the proof yields besides: at_infinity() makes it."""

    def __init__(self, text: str, unknowns: str, table: Table) -> None:
        self._text = text
        self._unknowns = unknowns
        self.limits: dict[str, Ball] = {}  #: free limits, "H(inf)"
        self.rates: dict[str, Ball] = {}  #: "rate 1", the slowest rate of decay, and "rate 1 at -inf"
        self.amplitudes: dict[str, Ball] = {}  #: of y = y(inf) + A exp(-rate |t|) + smaller terms: "y"
        self.angle: Ball | None = None  #: at which the manifolds of the two ends intersect
        own: dict[str, Ball] = {}
        of_kind = {"unknown": own, "limit": self.limits, "rate": self.rates}
        for (name, value), row in zip(values_of(table).items(), table):
            kind = row["kind"]
            if kind == "amplitude":
                self.amplitudes[name.removeprefix("amplitude of ")] = value
            elif kind == "angle":
                self.angle = value
            else:
                of_kind[str(kind)][name] = value
        super().__init__(own)

    @with_progress
    def states(self, times: str | Sequence[float | str], digits: int = 50) -> Table:
        """The unknowns and their lower derivatives at times, of which "inf" and "-inf" are the limits, each digit proved. An orbit
        with limits at both ends has its t = 0 where y = y(-inf) +- exp(rate t) + smaller terms, y the first unknown with a limit at -inf."""
        return Table._of(_libration.states_at_infinity(self._text, self._unknowns, times_text(times)[0], digits))


@with_progress
def at_infinity(text: str, unknowns: str | Sequence[str] = (), digits: int = 50) -> ConnectingSolution:
    """The parameters and initial values that the conditions at infinity of a text determine, each digit proved:
    at_infinity("f''' + f*f'' = 0; f(0)=0; f'(0)=0; f'(inf)=1"). The unknowns have first guesses, ["c = 0.3"], or none, "f''(0)"; without
    a list they are those without a value. UndecidedError if no solution is found or proved."""
    names = unknowns if isinstance(unknowns, str) else ", ".join(unknowns)
    return ConnectingSolution(text, names, Table._of(_libration.find_at_infinity(text, names, digits)))


@with_progress
def eigenvalues(text: str, energy: str = "E", count: int = 1, digits: int = 50) -> list[Ball]:
    """The first eigenvalues of psi'' = (V(x) - E)*psi with a condition at each end, proved to be the first ones, in order:
    eigenvalues("psi'' = (x^4 - E)*psi; psi(-inf) = 0; psi(inf) = 0", count=3). UndecidedError if there are fewer."""
    return list(values_of(Table._of(_libration.eigenvalues(text, energy, count, digits))).values())
