"""Rows of named numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Union

from .ball import Ball, ball
from .drawing import lines_of, table_of
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

    def column(self, name: str) -> list[Cell]:
        """The cells of a column. Raises KeyError for a name that there is not."""
        if name not in self.names:
            raise KeyError(f"{name}: the columns are {', '.join(self.names)}")
        at = self.names.index(name)
        return [row[at] for row in self.cells]

    def frame(self) -> Any:
        """A pandas DataFrame of the same cells, dtype object."""
        import pandas

        return pandas.DataFrame(self.cells, columns=self.names, dtype=object)

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
