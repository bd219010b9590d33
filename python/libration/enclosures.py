"""Intervals between fractions, and the decimals with bounds that are printed for them: the arithmetic of Ball."""

from __future__ import annotations

import re
from collections.abc import Callable
from decimal import ROUND_CEILING, Context, Decimal
from fractions import Fraction
from typing import Any

Bounds = tuple[Fraction, Fraction]

# Long ends of intervals are rounded outwards to 2^-64 of the width, so that they do not grow with each operation.
_bits_of_width = 64
_long = 2**10
_upwards = Context(prec=3, rounding=ROUND_CEILING)


def _power_of_two_below(x: Fraction) -> Fraction:
    return Fraction(2) ** (x.numerator.bit_length() - x.denominator.bit_length() - 1)


def shortened(bounds: Bounds) -> Bounds:
    """An interval that contains this one and has short ends."""
    lower, upper = bounds
    if lower == upper or (lower.denominator * upper.denominator).bit_length() < _long:
        return bounds
    grain = _power_of_two_below(upper - lower) / 2**_bits_of_width
    return lower // grain * grain, -(-upper // grain) * grain


def product(x: Bounds, y: Bounds) -> Bounds:
    """[x] * [y]."""
    ends = [a * b for a in x for b in y]
    return min(ends), max(ends)


def reciprocal(x: Bounds) -> Bounds:
    """1 / [x]. Raises ZeroDivisionError for an interval that contains 0."""
    if x[0] <= 0 <= x[1]:
        raise ZeroDivisionError("division by a number that is 0 or not distinguished from 0")
    return 1 / x[1], 1 / x[0]


def power(x: Bounds, n: int) -> Bounds:
    """[x]^n for an integer n."""
    if n < 0:
        return reciprocal(power(x, -n))
    low, high = sorted((x[0] ** n, x[1] ** n))
    return (Fraction(0) if n > 0 and n % 2 == 0 and x[0] <= 0 <= x[1] else low), high


def size(x: Bounds) -> Bounds:
    """[|x|]."""
    low, high = sorted((abs(x[0]), abs(x[1])))
    return (Fraction(0) if x[0] <= 0 <= x[1] else low), high


def _exponent_above(x: Fraction) -> int:
    """The least e with x <= 10^e."""
    guess = len(str(x.numerator)) - len(str(x.denominator)) - 1
    while Fraction(10) ** guess < x:
        guess += 1
    return guess


def _nearest(x: Fraction, exponent: int) -> Decimal:
    """A multiple of 10^exponent next to x."""
    whole = round(x / Fraction(10) ** exponent)
    return Decimal((0 if whole >= 0 else 1, tuple(map(int, str(abs(whole)))), exponent))


def _exact_decimal(x: Fraction) -> str | None:
    rest, exponent = x.denominator, 0
    for prime in (2, 5):
        count = 0
        while rest % prime == 0:
            rest, count = rest // prime, count + 1
        exponent = max(exponent, count)
    return str(_nearest(x, -exponent)).lower() if rest == 1 else None


def bound_text(x: Fraction) -> str:
    """A decimal of three digits that is at least x."""
    if x == 0:
        return "0"
    exponent = _exponent_above(x) - 4
    above = _upwards.plus(Decimal(-(-x // Fraction(10) ** exponent)).scaleb(exponent))
    return f"{above:.2e}" if not 1e-3 <= above < 1000 else f"{above:f}"


def decimal_and_bound(bounds: Bounds) -> tuple[str, str]:
    """The digits that are right to one unit in the last, and a bound of their error: fractions p/q where they are exact
    and no decimals, "0" where no digit is certain."""
    lower, upper = bounds
    if lower == upper:
        return _exact_decimal(lower) or f"{lower.numerator}/{lower.denominator}", "0"
    middle, reach = (lower + upper) / 2, (upper - lower) / 2
    digits = _nearest(middle, _exponent_above(2 * reach))
    if digits.is_zero():
        return "0", bound_text(max(-lower, upper))
    return str(digits).lower(), bound_text(reach + abs(middle - Fraction(digits)))


_precision = re.compile(r"^(.*?)\.(\d+)([eEfFgG%])$")


def formatted(bounds: Bounds, spec: str, text: str) -> str:
    """As format() of a Decimal, for a number between the bounds. Raises ValueError where the digits that are asked for are
    not certain to one unit in the last."""
    if not spec or spec[-1] not in "eEfFgG%":
        return format(text, spec)
    middle, reach = (bounds[0] + bounds[1]) / 2, (bounds[1] - bounds[0]) / 2
    found = _precision.match(spec)
    if not found:
        return format(Decimal(decimal_and_bound(bounds)[0]), spec)
    places, kind = int(found[2]), found[3].lower()
    leading = _exponent_above(abs(middle)) if middle else 0
    exponent = {"f": -places, "%": -places - 2, "e": leading - places - 1, "g": leading - max(places, 1)}[kind]
    if 2 * reach > Fraction(10) ** exponent:
        raise ValueError(f"{text} has fewer certain digits than format {spec!r} prints: compute it to more digits")
    return format(_nearest(middle, exponent - 2), spec)


def decided(bounds: Bounds, of: Callable[[Fraction], Any]) -> Any | None:
    """The value of a monotonic function that is the same at both bounds; None where it is not."""
    low, high = of(bounds[0]), of(bounds[1])
    return low if low == high else None
