"""The studies of the program `libration`: sweeps over energies, orders and parameters, with tables and figures."""

from __future__ import annotations

import csv
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

from .errors import ArgumentError, LibrationError
from .tables import Table
from .texts import text_of


def program() -> str:
    """The program: LIBRATION_PROGRAM of the environment, the one of this package, or libration of the PATH. Raises
    FileNotFoundError."""
    own = Path(__file__).parent / "program" / "bin" / "libration"
    found = os.environ.get("LIBRATION_PROGRAM") or (str(own) if own.exists() else shutil.which("libration"))
    if not found:
        raise FileNotFoundError("the program libration is not there: install it, or set LIBRATION_PROGRAM")
    return found


def _value(name: str, value: Any) -> str:
    if isinstance(value, (list, tuple, range)):
        return ",".join(text_of(each, name) for each in value)
    return text_of(value, name)


def _options(parameters: Mapping[str, Any]) -> list[str]:
    options: list[str] = []
    for name, value in parameters.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            options.append(option)
        elif name == "set" and isinstance(value, Mapping):
            options += [f"--set={key}={_value(key, each)}" for key, each in value.items()]
        elif value is not None and value is not False:
            options.append(f"{option}={_value(name, value)}")
    return options


def _cell(text: str) -> Any:
    try:
        return Decimal(text) if text else None
    except InvalidOperation:
        return text


class Study:
    """What a study computed: a CSV file as a frame, and the figures that the program drew."""

    def __init__(self, name: str, folder: Path, temporary: Any) -> None:
        self.name = name
        self.folder = folder
        self._temporary = temporary  # lives as long as this
        files = sorted(folder.glob("*.json"))
        if not files:
            raise LibrationError(f"the study {name} left nothing in {folder}")
        self.about: dict[str, Any] = json.loads(files[0].read_text(encoding="utf-8"))

    @property
    def files(self) -> list[str]:
        """The tables, in the order of the program."""
        return [table["file"] for table in self.about["tables"]]

    @property
    def columns(self) -> dict[str, str]:
        """What the columns are, with their units."""
        return self.about["columns"]

    def rows(self, file: str | None = None) -> list[dict[str, str]]:
        """The rows of a table, the first without a name, as they are written."""
        with open(self.folder / (file or self.files[0]), newline="", encoding="utf-8") as opened:
            return list(csv.DictReader(opened))

    def frame(self, file: str | None = None) -> Any:
        """A table as a pandas DataFrame: numbers are Decimals with all their digits, words are str, what is absent None."""
        import pandas

        rows = self.rows(file)
        return pandas.DataFrame(
            [{name: _cell(text) for name, text in row.items()} for row in rows], dtype=object
        )

    @property
    def figures(self) -> list[Path]:
        """The SVG files that the program drew; none where gnuplot is not installed."""
        return sorted(self.folder.glob("*.svg"))

    def plot(self, x: str | None = None, y: str | None = None, by: str | list[str] | None = None, ax: Any = None) -> Any:
        """Draws y against x, a line for each value of `by`, and returns the axes of matplotlib. Without names x is the
        order (else the first column), y the column norm or error (else the last one of numbers), by what else was
        swept. Values that leave the range of double are not drawn."""
        import matplotlib.pyplot as pyplot

        frame = self.frame()
        numeric = [name for name in frame if all(isinstance(each, (Decimal, type(None))) for each in frame[name])]
        y = y or next((name for name in ("norm", "error") if name in frame), numeric[-1])
        x = x or ("order" if "order" in frame else frame.columns[0])
        swept = [name for name in ("energy", "gap", "method", "unknown") if name in frame and name not in (x, y)]
        groups = [by] if isinstance(by, str) else by if by is not None else swept[:1] + [n for n in swept if n == "method"]
        axes = ax or pyplot.subplots()[1]
        parts = frame.groupby(groups, sort=False) if groups else [("", frame)]
        for label, part in parts:
            words = ", ".join(map(str, label)) if isinstance(label, tuple) else str(label)
            axes.plot([float(v) for v in part[x]], [float("nan") if v is None else float(v) for v in part[y]], label=words)
        positive = [v for v in frame[y] if v is not None]
        if positive and min(positive) > 0:
            axes.set_yscale("log")
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        if groups:
            axes.legend(title=", ".join(groups))
        return axes


def _output_of(*words: str) -> str:
    """What the program prints. Raises ArgumentError with its message for wrong options, LibrationError for other failures."""
    done = subprocess.run([program(), *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        kind = ArgumentError if done.returncode == 2 else LibrationError
        raise kind(done.stderr.strip() or f"{' '.join(words[:2])} failed")
    return done.stdout


def table(what: str | None = None, **options: Any) -> Table:
    """A table of `libration table`, proved: table("sn,cd", u="1.5", m="0.3", digits=30); table("pendulum",
    gaps="1e-3,-1e-30", times="1,T/8"); table(problem="lorenz", times="1,2"). Keywords are its options, as for study();
    cells are texts, the digits as they are printed. Raises ArgumentError for wrong options."""
    printed = _output_of("table", *([what] if what else []), *_options(options), "--format", "csv")
    names, *rows = csv.reader(printed.splitlines())
    return Table(names, rows)


def study(name: str, out: str | os.PathLike[str] | None = None, **parameters: Any) -> Study:
    """Runs a study of the program: study("error_norm", energies="0.5:8:16", orders=[5, 10, 20]).

    Keywords are the options of `libration study NAME` (underscores for hyphens; lists with commas; set={"k": "0:1:5"}
    for parameters of a problem). In `out` finished cells are kept, and a second run computes what is new; without it
    the files are temporary. Raises ArgumentError with the program's words for wrong options.
    """
    temporary = tempfile.TemporaryDirectory(prefix="libration-") if out is None else None
    folder = Path(temporary.name if temporary else os.fspath(out))  # type: ignore[arg-type]
    _output_of("study", name, *_options(parameters), "--out", str(folder))
    typed = sorted((each for each in folder.glob(f"{name}*") if each.is_dir()), key=lambda each: each.stat().st_mtime)
    return Study(name, typed[-1], temporary)
