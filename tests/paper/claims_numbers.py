#!/usr/bin/python3
"""The numbers of the claims about sections IV to VI and the appendix, by mpmath alone: tests/paper/claims_numbers.py.

Shares no code with the library: coefficients by the recursion of the paper, theta by mpmath's elliptic functions, norms
as maxima over 400 points and 40 more about the largest. Prints "claim number"; the tests quote it.
"""
from mpmath import acos, asin, atan2, atanh, binomial, ceil, cos, e, ellipfun, ellipk, log, mp, mpf, nstr, pi, polyval
from mpmath import sin, sqrt

mp.dps = 40


class Way:
    """The descent at energy E, in x = t/T*."""

    def __init__(self, energy, direction=1):
        self.energy = mpf(energy)
        self.rotates = self.energy > 2
        self.direction = direction
        if self.rotates:
            self.period = sqrt(2 / self.energy) * ellipk(2 / self.energy)
            self.height = sqrt(2 / self.energy) * ellipk(1 - 2 / self.energy)
        else:
            self.period = ellipk(self.energy / 2)
            self.height = ellipk(1 - self.energy / 2)
        self.radius = sqrt(self.period**2 + self.height**2)
        self.rho = self.period / self.radius
        self.speed = sqrt(2 * self.energy) * (direction if self.rotates else -1)
        self.angle = 2 * pi if self.rotates and direction > 0 else mpf(0)
        self.powers = []
        self.truth = {}

    def exact(self, x):
        """theta at x = t/T*: from the bottom, where the sine of half the angle is an elliptic function."""
        if x not in self.truth:
            s = (x - 1) * self.period
            if self.rotates:
                u = s * sqrt(self.energy / 2)
                m = 2 / self.energy
                half = asin(ellipfun("sn", u, m=m))
                self.truth[x] = self.angle + 2 * half * self.direction
            else:
                m = self.energy / 2
                self.truth[x] = -2 * asin(sqrt(m) * ellipfun("sn", s, m=m))
        return self.truth[x]

    def series(self, order):
        """a_n T*^n."""
        if len(self.powers) <= order:
            start = (pi, self.direction * sqrt(2 * self.energy - 4)) if self.rotates else (acos(1 - self.energy), mpf(0))
            a, s, c = list(start), [sin(start[0])], [cos(start[0])]
            for n in range(order):
                a.append(-s[n] / ((n + 1) * (n + 2)))
                s.append(sum((k + 1) * a[k + 1] * c[n - k] for k in range(n + 1)) / (n + 1))
                c.append(-sum((k + 1) * a[k + 1] * s[n - k] for k in range(n + 1)) / (n + 1))
            self.powers = [a[n] * self.period**n for n in range(order + 1)]
        return self.powers[:order + 1]

    def resummed(self, order, angle=None, speed=None):
        """The polynomial of degree N + 2 that ends in angle and speed."""
        angle = self.angle if angle is None else angle
        slope = (self.speed if speed is None else speed) * self.period
        x = self.series(order)
        miss, slope_miss = angle - sum(x), slope - sum(n * x[n] for n in range(order + 1))
        return x + [(order + 2) * miss - slope_miss, slope_miss - (order + 1) * miss]

    def error(self, polynomial, x):
        return abs(polyval(polynomial[::-1], x) - self.exact(x))

    def norm(self, polynomial, points=400):
        places = [mpf(i) / points for i in range(points + 1)]
        best = max(places, key=lambda x: self.error(polynomial, x))
        near = [best + mpf(i) / (points * 20) for i in range(-20, 21)]
        return max(self.error(polynomial, x) for x in near if 0 <= x <= 1)

    def bound(self, order):
        prefactor = pi**4 * self.radius**4 / (256 * self.period**2 * self.height**2)
        peak = mpf(4) / (order + 3)**2 * (mpf(order + 1) / (order + 3))**(order + 1)
        return 8 * prefactor / (order + 3) * self.rho**(order + 3) / (1 - self.rho)**3 * peak


def show(name, value):
    print(name, nstr(value, 5))


def old(k2, order):
    return sum(pi / 2 * binomial(2 * n, n)**2 / mpf(16)**n * k2**n for n in range(order + 1))


def new(k2, order):
    return (sum((pi / 2 * binomial(2 * n, n)**2 / mpf(16)**n - mpf(1) / (2 * n + 1)) * k2**n for n in range(order + 1)) +
            atanh(sqrt(k2)) / sqrt(k2))


def resummation():
    w = Way("1.71")
    up = Way("2.02")
    fast = abs(w.speed)
    show("figure_libration_orders", w.norm(w.series(6)) / w.norm(w.series(2)))
    show("omegab_rate", w.norm(w.resummed(100, speed=fast)) / (2 * fast * w.period / (e * 100)))
    show("omegab_rate N=0 printed", w.norm(w.resummed(0, speed=fast)))
    show("omegab_rate N=0 corrected", w.norm(w.resummed(0)))
    show("resummation_counterclockwise", up.norm(up.resummed(20, angle=mpf(0))))
    down = Way("2.02", -1)
    show("resummation_clockwise", down.norm(down.resummed(40)) / down.bound(40))
    show("approxcoeffs", w.error(w.resummed(40), mpf(9) / 10) / w.bound(40))
    b = w.series(150)
    b[0] += fast * w.period
    b[1] -= fast * w.period
    total, sums = mpf(0), mpf(0)
    for value in b:
        total += value
        sums += total
    show("exact_resummation", sums / (2 * fast * w.period))
    show("resummation_range", w.error(w.resummed(80), mpf(-1)))

    def curvature(order):
        x = w.resummed(order)
        return sum(n * (n - 1) * x[n] for n in range(len(x))) / w.period**2

    show("second_derivative", curvature(10))
    show("second_derivative N=0", curvature(0))
    show("period_analyticity", 2 * abs(curvature(10)))

    def rate(make):
        return (max(w.norm(make(n)) for n in (80, 82)) / max(w.norm(make(n)) for n in (40, 42)))**(mpf(1) / 40)

    show("acceleration_rate", rate(w.resummed) / rate(w.series))
    show("error_gain", Way("1.34").norm(Way("1.34").series(2)) / Way("1.34").norm(Way("1.34").resummed(2)))
    a, c = Way("1.90"), Way("1.85")
    show("error_monotone", a.norm(a.resummed(5)) / c.norm(c.resummed(5)))
    near = Way("1.9998")
    for order in (5, 10, 20):
        show("figure_orders N=%d" % order, near.norm(near.series(order)) / near.norm(near.resummed(order)))
    for order in (75, 80):
        show("fewer_orders series N=%d" % order, near.norm(near.series(order)))
    for order in (5, 10):
        show("fewer_orders resummed N=%d" % order, near.norm(near.resummed(order)))
    d = Way("1.34")
    show("degree_for_degree", d.norm(d.series(2)) / d.norm(d.resummed(0)))
    show("every_energy", Way("1.9999").error(Way("1.9999").resummed(160), mpf(3) / 4) /
         Way("1.9999").error(Way("1.9999").resummed(80), mpf(3) / 4))


def appendix():
    w = Way("1.71")
    a = [x / w.period**n for n, x in enumerate(w.series(10))]
    sigma, slope = sum(a) * w.period**10, 10 * sum(a) * w.period**9
    alpha = -12 * sigma / w.period**11 - (w.speed - slope) / w.period**10
    beta = 11 * sigma / w.period**12 + (w.speed - slope) / w.period**11
    show("appendix_sigma", w.norm(w.series(10) + [alpha * w.period**11, beta * w.period**12]))
    show("appendix_sigma N=1 printed", w.period * sum(w.series(1)))
    up = Way("2.02")
    show("appendix_alpha_beta", up.norm(up.resummed(11, angle=mpf(0))))
    x = w.series(10)
    slope = w.speed * w.period - sum(n * x[n] for n in range(11))
    bend = -sum(n * (n - 1) * x[n] for n in range(11))
    second = (bend - 10 * slope) / 12
    show("appendix_conditions", sum(x) + (slope - 12 * second) / 11 + second)
    show("appendix_conditions N=0", x[0] + w.speed * w.period)
    gap = Way(2 - mpf("1e-10"))
    order = int(ceil(log(mpf("1.7976931348623157e308")) / log(gap.period))) - 1
    show("appendix_range order", order)
    show("appendix_range", gap.error(gap.resummed(order), mpf(99) / 100))


def period():
    k2 = mpf("0.855")
    omitted = pi / 2 * binomial(202, 101)**2 / mpf(16)**101 * k2**101
    show("Kold_converges", (ellipk(k2) - old(k2, 100)) / (omitted / (1 - k2)))
    show("Knew_converges", (ellipk(k2) - new(k2, 100)) / (k2**101 / ((1 - k2) * 8 * 101**2)))
    show("Kold_towards_separatrix, N = 0, E = 3 and 2.5 scaled by k", (ellipk(mpf("0.8")) - old(mpf("0.8"), 0)) *
         sqrt(mpf("0.8")) / ((ellipk(mpf(2) / 3) - old(mpf(2) / 3, 0)) * sqrt(mpf(2) / 3)))
    show("Knew_better", (pi / 8) / (pi / 8 - mpf(1) / 3))
    near = 1 - mpf("1e-12") / 2
    show("Knew_rapid", (ellipk(near) - new(near, 800)) / (ellipk(near) - new(near, 400)))
    brackets = sum(pi / 2 * binomial(2 * n, n)**2 / mpf(16)**n - mpf(1) / (2 * n + 1) for n in range(1001))
    show("Knew_tail", 8000 * (log(mpf(2)) - brackets))
    below, above = mpf("1.9999")**2 / 4, 4 / mpf("2.0001")**2
    for name, k2 in (("1.9999", below), ("2.0001", above)):
        show("figure_period omega0 = " + name, (ellipk(k2) - old(k2, 100)) / (ellipk(k2) - new(k2, 10)))
    shift = 4 * (ellipk(below) - new(below, 10))
    w = Way(2 * below)
    fast = mpf(9) / 10
    show("figure_period_drift", abs(w.exact(fast - shift / w.period) - w.exact(fast)))
    mp.dps = 80
    gap = mpf("1e-20")
    show("period_grows", ellipk(1 - gap / 2) - log(32 / gap) / 2)
    below = mpf("1.9999")**2 / 4
    term = pi / 2
    rest, order = ellipk(below) - term, 0
    while rest > mpf("1e-4"):
        order += 1
        term *= (mpf(2 * order - 1) / (2 * order))**2 * below
        rest -= term
    print("Kold_hundred_terms", order)
    mp.dps = 40


def conclusions():
    gap = mpf("1e-100")
    mp.dps = 150
    t = ellipk(1 - gap / 2)
    show("converges_beyond_bottom", sqrt(t**2 + ellipk(gap / 2)**2) / t - 1)
    mp.dps = 40
    w = Way("1.71")
    half = w.period / 2
    show("optimal_at_top", half / sqrt(half**2 + w.height**2) / w.rho)
    near = Way(2 - mpf("1e-8"))
    show("better_at_every_truncation", near.norm(near.series(0)) / near.norm(near.resummed(0)))
    x = mpf(1) / 100
    show("better_at_every_time", w.error(w.resummed(4), x) / w.error(w.series(4), x))
    phi = atan2(w.height, w.period)
    ratios = [sqrt(abs(sin(n * phi) / sin((n + 2) * phi) * (n + 2) / n)) for n in range(300, 401, 2)]
    show("domb_sykes, asymptotically", max(ratios) / min(ratios))
    show("root_test, asymptotically", min((8 * abs(sin(n * phi)) / n)**(mpf(-1) / n) for n in range(300, 401, 2)))
    late = mpf(1002)
    where = late - 4 * w.period * int(late / (4 * w.period))
    if where > 2 * w.period:
        where = 4 * w.period - where
    part = where / w.period if where <= w.period else 2 - where / w.period
    show("all_times", w.error(w.resummed(20), part))


if __name__ == "__main__":
    resummation()
    appendix()
    period()
    conclusions()
