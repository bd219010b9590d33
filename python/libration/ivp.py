"""Initial value problems in double precision with the signature of scipy.integrate.solve_ivp, by Taylor series."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from . import _libration
from .drawing import lines_of, table_of
from .tracing import text_of_system, unknown_names

_messages = {
    -1: "Required step size is less than spacing between numbers.",
    0: "The solver successfully reached the end of the integration interval.",
    1: "A termination event occurred.",
}
_known_options = {"first_step", "max_step", "rtol", "atol", "jac", "jac_sparsity", "lband", "uband", "min_step"}
_methods = ("RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA", "taylor")
# The points of a step, in units of its length, between which events are searched: a step of Taylor series is longer than
# those of Runge-Kutta methods, and any length is one step if the solution is a polynomial.
_places_in_step = np.concatenate([[0], 2.0 ** np.arange(-10, -2), np.arange(2, 8) / 8])


class OdeResult(dict):  # type: ignore[type-arg]
    """What solve_ivp returns: t, y, sol, t_events, y_events, nfev, njev, nlu, status, message and success, as attributes
    and as items. heuristic: double precision, nothing proved."""

    rigour = "heuristic"

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError as missing:
            raise AttributeError(name) from missing

    __setattr__ = dict.__setitem__
    __delattr__ = dict.__delitem__

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        return "\n".join(f"{name:>{width}}: {value!r}" for name, value in self.items())

    def __dir__(self) -> list[str]:
        return [*self, "plot"]

    def plot(self, ax: Any = None) -> Any:
        """Draws every unknown against t and returns the axes of matplotlib."""
        return lines_of(self.t, dict(zip(unknown_names(len(self.y)), self.y)), "t", ax)

    def _repr_html_(self) -> str:
        rows = np.column_stack([self.t, *self.y])
        return table_of(["t", *unknown_names(len(self.y))], rows.tolist(), self.message)


class OdeSolution:
    """Dense output: sol(t) is the state at a time, or the states at an array of times, one column each."""

    def __init__(self, ts: np.ndarray, coefficients: np.ndarray) -> None:
        self.ts = ts
        self.t_min, self.t_max = min(ts[0], ts[-1]), max(ts[0], ts[-1])
        self._coefficients = coefficients  # [step][unknown][power]

    def __call__(self, t: Any) -> np.ndarray:
        times = np.asarray(t, dtype=float)
        flat = times.ravel()
        ascending = self.ts[-1] >= self.ts[0]
        edges = self.ts if ascending else -self.ts
        step = np.searchsorted(edges[1:-1], flat if ascending else -flat, side="left")
        distance = flat - self.ts[step]
        taken = self._coefficients[step]
        values = np.zeros(taken.shape[:2])
        with np.errstate(over="ignore", invalid="ignore"):
            for power in range(taken.shape[2] - 1, -1, -1):
                values = values * distance[:, None] + taken[:, :, power]
        return values.T if times.ndim else values[0]


def _root(g: Callable[[float], float], a: float, b: float, at_a: float, at_b: float) -> float:
    """A zero of g between two times at which its signs differ, by the Illinois rule."""
    if at_a == 0 or at_b == 0:
        return a if at_a == 0 else b
    while abs(b - a) > 4 * np.finfo(float).eps * max(abs(a), abs(b)):
        middle = b - at_b * (b - a) / (at_b - at_a)
        if not min(a, b) < middle < max(a, b):
            middle = a + (b - a) / 2
        if middle in (a, b):
            break
        value = g(middle)
        if value == 0:
            return middle
        if (value > 0) != (at_b > 0):
            a, at_a = b, at_b
        else:
            at_a = at_a / 2
        b, at_b = middle, value
    return b


class _Event:
    """A function whose zeros are searched, with SciPy's attributes terminal and direction."""

    def __init__(self, function: Callable[..., Any], args: Sequence[Any]) -> None:
        self._function = function
        self._args = args
        terminal = getattr(function, "terminal", None)
        self.most = int(terminal) if terminal else None  #: the number of events that ends the integration
        self.direction = float(getattr(function, "direction", 0))

    def __call__(self, t: float, state: np.ndarray) -> float:
        return float(np.squeeze(self._function(t, state, *self._args)))

    def times(self, sol: OdeSolution, grid: np.ndarray, states: np.ndarray) -> list[float]:
        """The zeros between the points of a grid, up to the one that ends the integration."""
        values = [self(t, states[:, i]) for i, t in enumerate(grid)]
        found: list[float] = []
        for a, b, at_a, at_b in zip(grid, grid[1:], values, values[1:]):
            up, down = at_a <= 0 <= at_b, at_a >= 0 >= at_b
            if not (up and self.direction >= 0 or down and self.direction <= 0):
                continue
            time = _root(lambda t: self(t, sol(t)), a, b, at_a, at_b)
            if not found or found[-1] != time:
                found.append(time)
            if self.most is not None and len(found) >= self.most:
                break
        return found


def _divided(ts: np.ndarray, places: np.ndarray) -> np.ndarray:
    inner = ts[:-1, None] + np.diff(ts)[:, None] * places
    return np.append(inner.ravel(), ts[-1])


def _span(t_span: Any) -> tuple[float, float]:
    t0, tf = map(float, t_span)
    return t0, tf


def _eval_times(t_eval: Any, t0: float, tf: float) -> np.ndarray:
    times = np.asarray(t_eval, dtype=float)
    if times.ndim != 1:
        raise ValueError("`t_eval` must be 1-dimensional.")
    if np.any(times < min(t0, tf)) or np.any(times > max(t0, tf)):
        raise ValueError("Values in `t_eval` are not within `t_span`.")
    steps = np.diff(times)
    if np.any(steps <= 0 if tf > t0 else steps >= 0):
        raise ValueError("Values in `t_eval` are not properly sorted.")
    return times


def _check(method: Any, options: dict[str, Any]) -> None:
    name = getattr(method, "__name__", method)
    if name not in _methods:
        raise ValueError(f"`method` must be one of {_methods}, and each of them means Taylor series")
    for option in options:
        if option not in _known_options:
            raise TypeError(f"solve_ivp has no option {option!r}")


def solve_ivp(
    fun: Callable[..., Any],
    t_span: Sequence[float],
    y0: Any,
    method: Any = "RK45",
    t_eval: Any = None,
    dense_output: bool = False,
    events: Any = None,
    vectorized: bool = False,
    args: Sequence[Any] | None = None,
    **options: Any,
) -> OdeResult:
    """scipy.integrate.solve_ivp with the same arguments and the same result, so that a script changes one import.

    fun is called once with symbols (libration.tracing) and becomes equations, which are integrated by Taylor series of
    full double precision: an error of some 1e-16 of max(1, |y|) per step, amplified by the equations, whatever rtol and
    atol are. method, jac and first_step are accepted and have no effect; max_step limits the distance of the points t.
    Without t_eval these are the ends of the steps, which are longer than those of SciPy. Events are zeros of functions of
    numbers, called as in SciPy; a pair of zeros within an eighth of a step (nfev is the number of steps) can be missed.
    Raises TypeError for a function that branches on its arguments or is not analytic, and for complex y0; UndecidedError
    after a million steps, as for stiff equations over long times.
    """
    _check(method, options)
    t0, tf = _span(t_span)
    start = np.atleast_1d(np.asarray(y0))
    if np.iscomplexobj(start):
        raise TypeError("y0 is complex: write the real and the imaginary parts as unknowns")
    if start.ndim != 1:
        raise ValueError("`y0` must be 1-dimensional.")
    start = start.astype(float)
    extra = tuple(args) if args is not None else ()
    problem = _libration.Problem(text_of_system(fun, t0, start.tolist(), extra), "")
    ts, coefficients = problem.steps(t0, start, tf)
    if len(coefficients) == 0 and tf != t0:
        ts, coefficients = np.array([t0, t0]), np.append(start[:, None], np.zeros((len(start), 1)), axis=1)[None]
    return _result(ts, coefficients, (t0, tf), start, t_eval, dense_output, _events_of(events, extra), options)


def _events_of(events: Any, args: Sequence[Any]) -> list[_Event] | None:
    if events is None:
        return None
    return [_Event(each, args) for each in ([events] if callable(events) else events)]


def _result(
    ts: np.ndarray,
    coefficients: np.ndarray,
    span: tuple[float, float],
    start: np.ndarray,
    t_eval: Any,
    dense_output: bool,
    events: list[_Event] | None,
    options: dict[str, Any],
) -> OdeResult:
    t0, tf = span
    if t0 == tf:
        ts, coefficients = np.array([t0, t0]), start[None, :, None]
    sol = OdeSolution(ts, coefficients)
    status = 0 if ts[-1] == tf else -1
    longest = float(options.get("max_step", np.inf))
    parts = 1 if not np.isfinite(longest) else max(1, int(np.ceil(np.abs(np.diff(ts)).max() / longest)))
    points = _divided(ts, np.arange(parts) / parts) if t0 != tf else np.array([t0])
    t_events = y_events = None
    end = ts[-1]
    if events is not None:
        grid = _divided(ts, np.union1d(np.arange(parts) / parts, _places_in_step))
        states = sol(grid)
        all_times = [np.array(each.times(sol, grid, states)) for each in events]
        ends = [times[-1] for each, times in zip(events, all_times) if each.most and len(times) >= each.most]
        if ends:
            end = min(ends, key=lambda t: abs(t - t0))
            status = 1
        t_events = [times[np.abs(times - t0) <= abs(end - t0)] for times in all_times]
        y_events = [sol(times).T if len(times) else np.empty((0,)) for times in t_events]
    if t_eval is not None:
        points = _eval_times(t_eval, t0, tf)
        points = points[np.abs(points - t0) <= abs(end - t0)]
    elif end != ts[-1]:
        points = np.append(points[np.abs(points - t0) < abs(end - t0)], end)
    return OdeResult(
        t=points,
        y=sol(points) if len(points) else np.empty((len(start), 0)),
        sol=sol if dense_output else None,
        t_events=t_events,
        y_events=y_events,
        nfev=len(ts) - 1,
        njev=0,
        nlu=0,
        status=status,
        message=_messages[status],
        success=status >= 0,
    )
