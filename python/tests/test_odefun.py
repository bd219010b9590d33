"""libration.odefun on the examples of mpmath.odefun's documentation, and on what that does not support."""

from fractions import Fraction

import libration as lb
import mpmath
import numpy as np
import pytest
from mpmath import atan, besselj, cos, exp, mp, mpf, pi, quad, sin


@pytest.fixture(autouse=True)
def precision():
    with mpmath.workdps(15):
        yield


def near(value, truth, units=1):
    """Within some units in the last of the digits of mp; the truth is computed with more of them."""
    return abs(value - truth) <= units * mpf(10) ** (1 - mp.dps) * abs(truth)


@pytest.mark.parametrize("x", [0, 1, 2.5])
def test_exponential(x):
    f = lb.odefun(lambda x, y: y, 0, 1)
    assert near(f(x), exp(x))


def test_exponential_with_50_digits():
    with mpmath.workdps(50):
        f = lb.odefun(lambda x, y: y, 0, 1)
        assert str(f(1)) == "2.7182818284590452353602874713526624977572470937"


def test_vectors_have_lists():
    f = lb.odefun(lambda x, y: [y[0]], 0, [1])
    assert isinstance(f(1), list) and str(f(1)[0]) == "2.71828182845905"


@pytest.mark.parametrize(("x", "shown"), [(2, "2.87255666284091"), (5, "3.14158520028345"), (10, "3.14159265358979")])
def test_sine_of_y(x, shown):
    f = lb.odefun(lambda x, y: x * sin(y), 0, pi / 2)
    # pi/2 is a number of 53 bits there, as for mpmath.
    assert str(f(x)) == shown
    assert near(f(x), 2 * atan(exp(mpf(x) ** 2 / 2)))


def test_integral():
    f = lambda x: (1 + x**2) / (1 + x**3)  # noqa: E731  # as in the documentation
    g = lb.odefun(lambda x, y: f(x), pi, 0)
    # 2*pi of 53 bits is the time.
    assert near(g(2 * pi), quad(f, [pi, 2 * pi]), 2)


@pytest.mark.parametrize("x", [0, 1, 2.5, 10])
def test_harmonic_oscillator(x):
    f = lb.odefun(lambda x, y: [-y[1], y[0]], 0, [1, 0])
    found = f(x)
    assert near(found[0], cos(x)) and near(found[1], sin(x))


def test_earlier_times_and_nested_functions():
    import math

    def decay(t):
        return math.exp(-t) * besselj(0, t + 3)

    f = lb.odefun(lambda t, y: decay(t) + np.cos(t), 0, Fraction(1, 3))
    with mpmath.workdps(30):
        truth = mpf(1) / 3 + quad(lambda t: exp(-t) * besselj(0, t + 3) + cos(t), [0, -2])
    assert near(f(-2), truth)


def test_tolerance_and_poles():
    f = lb.odefun(lambda t, y: 1 + y**2, 0, 0, tol=mpf("1e-30"))
    with mpmath.workdps(40):
        assert abs(f(1) - mpmath.tan(1)) < mpf("1e-30")
    with pytest.raises(lb.UndecidedError, match="is not reached"):
        f(2)
    assert f.balls(1, 20)[0].proved


def test_functions_that_are_no_equations():
    with pytest.raises(TypeError, match="branches on the solution"):
        lb.odefun(lambda t, y: y if y > 0 else -y, 0, 1)
    with pytest.raises(TypeError, match="complex"):
        lb.odefun(lambda t, y: 1j * y, 0, 1)
    with pytest.raises(TypeError, match="the text 'y'"):
        lb.odefun(lambda t, y: "y", 0, 1)
    with pytest.raises(ValueError, match="has 1 values"):
        lb.odefun(lambda t, y: [y[0]], 0, [1, 2])
