"""Rows of named numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Union

import numpy as np

from .ball import Ball, ball
from .drawing import imported, lines_of, table_of
from .errors import LibrationError

Cell = Union[Ball, str]


def number_of(cell: Cell) -> float:
    """A cell, also a text such as a time as it was typed, as a double for a figure; nan if it is not a number."""
    if not isinstance(cell, Ball):
        try:
            return number_of(ball(cell, 17)) if cell else math.nan
        except LibrationError:
            return math.nan
    return float(cell.fraction()) if "/" in cell.digits else float(cell.digits)


def _as_float(cell: Cell) -> Cell:
    """A time that was given as a double, m*2^(e) or 0x1.8p+0, as Python writes this double; other cells as they are."""
    if not isinstance(cell, str):
        return cell
    return repr(float.fromhex(cell)) if "0x" in cell else repr(number_of(cell)) if "*2^(" in cell else cell


class Row(Mapping[str, Cell]):
    """A row by the names of its columns; str() has a line a column."""

    def __init__(self, names: Sequence[str], cells: Sequence[Cell]) -> None:
        self._cells = dict(zip(names, cells))

    def __getitem__(self, name: str) -> Cell:
        return self._cells[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._cells)

    def __len__(self) -> int:
        return len(self._cells)

    def __str__(self) -> str:
        width = max(len(name) for name in self._cells)
        return "\n".join(f"{name:<{width}} {cell}" for name, cell in self._cells.items())

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return table_of(["name", "value"], list(self._cells.items()))


class Table(Sequence[Row]):
    """Rows in order; a cell is a Ball or a text ('' where there is nothing). Nothing is rounded to a float."""

    def __init__(self, names: Sequence[str], cells: Sequence[Sequence[Cell]]) -> None:
        self.names = list(names)
        self.cells = [list(row) for row in cells]

    @classmethod
    def _of(cls, parts: tuple[list[str], list[str | tuple[str, str, int]]]) -> Table:
        names, flat = parts
        cells: list[Cell] = [Ball._of(cell) if isinstance(cell, tuple) else cell for cell in flat]
        return cls(names, [cells[at : at + len(names)] for at in range(0, len(cells), len(names))])

    def __len__(self) -> int:
        return len(self.cells)

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, str):
            return self.column(at)
        if isinstance(at, slice):
            return Table(self.names, self.cells[at])
        return Row(self.names, self.cells[at])

    def with_times_as_floats(self) -> Table:
        """Times that were given as doubles as Python writes them: 0.1, and not 3602879701896397*2^(-55)."""
        places = [at for at, name in enumerate(self.names) if name == "time"]
        cells = [[_as_float(cell) if at in places else cell for at, cell in enumerate(row)] for row in self.cells]
        return Table(self.names, cells)

    def column(self, name: str) -> list[Cell]:
        """The cells of a column. Raises KeyError for a name that there is not."""
        if name not in self.names:
            raise KeyError(f"{name}: the columns are {', '.join(self.names)}")
        at = self.names.index(name)
        return [row[at] for row in self.cells]

    def to_numpy(self, *names: str) -> np.ndarray:
        """The columns with these names, by default all, as doubles: an array with a row for each row of the table; nan for
        texts that are no numbers."""
        columns = [[number_of(cell) for cell in self.column(name)] for name in names or self.names]
        return np.array(columns, dtype=float).reshape(len(columns), len(self.cells)).T

    def frame(self, floats: bool = False) -> Any:
        """A pandas DataFrame: times as floats, the other cells as they are, dtype object; with floats=True all columns of
        numbers as floats."""
        pandas = imported("pandas", "frame()")
        made = pandas.DataFrame(self.cells, columns=self.names, dtype=object)
        for at, name in enumerate(self.names):
            values = self.to_numpy(name)[:, 0] if floats or name == "time" else np.array([math.nan])
            if not np.isnan(values).any():
                made.isetitem(at, values)
        return made

    def plot(self, x: str | None = None, y: str | None = None, ax: Any = None) -> Any:
        """Draws y, by default every column of numbers, against x, by default the first of them, and returns the axes of
        matplotlib."""
        numeric = [name for name in self.names if not all(math.isnan(number_of(cell)) for cell in self.column(name))]
        x = x or (numeric[0] if numeric else self.names[0])
        names = [y] if y else [name for name in numeric if name != x]
        curves = {name: [number_of(cell) for cell in self.column(name)] for name in names}
        return lines_of([number_of(cell) for cell in self.column(x)], curves, x, ax)

    def _repr_html_(self) -> str:
        return table_of(self.names, self.cells)

    def __str__(self) -> str:
        texts = [self.names] + [[str(cell) for cell in row] for row in self.cells]
        widths = [max(len(row[i]) for row in texts) for i in range(len(self.names))]
        return "\n".join("  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)).rstrip() for row in texts)

    def __repr__(self) -> str:
        return str(self)
