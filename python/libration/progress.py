"""How far a long call is: a bar of tqdm where that is installed, else a line on stderr."""

from __future__ import annotations

import functools
import sys
import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar, cast

_Call = TypeVar("_Call", bound=Callable[..., Any])

_seconds_before = 2.0
_parts = 1000
_wanted: bool | None = None
_here = threading.local()


def show_progress(wanted: bool | None) -> None:
    """Whether calls that take longer than two seconds show how far they are: always, never, or, with None as at first, in
    notebooks and where stderr is a terminal."""
    global _wanted
    _wanted = wanted


def _is_shown() -> bool:
    if _wanted is not None:
        return _wanted
    return "ipykernel" in sys.modules or bool(getattr(sys.stderr, "isatty", lambda: False)())


class _Line:
    """Of one call. A part that is less than before, as of a second run with more digits, is shown as it is."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._begin = time.monotonic()
        self._part = 0.0
        self._bar: Any = None
        self._written = False

    def reached(self, part: float) -> None:
        self._part = part
        if time.monotonic() - self._begin < _seconds_before or not _is_shown():
            return
        if self._bar is None and not self._written:
            try:
                from tqdm.auto import tqdm

                self._bar = tqdm(total=_parts, desc=self._what, unit_scale=100 / _parts, unit="%", leave=False)
            except ImportError:
                self._written = True
        if self._bar is not None:
            self._bar.n = round(part * _parts)
            self._bar.refresh()
        else:
            print(f"\r{self.how_far()}", end="", file=sys.stderr, flush=True)

    def how_far(self) -> str:
        done = f"{100 * self._part:.1f} % done, " if self._part > 0 else ""
        return f"{self._what}: {done}{time.monotonic() - self._begin:.0f} s"

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
        elif self._written:
            print("\r" + " " * len(self.how_far()) + "\r", end="", file=sys.stderr, flush=True)


def reached(part: float) -> None:
    """Called by the library, at most ten times a second."""
    line = getattr(_here, "line", None)
    if line is not None:
        line.reached(part)


def with_progress(call: _Call) -> _Call:
    """A method that shows how far it is; an interrupt has as its message how far it was."""

    @functools.wraps(call)
    def shown(*args: Any, **options: Any) -> Any:
        before = getattr(_here, "line", None)
        line = _here.line = _Line(call.__name__)
        try:
            return call(*args, **options)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted at {line.how_far()}; a solution() keeps its steps for earlier times") from None
        finally:
            line.close()
            _here.line = before

    return cast(_Call, shown)
