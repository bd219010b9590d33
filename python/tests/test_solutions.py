"""One solution for several questions, against closed forms."""

import pickle
import threading

import libration as lb
import mpmath
import pytest
from conftest import near


def test_a_solution_is_integrated_once():
    s = lb.problem("x' = 1 + x^2; x(0) = 0").solution()
    assert s.steps == 0
    first = s.states(["1/2", "1"], 40)
    assert near(first[1]["x"], mpmath.tan(1), 40)
    steps = s.steps
    assert steps > 0
    again = s.states(["1/4", "1"], 40)
    assert near(again[0]["x"], mpmath.tan(mpmath.mpf(1) / 4), 40)
    assert again[1]["x"] == first[1]["x"]
    assert near(s.states("1/2", 20)["x"], mpmath.tan(mpmath.mpf(1) / 2), 20)
    assert near(s.events("x = 1/2", digits=40)[0]["time"], mpmath.atan(mpmath.mpf(1) / 2), 40)
    assert s.steps == steps
    assert near(s.states("3/2", 40)["x"], mpmath.tan(mpmath.mpf(3) / 2), 40)
    assert s.steps > steps


def test_the_answers_are_those_of_the_problem(tmp_path):
    p = lb.problem("x'' = -x^3; x(0) = 1; x'(0) = 0")
    s = p.solution()
    assert s.problem is p and s.names == ["x", "x'"]
    assert s.states([1, 2], 30).cells == p.reference([1, 2], 30).cells
    assert s.events("x = 0", 2, 30).cells == p.events("x = 0", 2, 30).cells
    assert s.coefficients(6, "ball:20", at=1).cells == p.coefficients(6, "ball:20", at=1).cells
    assert s.coefficients(4, "rational").cells == p.coefficients(4, "rational").cells
    assert str(s.radius(80, 10)) == str(p.radius(80, 10))
    assert [str(each) for each in s.radius_bounds(3)] == [str(each) for each in p.radius_bounds(3)]
    path = tmp_path / "s.cert"
    s.states([1, 2], 12)
    steps = s.steps
    assert s.certificate(path, times=[1, 2], digits=12)[0]["x"] == p.reference(1, 12)["x"]
    assert s.steps == steps
    lb.check(path)
    s.certificate(path, condition="x = 0", digits=12)
    lb.check(path)
    with pytest.raises(ValueError, match="either times or a condition"):
        s.certificate(path)


def test_events_in_one_direction_and_before_a_time():
    s = lb.problem("x'' = -x; x(0) = 0; x'(0) = 1").solution()
    assert near(s.events("x = 0", digits=20, crossing="up")[0]["time"], 2 * mpmath.pi, 20)
    assert s.events("x = 0", digits=20, from_start=True)[0]["time"].mpmath() == 0
    with pytest.raises(lb.UndecidedError) as undecided:
        s.events("x = 0", 3, 20, before=7)
    assert len(undecided.value.partial) == 2
    assert near(s.events("x = 0", digits=20, before=-4)[0]["time"], -mpmath.pi, 20)
    with pytest.raises(lb.ArgumentError):
        s.events("x = 0", crossing="left")
    with pytest.raises(lb.UndecidedError):
        s.events("x = 3/2", horizon=3)


def test_errors_and_what_is_proved_all_the_same():
    s = lb.problem("x' = x^2; x(0) = 1").solution()
    with pytest.raises(lb.UndecidedError) as undecided:
        s.states(["1/2", 2], 20)
    assert near(undecided.value.partial[0]["x"], 2, 20)
    assert near(s.states("1/2", 20)["x"], 2, 20)
    with pytest.raises(lb.ArgumentError):
        s.events("x = 2", 0)


def test_a_solution_of_a_bouncing_ball_keeps_no_steps():
    s = lb.problem("x'' = -2; x(0) = 1; x'(0) = 0; when x = 0 down: x' = -x'/2").solution()
    assert near(s.states("3/2", 20)["x"], mpmath.mpf(1) / 4, 20)
    assert s.steps == 0


def test_copies_and_threads():
    s = lb.problem("x' = 1 + x^2; x(0) = 0").solution()
    assert near(pickle.loads(pickle.dumps(s)).states(1, 20)["x"], mpmath.tan(1), 20)
    found = []
    threads = [threading.Thread(target=lambda: found.append(s.states(1, 20)["x"])) for _ in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert len(found) == 4 and all(near(each, mpmath.tan(1), 20) for each in found)
