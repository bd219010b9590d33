"""Numbers with what is known of their error."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

from . import _libration
from .texts import rigours, text_of, usual_word

_names = {number: name for name, number in rigours.items()}


class Ball:
    """A decimal and a bound of its distance to the exact number.

    str() prints the digits, each right to one unit in the last. `rigour` is 'proved' (ball arithmetic), 'two-method'
    (runs in MPFR that agree, or a bound of the error known before) or 'heuristic'. Immutable; equal to a ball with the same
    digits, bound and rigour.
    """

    __slots__ = ("_parts",)
    _parts: tuple[str, str, int]

    def __init__(self, decimal: str, uncertainty: str = "0", rigour: str = "proved") -> None:
        """A number as it was written down; bound and rigour are believed. Raises ArgumentError for what is none."""
        rigour = usual_word(rigour)
        if rigour not in rigours:
            raise ValueError(f"rigour is {rigour!r}: write 'proved', 'two-method' or 'heuristic'")
        _libration.Number(decimal, uncertainty, rigours[rigour])
        object.__setattr__(self, "_parts", (decimal, uncertainty, rigours[rigour]))

    @classmethod
    def _of(cls, parts: tuple[str, str, int]) -> Ball:
        made = object.__new__(cls)
        object.__setattr__(made, "_parts", parts)
        return made

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

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Ball):
            return NotImplemented
        return self._parts == other._parts

    def __hash__(self) -> int:
        return hash(self._parts)

    def __reduce__(self) -> tuple[Any, ...]:
        return Ball, (self.digits, self.uncertainty, self.rigour)

    def _number(self) -> _libration.Number:
        return _libration.Number(*self._parts)

    def __float__(self) -> float:
        """The double nearest to the exact number. Raises UndecidedError where the digits do not tell which one it is."""
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
        return self.fraction() - Fraction(self.uncertainty), self.fraction() + Fraction(self.uncertainty)

    def __contains__(self, x: Any) -> bool:
        """Whether a number (int, Fraction, Decimal, a decimal as str, mpf) is within the bounds."""
        lower, upper = self.bounds()
        value = _fraction_of(x)
        return lower <= value <= upper

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


def _fraction_of(x: Any) -> Fraction:
    if hasattr(x, "_mpf_"):
        sign, mantissa, exponent, _ = x._mpf_
        return Fraction((-1 if sign else 1) * int(mantissa)) * Fraction(2) ** int(exponent)
    return x if isinstance(x, Fraction) else Fraction(x)


def ball(number: Any, digits: int = 50) -> Ball:
    """The number given by a text such as 'sqrt(2)' or 'acos(1/3)', to proved digits."""
    return Ball._of(_libration.read(text_of(number), digits))
