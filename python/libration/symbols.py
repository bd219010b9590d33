"""Symbols instead of numbers: arithmetic and functions of them build the text of an equation."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from .texts import text_of

# How tightly a text binds: a sum or a sign, a product, a power, a name.
_SUM, _PRODUCT, _POWER, _NAME = range(4)

_constants = {"pi": "pi", "e = exp(1)": "exp(1)", "ln(2)": "log(2)", "ln(10)": "log(10)"}  # of mpmath, by their names


def constant_text(x: Any) -> str:
    """The exact text of a number in a function: a float is the double that it is."""
    name = getattr(x, "name", None)
    if name in _constants and hasattr(x, "_mpf_"):
        return _constants[name]
    if isinstance(x, np.generic):
        x = x.item()
    if isinstance(x, complex):
        raise TypeError(f"the function has the complex number {x}, and equations are real")
    return text_of(x, "a number of the function", exact=False)


class Traced:
    """An expression in the unknowns and the variable. Immutable."""

    __slots__ = ("rank", "text", "varies")

    def __init__(self, text: str, rank: int = _NAME, varies: bool = True) -> None:
        self.text = text
        self.rank = rank
        self.varies = varies  # not a constant

    @classmethod
    def of(cls, x: Any) -> Traced:
        if isinstance(x, Traced):
            return x
        if isinstance(x, np.ndarray) and x.ndim == 0:
            return cls.of(x.item())
        if isinstance(x, str):
            raise TypeError(f"the function has the text {x!r}, which is not a number")
        text = constant_text(x)
        return cls(text, _NAME if text.isalnum() else _SUM, False)

    def __repr__(self) -> str:
        return self.text

    def _within(self, rank: int) -> str:
        return self.text if self.rank >= rank else f"({self.text})"

    @property
    def _is_zero(self) -> bool:
        return self.text == "0"

    def _sum(self, other: Any, sign: str) -> Any:
        try:
            right = Traced.of(other)
        except TypeError:
            return NotImplemented
        if right._is_zero:
            return self
        if self._is_zero:
            return right if sign == "+" else -right
        return Traced(f"{self.text} {sign} {right._within(_PRODUCT)}", _SUM, self.varies or right.varies)

    def _product(self, other: Any, sign: str) -> Any:
        try:
            right = Traced.of(other)
        except TypeError:
            return NotImplemented
        if self._is_zero or (sign == "*" and right.text == "1"):
            return self
        if sign == "*" and (right._is_zero or self.text == "1"):
            return right
        text = f"{self._within(_PRODUCT)}{sign}{right._within(_PRODUCT if sign == '*' else _POWER)}"
        return Traced(text, _PRODUCT, self.varies or right.varies)

    def __add__(self, other: Any) -> Any:
        return self._sum(other, "+")

    def __radd__(self, other: Any) -> Any:
        return Traced.of(other) + self

    def __sub__(self, other: Any) -> Any:
        return self._sum(other, "-")

    def __rsub__(self, other: Any) -> Any:
        return Traced.of(other) - self

    def __mul__(self, other: Any) -> Any:
        return self._product(other, "*")

    def __rmul__(self, other: Any) -> Any:
        return Traced.of(other) * self

    def __truediv__(self, other: Any) -> Any:
        return self._product(other, "/")

    def __rtruediv__(self, other: Any) -> Any:
        return Traced.of(other) / self

    def __neg__(self) -> Traced:
        return Traced(f"-{self._within(_PRODUCT)}", _SUM, self.varies)

    def __pos__(self) -> Traced:
        return self

    def __pow__(self, other: Any) -> Any:
        if isinstance(other, np.ndarray) and other.ndim > 0:
            return NotImplemented
        exponent = Traced.of(other)
        if exponent.varies:
            return (exponent * self.log()).exp()
        if isinstance(other, float):
            exponent = Traced(str(Fraction(other)), _SUM, False)
        power = exponent.text if exponent.text.isdigit() else f"({exponent.text})"
        return Traced(f"{self._within(_NAME)}^{power}", _POWER, self.varies)

    def __rpow__(self, other: Any) -> Any:
        return Traced.of(other) ** self

    def _refuse(self, *_: Any) -> Any:
        raise TypeError(
            f"the function branches on the solution, or uses it as a float ({self.text}): only arithmetic and analytic "
            "functions become equations"
        )

    __bool__ = __float__ = __int__ = __complex__ = __index__ = __round__ = __trunc__ = __floor__ = __ceil__ = _refuse
    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = __abs__ = __mod__ = __rmod__ = __floordiv__ = _refuse
    __hash__ = None  # type: ignore[assignment]

    def _function(self, name: str) -> Traced:
        return Traced(f"{name}({self.text})", _NAME, self.varies)

    def log(self, base: Any = None) -> Any:
        return self._function("log") if base is None else self._function("log") / Traced.of(base)._function("log")

    def square(self) -> Any:
        return self * self

    def reciprocal(self) -> Any:
        return 1 / self

    def conjugate(self) -> Traced:
        return self


# Functions of one argument: those of the library by the names that they have in NumPy, math, mpmath and scipy.special.
_of_one: dict[str, str] = {
    **{name: name for name in "exp sqrt sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh".split()},
    **{name: name for name in "erf erfc log10 log2 exp2 cbrt expm1 log1p lambertw".split()},
    **{f"arc{name}": f"a{name}" for name in "sin cos tan sinh cosh tanh".split()},
    "airyai": "airy_ai", "airybi": "airy_bi",
}  # fmt: skip
_of_order = {"besselj": "bessel_j", "bessely": "bessel_y", "besseli": "bessel_i", "besselk": "bessel_k",
             "jv": "bessel_j", "yv": "bessel_y", "iv": "bessel_i", "kv": "bessel_k"}  # fmt: skip


def _of_order_function(name: str) -> Callable[..., Traced]:
    def function(order: Any, x: Any) -> Traced:
        degree, argument = Traced.of(order), Traced.of(x)
        return Traced(f"{name}({degree.text}, {argument.text})", _NAME, argument.varies)

    return function


def _method(name: str) -> Callable[[Traced], Traced]:
    return lambda self: self._function(name)


for _name, _own in _of_one.items():
    setattr(Traced, _name, _method(_own))

#: What replaces a function of numbers by its name if one of its arguments is Traced.
functions_of_symbols: dict[str, Callable[..., Any]] = {
    **{name: (lambda x, own=own: Traced.of(x)._function(own)) for name, own in _of_one.items()},
    **{name: _of_order_function(own) for name, own in _of_order.items()},
    "log": lambda x, base=None: Traced.of(x).log(base),
    "ln": lambda x: Traced.of(x).log(),
    "pow": lambda x, y: Traced.of(x) ** y,
    "power": lambda x, y: Traced.of(x) ** y,
    "float_power": lambda x, y: Traced.of(x) ** y,
    "square": lambda x: Traced.of(x).square(),
    "reciprocal": lambda x: 1 / Traced.of(x),
    "sec": lambda x: 1 / Traced.of(x)._function("cos"),
    "csc": lambda x: 1 / Traced.of(x)._function("sin"),
    "cot": lambda x: Traced.of(x)._function("cos") / Traced.of(x)._function("sin"),
    "fsum": lambda terms: sum(terms),
    "expit": lambda x: 1 / (1 + (-Traced.of(x))._function("exp")),
    "mpf": lambda x: Traced.of(x),
    "mpmathify": lambda x: Traced.of(x),
}
