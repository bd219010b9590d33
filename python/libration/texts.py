"""Numbers of Python as the exact texts that the library reads. No float is taken for the number that was intended."""

from __future__ import annotations

import numbers
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np


def exact(x: float) -> str:
    """A double exactly, mantissa*2^exponent: what `0.1` is to a program, and not 1/10.

    Raises ValueError for nan and infinities.
    """
    if not np.isfinite(x):
        raise ValueError(f"{x} is not a number")
    above, below = float(x).as_integer_ratio()
    return f"{above}*2^({1 - below.bit_length()})"


def _text_of_double(x: float) -> str:
    """A double exactly: as an integer where it is one, else as the function exact() writes it."""
    return str(int(x)) if x.is_integer() else exact(x)


def text_of(x: Any, name: str = "number", exact: bool = True) -> str:
    """The exact text of a number: a str as it is, int, Fraction, Decimal, a Ball of radius 0, numbers of mpmath and SymPy.

    Raises TypeError for a float: write '0.1', or exact(0.1) for the double next to it. With exact=False a float is that
    double.
    """
    from .ball import Ball

    if isinstance(x, str):
        return x
    if isinstance(x, (bool, np.bool_)):
        raise TypeError(f"{name} is {x}, which is not a number")
    if isinstance(x, numbers.Integral):
        return str(int(x))
    if isinstance(x, Fraction):
        return f"{x.numerator}/{x.denominator}" if x.denominator != 1 else str(x.numerator)
    if isinstance(x, Decimal):
        if not x.is_finite():
            raise ValueError(f"{name} is {x}, which is not a number")
        return str(x)
    if isinstance(x, Ball):
        if not x.is_exact:
            raise TypeError(f"{name} is a Ball, not one number: give its digits, str(ball), or its exact text")
        return str(x)
    if isinstance(x, (float, np.floating)):
        if not exact:
            return _text_of_double(float(x))
        raise TypeError(f"{name} is the float {x!r}: write '{x!r}' for the decimal, libration.exact({x!r}) for the double")
    if hasattr(x, "_mpf_"):
        sign, mantissa, exponent, _ = x._mpf_
        return f"{'-' if sign else ''}{int(mantissa)}*2^({int(exponent)})"
    if type(x).__module__.partition(".")[0] == "sympy":
        from .equations import constant_text

        return constant_text(x)
    raise TypeError(f"{name} is a {type(x).__name__}, which is not an exact number")


def times_text(times: Any, exact: bool = True) -> tuple[str, bool]:
    """One time or several as a list, and whether there was one alone. Ranges are not taken: lists say what is meant. Floats
    are refused unless exact is False."""
    if isinstance(times, str):
        return times, "," not in times
    if isinstance(times, (list, tuple, np.ndarray)):
        if len(times) == 0:
            raise ValueError("there are no times")
        return ",".join(text_of(each, "time", exact) for each in times), False
    return text_of(times, "time", exact), True


def digits_and_rigour(scalar: str) -> tuple[int, int]:
    """mpfr:50 or ball:50 as digits and the rigour of libration.h. Raises ValueError for another arithmetic."""
    found = re.fullmatch(r"(mpfr|ball):(\d+)", scalar)
    if not found:
        raise ValueError(f"scalar is {scalar!r}: write 'mpfr:50' for two runs that agree, 'ball:50' for proofs")
    return int(found[2]), 2 if found[1] == "ball" else 1


#: The rigour of a number, in the same words everywhere in the library: proved by ball arithmetic; two-method, on which two
#: computations agree; heuristic.
rigours = {"heuristic": 0, "two-method": 1, "proved": 2}
_earlier_words = {"rounded": "two-method"}


def usual_word(rigour: str) -> str:
    """The word of rigours for one that was used earlier."""
    return _earlier_words.get(rigour, rigour)


def rigour_of(rigour: str) -> int:
    """'two-method' or 'proved' as a number of libration.h."""
    if usual_word(rigour) not in ("two-method", "proved"):
        raise ValueError(f"rigour is {rigour!r}: write 'proved' or 'two-method'")
    return rigours[usual_word(rigour)]
