"""Motions of the pendulum, theta'' + sin theta = 0."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _libration
from .ball import Ball
from .tables import Row, Table
from .texts import digits_and_rigour, rigour_of, text_of, times_text


class Samples(NamedTuple):
    """theta and omega in double, in the shape of the times."""

    theta: np.ndarray
    omega: np.ndarray


class Motion:
    """A motion, exact as it was given; made by motion(). Times are in sqrt(length/gravity) and energies in units of
    m g length; with a length and a gravity times are seconds and omega is in rad/s. Any number of threads may ask it.
    """

    def __init__(self, given: str) -> None:
        """From a text, "theta0 = 150deg; omega0 = 0": motion() makes it of keywords."""
        self._given = given
        self._motion = _libration.Motion(given)
        self._sampler: Any = None

    def __repr__(self) -> str:
        return f"libration.Motion({self._given!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Motion, (self._given,)

    @property
    def regime(self) -> str:
        """libration, rotation, separatrix, stable-equilibrium or unstable-equilibrium, decided exactly."""
        return self._motion.regime()

    def theta(self, time: Any, digits: int = 50, rigour: str = "proved") -> Ball:
        """The angle at a time ("1e12", "T/4", 3), not reduced to one turn."""
        return Ball._of(self._motion.theta(text_of(time, "time"), digits, rigour_of(rigour)))

    def omega(self, time: Any, digits: int = 50, rigour: str = "proved") -> Ball:
        """The angular velocity at a time."""
        return Ball._of(self._motion.omega(text_of(time, "time"), digits, rigour_of(rigour)))

    def reference(self, times: Any, digits: int = 50, rigour: str = "proved") -> Row | Table:
        """theta and omega at one time, or at a list of times as a Table."""
        texts, alone = times_text(times)
        states = Table._of(self._motion.states(texts, digits, rigour_of(rigour)))
        return states[0] if alone else states

    def period(self, digits: int = 50, rigour: str = "proved") -> Ball:
        """T, of a rotation the time of one turn; inf at E = 2."""
        return Ball._of(self._motion.period(digits, rigour_of(rigour)))

    def effective_period(self, digits: int = 50, rigour: str = "proved") -> Ball:
        """T*, from the top to the bottom; inf at E = 2."""
        return Ball._of(self._motion.effective_period(digits, rigour_of(rigour)))

    def energy(self, digits: int = 50, rigour: str = "proved") -> Ball:
        """E."""
        return Ball._of(self._motion.energy(digits, rigour_of(rigour)))

    def gap(self, digits: int = 50, rigour: str = "proved") -> Ball:
        """2 - E."""
        return Ball._of(self._motion.gap(digits, rigour_of(rigour)))

    def radius(self, at: Any = "", digits: int = 50, rigour: str = "proved") -> Ball:
        """The radius of convergence of the series of theta about top, bottom, start or a time; '' is the top, at E = 2
        the bottom."""
        return Ball._of(self._motion.radius(text_of(at, "at"), digits, rigour_of(rigour)))

    def coefficients(self, order: int, scalar: str = "ball:50", at: Any = "", first: int = 0) -> Table:
        """The Taylor coefficients first .. order of theta about a point: columns n, coefficient."""
        digits, rigour = digits_and_rigour(scalar)
        return Table._of(self._motion.coefficients(text_of(at, "at"), first, order, digits, rigour))

    def __call__(self, times: Any) -> Samples:
        """theta and omega at doubles, each of which counts as exact, without the interpreter's lock: within 4 units in
        the last place of max(1, |theta|) and of the largest |omega|. Some ten microseconds once, then a few nanoseconds
        a time. Raises ArgumentError for nan and infinities."""
        if self._sampler is None:
            self._sampler = _libration.Sampler(self._motion)
        return Samples(*self._sampler.at(np.asarray(times, dtype=float)))


def motion(
    *,
    theta0: Any = None,
    omega0: Any = None,
    energy: Any = None,
    gap: Any = None,
    direction: str | None = None,
    length: Any = None,
    gravity: Any = None,
) -> Motion:
    """theta0 and omega0; or the energy E, or the gap 2 - E, from the canonical start (the top, at E = 2 the bottom) or
    from theta0, in the direction '+' or '-'. length and gravity make times seconds.

    Numbers are texts ("150deg", "1e-30", "2-1e-10"), int, Fraction, Decimal, numbers of mpmath or SymPy; a float is
    refused with a TypeError. Raises ArgumentError for what is no motion.

    >>> motion(theta0="150deg", omega0=0).theta("1e12", digits=20)
    """
    given = {
        "theta0": theta0,
        "omega0": omega0,
        "energy": energy,
        "gap": gap,
        "direction": direction,
        "length": length,
        "gravity": gravity,
    }
    return Motion("; ".join(f"{name} = {text_of(value, name)}" for name, value in given.items() if value is not None))
