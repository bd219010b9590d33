"""Numbers in and out: exact texts, balls, and what they become elsewhere."""

import pickle
from decimal import Decimal
from fractions import Fraction
from importlib import metadata

import libration as lb
import mpmath
import numpy as np
import pytest
import sympy
from libration.texts import text_of


def test_ball_prints_its_proved_digits():
    root = lb.ball("sqrt(2)", 30)
    assert str(root) == "1.41421356237309504880168872421"
    assert root.proved and root.rigour == "proved"
    assert abs(root.fraction() - Fraction(14142135623730950488016887242096980786, 10**37)) < Fraction(1, 10**29)
    assert pickle.loads(pickle.dumps(root)) == root


def test_ball_becomes_what_it_is_asked_for_without_loss():
    root = lb.ball("sqrt(2)", 40)
    assert root.decimal() == Decimal(str(root))
    assert root.fraction() == Fraction(str(root))
    lower, upper = root.bounds()
    assert lower * lower < 2 < upper * upper
    mantissa, exponent, radius, radius_exponent = root.exact()
    middle, reach = Fraction(mantissa) * Fraction(2) ** exponent, Fraction(radius) * Fraction(2) ** radius_exponent
    assert (middle - reach) ** 2 < 2 < (middle + reach) ** 2
    with mpmath.workdps(15):  # the precision in force rounds nothing
        midpoint = root.mpmath()
    with mpmath.workdps(50):
        assert abs(midpoint - mpmath.sqrt(2)) < mpmath.mpf(10) ** -39
    assert mpmath.mpf(2) in root.mpi() ** 2


def test_float_is_the_nearest_or_refused():
    assert float(lb.ball("sqrt(2)", 30)) == 2**0.5  # IEEE 754 rounds a root correctly
    assert float(lb.ball("0")) == 0
    with pytest.raises(lb.UndecidedError):
        float(lb.ball("1/3", 5))
    lower, upper = lb.ball("1/3", 5).double_bounds()
    assert lower < 1 / 3 < upper


def test_a_ball_is_no_number_that_changes():
    third = lb.ball("1/3", 5)
    assert Fraction(1, 3) in third
    assert Fraction(1, 2) not in third
    with pytest.raises(AttributeError):
        third.digits = "0.5"
    with pytest.raises(lb.ArgumentError):
        lb.Ball("much")


def test_no_float_is_taken_for_a_number():
    with pytest.raises(TypeError, match="'0.1'"):
        lb.motion(energy=0.1)
    with pytest.raises(TypeError):
        lb.motion(energy=np.float64(0.1))
    with pytest.raises(TypeError):
        lb.motion(energy=True)
    assert str(lb.motion(energy=lb.exact(0.1)).energy(60)) == str(Decimal(0.1))


@pytest.mark.parametrize(
    "number",
    ["1/4", Fraction(1, 4), Decimal("0.25"), sympy.Rational(1, 4), mpmath.mpf(0.25), "0.25"],
)
def test_exact_numbers_of_other_kinds(number):
    assert str(lb.motion(energy=number).energy(10)) == "0.25"


def test_constants_of_sympy_and_numpy_integers():
    assert str(lb.ball(sympy.sqrt(2) * sympy.pi, 20)) == str(lb.ball("sqrt(2)*pi", 20))
    assert text_of(np.int64(-3)) == "-3"
    assert lb.exact(-0.75) == "-3*2^(-2)"
    with pytest.raises(ValueError):
        lb.exact(float("nan"))


def test_the_package_is_of_the_version_of_its_library():
    assert metadata.version("libration") == lb.__version__
