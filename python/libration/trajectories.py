"""Solutions at many times from many starts, as arrays of doubles."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from .drawing import imported, lines_of, table_of


class Trajectory:
    """Values in double: trajectory["x"] has the shape of the times, with many starts one row for each of them. nan where
    the steps become too small, near a singularity. heuristic: nothing is proved."""

    rigour = "heuristic"

    def __init__(self, names: list[str], times: np.ndarray, values: np.ndarray) -> None:
        self.names = names
        self.times = times
        #: [time][name], or [start][time][name].
        self.values = values

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.names:
            raise KeyError(f"{name}: the names are {', '.join(self.names)}")
        return self.values[..., self.names.index(name)]

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        starts = "" if self.values.ndim == 2 else f"{len(self.values)} solutions "
        return f"<Trajectory: {starts}of {', '.join(self.names)} at {len(self.times)} times, heuristic>"

    def frame(self) -> Any:
        """A pandas DataFrame with the columns time and the names, of many starts also start, their number."""
        pandas = imported("pandas", "frame()")
        if self.values.ndim == 2:
            return pandas.DataFrame({"time": self.times, **{name: self[name] for name in self.names}})
        count = len(self.values)
        columns = {"start": np.repeat(np.arange(count), len(self.times)), "time": np.tile(self.times, count)}
        return pandas.DataFrame({**columns, **{name: self[name].ravel() for name in self.names}})

    def plot(self, x: str | None = None, y: str | None = None, ax: Any = None) -> Any:
        """Draws all unknowns against time, or y against x, and returns the axes of matplotlib."""
        if x is not None and y is not None:
            return lines_of(self[x].T, {y: self[y]}, x, ax)
        names = [y] if y is not None else self.names
        return lines_of(self.times, {name: self[name] for name in names}, "time", ax)

    def _repr_html_(self) -> str:
        frame = self.frame()
        return table_of(list(frame), frame.to_numpy(dtype=object).tolist(), repr(self))


def starts_of(given: Any, names: list[str], own: np.ndarray) -> np.ndarray:
    """Starts as rows: an array of rows, or values by name, the others from the problem."""
    if not isinstance(given, Mapping):
        rows = np.asarray(given, dtype=float)
        if rows.ndim != 2 or rows.shape[1] != len(names):
            raise ValueError(f"starts are rows of {len(names)} numbers ({', '.join(names)}), or a mapping of names")
        return rows
    unknown = [name for name in given if name not in names]
    if unknown:
        raise ValueError(f"{unknown[0]!r} has no start in the problem: the names are {', '.join(names)}")
    columns = np.broadcast_arrays(*(np.asarray(given.get(name, own[i]), dtype=float) for i, name in enumerate(names)))
    return np.stack([np.atleast_1d(column).ravel() for column in columns], axis=1)


def numbers_of(
    parameters: Mapping[str, Any], starts: Any, names: list[str], point: float, begin: Any
) -> tuple[list[str], np.ndarray, np.ndarray | None]:
    """The names of parameters and initial values with a row of values for each solution; and the starts as rows, if they
    are given completely."""
    given = dict(parameters)
    rows = None
    if begin is None and isinstance(starts, Mapping):
        starts_of(starts, names, np.zeros(len(names)))  # checks the names
        given.update({f"{name}({point:g})": values for name, values in starts.items()})
    elif begin is not None or starts is not None:
        if starts is None or (isinstance(starts, Mapping) and len(starts) < len(names)):
            raise ValueError(f"at another time than that of the problem, with parameters, give all starts: {', '.join(names)}")
        rows = starts_of(starts, names, np.zeros(len(names)))
    alone = [np.empty(len(rows))] if rows is not None and len(rows) != 1 else []
    columns = np.broadcast_arrays(*(np.asarray(values, dtype=float) for values in given.values()), *alone)
    numbers = np.stack([np.atleast_1d(column).ravel() for column in columns[: len(given)]], axis=1)
    return list(given), numbers, rows if rows is None else np.repeat(rows, len(numbers) // len(rows), axis=0)


def trajectory_of(
    problem: Any, times: Any, starts: Any, begin: Any, threads: int | None, parameters: Mapping[str, Any] | None
) -> Trajectory:
    """The solutions of a compiled problem, many of them in threads without the interpreter's lock."""
    names = problem.names()
    at = np.atleast_1d(np.asarray(times, dtype=float))
    if starts is None and not parameters:
        return Trajectory(names, at, problem.flow(0.0, None, at)[0])
    point, own = problem.start()
    time = float(point if begin is None else begin)
    if parameters:
        labels, numbers, given = numbers_of(parameters, starts, names, point, begin)

        def flow(part: slice) -> np.ndarray:
            return problem.varied_flow(",".join(labels), numbers[part], time, None if given is None else given[part], at)

        count = len(numbers)
    else:
        rows = starts_of(starts, names, own)

        def flow(part: slice) -> np.ndarray:
            return problem.flow(time, rows[part], at)

        count = len(rows)
    return Trajectory(names, at, np.concatenate(_in_threads(flow, count, threads or os.cpu_count() or 1)))


def _in_threads(flow: Callable[[slice], np.ndarray], count: int, threads: int) -> list[np.ndarray]:
    """flow() of all solutions, in parts: more than there are threads, because some solutions take longer, and no smaller
    than is worth preparing the equations again."""
    smallest, parts_of_thread = 64, 8
    parts = max(1, min(threads * parts_of_thread, count // smallest)) if threads > 1 else 1
    ends = [count * i // parts for i in range(parts + 1)]
    slices = [slice(a, b) for a, b in zip(ends, ends[1:])]
    if parts == 1:
        return [flow(slices[0])]
    with ThreadPoolExecutor(min(threads, parts)) as pool:
        return list(pool.map(flow, slices))
