"""Coefficients of a series from arrays and files, as texts whose last digits say how well they are known."""

from __future__ import annotations

import math
import os
import re
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np

from .texts import times_text


def _decimal_of_double(x: float, ulp: float) -> str:
    """A double that is known to half a unit in the last place: the decimal with as many digits as that supports, that is,
    whose last place is the smallest power of ten that is not below half a unit."""
    if not math.isfinite(x):
        raise ValueError(f"a coefficient is {x}")
    if x == 0:
        return "0"
    place = math.ceil(math.log10(ulp / 2))
    return f"{Decimal(x).quantize(Decimal(1).scaleb(place)):e}"


def _texts_of_array(values: np.ndarray) -> str:
    if values.ndim != 1:
        raise ValueError(f"the coefficients are an array of shape {values.shape}: give one row of them")
    if values.dtype.kind in "iu":
        return ",".join(str(int(each)) for each in values)
    if values.dtype.kind != "f" or values.dtype.itemsize > 8:
        return times_text(values)[0]
    return ",".join(_decimal_of_double(float(each), float(np.spacing(np.abs(each)))) for each in values)


def _texts_of_lines(path: Path) -> str:
    lines = [line.partition("#")[0].strip() for line in path.read_text(encoding="utf-8").splitlines()]
    rows = [re.split(r"[\s,;]+", line) for line in lines if line]
    if rows and not re.match(r"[-+.\d]", rows[0][-1]):
        rows = rows[1:]  # names of columns
    widths = {len(row) for row in rows}
    if widths not in ({1}, {2}):
        raise ValueError(f"{path} has no lines of one coefficient, or of n and a coefficient")
    return ",".join(row[-1] for row in rows)


def texts_of_coefficients(given: Any) -> str:
    """A list for the library: of exact numbers, of an array, whose floats are data, or of a file by its path. A text that
    names a file that exists is a path."""
    if isinstance(given, os.PathLike) or (isinstance(given, str) and Path(given).is_file()):
        path = Path(given)
        return _texts_of_array(np.load(path)) if path.suffix == ".npy" else _texts_of_lines(path)
    return _texts_of_array(given) if isinstance(given, np.ndarray) else times_text(given)[0]
