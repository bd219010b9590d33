"""libration.solve_ivp on examples of SciPy's documentation and on its interface, against closed forms and proved values."""

import math

import libration as lb
import numpy as np
import pytest

# Double precision: some hundred operations per step, a few steps, and the condition of the examples, which is below 10.
CLOSE = 1e4 * np.finfo(float).eps


def exponential_decay(t, y):
    return -0.5 * y


def test_exponential_decay():
    sol = lb.solve_ivp(exponential_decay, [0, 10], [2, 4, 8])
    assert sol.t[0] == 0 and sol.t[-1] == 10 and sol.y.shape == (3, len(sol.t))
    assert np.allclose(sol.y, np.outer([2, 4, 8], np.exp(-0.5 * sol.t)), rtol=CLOSE, atol=0)
    assert sol.success and sol.status == 0 and sol["message"].startswith("The solver successfully")


def test_exponential_decay_at_times():
    sol = lb.solve_ivp(exponential_decay, [0, 10], [2, 4, 8], t_eval=[0, 1, 2, 4, 10])
    assert sol.t.tolist() == [0, 1, 2, 4, 10]
    assert np.allclose(sol.y[1], 4 * np.exp(-0.5 * sol.t), rtol=CLOSE)


def upward_cannon(t, y):
    return [y[1], -0.5]


def hit_ground(t, y):
    return y[0]


def test_cannon_that_ends_at_the_ground():
    def event(t, y):
        return hit_ground(t, y)

    event.terminal = True
    event.direction = -1
    sol = lb.solve_ivp(upward_cannon, [0, 100], [0, 0.5], events=event)
    assert sol.status == 1 and sol.message == "A termination event occurred."
    assert len(sol.t_events) == 1 and abs(sol.t_events[0][0] - 2) < CLOSE
    assert sol.t[-1] == sol.t_events[0][0]


def test_cannon_with_apex_and_dense_output():
    def ground(t, y):
        return y[0]

    ground.terminal = True
    ground.direction = -1

    def apex(t, y):
        return y[1]

    sol = lb.solve_ivp(lambda t, y: [y[1], -10], [0, 100], [0, 10], events=(ground, apex), dense_output=True)
    assert np.allclose(sol.t_events[0], [2], rtol=CLOSE) and np.allclose(sol.t_events[1], [1], rtol=CLOSE)
    assert np.allclose(sol.sol(sol.t_events[1][0]), [5, 0], atol=CLOSE)
    assert np.allclose(sol.y_events[1], [[5, 0]], atol=CLOSE)
    assert sol.sol([0.5, 1.5]).shape == (2, 2)
    assert np.allclose(sol.sol(np.array([0.5, 1.5]))[0], [3.75, 3.75], rtol=CLOSE)


def lotkavolterra(t, z, a, b, c, d):
    x, y = z
    return [a * x - b * x * y, -c * y + d * x * y]


def test_lotka_volterra_with_args():
    sol = lb.solve_ivp(lotkavolterra, [0, 15], [10, 5], args=(1.5, 1, 3, 1), dense_output=True)
    t = np.linspace(0, 15, 300)
    x, y = sol.sol(t)
    conserved = x - 3 * np.log(x) + y - 1.5 * np.log(y)
    assert np.ptp(conserved) < CLOSE * np.abs(conserved).max()
    proved = lb.problem("x' = 3/2*x - x*y; y' = -3*y + x*y", x=10, y=5).reference(15, 20)
    assert np.allclose(sol.sol(15.0), [float(proved["x"]), float(proved["y"])], rtol=CLOSE)


def test_van_der_pol_with_an_array_of_results():
    def fun(t, y):
        slopes = np.zeros(2)
        slopes[0] = y[1]
        slopes[1] = 5 * (1 - y[0] ** 2) * y[1] - y[0]
        return slopes

    sol = lb.solve_ivp(fun, (0, 20), np.array([2.0, 0.0]), method="Radau", rtol=1e-8)
    proved = lb.problem("y'' = 5*(1 - y^2)*y' - y", y=2, starts={"y'": 0}).reference(20, 20)
    assert np.allclose(sol.y[:, -1], [float(proved["y"]), float(proved["y'"])], rtol=CLOSE)


def test_lorenz_of_the_tutorials():
    def lorenz(t, xyz, s=10, r=28, b=8 / 3):
        x, y, z = xyz
        return np.array([s * (y - x), r * x - y - x * z, x * y - b * z])

    sol = lb.solve_ivp(lorenz, [0, 5], [1.0, 1.0, 1.0], method="DOP853")
    b = lb.exact(8 / 3)
    proved = lb.problem(f"x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y-b*z; b = {b}", x=1, y=1, z=1).reference(5, 20)
    # The flow amplifies errors by about 10^2 until then.
    assert np.allclose(sol.y[:, -1], [float(proved[name]) for name in "xyz"], rtol=1e2 * CLOSE)


def test_airy_equation_backwards():
    # SciPy's tutorial: w'' = z w, with Ai as the solution.
    from mpmath import airyai

    start = [float(airyai(0)), float(airyai(0, derivative=1))]
    for end in (-4, 4):
        sol = lb.solve_ivp(lambda z, w: [w[1], z * w[0]], [0, end], start, t_eval=[end])
        # Bi grows from the rounding of the start by its size there.
        assert abs(sol.y[0, 0] - float(airyai(end))) < CLOSE
        assert sol.t.tolist() == [end]


def test_pendulum_with_friction_and_gravity():
    # SciPy's odeint: theta'' + b theta' + c sin theta = 0.
    def pend(t, y, b, c):
        theta, omega = y
        return [omega, -b * omega - c * np.sin(theta)]

    t = np.linspace(0, 10, 101)
    sol = lb.solve_ivp(pend, [0, 10], [np.pi - 0.1, 0.0], t_eval=t, args=(0.25, 5.0))
    first = lb.exact(np.pi - 0.1)
    proved = lb.problem("y'' = -y'/4 - 5*sin(y)", y=first, starts={"y'": 0}).reference(10, 20)
    assert np.array_equal(sol.t, t)
    assert np.allclose(sol.y[:, -1], [float(proved["y"]), float(proved["y'"])], rtol=CLOSE, atol=CLOSE)


def test_rational_equation_with_events_that_are_counted():
    # Of SciPy's own tests: y0 = t/(t + 10), y1 = 10 t/(t + 10)^2 from t = 5.
    def rational(t, y):
        return np.array([y[1] / t, y[1] * (y[0] + 2 * y[1] - 1) / (t * (y[0] - 1))])

    def at_07(t, y):
        return y[0] - y[1] ** 0.7

    sol = lb.solve_ivp(rational, [5, 9], [1 / 3, 2 / 9], events=at_07, dense_output=True)
    assert np.allclose(sol.y[0], sol.t / (sol.t + 10), rtol=CLOSE)
    assert np.allclose(sol.y[1], 10 * sol.t / (sol.t + 10) ** 2, rtol=CLOSE)
    assert len(sol.t_events[0]) == 1
    t = sol.t_events[0][0]
    assert abs(t / (t + 10) - (10 * t / (t + 10) ** 2) ** 0.7) < CLOSE

    def quarter_turns(t, y):
        return y[0]

    quarter_turns.terminal = 3
    turns = lb.solve_ivp(lambda t, y: [y[1], -y[0]], [0, 100], [1, 0], events=quarter_turns)
    assert np.allclose(turns.t_events[0], [math.pi / 2, 3 * math.pi / 2, 5 * math.pi / 2], rtol=CLOSE)
    assert turns.status == 1


def test_singularities_and_limits_of_the_interface():
    blown = lb.solve_ivp(lambda t, y: y**2, [0, 2], [1])
    assert blown.status == -1 and not blown.success and 0.99 < blown.t[-1] <= 1
    overflowing = lb.solve_ivp(lambda t, y: y, [0, 1000], [1])
    assert overflowing.status == -1 and 700 < overflowing.t[-1] < 711
    assert lb.solve_ivp(lambda t, y: y, [1, 1], [3]).y.tolist() == [[3]]
    dense = lb.solve_ivp(lambda t, y: y, [0, 10], [1], max_step=0.5)
    assert np.diff(dense.t).max() <= 0.5
    with pytest.raises(ValueError, match="not within"):
        lb.solve_ivp(lambda t, y: y, [0, 1], [1], t_eval=[2])
    with pytest.raises(ValueError, match="sorted"):
        lb.solve_ivp(lambda t, y: y, [0, 1], [1], t_eval=[0.5, 0.2])
    with pytest.raises(TypeError, match="branches"):
        lb.solve_ivp(lambda t, y: [max(y[0], 0)], [0, 1], [1])
    with pytest.raises(TypeError, match="complex"):
        lb.solve_ivp(lambda t, y: y, [0, 1], [1j])
    with pytest.raises(TypeError, match="no option 'rtool'"):
        lb.solve_ivp(lambda t, y: y, [0, 1], [1], rtool=1e-3)
