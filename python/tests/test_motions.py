"""Motions against closed forms by mpmath."""

import threading

import libration as lb
import mpmath
import numpy as np
import pytest

DIGITS = 40


@pytest.fixture(autouse=True)
def precision():
    with mpmath.workdps(80):
        yield


def near(ball, truth, digits=DIGITS):
    return abs(ball.mpmath() - truth) <= abs(truth) * mpmath.mpf(10) ** (1 - digits)


@pytest.mark.parametrize("rigour", ["proved", "two-method"])
def test_period_from_90_degrees(rigour):
    swing = lb.motion(theta0="90deg", omega0=0)
    period = swing.period(DIGITS, rigour)
    assert near(period, mpmath.gamma(0.25) ** 2 / mpmath.sqrt(mpmath.pi))
    assert period.rigour == rigour
    assert swing.regime == "libration"


def test_theta_by_jacobi():
    swing = lb.motion(theta0="150deg", omega0=0)
    k = mpmath.sin(mpmath.pi * 5 / 12)
    time = mpmath.mpf(10) ** 12
    phase = time - 4 * mpmath.ellipk(k**2) * mpmath.floor(time / (4 * mpmath.ellipk(k**2)))
    truth = 2 * mpmath.asin(k * mpmath.ellipfun("cd")(phase, m=k**2))
    assert near(swing.theta("1e12", DIGITS), truth)
    assert str(swing.theta("T/4")) == "0"
    assert near(swing.omega("T/4", DIGITS), -2 * k)


def test_reference_at_one_time_and_at_several():
    swing = lb.motion(theta0="90deg", omega0=0)
    row = swing.reference("T/4", 20)
    assert set(row) == {"time", "theta", "omega"}
    table = swing.reference(["0", "T/4"], 20)
    assert [str(cell) for cell in table["theta"]] == ["1.5707963267948966192", "0"]
    assert table.frame().shape == (2, 3)


def test_radius_and_coefficients():
    swing = lb.motion(energy=1)
    assert near(swing.radius(digits=DIGITS), mpmath.gamma(0.25) ** 2 / (2 * mpmath.sqrt(2 * mpmath.pi)))
    terms = swing.coefficients(6, scalar="ball:20")
    assert [str(c) for c in terms["coefficient"][1:]] == [
        "0", "-0.50000000000000000000", "0", "0", "0", "0.0041666666666666666667"]  # fmt: skip
    with pytest.raises(ValueError, match="mpfr:50"):
        swing.coefficients(6, scalar="double")


def test_the_separatrix_is_decided_exactly():
    assert lb.motion(theta0="120deg", omega0=1).regime == "separatrix"
    assert lb.motion(gap="1e-30").regime == "libration"
    assert str(lb.motion(theta0="120deg", omega0=1).period()) == "inf"


def test_sampler_keeps_four_units_in_the_last_place():
    swing = lb.motion(theta0="150deg", omega0=0)
    times = np.array([[0.0, 0.5, -3.25], [1e3, 12345.0, 1e9]])
    samples = swing(times)
    assert samples.theta.shape == times.shape
    for time, theta, omega in zip(times.flat, samples.theta.flat, samples.omega.flat):
        state = swing.reference(lb.exact(time), 25)
        assert abs(theta - state["theta"].mpmath()) <= 4 * 2.0**-52 * 2  # |theta| < 4
        assert abs(omega - state["omega"].mpmath()) <= 4 * 2.0**-52  # omega is below 2
    with pytest.raises(lb.ArgumentError):
        swing(np.array([np.nan]))


def test_threads_get_the_digits_that_they_get_alone():
    swing = lb.motion(theta0="2.5", omega0="-0.3")
    alone = {digits: swing.theta("1e6", digits) for digits in (15, 60, 200)}
    found = {}
    threads = [threading.Thread(target=lambda d=d: found.update({d: swing.theta("1e6", d)})) for d in alone]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == alone


def test_errors_name_what_is_wrong():
    with pytest.raises(lb.ArgumentError) as raised:
        lb.motion(energy="-1")
    assert (raised.value.subject, raised.value.value, raised.value.reason) == ("energy", "-1", "is negative")
    assert isinstance(raised.value, ValueError)
    with pytest.raises(lb.ArgumentError, match="is not reached"):
        lb.motion(theta0=3, energy="1/2")
    with pytest.raises(ValueError):
        lb.motion(energy=1).theta(1, rigour="sure")


def test_undefined_and_unable_are_kept_apart():
    with pytest.raises(lb.UndefinedError) as undefined:
        lb.motion(energy="-1")
    with pytest.raises(lb.UnableError) as unable:
        lb.problem("x' = 1 + x^2; x(0) = 0").reference(2, digits=5)
    assert not isinstance(undefined.value, lb.UnableError)
    assert not isinstance(unable.value, lb.UndefinedError)
    assert issubclass(lb.RangeError, lb.UndefinedError)
