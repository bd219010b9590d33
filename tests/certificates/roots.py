"""Certificates from which a root does not follow, for attack.py: each is refused for one reason.

They are of y' = z + exp(z) - 1, z' = 0, s' = 1, y(0) = s(0) = 0, where y(1) = 0 for z(0) = 0, and consist of one step
of 9/8, about the solution z = 0."""

# Conditions: (name, text of the checker, the text with which the condition always holds).
CONDITIONS = [
    ("certificates of one problem", "need(same and heads == heads[:1] * len(heads),", "need(same,"),
    ("conditions at one time", 'same = ":" in ends or fraction(middle) == fraction(ends)', "same = True"),
    ("equal starts", "match = match and all(x.starts == near.starts for x in others)", "pass"),
    ("derivatives by each unknown start", "match = [x.vary for x in problems] == [None] + [point.state[k] for k in moved]",
     "match = True"),
    ("as many conditions as unknowns", "form(good and {x[1]", "form({x[1]"),
    ("a contraction", "need(total < radii[i],", "need(True,"),
    ("the distance of the middle", "total = distance(C, F, 0) + sum(parts)", "total = sum(parts)"),
    ("the matrix is near the inverse", "total = distance(C, F, 0) + sum(parts)", "total = distance(C, F, 0)"),
    ("the middle is in the box", "min(m - a, b - m)", "b - m"),
    ("derivatives alone", "need(self.vary is None,", "need(True,"),
    ("times behind the start", "behind = (self.first - problem.t0) * (self.last - self.first) >= 0", "behind = True"),
    ("derivatives of added unknowns", "by_start[k] = algebra.times(slope, algebra.along(u, by_start))", "pass"),
]

# Radii at both ends of y, z, s, of d(y), d(z), d(s) in certificates with these, and of exp(z), in units of 2^-10.
ALONE = [1, 1, 1, 1], [10, 1, 1, 1]
BY_Z = [1, 113, 1, 1, 1, 1, 128], [280, 113, 1, 180, 1, 1, 128]
BY_Y = [1, 113, 1, 1, 1, 1, 128], [280, 113, 1, 20, 1, 1, 128]
WIDE_BY_Z = [110, 113, 1, 1, 1, 1, 128], [400, 113, 1, 180, 1, 1, 128]
WIDE_BY_Y = [110, 113, 1, 1, 1, 1, 128], [400, 113, 1, 20, 1, 1, 128]

# Of z(0) and the time; of z(0); of y(0) and z(0).
IN_TIME = "root y start 1/2 0\nroot s 1 0 1\n"
AT_TIME = "root y 0 1/2\n"
OF_TWO = "root y 0 1 -2\nroot z 0 0 1\n"


def certificate(starts, claims, curves, radii, vary=()):
    n = len(curves)
    unit = ["1" if i == j else "" for i in range(n) for j in range(n)]
    return "\n".join(
        ["libration-certificate 1", "variable t", "at 0", "equation y' = z + exp(z) - 1", "equation z' = 0",
         "equation s' = 1"] + ["start " + x for x in starts] + ["vary " + x for x in vary]
        + ["define _1 = exp(z)", "bits 100 200"] + ["claim %s %s %s" % x for x in claims]
        + ["steps 1", "step 3", "9", "scale" + " 0" * n, "blocks" + " 1" * n, "p 5"] + curves
        + ["V" + " 0" * n] + unit + ["U" + " 0" * n] + unit
        + ["radii" + " 10" * n] + [" ".join("%x" % x for x in r) for r in radii] + ["end", ""])


def point(y="-1/100 1/100"):
    """For z(0) = 0: y = 0, z = 0, s = t, exp(z) = 1."""
    claims = [("1", "y", y), ("1", "z", "-1/100 1/100"), ("1", "s", "99/100 101/100")]
    return certificate(["0", "0", "0"], claims, ["", "", "12 9", "20"], ALONE)


def near(times="1", z="[-1/10, 1/10]", slope="1.6 2.4", y="0", radii=BY_Z):
    """For all z(0) in an interval, with the derivatives by it: d(y) = 2 t, d(z) = 1, d(s) = 0."""
    claims = [("y", "-1 1"), ("z", "-1/8 1/8"), ("s", "-1 2"), ("d(y)", slope), ("d(z)", "15/16 17/16"),
              ("d(s)", "-1/64 1/64")]
    curves = ["", "", "12 9", "24 12", "20", "", "20"]
    return certificate([y, z, "0"], [(times, *x) for x in claims], curves, radii, "z")


def near_by_y(y="0", radii=BY_Y):
    """The same with the derivatives by y(0): 1, 0, 0."""
    claims = [("d(y)", "15/16 17/16"), ("d(z)", "-1/64 1/64")]
    curves = ["", "", "12 9", "20", "", "", "20"]
    return certificate([y, "[-1/10, 1/10]", "0"], [("1", *x) for x in claims], curves, radii, "y")


def made_certificates(accepted, whole):
    """(name, text)."""
    around, wide = "9/10:11/10", "[-1/10, 1/10]"
    by_y, by_z = near_by_y(wide, WIDE_BY_Y), near(y=wide, radii=WIDE_BY_Z)
    for good in (point() + near(around) + IN_TIME, point() + near() + AT_TIME, point() + by_y + by_z + OF_TWO):
        if not accepted(whole, good):
            raise SystemExit("roots.py: a true certificate is refused")
    yield "another equation", point() + near(around).replace("s' = 1", "s' = 1*1") + IN_TIME
    yield "another time", point() + near("9/8", slope="1.9 2.5") + AT_TIME
    yield "another interval of starts", point() + by_y + near(y="[-1/20, 1/20]", radii=WIDE_BY_Z) + OF_TWO
    yield "a start without derivatives", point() + by_z + "root y 0 1/2 0\nroot s 1 0 1\n"
    yield "derivatives by another start", point() + near_by_y() + "root y 0 1\n"
    yield "no conditions", point() + near(around)
    yield "a condition is missing", point() + near(around) + "root y start 1/2\n"
    yield "no contraction", point() + near(around) + IN_TIME.replace("1/2", "2")
    yield "a root far away", point(y="-1 1") + near() + AT_TIME
    yield "derivatives that are not known", point() + near(slope="-9 9") + AT_TIME
    yield "a middle at an end", point() + near(z="[0, 1/10]") + AT_TIME
    yield "a time at an end", point() + near("1:11/10") + IN_TIME
    yield "derivatives alone", near()
    yield "from times before the start", point() + near("-1/2:11/10", slope="-9 9") + "root z 0 1 0\nroot s 1 0 1\n"
    false = near(slope="1/2 3/2").replace("\n24 12\n", "\n12 9\n")
    yield "derivatives without those of exp(z)", point() + false + AT_TIME.replace("1/2", "1")
