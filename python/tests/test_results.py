"""Derivatives, events, arrays from many starts, coefficients as data, figures and tables, references for SciML."""

import json
import math
import threading
from fractions import Fraction

import libration as lb
import mpmath
import numpy as np
import pytest
from conftest import near
from libration import scimlref

SPRING = "x'' = -k*x; x(0) = 1; x'(0) = 0; k = 1"
# Some hundred operations per step, a few steps, and the condition of the problems here, which is below 10.
CLOSE = 1e4 * np.finfo(float).eps


def test_derivatives_of_a_spring():
    found = lb.problem(SPRING).derivatives(["1", "2"], by="x(0), x'(0), k", digits=30)
    assert found.names[:6] == ["time", "x", "x'", "dx(t)/dx(0)", "dx(t)/dx'(0)", "dx(t)/dk"]
    assert found.matrix.shape == (2, 2, 3)
    for i, t in enumerate((1, 2)):
        truth = [[mpmath.cos(t), mpmath.sin(t), -t * mpmath.sin(t) / 2],
                 [-mpmath.sin(t), mpmath.cos(t), -(mpmath.sin(t) + t * mpmath.cos(t)) / 2]]  # fmt: skip
        for j in range(2):
            for k in range(3):
                assert found.matrix[i, j, k].proved and near(found.matrix[i, j, k], truth[j][k], 30)
    assert abs(found.floats()[0, 0, 0] - np.cos(1)) < CLOSE


def test_derivatives_that_are_not_known():
    p = lb.problem("y' = y^2; y(0) = 1")
    with pytest.raises(lb.UndecidedError) as caught:
        p.derivatives(["1/2", "2"], by=["y(0)"], digits=10)
    assert isinstance(caught.value.partial, lb.Derivatives)
    assert str(caught.value.partial.matrix[0, 0, 0]) == "4.000000000"
    assert caught.value.partial.matrix[1, 0, 0] == "" and np.isnan(caught.value.partial.floats()[1, 0, 0])
    with pytest.raises(lb.ArgumentError, match="neither a parameter nor an initial value"):
        p.derivatives(1, by="z")


def test_conditions_are_those_of_the_derivatives():
    # y = c e^(-kt): |dy/dc c| + |dy/dk k| + |t y'| = y (1 + 2 k t), relative to 1 where y is smaller.
    found = lb.problem("y' = -k*y; y(0) = 10; k = 1/2").conditions(["2", "4"])
    assert [float(str(each)) for each in found["condition"]] == pytest.approx([3, 5], rel=1e-2)


def test_events_are_times():
    found = lb.problem(SPRING).events("x = 0", count=2, digits=30)
    assert near(found["time"][1], 3 * mpmath.pi / 2, 30) and found["time"][0].proved
    with pytest.raises(lb.UndecidedError) as caught:
        lb.problem("x' = 1 + x^2; x(0) = 0").events("x = 1", count=2, digits=20)
    assert near(caught.value.partial["time"][0], mpmath.pi / 4, 20)


def test_a_number_of_an_event_that_is_0_has_a_bound():
    # x = t - 1 and u = tan(t - 1).
    with pytest.raises(lb.UndecidedError, match="value of u") as caught:
        lb.problem("x' = 1; u' = 1 + u^2; x(0) = -1; u(0) = -tan(1)").events("x = 0", digits=20)
    event = caught.value.partial[0]
    assert str(event["time"]) == "1.0000000000000000000" and event["x"].uncertainty == "0"
    assert str(event["u"]) == "0" and 0 < mpmath.mpf(event["u"].uncertainty) < mpmath.mpf(10) ** -60


def test_trajectory_of_the_problem_itself():
    times = np.linspace(-5, 5, 101)
    found = lb.problem(SPRING).trajectory(times)
    assert found.values.shape == (101, 2) and found.rigour == "heuristic"
    assert np.allclose(found["x"], np.cos(times), rtol=0, atol=CLOSE)
    assert np.allclose(found["x'"], -np.sin(times), rtol=0, atol=CLOSE)
    assert list(found.frame()) == ["time", "x", "x'"]
    # From a singular initial point: Lane and Emden, n = 1, y = sin t/t.
    emden = lb.problem("lane_emden", n=1).trajectory([0.0, 2.0])
    assert np.allclose(emden["y"], [1, np.sin(2) / 2], rtol=CLOSE)


@pytest.mark.parametrize("threads", [1, 3])
def test_trajectories_from_many_starts(threads):
    p = lb.problem("x' = -y; y' = x; x(0) = 1; y(0) = 0")
    angles = np.linspace(0, 6, 50)
    times = np.array([2.0, 0.0, 1.0, -1.0])
    by_name = p.trajectory(times, starts={"x": np.cos(angles), "y": np.sin(angles)}, threads=threads)
    assert by_name["x"].shape == (50, 4)
    assert np.allclose(by_name["x"], np.cos(angles[:, None] + times), rtol=0, atol=CLOSE)
    rows = p.trajectory(times, starts=np.stack([np.cos(angles), np.sin(angles)], axis=1), threads=threads)
    assert np.array_equal(rows.values, by_name.values)
    assert np.array_equal(p.trajectory([1.0], starts={"y": [0.5]}).values, p.trajectory([1.0], [[1, 0.5]]).values)
    later = p.trajectory([3.0], starts=[[1, 0]], begin=2)
    assert np.allclose(later["x"], np.cos(1), rtol=CLOSE)
    assert len(by_name.frame()) == 200


@pytest.mark.parametrize("threads", [1, 3])
def test_trajectories_with_many_parameters(threads):
    p = lb.problem("x'' = -w^2*x; x(0) = 1/w; x'(0) = 0; w = 1")
    w = np.linspace(1, 3, 300)
    times = np.array([2.0, 0.0, -1.0])
    found = p.trajectory(times, parameters={"w": w}, threads=threads)
    assert found["x"].shape == (300, 3)
    assert np.allclose(found["x"], np.cos(w[:, None] * times) / w[:, None], rtol=0, atol=CLOSE)
    together = p.trajectory(times, starts={"x'": w**2}, parameters={"w": w}, threads=threads)
    expected = (np.cos(w[:, None] * times) + w[:, None] ** 2 * np.sin(w[:, None] * times)) / w[:, None]
    assert np.allclose(together["x"], expected, rtol=0, atol=10 * CLOSE)
    later = p.trajectory([3.0], starts=[[1, 0]], begin=2, parameters={"w": w}, threads=threads)
    assert np.allclose(later["x"][:, 0], np.cos(w), rtol=0, atol=CLOSE)
    rows = p.trajectory([3.0], starts=np.stack([w, 0 * w], axis=1), parameters={"w": 2.0}, threads=threads)
    assert np.allclose(rows["x"][:, 0], w * np.cos(6), rtol=0, atol=10 * CLOSE)
    with pytest.raises(ValueError, match="all starts"):
        p.trajectory([3.0], starts={"x": [1.0]}, begin=2, parameters={"w": w})
    with pytest.raises(lb.ArgumentError, match="neither a parameter"):
        p.trajectory([3.0], parameters={"v": w})


def test_trajectories_that_end():
    found = lb.problem("y' = y^2; y(0) = 1").trajectory([0.5, 0.9, 3.0], starts={"y": [1.0, 0.25]})
    assert np.isnan(found["y"]).tolist() == [[False, False, True], [False, False, False]]
    assert np.allclose(found["y"][1], 1 / (4 - np.array([0.5, 0.9, 3.0])), rtol=CLOSE)
    for starts in ({"z": [1.0]}, [1.0]):
        with pytest.raises(ValueError):
            lb.problem("y' = y^2; y(0) = 1").trajectory([1.0], starts=starts)
    with pytest.raises(lb.ArgumentError, match="singular initial point"):
        lb.problem("lane_emden", n=1).trajectory([1.0], starts={"y": [1.0, 2.0]})
    with pytest.raises(lb.ArgumentError, match="finite"):
        lb.problem("y' = y^2; y(0) = 1").trajectory([np.nan])


def test_trajectories_leave_the_interpreter_free():
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    lb.problem("lorenz").trajectory(np.linspace(0, 20, 5), starts={"x": np.linspace(1, 2, 10)}, threads=1)
    done.set()
    thread.join()
    assert counted[0] > 100


def test_floats_are_data_on_request():
    p = lb.problem("y' = a*y", y=0.5, a=0.1, exact=False)
    with pytest.raises(TypeError):
        lb.problem("y' = a*y", y=0.5, a=0.1)
    assert near(p.reference(0.25, 30, exact=False)["y"], mpmath.exp(mpmath.mpf(0.1) / 4) / 2, 30)


def test_radius_of_an_array_and_of_files(tmp_path):
    a = 1 / 1.5 ** np.arange(60) / (1 + np.arange(60.0))
    found = lb.radius(a)
    assert abs(float(found.value.digits) - 1.5) <= float(found.value.uncertainty)
    # The uncertainty comes from the coefficients as they are known, so that it is not below the precision of doubles.
    assert float(found.value.uncertainty) > 1e-16
    np.save(tmp_path / "a.npy", a)
    assert str(lb.radius(tmp_path / "a.npy")) == str(found)
    lines = "\n".join(f"{n},{2.0 ** -n!r}" for n in range(40))
    (tmp_path / "a.csv").write_text("n,a  # of 1/(1 - x/2)\n" + lines)
    geometric = lb.radius(str(tmp_path / "a.csv"))
    assert abs(float(geometric.value.digits) - 2) <= float(geometric.value.uncertainty)
    with pytest.raises(ValueError, match="shape"):
        lb.radius(np.zeros((2, 2)))
    with pytest.raises(ValueError, match="nan"):
        lb.radius(np.array([1, np.nan]))


def test_figures_and_tables():
    import matplotlib

    matplotlib.use("Agg")
    p = lb.problem(SPRING)
    table = p.reference(["0", "1", "2"], 10)
    assert len(table.plot().lines) == 2
    assert table.plot(x="x", y="x'").get_xlabel() == "x"
    assert len(p.trajectory(np.linspace(0, 1, 5), starts={"x": [1.0, 2.0]}).plot(y="x").lines) == 2
    assert len(p.trajectory(np.linspace(0, 1, 5)).plot(x="x", y="x'").lines) == 1
    assert len(lb.solve_ivp(lambda t, y: [y[1], -y[0]], [0, 1], [1, 0]).plot().lines) == 2
    tangent = lb.problem("x' = 1 + x^2; x(0) = 0")
    assert tangent.radius(order=60).plot().get_xlabel() == "radius of convergence"
    assert tangent.singularities(within=2).plot().get_ylabel() == "position_im"
    roots = lb.radius([Fraction(math.comb(2 * n, n)) for n in range(30)])  # (1 - 4 x)^(-1/2)
    assert all(abs(each["position"] - 0.25) < 1e-3 for each in roots.fits[:5])
    assert roots.history[-1]["order"] <= 29 and abs(roots.history[-1]["radius"] - 0.25) <= roots.history[-1]["uncertainty"]
    for what, x in (("history", "order"), ("fits", "position"), ("predictions", "order")):
        assert roots.plot(what=what).get_xlabel() == x
    with pytest.raises(ValueError, match="history"):
        roots.plot(what="verdict")
    for result in (table, table[0], p.trajectory([0.0, 1.0]), tangent.radius(order=60), tangent.singularities(within=2)):
        shown = result._repr_html_()
        assert shown.startswith("<table>") and shown.count("<tr>") > 1
    assert "<td>omega</td>" in lb.problem("x' = 1; x(0) = omega; omega = 1").find("omega", "x(1) = 3")._repr_html_()
    assert "&lt;b&gt;" in lb.Table(["<b>"], [["1"]])._repr_html_()
    assert lb.solve_ivp(lambda t, y: y, [0, 1], [1])._repr_html_().count("<tr>") > 1


def test_tables_of_the_command():
    found = lb.table("sn,cd", u="1.5", m="0.3", digits=20)
    assert found["function"] == ["sn", "cd"] and found["rigour"] == ["proved", "proved"]
    assert found["value"][0] == mpmath.nstr(mpmath.ellipfun("sn", 1.5, mpmath.mpf("0.3")), 20)
    assert len(lb.table(problem="x' = -x; x(0) = 1", times="1,2", digits=10).plot(y="x").lines) == 1
    with pytest.raises(lb.ArgumentError, match="--problem"):
        lb.table(problem="no_such_problem", times="1")


def test_words_of_rigour():
    assert lb.ball("sqrt(2)").rigour == "proved"
    assert lb.problem(SPRING).reference(1, 10, "two-method")["x"].rigour == "two-method"
    assert lb.problem(SPRING).reference(1, 10, "rounded")["x"].rigour == "two-method"
    assert lb.Ball("1", "0", "rounded") == lb.Ball("1", "0", "two-method")
    assert lb.problem("x' = 1 + x^2; x(0) = 0").radius(order=60).value.rigour == "heuristic"


def test_references_for_sciml(tmp_path):
    p = lb.problem(SPRING)
    path = scimlref.write(tmp_path / "spring.json", p, ["1/2", "1"], digits=20)
    read = json.loads(path.read_text())
    assert read["names"] == ["x", "x'"] and read["t"] == ["0.5", "1"] and read["rigour"] == "proved"
    assert read["u"][1][0] == "0.54030230586813971740"  # cos 1
    assert all(float(each) < 1e-19 for row in read["u_uncertainty"] for each in row)
    text = scimlref.write(tmp_path / "spring.jl", p, [0, 1]).read_text()
    assert "t = [0.0, 1.0]" in text and "test_sol = TestSolution(t, u)" in text
    assert "u = [\n    [1.0000000000000000000, 0.0],\n    [0.54030230586813971740, -0.84147098480789650665]]" in text
    assert 'big"0.5403023058' in scimlref.Reference(p, [1], 30).julia(big=True)
    with pytest.raises(ValueError, match=".jl"):
        scimlref.write(tmp_path / "spring.txt", p, [1])
