"""Numbers with what is known of their error."""

from __future__ import annotations

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np

from . import _libration, enclosures
from .texts import rigours, text_of, usual_word

_names = {number: name for name, number in rigours.items()}


class Ball:
    """A decimal and a bound of its distance to the exact number.

    str() prints the digits, each right to one unit in the last. `rigour` is 'proved' (ball arithmetic), 'two-method'
    (runs in MPFR that agree, or a bound of the error known before) or 'heuristic'.

    Arithmetic, powers, abs() and comparisons with numbers, of which floats are the doubles that they are, have the
    rigour of the least certain operand; their bounds contain the result for all numbers within the bounds. A comparison
    that the bounds do not decide raises UndecidedError, and so do int(), round() and float(). == is True for an exact number
    that is equal, and for a ball with the same digits, bound and rigour. Immutable.

        >>> b = libration.ball("sqrt(2)", 10)
        >>> b, b * b, b < 1.5, round(b, 3), f"{b:.4f}"
        (Ball('1.414213562', '3.74e-10', 'proved'), Ball('2.00000000', '2.12e-9', 'proved'), True, Ball('1.414', '2.14e-4', 'proved'),
        '1.4142')
    """

    __slots__ = ("_bounds", "_parts")
    _parts: tuple[str, str, int]
    _bounds: enclosures.Bounds | None  # of results of operations, narrower than digits and bound

    def __init__(self, decimal: str, uncertainty: str = "0", rigour: str = "proved") -> None:
        """A number as it was written down; bound and rigour are believed. Raises ArgumentError for what is none."""
        rigour = usual_word(rigour)
        if rigour not in rigours:
            raise ValueError(f"rigour is {rigour!r}: write 'proved', 'two-method' or 'heuristic'")
        _libration.Number(decimal, uncertainty, rigours[rigour])
        object.__setattr__(self, "_parts", (decimal, uncertainty, rigours[rigour]))
        object.__setattr__(self, "_bounds", None)

    @classmethod
    def _of(cls, parts: tuple[str, str, int], bounds: enclosures.Bounds | None = None) -> Ball:
        made = object.__new__(cls)
        object.__setattr__(made, "_parts", parts)
        object.__setattr__(made, "_bounds", bounds)
        return made

    @classmethod
    def _between(cls, bounds: enclosures.Bounds, rigour: int) -> Ball:
        bounds = enclosures.shortened(bounds)
        return cls._of((*enclosures.decimal_and_bound(bounds), rigour), bounds)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a Ball does not change")

    @property
    def digits(self) -> str:
        """The decimal: 1.5e-30, inf; p/q of exact fractions."""
        return self._parts[0]

    @property
    def uncertainty(self) -> str:
        """A bound of |decimal - exact number|, three digits; an estimate of heuristic numbers, '' where there is none."""
        return self._parts[1]

    @property
    def rigour(self) -> str:
        return _names[self._parts[2]]

    @property
    def proved(self) -> bool:
        return self._parts[2] == 2

    @property
    def is_exact(self) -> bool:
        """Whether it is one number, with a radius of 0."""
        return self.uncertainty == "0" and self.digits not in ("inf", "-inf")

    def __str__(self) -> str:
        return self.digits

    def __repr__(self) -> str:
        return f"Ball('{self.digits}', '{self.uncertainty}', '{self.rigour}')"

    def _exact_value(self) -> Fraction | None:
        return self.fraction() if self.is_exact and self.proved else None

    def __eq__(self, other: object) -> bool:
        mine = self._exact_value()
        if isinstance(other, Ball):
            theirs = other._exact_value()
            return self._parts == other._parts if mine is None or theirs is None else mine == theirs
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        return mine is not None and mine == known[0]

    def __hash__(self) -> int:
        exact = self._exact_value()
        return hash(self._parts) if exact is None else hash(exact)

    def __reduce__(self) -> tuple[Any, ...]:
        return Ball, (self.digits, self.uncertainty, self.rigour)

    def _number(self) -> _libration.Number:
        return _libration.Number(*self._parts)

    def __float__(self) -> float:
        """The double nearest to the exact number; of a number without a bound, to its digits. Raises UndecidedError where
        the digits do not tell which one it is."""
        if self.uncertainty == "":
            return float(self.fraction()) if "/" in self.digits else float(self.digits)
        return self._number().nearest()

    def double_bounds(self) -> tuple[float, float]:
        """Doubles below and above the exact number, as near as the digits allow."""
        return self._number().bounds()

    def exact(self) -> tuple[int, int, int, int]:
        """(m, e, r, f) with |exact number - m 2^e| <= r 2^f. Raises RangeError for infinity."""
        mantissa, exponent, radius, radius_exponent = self._number().exact()
        return int(mantissa), exponent, radius, radius_exponent

    def decimal(self) -> Decimal:
        """The digits exactly, whatever the context. Raises ValueError for a fraction."""
        if "/" in self.digits:
            raise ValueError(f"{self.digits} is not a decimal")
        return Decimal(self.digits)

    def fraction(self) -> Fraction:
        """The digits exactly. Raises ValueError for infinity."""
        return Fraction(self.digits)

    def bounds(self) -> tuple[Fraction, Fraction]:
        """Fractions below and above. Raises UndecidedError where nothing is known of the error."""
        if self.uncertainty == "":
            from .errors import UndecidedError

            raise UndecidedError(f"{self.digits} has no bound of its error")
        if self._bounds is not None:
            return self._bounds
        return self.fraction() - Fraction(self.uncertainty), self.fraction() + Fraction(self.uncertainty)

    def __contains__(self, x: Any) -> bool:
        """Whether a number (int, Fraction, Decimal, a decimal as str, mpf) is within the bounds; of a Ball, all of it."""
        lower, upper = self.bounds()
        if isinstance(x, Ball):
            return lower <= x.bounds()[0] and x.bounds()[1] <= upper
        value = _fraction_of(x)
        return lower <= value <= upper

    def _with(self, other: Any, operation: Callable[[enclosures.Bounds, enclosures.Bounds], enclosures.Bounds]) -> Any:
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        if isinstance(known[0], float):
            raise ValueError(f"{other} is not a finite number")
        rigour = other._parts[2] if isinstance(other, Ball) else rigours["proved"]
        return Ball._between(operation(self.bounds(), known), min(self._parts[2], rigour))

    def __neg__(self) -> Ball:
        lower, upper = self.bounds()
        return Ball._between((-upper, -lower), self._parts[2])

    def __pos__(self) -> Ball:
        return self

    def __abs__(self) -> Ball:
        return Ball._between(enclosures.size(self.bounds()), self._parts[2])

    def __add__(self, other: Any) -> Any:
        return self._with(other, lambda x, y: (x[0] + y[0], x[1] + y[1]))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda x, y: (x[0] - y[1], x[1] - y[0]))

    def __rsub__(self, other: Any) -> Any:
        return self._with(other, lambda x, y: (y[0] - x[1], y[1] - x[0]))

    def __mul__(self, other: Any) -> Any:
        return self._with(other, enclosures.product)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, lambda x, y: enclosures.product(x, enclosures.reciprocal(y)))

    def __rtruediv__(self, other: Any) -> Any:
        return self._with(other, lambda x, y: enclosures.product(y, enclosures.reciprocal(x)))

    def __pow__(self, n: Any) -> Any:
        if isinstance(n, (int, np.integer)):
            return Ball._between(enclosures.power(self.bounds(), int(n)), self._parts[2])
        return self._with(n, self._power)

    def __rpow__(self, base: Any) -> Any:
        return self._with(base, lambda x, y: self._power(y, x))

    def _power(self, x: enclosures.Bounds, y: enclosures.Bounds) -> enclosures.Bounds:
        """[x]^[y] for positive numbers, where it is monotone in both: between powers of the ends, each proved."""
        if x[0] <= 0:
            raise ValueError("a power that is not whole is of a positive number, and this one is not, or not known to be")
        digits = len(self.digits) + 20
        ends = [ball(f"({base})^({exponent})", digits).bounds() for base in set(x) for exponent in set(y)]
        return min(low for low, _ in ends), max(high for _, high in ends)

    def _decided(self, what: str, true: bool, false: bool) -> bool:
        if not true and not false:
            from .errors import UndecidedError

            raise UndecidedError(f"{self.digits} +- {self.uncertainty} {what} is not decided: compute it to more digits")
        return true

    def __lt__(self, other: Any) -> bool:
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        lower, upper = self._ends()
        return self._decided(f"< {other}", upper < known[0], lower >= known[1])

    def __le__(self, other: Any) -> bool:
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        lower, upper = self._ends()
        return self._decided(f"<= {other}", upper <= known[0], lower > known[1])

    def __gt__(self, other: Any) -> bool:
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        lower, upper = self._ends()
        return self._decided(f"> {other}", lower > known[1], upper <= known[0])

    def __ge__(self, other: Any) -> bool:
        known = _bounds_of(other)
        if known is None:
            return NotImplemented
        lower, upper = self._ends()
        return self._decided(f">= {other}", lower >= known[1], upper < known[0])

    def __bool__(self) -> bool:
        """Whether it differs from 0. Raises UndecidedError where it is not distinguished from 0."""
        lower, upper = self._ends()
        return self._decided("!= 0", lower > 0 or upper < 0, lower == upper == 0)

    def _ends(self) -> tuple[Any, Any]:
        """What comparisons use: numbers without a bound are their digits, and there is infinity."""
        if self.digits in ("inf", "-inf"):
            return float(self.digits), float(self.digits)
        return (self.fraction(), self.fraction()) if self.uncertainty == "" else self.bounds()

    def _whole(self, what: str, of: Callable[[Fraction], int]) -> int:
        found = enclosures.decided(self.bounds(), of)
        if found is None:
            from .errors import UndecidedError

            raise UndecidedError(f"{what} of {self.digits} +- {self.uncertainty} is not decided: compute it to more digits")
        return int(found)

    def __int__(self) -> int:
        return self._whole("int()", math.trunc)

    def __trunc__(self) -> int:
        return self._whole("trunc()", math.trunc)

    def __floor__(self) -> int:
        return self._whole("floor()", math.floor)

    def __ceil__(self) -> int:
        return self._whole("ceil()", math.ceil)

    def __round__(self, places: int | None = None) -> Any:
        """The nearest integer; with places a Ball with so many decimals, whose bound includes the rounding."""
        if places is None:
            return self._whole("round()", round)
        lower, upper = self.bounds()
        digits = str(Decimal(self._whole("round()", lambda x: round(x * Fraction(10) ** places))).scaleb(-places)).lower()
        reach = max(abs(Fraction(digits) - end) for end in (lower, upper))
        return Ball._of((digits, enclosures.bound_text(reach), self._parts[2]), (lower, upper))

    def __format__(self, spec: str) -> str:
        """As of a Decimal: f"{b:.10f}". Raises ValueError for more digits than are certain."""
        if self.uncertainty == "" or self.digits in ("inf", "-inf"):
            return format(Decimal(self.digits) if spec and spec[-1] in "eEfFgG%" else self.digits, spec)
        return enclosures.formatted(self.bounds(), spec, self.digits)

    @property
    def _mpf_(self) -> Any:
        """What mpmath.mpf(ball) takes: the midpoint, which it rounds to its own precision."""
        return self.mpmath()._mpf_

    def mpmath(self) -> Any:
        """The midpoint as an mpf, exactly, whatever mp.prec is. Raises RangeError for infinity."""
        from mpmath import mp
        from mpmath.libmp import from_man_exp

        mantissa, exponent, _, _ = self.exact()
        return mp.make_mpf(from_man_exp(mantissa, exponent))

    def mpi(self) -> Any:
        """The enclosure as an interval of mpmath.iv, rounded outwards to its precision."""
        from mpmath import iv
        from mpmath.libmp import from_man_exp

        mantissa, exponent, radius, radius_exponent = self.exact()
        reach = iv.make_mpf((from_man_exp(-radius, radius_exponent), from_man_exp(radius, radius_exponent)))
        middle = iv.make_mpf((from_man_exp(mantissa, exponent),) * 2)
        return middle + reach


def _bounds_of(x: Any) -> enclosures.Bounds | None:
    """The bounds of a number of another kind, floats as the doubles that they are; None for what is none."""
    if isinstance(x, Ball):
        return x._ends()
    if isinstance(x, (bool, np.bool_, str)):
        return None
    if isinstance(x, (float, np.floating)) and not math.isfinite(x):
        return (float(x), float(x)) if not math.isnan(x) else None  # type: ignore[return-value]
    if isinstance(x, (int, Fraction, Decimal, float, np.integer, np.floating)) or hasattr(x, "_mpf_"):
        value = _fraction_of(x if not isinstance(x, (np.integer, np.floating)) else x.item())
        return value, value
    return None


def _fraction_of(x: Any) -> Fraction:
    if hasattr(x, "_mpf_"):
        sign, mantissa, exponent, _ = x._mpf_
        return Fraction((-1 if sign else 1) * int(mantissa)) * Fraction(2) ** int(exponent)
    return x if isinstance(x, Fraction) else Fraction(x)


def ball(number: Any, digits: int = 50) -> Ball:
    """The number given by a text such as 'sqrt(2)' or 'acos(1/3)', to proved digits."""
    return Ball._of(_libration.read(text_of(number), digits))
