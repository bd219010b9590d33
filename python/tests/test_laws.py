"""The law of all coefficients, against mpmath."""

import pickle

import libration as lb
import mpmath
import pytest
from conftest import near


def test_a_branch_point():  # (1 - 2t)^(-1/2)
    law = lb.problem("y' = y^3; y(0) = 1").law()
    n = 3000
    truth = mpmath.factorial(2 * n) / mpmath.factorial(n) ** 2 / mpmath.mpf(2) ** n
    assert near(law.coefficient(n, 25), truth, 25)
    assert law.coefficient(n, 25).rigour == "proved"
    assert near(law.ratio(n, 25), 2 - mpmath.mpf(1) / n, 25)
    assert law.rho > 0.5 and law.n0 >= 0 and law.stride == 1
    found = law.singularities
    assert near(found[0]["position_re"], mpmath.mpf(1) / 2, 29)
    assert found[0]["exponent"] == "-1/2"
    assert "these are all singularities" in str(law)
    again = pickle.loads(pickle.dumps(law))
    assert again.ratio(n, 10) == law.ratio(n, 10)


def test_poles_of_the_angular_velocity_are_logarithms_of_the_angle():
    law = lb.problem("y' = 1 + y^2; y(0) = 0").solution().law("y", within=2)
    n = 101  # tan: a_n = 2 (2/pi)^(n+1) (1 + 3^-(n+1) + ..), n odd
    truth = 2 * (2 / mpmath.pi) ** (n + 1) * (1 - mpmath.mpf(2) ** (-n - 1)) * mpmath.zeta(n + 1)
    assert law.stride == 2 and law.residue == 1
    assert near(law.coefficient(n, 20), truth, 20)


def test_refusals():
    with pytest.raises(lb.UndecidedError, match="entire"):
        lb.problem("y'' = -y; y(0) = 0; y'(0) = 1").law()
    with pytest.raises(lb.ArgumentError):
        lb.problem("y' = y^2; y(0) = 1").law("z")
