"""Reference solutions for the work-precision diagrams of SciMLBenchmarks: proved values at times as JSON, and as Julia.

    import libration as lb
    from libration import scimlref
    scimlref.write("lotka_volterra.jl", lb.problem("lotka_volterra"), times=["1", "10"])

The Julia file defines test_sol = TestSolution(t, u), which WorkPrecisionSet of DiffEqDevTools takes as appxsol; u[i] has
the unknowns in the order of problem.names at t[i].
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from .ball import Ball
from .problems import Problem
from .tables import Table
from .texts import times_text


class Reference:
    """Proved states of a problem at times."""

    def __init__(self, problem: Problem, times: Any, digits: int = 20, exact: bool = True) -> None:
        """`digits` digits of each value; with exact=False floats among the times are the doubles that they are. Raises
        UndecidedError as Problem.reference."""
        self.names = problem.names
        texts, _ = times_text(times, exact)
        self.times = [Ball._of(_read(each)) for each in texts.split(",")]
        states = problem.reference(texts.split(","), digits)
        assert isinstance(states, Table)
        self.states = [[row[name] for name in self.names] for row in states]

    def json(self) -> str:
        """{"names", "t", "u", "u_uncertainty", "rigour"}: numbers as their digits, so that none is rounded."""
        values = {
            "names": self.names,
            "t": [_shortest(each) for each in self.times],
            "u": [[_digits(each) for each in row] for row in self.states],
            "u_uncertainty": [[_uncertainty(each) for each in row] for row in self.states],
            "rigour": "proved",
        }
        return json.dumps(values, indent=1) + "\n"

    def julia(self, big: bool = False) -> str:
        """TestSolution(t, u) in Float64, or in BigFloat."""
        number = (lambda text: f'big"{text}"') if big else _float_of_julia
        times = ", ".join(number(_shortest(each)) for each in self.times)
        states = ",\n    ".join("[" + ", ".join(number(_digits(each)) for each in row) + "]" for row in self.states)
        return (
            f"# {', '.join(self.names)}: every digit proved by Libration.\n"
            "using DiffEqDevTools\n"
            f"t = [{times}]\n"
            f"u = [\n    {states}]\n"
            "test_sol = TestSolution(t, u)\n"
        )


def _read(time: str) -> tuple[str, str, int]:
    from . import _libration

    return _libration.read(time, 40)


def _shortest(time: Ball) -> str:
    """The digits of a time, without zeros at the end if it is exact."""
    if time.uncertainty != "0" or "." not in time.digits or "e" in time.digits:
        return time.digits
    return time.digits.rstrip("0").rstrip(".")


def _digits(cell: Any) -> str:
    assert isinstance(cell, Ball)
    return cell.digits


def _uncertainty(cell: Any) -> str:
    assert isinstance(cell, Ball)
    return cell.uncertainty


def _float_of_julia(text: str) -> str:
    return text if any(each in text for each in ".en") else text + ".0"


def write(path: str | os.PathLike[str], problem: Problem, times: Any, digits: int = 20, exact: bool = True) -> Path:
    """Writes a reference solution: as JSON to a path that ends in .json, as Julia to one that ends in .jl. Returns the
    path. Raises ValueError for another ending."""
    target = Path(path)
    if target.suffix not in (".json", ".jl"):
        raise ValueError(f"{target} ends neither in .json nor in .jl")
    reference = Reference(problem, times, digits, exact)
    target.write_text(reference.json() if target.suffix == ".json" else reference.julia(), encoding="utf-8")
    return target
