"""Rows of named numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Union

from .ball import Ball

Cell = Union[Ball, str]


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

    def __str__(self) -> str:
        texts = [self.names] + [[str(cell) for cell in row] for row in self.cells]
        widths = [max(len(row[i]) for row in texts) for i in range(len(self.names))]
        return "\n".join("  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)).rstrip() for row in texts)

    def __repr__(self) -> str:
        return str(self)
