"""What goes wrong, by what a caller can do about it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from .tables import Row, Table


class LibrationError(Exception):
    """An error of the library: `subject` is the quantity, `value` what was given, `reason` why it is an error."""

    def __init__(self, message: str, subject: str = "", value: str = "", reason: str = "") -> None:
        super().__init__(message)
        self.subject = subject
        self.value = value
        self.reason = reason


class UndefinedError(LibrationError):
    """The question as stated has no result."""


class UnableError(LibrationError):
    """An answer was not decided or not computed within the limits."""


class ArgumentError(UndefinedError, ValueError):
    """Malformed or outside the domain: give another value."""


class RangeError(UndefinedError, OverflowError):
    """Beyond the range of the requested type."""


class UndecidedError(UnableError, ArithmeticError):
    """No precision, proof or method within the limits decides; nothing is wrong with the value.

    partial: what is proved all the same, of the type that the call would have returned, or None where the call has no
    parts. In it a value that is not distinguished from 0 is the Ball 0 with the bound of its size as uncertainty, and
    one at a time that is not reached is ''.
    """

    partial: Row | Table | None = None


class Fault(LibrationError, RuntimeError):
    """A mistake of the library, or of one under it."""


_classes = {1: ArgumentError, 2: RangeError, 3: UndecidedError}


def error_of(code: int, message: str, subject: str, value: str, reason: str) -> LibrationError:
    """The exception of a code of libration.h."""
    return _classes.get(code, Fault)(message, subject, value, reason)


def with_partial(problem: UndecidedError, form: Callable[[Any], Any]) -> UndecidedError:
    """The error with what is known nevertheless in the form of the result."""
    if problem.partial is not None:
        problem.partial = form(problem.partial)
    return problem
