"""Arithmetic, comparisons and formats of Balls, against fractions and mpmath."""

import math
from decimal import Decimal
from fractions import Fraction

import libration as lb
import mpmath
import numpy as np
import pytest

ROOT = lb.ball("sqrt(2)", 30)
THIRD = lb.ball("1/3", 20)


def test_results_contain_the_exact_numbers():
    for exact, found in [
        (Fraction(2, 3), THIRD + THIRD),
        (Fraction(0), THIRD - THIRD),
        (Fraction(1, 9), THIRD * THIRD),
        (Fraction(3), 1 / THIRD),
        (Fraction(1, 3) - Fraction(0.1), THIRD - 0.1),
        (Fraction(-1, 6), THIRD - Fraction(1, 2)),
        (Fraction(7, 3), Decimal(2) + THIRD),
        (Fraction(1, 27), THIRD**3),
        (Fraction(9), THIRD**-2),
        (Fraction(1, 3), abs(-THIRD)),
    ]:
        assert exact in found and found.proved
        assert abs(found.fraction() - exact) <= Fraction(found.uncertainty)
    lower, upper = (ROOT * ROOT).bounds()
    assert lower < 2 < upper and upper - lower < Fraction(1, 10**28)


def test_powers_that_are_not_whole_contain_the_exact_numbers():
    with mpmath.workdps(60):
        root = mpmath.sqrt(2)
        for exact, found in [
            (mpmath.root(2, 4), ROOT**0.5),
            (mpmath.power(2, mpmath.mpf(-1) / 6), ROOT ** Fraction(-1, 3)),
            (mpmath.power(2, root), 2**ROOT),
            (mpmath.power(root, root), ROOT**ROOT),
            (mpmath.power(3, mpmath.mpf(-1) / 3), THIRD**THIRD),
        ]:
            assert exact in found and found.proved
            assert Fraction(found.uncertainty) < Fraction(1, 10**18)
    assert lb.Ball("4") ** 0.5 == 2
    wide = lb.Ball("1", "0.5") ** lb.Ball("0", "1")  # from 0.5^1 = 1.5^-1 - 1/6 to 0.5^-1
    assert Fraction(1, 2) in wide and 2 in wide
    for base in (-ROOT, ROOT - ROOT):
        with pytest.raises(ValueError, match="of a positive number"):
            base**0.5


def test_arithmetic_with_infinity_is_refused():
    for operation in (lambda: ROOT * math.inf, lambda: math.inf - ROOT, lambda: ROOT**math.inf):
        with pytest.raises(ValueError, match="inf is not a finite number"):
            operation()


def test_digits_are_right_to_one_unit_and_bounds_do_not_grow_by_printing():
    total = lb.Ball("0")
    for _ in range(1000):
        total = total + THIRD
    assert Fraction(1000, 3) in total
    assert str(total).startswith("333.3333333333333") and Fraction(total.uncertainty) < Fraction(1, 10**16)
    unit = Fraction(10) ** Decimal(str(total)).as_tuple().exponent
    assert abs(total.fraction() - Fraction(1000, 3)) <= unit


def test_exact_numbers_stay_exact_and_equal_others():
    half = lb.Ball("0.5")
    assert str(half / 3) == "1/6" and (half * 3).uncertainty == "0"
    assert half == 0.5 == Fraction(1, 2) and half == lb.Ball("0.50") and hash(half) == hash(Fraction(1, 2))
    assert ROOT != 1.414 and len({half, lb.Ball("0.50"), ROOT}) == 2


def test_the_rigour_is_that_of_the_least_certain_operand():
    guess = lb.Ball("0.25", "1e-3", "heuristic")
    assert (guess + THIRD).rigour == "heuristic" and (THIRD + 1).rigour == "proved"
    with pytest.raises(lb.UndecidedError, match="no bound"):
        lb.Ball("0.25", "", "heuristic") + 1


def test_comparisons_are_decided_by_bounds_or_refused():
    assert ROOT < 1.5 and ROOT > Fraction(7, 5) and 1 < ROOT <= mpmath.mpf(2) and ROOT >= THIRD
    assert sorted([ROOT, THIRD, lb.Ball("1")]) == [THIRD, lb.Ball("1"), ROOT]
    assert lb.Ball("inf") > ROOT and ROOT < math.inf
    with pytest.raises(lb.UndecidedError, match="not decided"):
        assert THIRD < lb.ball("1/3", 30)
    with pytest.raises(lb.UndecidedError):
        bool(THIRD - THIRD)
    with pytest.raises(TypeError):
        assert ROOT < "2"


def test_integers_and_roundings():
    assert int(ROOT) == 1 and int(-ROOT) == -1 and round(10 * ROOT) == 14
    assert math.floor(-ROOT) == -2 and math.ceil(ROOT) == 2
    assert str(round(ROOT, 5)) == "1.41421" and Fraction(round(ROOT, 5).uncertainty) < Fraction(5, 10**6)
    with pytest.raises(lb.UndecidedError):
        int(THIRD * 3)


def test_formats_print_certain_digits_only():
    assert f"{ROOT:.10f}" == "1.4142135624" and f"{ROOT:.3e}" == "1.414e+0" and f"{ROOT:8.2f}" == "    1.41"
    assert f"{ROOT:>40}".strip() == str(ROOT) and f"{lb.Ball('1/3'):.4f}" == "0.3333"
    with pytest.raises(ValueError, match="fewer certain digits"):
        format(THIRD, ".30f")


def test_other_packages_take_balls():
    with mpmath.workdps(40):
        number = mpmath.mpf(ROOT)
        assert abs(number - mpmath.sqrt(2)) < mpmath.mpf(10) ** -28
    assert np.array([ROOT, THIRD], dtype=float).tolist() == [2**0.5, 1 / 3]
    sums = np.array([1.0, 2.0]) + ROOT
    assert isinstance(sums[1], lb.Ball) and sums[1] > 3.4142
    assert isinstance(np.float64(1) + ROOT, lb.Ball)
    assert float(lb.Ball("0", "", "heuristic")) == 0.0
