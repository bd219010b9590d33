"""Values that somebody computed, compared with proved ones."""

from __future__ import annotations

import csv
import os
from collections.abc import Sequence
from typing import Any

import numpy as np

from .ball import Ball
from .motions import Motion
from .problems import Problem, problem as problem_of
from .tables import Table
from .texts import text_of

_times = ("time", "t")


class Verdicts(Table):
    """A row for each that was compared: time, verdict (ok or miss), condition, and for each name NAME_reference (proved),
    NAME_error and NAME_correct_digits; of times in double also time_as_double, as C's %a writes them."""

    @property
    def misses(self) -> int:
        """How many rows miss the tolerance."""
        return sum(1 for verdict in self.column("verdict") if verdict != "ok")

    @property
    def ok(self) -> bool:
        return self.misses == 0

    def __repr__(self) -> str:
        return f"{len(self)} rows, {self.misses} miss\n{self}"


def _columns_of_solution(solution: Any, names: Sequence[str]) -> dict[str, list[Any]]:
    """What solve_ivp returns: a row of `y` for each unknown."""
    rows = np.atleast_2d(np.asarray(solution.y))
    if len(rows) != len(names):
        raise ValueError(f"the solution has {len(rows)} unknowns, and the problem has {len(names)}: {', '.join(names)}")
    return {"time": list(np.asarray(solution.t)), **{name: list(row) for name, row in zip(names, rows)}}


def _columns(data: Any, names: Sequence[str]) -> dict[str, list[Any]]:
    if isinstance(data, (str, os.PathLike)):
        with open(data, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        if not rows:
            raise ValueError(f"{data} is empty")
        names = [name.strip() for name in rows[0]]
        if any(len(row) != len(names) for row in rows[1:]):
            raise ValueError(f"{data} has rows of other lengths than its header")
        return {name: [row[i].strip() for row in rows[1:]] for i, name in enumerate(names)}
    if hasattr(data, "t") and hasattr(data, "y"):
        return _columns_of_solution(data, names)
    if isinstance(data, Table):
        return {name: data.column(name) for name in data.names}
    if hasattr(data, "columns"):
        return {str(name): list(data[name]) for name in data.columns}
    return {str(name): list(np.ravel(column)) if isinstance(column, np.ndarray) else list(column) for name, column in
            dict(data).items()}


def _written(x: Any) -> str:
    """A value as it was written: a text as it is, a double as C's %a writes it, other numbers exactly where that ends."""
    if isinstance(x, (float, np.floating)):
        value = float(x)
        return value.hex() if np.isfinite(value) else str(value)
    if isinstance(x, Ball):
        return str(x)
    if hasattr(x, "_mpf_"):
        sign, mantissa, exponent, _ = x._mpf_
        return f"{'-' if sign else ''}0x{int(mantissa):x}p{int(exponent)}"
    return text_of(x, "value")


def _rules(tolerance: Any, relative: Any, ulp: Any, rounding: bool, modulo_2pi: bool) -> str:
    rules = [
        f"{name} = {text_of(value, name)}"
        for name, value in (("tolerance", tolerance), ("relative", relative), ("ulp", ulp))
        if value is not None
    ]
    return "; ".join(rules + ["rounding = half"] * rounding + ["modulo = 2pi"] * modulo_2pi)


def _names(columns: dict[str, list[Any]], offered: Sequence[str]) -> tuple[str, list[str]]:
    time = next((name for name in _times if name in columns), None)
    if time is None:
        raise ValueError(f"there is no column time: the columns are {', '.join(columns)}")
    names = [name for name in offered if name in columns]
    if not names:
        raise ValueError(f"there is none of the columns {', '.join(offered)}: the columns are {', '.join(columns)}")
    return time, names


def verify(
    data: Any,
    motion: Motion | None = None,
    problem: Problem | str | None = None,
    *,
    tolerance: Any = None,
    relative: Any = None,
    ulp: Any = None,
    rounding: bool = False,
    modulo_2pi: bool = False,
) -> Verdicts:
    """Compares a table with a motion (columns time, theta, perhaps omega) or a problem (time, some of its names), which
    may be a text or a name as problem() takes them.

    data is a DataFrame, the path of a CSV file, a Table, a mapping of columns, or the result of solve_ivp, of SciPy or of this
    package, whose rows are the unknowns in the order of the names. Values and times in double count as
    the exact numbers that they are; texts as they are written. Without a tolerance it is one unit of the last digit as
    written (half of it with `rounding`, for printed tables), of a double its last bit, of a column of doubles in decimal
    ("%.18e") half a unit in their last place; times in such a column are these doubles; `ulp` counts units in the last
    place of a double of max(1, |truth|).
    Raises ArgumentError for what is no number.
    """
    if (motion is None) == (problem is None):
        raise ValueError("give a motion or a problem")
    if isinstance(problem, str):
        problem = problem_of(problem)
    if not isinstance(problem if motion is None else motion, (Motion, Problem)):
        raise TypeError("a motion is made by motion(), a problem by problem()")
    offered = ("theta", "omega") if problem is None else problem.names
    columns = _columns(data, offered)
    target: Any = motion._motion if motion is not None else problem._problem  # type: ignore[union-attr]
    time, names = _names(columns, offered)
    times = ",".join(_written(each) for each in columns[time])
    values = ",".join(_written(columns[name][row]) for row in range(len(columns[time])) for name in names)
    found = target.verify(",".join(names), times, values, _rules(tolerance, relative, ulp, rounding, modulo_2pi))
    made = Table._of(found)
    if not any(isinstance(each, (float, np.floating)) for each in columns[time]):
        return Verdicts(made.names, made.cells)
    doubles = [str(cell) for cell in made.column("time")]
    shown = made.with_times_as_floats()
    return Verdicts([*made.names, "time_as_double"], [[*row, double] for row, double in zip(shown.cells, doubles)])
