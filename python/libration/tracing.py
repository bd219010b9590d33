"""Equations from a function of Python, which is called once with symbols in place of numbers.

    text_of_system(lambda t, y: [y[1], -np.sin(y[0])], 0, [2, 0])

The function may use arithmetic, NumPy, math, mpmath and scipy.special, also in functions that it calls; it may not branch
on the solution. Floats in it are the doubles that they are, as the function itself would use them.
"""

from __future__ import annotations

import functools
import types
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .symbols import Traced, constant_text, functions_of_symbols

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
    replaced = functions_of_symbols[name]

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
        if self._package is np and name in functions_of_symbols:
            return found
        if name in functions_of_symbols and callable(found):
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

            name = next((each for each in functions_of_symbols if getattr(mpmath, each, None) == value), "")
        return _dispatched(name, value) if name in functions_of_symbols else value

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
    point = constant_text(t0)
    lines = [f"{name}' = {right}" for name, right in zip(names, right_sides(function, len(y0), extra, of_arrays))]
    lines += [f"{name}({point}) = {constant_text(start)}" for name, start in zip(names, y0)]
    return "\n".join(lines)
