"""Equations against closed forms, and those of SymPy."""

import zlib
from fractions import Fraction

import libration as lb
import mpmath
import pytest
import sympy
from conftest import near


def tangent():
    return lb.problem("x' = a + x^2", x=0, a=1)


@pytest.mark.parametrize("text", ["dx/dt = a + x²", "x'(t) = a + x(t)^2", "x′ = a + x·x", "x' = a + x^2, x(0) = 1"])
def test_notation(text):
    assert near(lb.problem(text, x=0, a=1).reference(1, 40)["x"], mpmath.tan(1), 40)


@pytest.mark.parametrize("rigour", ["proved", "two-method"])
def test_tangent(rigour):
    assert near(tangent().reference(1, 40, rigour)["x"], mpmath.tan(1), 40)
    assert near(tangent().reference(["1/2", "1"], 40, rigour)["x"][0], mpmath.tan(0.5), 40)


def test_lorenz_as_in_the_manual():
    p = lb.problem("x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y-8/3*z", x=1, y=0, z=0)
    assert p.names == ["x", "y", "z"]
    state = p.reference(2, digits=25)
    # mpmath's odefun with 45 digits: tests/reference/c_examples.csv.
    assert str(state["x"]).startswith("-7.87608254999165761122475")
    assert str(state) == str(lb.problem("lorenz").reference(2, digits=25))
    assert str(lb.problem("lorenz", r=20, x=2).reference(1, 10)) != str(lb.problem("lorenz").reference(1, 10))


def test_coefficients_are_those_of_the_tangent():
    terms = tangent().coefficients(7, scalar="rational")
    assert terms["x"][7].fraction() == Fraction(17, 315)
    assert str(tangent().coefficients(3, scalar="mpfr:20")["x"][3]) == "0.33333333333333333333"
    assert tangent().coefficients(3, first=3)["x"][0].proved
    about = tangent().coefficients(1, scalar="mpfr:30", at="i")
    assert near(about["x_im"][0], mpmath.tanh(1), 30)
    with pytest.raises(lb.ArgumentError):
        tangent().coefficients(3, scalar="ball:20", at="i")


def test_unknowns_orbits_and_limits():
    speed = lb.problem("y'' = -y; y(0) = 0; y'(0) = 1").find("y'(0)", "y(pi/6) = 1", 20)
    assert str(speed["y'(0)"]) == "2.0000000000000000000" and speed["y'(0)"].proved
    assert str(lb.problem("blasius").find(["k"], ["f'(inf) = 1"], 20)["k"]) == "0.33205733621519629894"
    assert str(lb.problem("van_der_pol").orbit(12)["period"]).startswith("6.6632868593")
    assert str(lb.problem("sir").limits(12)["S"]) == "76.0563587703"
    with pytest.raises(lb.UndecidedError):
        lb.problem("y' = -y^2; y(0) = 1").limits(5)
    assert str(lb.problem("y' = cos(y) - y; y(0) = 1").limits(20)["y"]) == "0.73908513321516064166"


def test_a_branch_passes_its_turning_points():
    # x(1) = s^3/3 - s - k.
    cubic = lb.problem("x' = s^3/3 - 2*s - k; x(0) = s; s = -2; k = -2")
    branch = cubic.find("s", "x(1) = 0", 15, along="k = -2:2:3")
    turns = [row for row in branch if row["point"] == "turning point"]
    assert [str(row["k"]) for row in turns] == ["0.666666666666667", "-0.666666666666667"]
    assert [str(row["s"]) for row in turns] == ["-1.00000000000000", "1.00000000000000"]
    assert branch.names == ["point", "k", "s"] and branch.end.startswith("leaves the range at k = 2.")
    with pytest.raises(lb.ArgumentError, match="k = 0:1:11"):
        cubic.find("s", "x(1) = 0", along="k")
    with pytest.raises(ValueError, match="one solution"):
        cubic.find("s", "x(1) = 0", along="k = 0, 1", certificate="a.cert")


def test_radius_of_the_tangent():
    found = tangent().radius(order=100)
    assert not found.value.proved
    assert abs(found.value.mpmath() - mpmath.pi / 2) <= mpmath.mpf(found.value.uncertainty)
    lower, upper = tangent().radius_bounds(10)
    assert lower.mpmath() < mpmath.pi / 2 < upper.mpmath()
    assert upper.mpmath() - lower.mpmath() < mpmath.mpf(10) ** -9
    poles = tangent().singularities(within=2, digits=12, prove=True)
    assert poles.complete and len(poles) == 2 and poles[0]["kind"] == "pole of order 1" and poles[0]["position_re"].proved
    assert lb.problem("x' = x; x(0) = 1").radius_bounds()[0].digits == "inf"


def test_a_radius_without_an_uncertainty_has_none_in_its_text():
    assert repr(lb.problem("y' = y; y(0) = 1").radius(20)) == "inf (heuristic)"


def test_radius_of_a_list():
    found = lb.radius([Fraction(1, 2**n) for n in range(20)])
    assert abs(found.value.fraction() - 2) <= Fraction(found.value.uncertainty)


def test_sympy():
    t = sympy.Symbol("t")
    x = sympy.Function("x")
    g = sympy.Symbol("g")
    swing = lb.problem(sympy.Eq(x(t).diff(t, 2), -g * sympy.sin(x(t))), {"x'": 0}, x="pi/2", g=1)
    truth = lb.motion(theta0="90deg", omega0=0).theta(1, 30)
    assert swing.reference(1, 30)["x"] == truth or near(swing.reference(1, 30)["x"], truth.mpmath(), 29)
    s = sympy.Symbol("s")
    y = sympy.Function("y")
    grows = lb.problem([y(s).diff(s) - sympy.E * y(s) / sympy.E], y=1)
    assert near(grows.reference(1, 30)["y"], mpmath.e, 30)
    with pytest.raises(TypeError):
        lb.problem(sympy.Eq(x(t).diff(t), 0.1 * x(t)), x=1)
    with pytest.raises(ValueError):
        lb.problem(sympy.Eq(x(t).diff(t), sympy.gamma(x(t))), x=1)


def test_conditions_of_sympy():
    t = sympy.Symbol("t")
    x = sympy.Function("x")
    pieces = sympy.Piecewise((1, (t >= 1) & (t < 2)), (3, ~(t < 4) | (t < 0)), (0, True))
    # 1 from 1 to 2, and 3 from 4 on.
    assert near(lb.problem(sympy.Eq(x(t).diff(t), pieces), x=0).reference(5, 30)["x"], 4, 30)
    folded = sympy.Max(t, 2) + sympy.Abs(t - 1) + sympy.Mod(t, 2) + sympy.Heaviside(t - 1)
    # 13/2 + 5/2 + 5/2 + 2
    assert near(lb.problem(sympy.Eq(x(t).diff(t), folded), x=0).reference(3, 30)["x"], mpmath.mpf("13.5"), 30)


def test_an_unknown_with_the_name_of_a_column():
    decay = lb.problem("n' = -n", n=1)
    assert near(decay.reference(1, 30)["n_"], mpmath.exp(-1), 30)


def test_starts_elsewhere():
    grows = lb.problem("x' = x", x=1, at=1)
    assert near(grows.reference(2, 30)["x"], mpmath.e, 30)


def test_errors_say_where():
    with pytest.raises(lb.ArgumentError, match="line 1, column 3"):
        lb.problem("x'=; x(0)=1")
    with pytest.raises(lb.ArgumentError):
        lb.problem("lorentz")
    with pytest.raises(lb.UndecidedError, match="proved to exist up to 1.5707"):
        tangent().reference(2)
    assert "lorenz" in lb.catalogue()


def test_undecided_values_leave_the_others():
    # x = 1/(1 - t), y = tan t, w = -cos t, which is 0 at pi/2.
    p = lb.problem("x' = x^2; y' = 1 + y^2; w' = sin(t); v' = cos(t); x(0) = 1; y(0) = 0; w(0) = -1; v(0) = 0")
    with pytest.raises(lb.UndecidedError, match="is not reached") as raised:
        p.reference(["1/2", 1, "pi/2"], 30)
    known = raised.value.partial
    assert isinstance(known, lb.Table) and known.names == ["time", "x", "y", "w", "v"] and len(known) == 3
    assert near(known[0]["x"], mpmath.mpf(2), 29) and known[1]["x"] == "" and known[2]["y"] == ""
    assert near(known[1]["y"], mpmath.tan(1), 29) and near(known[2]["v"], mpmath.mpf(1), 29)
    zero = known[2]["w"]
    assert zero.digits == "0" and zero.proved and 0 < Fraction(zero.uncertainty) < Fraction(1, 10**30)
    exact = lb.problem("w'' = -w; w(0) = -1; w'(0) = 0").reference("pi/2", 30)["w"]
    assert exact.digits == "0" and exact.proved and Fraction(exact.uncertainty) == 0
    with pytest.raises(lb.UndecidedError) as raised:
        p.reference(1, 30)
    assert isinstance(raised.value.partial, lb.Row) and raised.value.partial["x"] == ""


@pytest.mark.parametrize(
    "text, keywords, near",
    [("van_der_pol", {"mu": 5}, "did you mean m?"), ("lorenz", {"rho": 30}, "did you mean r?"), ("y' = y; y(0) = 1", {"k": 2}, "")],
)
def test_keywords_that_the_text_has_no_use_for_are_refused(text, keywords, near):
    with pytest.raises(lb.ArgumentError, match="is not a parameter of this problem") as raised:
        lb.problem(text, **keywords)
    assert near in str(raised.value)


def test_keywords_may_use_each_other():
    p = lb.problem("y' = -a*y", y=1, a="b/2", b=3)
    assert near(p.reference(1, 40)["y"], mpmath.exp(mpmath.mpf(-3) / 2), 40)


def test_unused_parameters_are_warned_of():
    with pytest.warns(UserWarning, match="the parameter k is defined and used nowhere"):
        lb.problem("y' = y; y(0) = 1; k = 3")


def test_certificates(tmp_path):
    p = lb.problem("x' = a + x^2", x=0, a=1)
    file = tmp_path / "a.cert"
    state = p.reference("1/2", 15, certificate=file)
    assert state["x"] == p.reference("1/2", 15)["x"]
    assert "x(1/2) lies in [0.54630248984379" in lb.check(file)
    zero = p.events("x = 1", digits=12, certificate=str(file))
    assert near(zero["time"][0], mpmath.pi / 4, 12)
    assert "#1 lies in [0.785398163397" in lb.check(str(file))
    p.find("a", "x(1/2) = 1", 10, certificate=file)
    assert "x(1/2) = 1." in lb.check(file)
    lb.problem("van_der_pol").orbit(8, certificate=file)
    assert "x'(t) = x'(0)." in lb.check(file)
    p.events("x = 1", digits=12, certificate=str(file))
    changed = zlib.decompress(file.read_bytes()).replace(b"start 0", b"start 1/9")
    file.write_bytes(zlib.compress(changed))
    with pytest.raises(lb.UndecidedError, match="start or joint"):
        lb.check(file)
    file.write_bytes(b"text")
    with pytest.raises(lb.UndecidedError, match="is not a certificate"):
        lb.check(file)
    with pytest.raises(lb.ArgumentError, match="fractions"):
        p.reference("pi/4", 15, certificate=file)


def test_a_bouncing_ball():
    # It falls from 1 to 0 at t = 1, and leaves with the speed 1: x = s - s^2, s = t - 1, up to t = 2.
    ball = lb.problem("x'' = -2; x(0) = 1; x'(0) = 0; when x = 0 down: x' = -x'/2")
    assert ball.reference("3/2", 20)["x"].fraction() == Fraction(1, 4)
    assert [str(time) for time in ball.events("x = 0", count=2, digits=5)["time"]] == ["1.0000", "2.0000"]
    # From h it hits the ground at u = sqrt(h): x = u s - s^2, s = t - u.
    assert ball.derivatives("3/2", by="x(0)", digits=20)["dx(t)/dx(0)"][0].fraction() == Fraction(1, 4)
    floats = ball.trajectory([0.5, 1.25])["x"]
    assert abs(floats - [0.75, 0.1875]).max() < 1e-14
    with pytest.raises(lb.ArgumentError, match="is an event"):
        ball.trajectory([1], starts={"x": [1, 2]})


def test_all_solutions_of_a_set():
    # x = x0 e^(b t), which increases with x0 and b.
    growth = lb.problem("x' = b*x; x(0) = [0.9, 1.1]; b = [1, 2]")
    assert growth.names == ["x"]
    at, over = growth.enclosures([1, (0, "1/2")], digits=20)
    assert (over["from"].fraction(), over["to"].fraction()) == (0, Fraction(1, 2))
    for row, time in ((at, 1), (over, 0.5)):
        upper = mpmath.mpf(11) / 10 * mpmath.exp(2 * time)
        assert upper <= row["upper"].mpmath() < upper * 1.1
    lower = mpmath.mpf(9) / 10 * mpmath.e
    assert lower * 0.9 < at["lower"].mpmath() <= lower
    with pytest.raises(lb.ArgumentError, match="set of values"):
        growth.reference(1)
    # It is 2 at ln(2/x0)/b.
    event = {row["quantity"]: row for row in growth.enclosed_events("x = 2", digits=20)}
    assert event["time"]["lower"].mpmath() <= mpmath.log(mpmath.mpf(20) / 11) / 2
    assert event["time"]["upper"].mpmath() >= mpmath.log(mpmath.mpf(20) / 9)
    assert event["x"]["lower"].fraction() == 2
    with pytest.raises(lb.UndecidedError, match="is not") as caught:
        growth.enclosed_events("x = -2", parts=1)
    assert len(caught.value.partial.cells) == 0


def test_a_delay():
    delayed = lb.problem("x' = x(t - 1); x(t <= 0) = 1")
    assert delayed.reference(2, 20)["x"].fraction() == Fraction(7, 2)
    with pytest.raises(lb.ArgumentError, match="has delays"):
        delayed.radius()


def test_limits_at_infinity_determine_unknowns_as_in_the_command():
    # Blasius's layer [Boyd2008]; sqrt(2) sech(t); 1/(1 + exp(t/sqrt(2))).
    layer = lb.at_infinity("f''' + f*f'' = 0; f(0)=0; f'(0)=0; f'(inf)=1", digits=20)
    assert str(layer["f''(0)"]) == "0.46959998836101330451"
    assert str(layer.states([1, "inf"], digits=20).column("f'")[0]) == "0.46063257676899924547"
    guessed = lb.problem("f''' + f*f'' = 0; f(0)=0; f'(0)=0; f''(0)=1/2").find("f''(0)", "f'(inf) = 1", 20)
    assert str(guessed["f''(0)"]) == str(layer["f''(0)"])
    soliton = lb.at_infinity("y'' = y - y^3; y'(0) = 0; y(inf) = 0", "y(0) = 1.4", digits=20)
    assert list(soliton) == ["y(0)"]
    assert near(soliton.amplitudes["y"], mpmath.sqrt(8), 19)
    assert str(soliton.rates["rate 1"]) == "1.0000000000000000000"
    front = lb.at_infinity("u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(-inf) = 1; u(inf) = 0", digits=20)
    assert front.angle is not None
    assert str(front.angle).startswith("0.732302248989508")
    assert str(front.states(["0"], digits=20).column("u")[0]) == "0.50000000000000000000"
    with pytest.raises(lb.ArgumentError, match="no condition at infinity"):
        lb.at_infinity("y' = -y; y(0) = 1")


def test_eigenvalues_of_wells():
    found = lb.eigenvalues("psi'' = (x^2 - E)*psi; psi(-inf) = 0; psi(inf) = 0", count=3, digits=20)
    assert [str(each) for each in found] == ["1.0000000000000000000", "3.0000000000000000000", "5.0000000000000000000"]
    with pytest.raises(lb.UndecidedError):
        lb.eigenvalues("psi'' = (-6*sech(x)^2 - E)*psi; psi(-inf) = 0; psi(inf) = 0", count=3, digits=10)
