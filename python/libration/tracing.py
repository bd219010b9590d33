"""Equations from a function of Python, which is called once with symbols in place of numbers.

    text_of_system(lambda t, y: [y[1], -np.sin(y[0])], 0, [2, 0])

The function may use arithmetic, NumPy, math, mpmath and scipy.special, also in functions that it calls; it may not branch
on the solution. Floats in it are the doubles that they are, as the function itself would use them.
"""

from __future__ import annotations

import functools
import types
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from .texts import text_of

# How tightly a text binds: a sum or a sign, a product, a power, a name.
_SUM, _PRODUCT, _POWER, _NAME = range(4)

_constants = {"pi": "pi", "e = exp(1)": "exp(1)", "ln(2)": "log(2)", "ln(10)": "log(10)"}  # of mpmath, by their names


def _constant(x: Any) -> str:
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
        text = _constant(x)
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

# What replaces a function by its name if one of its arguments is Traced.
_functions: dict[str, Callable[..., Any]] = {
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
_traced_packages = ("math", "cmath", "numpy", "mpmath", "scipy")


def _has_traced(arguments: Sequence[Any]) -> bool:
    return any(
        isinstance(each, Traced)
        or (isinstance(each, (list, tuple)) and _has_traced(each))
        or (isinstance(each, np.ndarray) and each.dtype == object and _has_traced(each.ravel().tolist()))
        for each in arguments
    )


def _package_of(x: Any) -> str:
    owner = getattr(x, "__self__", None)
    module = x.__name__ if isinstance(x, types.ModuleType) else getattr(x, "__module__", None)
    if module is None or isinstance(owner, types.ModuleType):
        module = getattr(owner, "__name__", None) or type(owner if owner is not None else x).__module__
    return str(module).partition(".")[0]


def _dispatched(name: str, original: Any) -> Any:
    """The function, and on symbols the one of the same name."""
    replaced = _functions[name]

    @functools.wraps(original, updated=())
    def function(*arguments: Any, **options: Any) -> Any:
        if not _has_traced(arguments):
            return original(*arguments, **options)
        if any(isinstance(each, np.ndarray) for each in arguments):
            return np.frompyfunc(replaced, len(arguments), 1)(*arguments)
        return replaced(*arguments)

    return function


def _of_objects(create: Any) -> Any:
    """np.zeros and the like, with places for symbols."""
    return functools.wraps(create)(lambda shape, *_, **__: create(shape, dtype=object))


class _Package:
    """A module, or a context of mpmath, whose functions take symbols."""

    def __init__(self, package: Any) -> None:
        self._package = package

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._package, name)
        if self._package is np and name in ("zeros", "empty", "ones"):
            return _of_objects(found)
        if self._package is np and name in _functions:
            return found
        if name in _functions and callable(found):
            return _dispatched(name, found)
        return _Package(found) if isinstance(found, types.ModuleType) else found


class _Rebinding:
    """Functions with the same code, in which the names of packages and of their functions mean those for symbols."""

    def __init__(self) -> None:
        self._done: dict[int, Any] = {}

    def of(self, value: Any) -> Any:
        if id(value) in self._done:
            return self._done[id(value)]
        if isinstance(value, functools.partial):
            return functools.partial(self.of(value.func), *value.args, **value.keywords)
        if isinstance(value, types.MethodType) and _package_of(value) not in _traced_packages:
            return types.MethodType(self.of(value.__func__), value.__self__)
        if not (callable(value) or isinstance(value, types.ModuleType)) and type(value).__name__ != "MPContext":
            return value
        package = _package_of(value)
        if package in _traced_packages:
            return self._of_package(value)
        return self._function(value) if isinstance(value, types.FunctionType) else value

    @staticmethod
    def _of_package(value: Any) -> Any:
        if isinstance(value, types.ModuleType) or type(value).__name__ == "MPContext":
            return _Package(value)
        name = getattr(value, "__name__", "")
        if isinstance(value, np.ufunc) and getattr(np, name, None) is value:
            return value  # calls the method of this name of each symbol
        if name in ("f", "f_wrapped"):  # functions of mpmath that hide their names
            import mpmath

            name = next((each for each in _functions if getattr(mpmath, each, None) == value), "")
        return _dispatched(name, value) if name in _functions else value

    def _function(self, function: types.FunctionType) -> Any:
        names = dict(function.__globals__)
        cells = tuple(types.CellType() for _ in function.__closure__ or ())
        made = types.FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells)
        made.__kwdefaults__ = function.__kwdefaults__
        self._done[id(function)] = made  # before what it refers to, which may be the function itself
        for name in _names_in(function.__code__):
            if name in names:
                names[name] = self.of(names[name])
        for cell, given in zip(cells, function.__closure__ or ()):
            cell.cell_contents = self.of(given.cell_contents)
        return made


def _names_in(code: types.CodeType) -> set[str]:
    names = set(code.co_names)
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            names |= _names_in(constant)
    return names


def rebound(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function as it is called with symbols."""
    return _Rebinding().of(function)


def unknown_names(count: int) -> list[str]:
    """y0, y1, ...: the unknowns of a system by their places."""
    return [f"y{i}" for i in range(count)]


def right_sides(function: Callable[..., Any], size: int, extra: Sequence[Any] = (), of_arrays: bool = True) -> list[str]:
    """The texts of function(t, y, *extra). Raises TypeError for what is no equation, ValueError for another number of
    right-hand sides than of unknowns."""
    symbols = [Traced(name) for name in unknown_names(size)]
    given = np.array(symbols, dtype=object) if of_arrays else symbols
    found = rebound(function)(Traced("t"), given, *extra)
    if isinstance(found, np.ndarray):
        found = found.ravel().tolist()
    elif not isinstance(found, (list, tuple)):
        found = list(found) if hasattr(found, "__iter__") else [found]
    if len(found) != size:
        raise ValueError(f"the function has {len(found)} values, and y0 has {size}")
    return [Traced.of(each).text for each in found]


def text_of_system(
    function: Callable[..., Any], t0: Any, y0: Sequence[Any], extra: Sequence[Any] = (), of_arrays: bool = True
) -> str:
    """The problem y' = function(t, y, *extra), y(t0) = y0, as the library reads it."""
    names = unknown_names(len(y0))
    point = _constant(t0)
    lines = [f"{name}' = {right}" for name, right in zip(names, right_sides(function, len(y0), extra, of_arrays))]
    lines += [f"{name}({point}) = {_constant(start)}" for name, start in zip(names, y0)]
    return "\n".join(lines)
