"""What notebooks and frames show: LaTeX of equations, times as numbers, progress, and the packages that are missing."""

import inspect
import sys

import libration as lb
import numpy as np
import pytest
from libration import progress
from libration.latex import latex_of

SPRING = "x'' = -k*x; x(0) = 1; x'(0) = 0; k = 1"


@pytest.mark.parametrize(
    ("statement", "latex"),
    [
        ("x' = -(a + b)*x/(1 + x^2)", r"x' = -\frac{\left(a + b\right) \, x}{1 + x^{2}}"),
        ("y'' = 2*sin(t)^2 - sqrt(y)", r"y'' = 2 \, \sin\left(t\right)^{2} - \sqrt{y}"),
        ("theta1' = omega_max*10^-3", r"\theta_{1}' = \omega_{max} \cdot 10^{-3}"),
        ("x'(0) = 1/3", r"x'\left(0\right) = \frac{1}{3}"),
        ("(x^2)^3 = a - (b - c)", r"\left(x^{2}\right)^{3} = a - \left(b - c\right)"),
        (
            "x' = 2*if(0 <= x < 1 and not y > 2, -x, 1)",
            r"x' = 2 \, \left(\begin{cases} -x & \text{if } 0 \le x < 1 \text{ and } \text{not } y > 2 \\ "
            r"1 & \text{otherwise} \end{cases}\right)",
        ),
        ("when y = 0 down: y' = -y'", r"\texttt{when y = 0 down: y' = -y'}"),
    ],
)
def test_latex_of_statements(statement, latex):
    assert latex_of(statement) == latex


def test_a_problem_shows_its_equations():
    spring = lb.problem(SPRING, k=2)
    assert spring.latex().count("&") == 5 and "k = 2" in spring.latex()
    assert r"\begin{aligned}" in spring._repr_latex_() and "&lt;" in lb.problem("x' = if(x < 1, 1, 0); x(0) = 0")._repr_html_()


def test_times_of_frames_are_numbers():
    spring = lb.problem(SPRING)
    frame = spring.reference(np.linspace(0, 1, 3), digits=20, exact=False).frame()
    assert frame["time"].tolist() == [0.0, 0.5, 1.0] and isinstance(frame["x"][1], lb.Ball)
    assert np.allclose(frame.astype(float)["x"], np.cos([0, 0.5, 1]), rtol=0, atol=1e-15)
    table = spring.reference(["1/4", "2"], digits=20)
    assert np.allclose(table.to_numpy("time", "x'"), [[0.25, -np.sin(0.25)], [2, -np.sin(2)]], rtol=0, atol=1e-15)
    assert table.frame(floats=True).dtypes.tolist() == [float] * 3


def test_verdicts_of_solve_ivp():
    spring = lb.problem(SPRING)
    found = lb.solve_ivp(lambda t, y: [y[1], -y[0]], [0, 2], [1, 0], t_eval=[0, 0.1, 2])
    judged = lb.verify(found, problem=spring, tolerance="1e-14")
    assert judged.ok and judged["time"] == ["0.0", "0.1", "2.0"]
    assert float.fromhex(judged["time_as_double"][1]) == 0.1
    assert max(float(error) for error in judged.frame()["x_error"]) < 1e-14
    with pytest.raises(ValueError, match="2 unknowns, and the problem has 1: x"):
        lb.verify(found, problem="x' = -x; x(0) = 1")


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ModuleNotFoundError, match="plot.. needs matplotlib: apt install python3-matplotlib"):
        lb.problem(SPRING).trajectory([0.0, 1.0]).plot()


def test_signatures_are_those_of_the_methods():
    assert list(inspect.signature(lb.Problem.reference).parameters) == [
        "self", "times", "digits", "rigour", "exact", "certificate"]  # fmt: skip


def test_long_calls_show_how_far_they_are(monkeypatch, capsys):
    monkeypatch.setattr(progress, "_seconds_before", 0.0)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    lb.show_progress(True)
    try:

        @progress.with_progress
        def work():
            progress.reached(0.25)

        work()
        assert "work: 25.0 % done" in capsys.readouterr().err

        @progress.with_progress
        def stopped():
            progress.reached(0.5)
            raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt, match="interrupted at stopped: 50.0 % done"):
            stopped()
    finally:
        lb.show_progress(None)
