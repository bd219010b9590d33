"""What tests against mpmath share."""

import mpmath
import pytest


@pytest.fixture(autouse=True)
def precision():
    """More digits than a test requests; a module whose tests need others has a fixture of this name."""
    with mpmath.workdps(60):
        yield


def near(ball, truth, digits):
    """Whether a number is within one unit of its last digit."""
    return abs(ball.mpmath() - truth) <= abs(truth) * mpmath.mpf(10) ** (1 - digits)
