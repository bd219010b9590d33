"""Values of others against proved ones, and studies of the program."""

from decimal import Decimal

import libration as lb
import numpy as np
import pandas
import pytest


def tangent():
    return lb.problem("x' = 1 + x^2; x(0) = 0")


def test_doubles_of_a_frame():
    times = np.array([0.0, 0.25, 0.5, 1.0])
    frame = pandas.DataFrame({"time": times, "x": np.tan(times)})
    assert lb.verify(frame, problem=tangent(), ulp=2).ok
    frame.loc[2, "x"] += 1e-6
    judged = lb.verify(frame, problem=tangent(), ulp=2)
    assert judged.misses == 1 and judged["verdict"][2] == "miss"
    assert abs(float(judged["x_error"][2].decimal()) - 1e-6) < 1e-8


def test_texts_of_a_file(tmp_path):
    path = tmp_path / "theirs.csv"
    path.write_text("time,theta,omega\n0,1.5707963,0\nT/4,0.0,-1.4142136\nT/4,0.1000000,-1.4142136\n")
    judged = lb.verify(path, motion=lb.motion(theta0="90deg", omega0=0))
    assert judged["verdict"] == ["ok", "ok", "miss"]
    assert str(judged["omega_reference"][1]).startswith("-1.41421356237")
    assert not judged.ok and "2 miss" not in repr(judged)


def test_the_sampler_keeps_its_promise():
    swing = lb.motion(theta0="150deg", omega0=0)
    times = np.linspace(0, 100, 50)
    samples = swing(times)
    judged = lb.verify({"time": times, "theta": samples.theta, "omega": samples.omega}, motion=swing, tolerance="1e-14")
    assert judged.ok
    assert not lb.verify({"t": times, "theta": samples.theta + 1e-9}, motion=swing, tolerance="1e-14").ok


def test_whole_turns_may_not_count():
    spin = lb.motion(theta0=0, omega0=3)
    turned = float(spin.theta(10)) - 6 * np.pi
    assert not lb.verify({"time": ["10"], "theta": [turned]}, motion=spin, tolerance="1e-12").ok
    assert lb.verify({"time": ["10"], "theta": [turned]}, motion=spin, tolerance="1e-12", modulo_2pi=True).ok


def test_what_is_asked_wrongly():
    with pytest.raises(ValueError, match="a motion or a problem"):
        lb.verify({"time": ["1"], "x": ["1"]})
    with pytest.raises(ValueError, match="no column time"):
        lb.verify({"x": ["1"]}, problem=tangent())
    with pytest.raises(lb.ArgumentError):
        lb.verify({"time": ["1"], "x": ["much"]}, problem=tangent())
    with pytest.raises(TypeError, match="by motion()"):
        lb.verify({"time": ["1"], "theta": ["1"]}, motion="90deg")
    with pytest.raises(TypeError):
        lb.verify({"time": ["1"], "x": ["1"]}, problem=tangent(), tolerance=1e-3)


def test_a_study_is_a_frame_with_all_its_digits(tmp_path):
    made = lb.study("error_norm", out=tmp_path, energies="0.5:8:3", orders=[5, 10], scalar="ball:20")
    frame = made.frame()
    assert set(frame["method"]) == {"series", "resummed"}
    assert all(isinstance(norm, Decimal) for norm in frame["norm"])
    assert len(frame) == 12
    # The series of order 10 is better than that of order 5.
    of = {(row["energy"], row["order"], row["method"]): row["norm"] for _, row in frame.iterrows()}
    assert all(of[e, Decimal(10), "series"] < of[e, Decimal(5), "series"] for e in set(frame["energy"]))
    assert "radians" in made.columns["norm"]
    import matplotlib

    matplotlib.use("Agg")
    axes = made.plot()
    assert axes.get_xlabel() == "order" and axes.get_ylabel() == "norm" and len(axes.lines) == 6
    with pytest.raises(lb.ArgumentError, match="energies"):
        lb.study("error_norm", energies="much")


def test_a_problem_may_be_a_text():
    # x = tan t
    assert lb.verify({"time": ["1"], "x": ["1.5574077"]}, problem="x' = 1 + x^2; x(0) = 0", tolerance="1e-6").ok


def test_printed_tables_are_rounded():
    table = {"time": ["1"], "x": ["1.557407"]}
    assert lb.verify(table, problem=tangent()).ok
    assert not lb.verify(table, problem=tangent(), rounding=True).ok
