"""Any differential equation."""

from __future__ import annotations

import html
import json
import re
import warnings
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import Any, NamedTuple, overload

import numpy as np

from . import _libration
from .ball import Ball
from .coefficients import texts_of_coefficients
from .drawing import axes_of, table_of
from .errors import UndecidedError, with_partial
from .latex import latex_of, statements_of
from .laws import Law
from .progress import with_progress
from .solutions import Solution
from .tables import Cell, Row, Table, number_of
from .texts import digits_and_rigour, rigour_of, text_of, times_text
from .trajectories import Trajectory, trajectory_of


class Radius(NamedTuple):
    """A radius of convergence from coefficients alone, which prove none: the verdict, and every test behind it."""

    value: Ball | None  #: None where the tests see no radius; `note` is the reason
    unknown: str
    note: str
    tests: Table

    def __str__(self) -> str:
        if self.value is None:
            return self.note
        return f"{self.value}{f' +- {self.value.uncertainty}' if self.value.uncertainty else ''} (heuristic)"

    def __repr__(self) -> str:
        return str(self)

    def _list(self, name: str) -> list[dict[str, float]]:
        rows = json.loads(str(self.tests[0][name]) or "[]")
        return [{key: float(value) for key, value in row.items()} for row in rows]

    @property
    def history(self) -> list[dict[str, float]]:
        """The verdict on the first coefficients alone: order, radius, uncertainty."""
        return self._list("history")

    @property
    def fits(self) -> list[dict[str, float]]:
        """The singularity by each differential approximant: position, exponent."""
        return self._list("fits")

    @property
    def predictions(self) -> list[dict[str, float]]:
        """How well the coefficients before it predict a coefficient: order, log10_error, relative."""
        return self._list("predictions")

    def plot(self, ax: Any = None, what: str = "tests") -> Any:
        """Draws the radius of each test with its uncertainty ("tests"), the verdict against the number of coefficients
        ("history"), positions and exponents by all approximants ("fits"), or the errors of predicted coefficients
        ("predictions"), and returns the axes of matplotlib."""
        if what not in ("tests", "history", "fits", "predictions"):
            raise ValueError(f"{what!r} cannot be drawn: write 'tests', 'history', 'fits' or 'predictions'")
        axes = axes_of(ax)
        if what == "fits":
            axes.plot([each["position"] for each in self.fits], [each["exponent"] for each in self.fits], ".")
            axes.set_xlabel("position")
            axes.set_ylabel("exponent")
        elif what == "predictions":
            axes.plot(
                [each["order"] for each in self.predictions], [each["log10_error"] for each in self.predictions], ".-"
            )
            axes.set_xlabel("order")
            axes.set_ylabel("log10 of the relative error of the prediction")
        elif what == "history":
            orders = [each["order"] for each in self.history]
            radii = [each["radius"] for each in self.history]
            axes.errorbar(orders, radii, yerr=[each["uncertainty"] for each in self.history], fmt="o-")
            axes.set_xlabel("order")
            axes.set_ylabel("radius of convergence")
        else:
            found = [row for row in self.tests if isinstance(row["radius"], Ball)]
            values = [number_of(row["radius"]) for row in found]
            reaches = [float(row["radius"].uncertainty or 0) for row in found]  # type: ignore[union-attr]
            axes.errorbar(values, range(len(found)), xerr=reaches, fmt="o")
            axes.set_yticks(range(len(found)), [str(row["method"]) for row in found])
            axes.set_xlabel("radius of convergence")
        return axes

    def _repr_html_(self) -> str:
        return self.tests._repr_html_()


class Singularities(Table):
    """position_re, position_im, modulus, kind, exponent_re, exponent_im, unknown, by modulus."""

    def __init__(self, names: Sequence[str], cells: Sequence[Sequence[Cell]], complete: bool) -> None:
        super().__init__(names, cells)
        #: Whether every part of the disc was searched; where it was not, singularities accumulate, or hide others.
        self.complete = complete

    def __repr__(self) -> str:
        return str(self) + ("" if self.complete else "\nand possibly more: a part of the disc is unresolved")

    def plot(self, x: str | None = None, y: str | None = None, ax: Any = None) -> Any:
        """Draws the positions in the complex plane, and returns the axes of matplotlib."""
        x, y = x or "position_re", y or "position_im"
        axes = axes_of(ax)
        axes.plot([number_of(cell) for cell in self[x]], [number_of(cell) for cell in self[y]], "x")
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        return axes


class Branch(Table):
    """point ("solution" or "turning point"), the parameter, and the unknowns, in the order of the branch."""

    def __init__(self, names: Sequence[str], cells: Sequence[Sequence[Cell]]) -> None:
        super().__init__(names[:-1], [row[:-1] for row in cells])
        #: Where and why the branch ends.
        self.end = str(cells[-1][-1]) if cells else ""

    def __repr__(self) -> str:
        return f"{self}\nthe branch {self.end}"

    def plot(self, x: str | None = None, y: str | None = None, ax: Any = None) -> Any:
        """Draws an unknown, the first one unless `y` is another, against the parameter, and returns the axes of
        matplotlib."""
        x, y = x or self.names[1], y or self.names[2]
        axes = axes_of(ax)
        axes.plot([number_of(cell) for cell in self[x]], [number_of(cell) for cell in self[y]], ".-")
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        return axes


class Derivatives(Table):
    """The values at times, and their derivatives dx(t)/dx(0), ... in further columns."""

    def __init__(
        self, names: Sequence[str], cells: Sequence[Sequence[Cell]], quantities: Sequence[str], by: Sequence[str]
    ) -> None:
        super().__init__(names, cells)
        self.quantities = list(quantities)
        self.by = list(by)

    @property
    def matrix(self) -> np.ndarray:
        """The derivatives as an array [time][quantity][number] of Balls ('' where there is none)."""
        first = 1 + len(self.quantities)
        flat = np.empty((len(self.cells), len(self.names) - first), dtype=object)
        for i, row in enumerate(self.cells):
            flat[i, :] = row[first:]
        return flat.reshape(len(self.cells), len(self.quantities), len(self.by))

    def floats(self) -> np.ndarray:
        """The same as doubles, nan where there is no derivative."""
        return np.vectorize(number_of, otypes=[float])(self.matrix)


class Problem:
    """Differential equations with their starts; made by problem(). Any number of threads may ask it."""

    def __init__(self, text: str, settings: str = "") -> None:
        self._text = text
        self._settings = settings
        self._problem = _libration.Problem(text, settings)

    def __repr__(self) -> str:
        return f"libration.Problem({self._text!r}, {self._settings!r})"

    def latex(self) -> str:
        """The statements as LaTeX, a line each in an environment `aligned`: with the changes behind them."""
        lines = [latex_of(each) for each in statements_of(self._text) + statements_of(self._settings)]
        return r"\begin{aligned}" + r" \\ ".join("& " + line for line in lines) + r"\end{aligned}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    def _repr_html_(self) -> str:
        return f"<div>{html.escape(self._repr_latex_(), quote=False)}</div>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Problem, (self._text, self._settings)

    @property
    def text(self) -> str:
        """The equations in the notation of the command, without the changes."""
        return self._text

    @property
    def settings(self) -> str:
        """What was changed."""
        return self._settings

    @property
    def names(self) -> list[str]:
        """The unknowns and their lower derivatives, x, x'."""
        return self._problem.names()

    def solution(self) -> Solution:
        """The solution as an object that keeps the steps of its integration: for several questions about it."""
        return Solution(self)

    @with_progress
    def reference(
        self,
        times: Any,
        digits: int = 50,
        rigour: str = "proved",
        exact: bool = True,
        certificate: str | PathLike[str] | None = None,
    ) -> Row | Table:
        """The unknowns and their lower derivatives at one time, or at a list of times as a Table; with exact=False floats
        are the doubles that they are. Raises UndecidedError
        for a time that is not reached, which says up to where the solution is proved to exist, and for a value that is
        not distinguished from 0; its `partial` has what is proved of the others. ArgumentError for proofs from a
        singular start whose right sides are no polynomials. Ctrl-C ends a proof.

        certificate is the path of a file from which check() proves the values again, in integers; the times are then
        fractions."""
        texts, alone = times_text(times, exact)

        def form(parts: Any) -> Row | Table:
            states = Table._of(parts)
            states = states if exact else states.with_times_as_floats()
            return states[0] if alone else states

        if certificate is not None:
            if rigour != "proved":
                raise ValueError("a certificate is of proved values: leave out rigour")
            return form(self._problem.certificate(texts, digits, fspath(certificate)))
        try:
            return form(self._problem.states(texts, digits, rigour_of(rigour)))
        except UndecidedError as problem:
            raise with_partial(problem, form) from None

    @with_progress
    def derivatives(
        self, times: Any, by: str | Sequence[str], digits: int = 50, exact: bool = True
    ) -> Derivatives:
        """The unknowns at times, and the derivative of each with respect to initial values and parameters, "x(0)",
        "x'(0)", "r", every digit proved: a Table with the columns dx(t)/dx(0), ..., whose `matrix` is an array. The
        derivative with respect to a parameter includes the motion of initial values that contain it. Raises
        UndecidedError as reference(), also for a derivative that is not distinguished from 0."""
        numbers = [each.strip() for each in by.split(",")] if isinstance(by, str) else list(by)

        def form(parts: Any) -> Derivatives:
            table = Table._of(parts)
            return Derivatives(table.names, table.cells, self.names, numbers)

        try:
            return form(self._problem.derivatives(times_text(times, exact)[0], ",".join(numbers), digits))
        except UndecidedError as problem:
            raise with_partial(problem, form) from None

    @with_progress
    def conditions(self, times: Any, exact: bool = True) -> Table:
        """time and condition: the largest of (|t y'| + sum of |x dy/dx|)/max(1, |y|) over the unknowns y, x the initial
        values and parameters, three digits: the error amplification that no algorithm can avoid, as in verify()."""
        texts, _ = times_text(times, exact)
        values = ",".join(["0"] * len(self.names) * len(texts.split(",")))
        compared = Table._of(self._problem.verify(",".join(self.names), texts, values, "tolerance = 1"))
        return Table(["time", "condition"], list(zip(compared["time"], compared["condition"])))

    @with_progress
    def enclosures(self, times: Any, digits: int = 50, parts: int = 64, exact: bool = True) -> Table:
        """Bounds of all solutions of a problem whose initial values or parameters are intervals, x="[0.9, 1.1]",
        b="1 +- 0.1", or of the single solution: at times, and over all times of a span, "0:10" or (0, 10), in a list. A
        Table with the columns from, to, unknown, lower, upper, rounded outwards and proved. The set is divided into at most
        `parts` parts. Raises UndecidedError for times that not all solutions are proved to reach; its `partial` has the
        others."""
        spans = times if isinstance(times, list) else [times]
        texts = [
            ":".join(text_of(end, "time", exact) for end in each) if isinstance(each, tuple) else times_text(each, exact)[0]
            for each in spans
        ]
        try:
            return Table._of(self._problem.enclosures(",".join(texts), parts, digits))
        except UndecidedError as problem:
            raise with_partial(problem, Table._of) from None

    @with_progress
    def enclosed_events(self, condition: str, count: int = 1, digits: int = 50, parts: int = 64) -> Table:
        """Bounds of the first `count` events of all solutions of a problem whose initial values or parameters are
        intervals: a Table with the columns event, quantity ("time" and the unknowns), lower, upper, rounded outwards and
        proved, as enclosures(). The condition may contain these parameters. Raises UndecidedError where not all
        solutions are proved to have as many; its `partial` has the others."""
        try:
            return Table._of(self._problem.enclosed_events(condition, count, parts, digits))
        except UndecidedError as problem:
            raise with_partial(problem, Table._of) from None

    @with_progress
    def events(
        self, condition: str, count: int = 1, digits: int = 50, certificate: str | PathLike[str] | None = None
    ) -> Table:
        """The first `count` times after the start at which a condition "x' = 1/2" holds, and the unknowns there, proved,
        without omissions. Raises UndecidedError where there are not as many, and for a number that is not
        distinguished from 0; its `partial` has what is proved.
        certificate is the path of a file from which check() proves them again, and that there are no others."""
        if certificate is not None:
            return Table._of(self._problem.event_certificate(condition, count, digits, fspath(certificate)))
        try:
            return Table._of(self._problem.events(condition, count, digits))
        except UndecidedError as problem:
            raise with_partial(problem, Table._of) from None

    def trajectory(
        self,
        times: Any,
        starts: Any = None,
        begin: Any = None,
        threads: int | None = None,
        parameters: Mapping[str, Any] | None = None,
    ) -> Trajectory:
        """The unknowns at an array of times in double precision, heuristic, from many starts in one call: an array with a
        row (in the order of `names`) for each, or a mapping {"x": array} with the others as in the problem, at the time
        `begin`, by default that of the problem; and with many values of its parameters, {"r": array}, on which the other
        starts depend as in the problem. Arrays of starts and parameters go together, one value of each for a solution;
        single values are those of all solutions. Solutions run in lock step in the lanes of SIMD vectors, shared among
        threads, all cores by default, without the interpreter's lock. Doubles are data here, and accepted. A solution is
        nan where its steps become too small, near a singularity. Raises ArgumentError for nan and infinities, for starts
        at a singular initial point, and for parameters that the equations require to be constant, such as exponents."""
        return trajectory_of(self._problem, times, starts, begin, threads, parameters)

    @with_progress
    def coefficients(
        self, order: int, scalar: str = "ball:50", at: Any = None, via: Any = None, first: int = 0
    ) -> Table:
        """The Taylor coefficients first .. order of every unknown: columns n and the unknowns, about a complex point
        x_re and x_im. scalar is mpfr:D, ball:D or rational; at a time, "1+2i" too, by way of the corners `via`,
        "1+i,2+i"."""
        if scalar == "rational":
            if at is not None or via is not None:
                raise ValueError("fractions are those about the start: leave out at and via")
            return Table._of(self._problem.fractions(first, order))
        digits, rigour = digits_and_rigour(scalar)
        point = None if at is None else text_of(at, "at")
        corners = None if via is None else times_text(via)[0]
        return Table._of(self._problem.coefficients(point, corners, first, order, digits, rigour))

    def radius(self, order: int = 300, digits: int = 30) -> Radius:
        """The radius of convergence about the start from the coefficients up to `order`, that of the nearest unknown.
        Heuristic: radius_bounds() proves."""
        return radius_of(Table._of(self._problem.radius(order, digits)))

    @with_progress
    def radius_bounds(self, digits: int = 12) -> tuple[Ball, Ball]:
        """Proved lower and upper bounds, upper - lower < lower 10^-digits; both inf if every solution is entire by
        the form of the equations. Raises UndecidedError with what is proved where that is less."""
        lower, upper = self._problem.radius_bounds(digits)
        return Ball._of(lower), Ball._of(upper)

    @with_progress
    def singularities(self, within: Any = None, digits: int = 15, prove: bool = False) -> Singularities:
        """The singularities in the complex plane of time within a distance of the start, twice that of the nearest
        without it, on the branch that is reached straight. With prove the places are proved; kinds and exponents never
        are. `complete` says whether the whole disc was searched."""
        distance = None if within is None else text_of(within, "within")
        parts, complete = self._problem.singularities(distance, digits, 2 if prove else 0)
        found = Table._of(parts)
        return Singularities(found.names, found.cells, complete)

    @with_progress
    def law(self, show: str | None = None, within: Any = None) -> Law:
        """The law of all Taylor coefficients about the start of an unknown or a derivative, "y" or "th'", the first unknown
        without it: all singularities within a distance, and any coefficient without the ones before, proved. Raises
        UndecidedError with the reason if no law is proved."""
        return Law(self, show, within)

    @with_progress
    def limits(self, digits: int = 50) -> Row:
        """The unknowns and their lower derivatives at infinite time, proved: at a stable equilibrium that the solution
        approaches, or by a lemma on the problem. Raises UndecidedError if neither is found, and for a value that is not
        distinguished from 0; its `partial` has the others."""
        try:
            return Table._of(self._problem.limits(digits))[0]
        except UndecidedError as problem:
            raise with_partial(problem, lambda table: Table._of(table)[0]) from None

    @overload
    def find(
        self,
        unknowns: str | Sequence[str],
        such_that: str | Sequence[str],
        digits: int = 50,
        certificate: str | PathLike[str] | None = None,
        along: None = None,
    ) -> dict[str, Ball]: ...
    @overload
    def find(
        self,
        unknowns: str | Sequence[str],
        such_that: str | Sequence[str],
        digits: int = 50,
        certificate: None = None,
        *,
        along: str,
    ) -> Branch: ...

    @with_progress
    def find(
        self,
        unknowns: str | Sequence[str],
        such_that: str | Sequence[str],
        digits: int = 50,
        certificate: str | PathLike[str] | None = None,
        along: str | None = None,
    ) -> dict[str, Ball] | Branch:
        """The parameters or initial values "k", ["k", "f''(0)"] for which as many conditions "f'(5) = 1" hold, near the
        values that the problem has, each digit proved. Conditions at infinity, "f'(inf) = 1", are decided as by
        at_infinity(), which also gives the limits, rates and amplitudes.

        along, "k = 0:3.5:36" or a list of values in one direction, follows the branch of solutions in another parameter, from
        its first value on and past turning points, each point proved. Raises UndecidedError if a point is not proved, or
        the branch could not be continued; its `partial` has the others.

        certificate is the path of a file from which check() proves again, in integers, that there is exactly one such choice
        within one unit of the last digits: for conditions "f'(5) = 1" at one time that is a fraction."""
        names = unknowns if isinstance(unknowns, str) else ", ".join(unknowns)
        conditions = such_that if isinstance(such_that, str) else "; ".join(such_that)
        if along is not None:
            if certificate is not None:
                raise ValueError("a certificate is of one solution: leave out along")
            try:
                return _branch(Table._of(self._problem.branch(names, conditions, along, digits)))
            except UndecidedError as problem:
                raise with_partial(problem, lambda table: _branch(Table._of(table))) from None
        if certificate is not None:
            return values_of(Table._of(self._problem.find_certificate(names, conditions, digits, fspath(certificate))))
        return values_of(Table._of(self._problem.find(names, conditions, digits)))

    @with_progress
    def orbit(self, digits: int = 50, certificate: str | PathLike[str] | None = None) -> dict[str, Ball]:
        """The periodic orbit near the initial values of an autonomous problem, each digit proved: the unknowns and
        their lower derivatives on a section, and the period.

        certificate is the path of a file from which check() proves again, in integers, that there is exactly one such orbit
        within one unit of the last digits."""
        if certificate is not None:
            return values_of(Table._of(self._problem.orbit_certificate(digits, fspath(certificate))))
        return values_of(Table._of(self._problem.orbit(digits)))


class Values(dict[str, Ball]):
    """Balls by name, which a notebook shows as a table."""

    def _repr_html_(self) -> str:
        return table_of(["name", "value"], list(self.items()))


def _branch(table: Table) -> Branch:
    return Branch(table.names, table.cells)


def values_of(table: Table) -> Values:
    """Of the columns name and value."""
    found = Values()
    for row in table:
        value = row["value"]
        assert isinstance(value, Ball)
        found[str(row["name"])] = value
    return found


def radius_of(tests: Table) -> Radius:
    """The verdict of a table of tests."""
    verdict = tests[0]
    value = verdict["radius"]
    return Radius(value if isinstance(value, Ball) else None, str(verdict["unknown"]), str(verdict["note"]), tests)


_start = re.compile(r"(?:^|[;,\n])\s*(\w+'*)\s*\(([^()=]*)\)\s*=")
_parameter = re.compile(r"(?:^|[;,\n])\s*([^\W\d_]\w*)\s*=")
_unknown = re.compile(r"([^\W\d_]\w*)'")
_quotient = re.compile(r"(?<!\w)d(?:\d|\^\d|[²³])?\s*([^\W\d_]\w*)\s*/\s*d")
_name = re.compile(r"(?<![\w.])[^\W\d_]\w*")
_primes = str.maketrans({"′": "'", "’": "'", "″": "''", "”": "''"})


def _without_comments(text: str) -> str:
    return re.sub(r"#[^\n]*", "", text)


def problem(
    text: Any, starts: Mapping[str, Any] | None = None, *, at: Any = 0, exact: bool = True, **values: Any
) -> Problem:
    """A text of equations ("x' = 10*(y-x); ..."), a name of the catalogue ("lorenz"), or equations of SymPy.

    Keywords give or change starts, x=1 for x(0) = 1, and parameters, r=28; `starts` takes derivatives: {"x'": 0}. `at`
    is the time of starts that the text does not have. Numbers as for motion(); with exact=False floats are the doubles
    that they are. Raises ArgumentError with line and
    column for what cannot be read, and for a keyword that the text has no use for; warns of a parameter that the text
    defines and uses nowhere.
    """
    if not isinstance(text, str):
        from .equations import text_of_equations

        text = text_of_equations(text)
    if "=" not in text:
        known = dict(_libration.catalogue())
        text = known.get(text.strip(), text)
    bare = _without_comments(text).translate(_primes)
    given = {left: point.strip() for left, point in _start.findall(bare)}
    unknowns = set(_unknown.findall(bare)) | set(_quotient.findall(bare))
    parameters = set(_parameter.findall(bare)) - unknowns
    names = _name.findall(bare)
    for name in sorted(each for each in parameters if names.count(each) == 1):
        warnings.warn(f"the parameter {name} is defined and used nowhere: leave it out", stacklevel=2)
    settings: list[str] = []
    added: list[str] = []
    numbers = {name: text_of(value, name, exact) for name, value in {**values, **(starts or {})}.items()}
    names += [name for number in numbers.values() for name in _name.findall(number)]
    for name, number in numbers.items():
        if name in given:
            settings.append(f"{name}({given[name]}) = {number}")
        elif name in parameters:
            settings.append(f"{name} = {number}")
        elif name.rstrip("'") in unknowns:
            added.append(f"{name}({text_of(at, 'at', exact)}) = {number}")
        elif name in names:
            added.append(f"{name} = {number}")
        else:
            settings.append(f"{name} = {number}")  # which the library rejects, with the name that is near
    return Problem("\n".join([text.rstrip().rstrip(";,"), *added]) if added else text, "; ".join(settings))


def catalogue() -> dict[str, str]:
    """The problems that come with the library: texts by name."""
    return dict(_libration.catalogue())


def radius(coefficients: Any, digits: int = 30) -> Radius:
    """The radius of convergence of a series a_0, a_1, ... from its coefficients alone; decimals say by their last digit
    how well they are known. Heuristic.

    coefficients is a list of exact numbers, or data: an array of NumPy, whose floats are known to half a unit in the last
    place, or the path of a file, .npy or text with a coefficient, or n and a coefficient, in each line."""
    return radius_of(Table._of(_libration.list_radius(texts_of_coefficients(coefficients), digits)))
