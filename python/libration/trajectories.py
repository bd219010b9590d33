"""Solutions at many times from many starts, as arrays of doubles."""

from __future__ import annotations

import os
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from .drawing import lines_of, table_of


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
        import pandas

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


def trajectory_of(problem: Any, times: Any, starts: Any, begin: Any, threads: int | None) -> Trajectory:
    """The solutions of a compiled problem, those from many starts in threads without the interpreter's lock."""
    names = problem.names()
    at = np.atleast_1d(np.asarray(times, dtype=float))
    if starts is None:
        return Trajectory(names, at, problem.flow(0.0, None, at)[0])
    point, own = problem.start()
    rows = starts_of(starts, names, own)
    time = float(point if begin is None else begin)
    workers = min(threads or os.cpu_count() or 1, max(1, len(rows)))
    parts = np.array_split(rows, workers)
    if workers == 1:
        return Trajectory(names, at, problem.flow(time, rows, at))
    with ThreadPoolExecutor(workers) as pool:
        values = list(pool.map(lambda part: problem.flow(time, part, at), parts))
    return Trajectory(names, at, np.concatenate(values))
