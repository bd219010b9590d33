"""Figures of matplotlib and tables of HTML for the results of this package. matplotlib is imported where it is used."""

from __future__ import annotations

import html
import importlib
from collections.abc import Mapping, Sequence
from typing import Any

#: Rows of a table that a notebook shows: the first and the last ones.
rows_shown = 60


def imported(package: str, what: str) -> Any:
    """A package that `what` needs, and that may be missing. Raises ModuleNotFoundError with the lines that install it."""
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError:
        name = package.partition(".")[0]
        raise ModuleNotFoundError(f"{what} needs {name}: apt install python3-{name}, or pip install {name}") from None


def axes_of(ax: Any) -> Any:
    """The axes that are given, or new ones."""
    if ax is not None:
        return ax
    return imported("matplotlib.pyplot", "plot()").subplots()[1]


def lines_of(x: Any, curves: Mapping[str, Any], name: str, ax: Any = None) -> Any:
    """Draws curves against x, each with its name in a legend; a two-dimensional one is a line for each row. Returns the
    axes."""
    axes = axes_of(ax)
    for label, y in curves.items():
        lines = axes.plot(x, y.T if getattr(y, "ndim", 1) == 2 else y)
        lines[0].set_label(label)
    axes.set_xlabel(name)
    if len(curves) == 1:
        axes.set_ylabel(next(iter(curves)))
    else:
        axes.legend()
    return axes


def table_of(names: Sequence[str], rows: Sequence[Sequence[Any]], caption: str = "") -> str:
    """A table of HTML, in the middle shortened to rows_shown rows."""
    head = "".join(f"<th>{html.escape(str(name))}</th>" for name in names)
    half = rows_shown // 2
    shown = list(rows) if len(rows) <= rows_shown else [*rows[:half], ["..."] * len(names), *rows[-half:]]
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(str(cell))}</td>" for cell in row) + "</tr>" for row in shown
    )
    words = f"<caption>{html.escape(caption)}</caption>" if caption else ""
    return f"<table>{words}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
