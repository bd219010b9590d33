#!/usr/bin/env python3
"""convert.py CERTIFICATE NAME: writes the Coq text of a certificate of docs/certificates.md to stdout.

Nothing here is trusted: the text states equations, initial values, times and intervals in a readable form, and Coq
proves them from the numbers, or fails. Exit status 1, with one line on stderr, for what the formal proof does not cover.
"""
import pathlib
import sys
import zlib
from fractions import Fraction
from math import lcm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "check"))
sys.dont_write_bytecode = True
import libration_check as checker  # noqa: E402, its parser of formulas and of the format


class NotCovered(Exception):
    pass


def dyadic(x):
    """A fraction as (integer, exponent); NotCovered if its denominator is not a power of two."""
    if x.denominator & (x.denominator - 1):
        raise NotCovered("the number %s is not dyadic" % x)
    return x.numerator, 1 - x.denominator.bit_length()


def num(m, e):
    return "((%d)%%bigZ, (%d))" % (m, e)


def listed(items, separator="; "):
    return "[" + separator.join(items) + "]"


def polynomial(a, e):
    return "(%s, (%d))" % (listed("(%d)%%bigZ" % x for x in a), e)


def expression(f, unit):
    """unit times a polynomial {monomial: coefficient} as an expr."""
    terms = []
    for monomial, c in f.items():
        term = "Const (%d)" % (c * unit)
        for k in monomial:
            term = "Times (%s) (%s)" % (term, "Unknown %d" % (k - 1) if k else "Time")
        terms.append(term)
    text = terms[0] if terms else "Const 0"
    for term in terms[1:]:
        text = "Plus (%s) (%s)" % (text, term)
    return text


class Step:
    def __init__(self, r, n):
        (k,), ((h,),) = r.section("step", 1, 1)
        self.half, scales = (h, -k - 1), r.integers("scale", n)
        self.sizes = [int(x) for x in r.line("blocks")]
        (kp,), p = r.section("p", 1, n)
        (kv, v), (ku, u) = r.section("V", n, n * n), r.section("U", n, n * n)
        self.p = [polynomial(a, scales[i] - kp) for i, a in enumerate(p)]
        self.V = [listed(polynomial(v[i * n + j], scales[i] - kv[j]) for j in range(n)) for i in range(n)]
        self.U = [listed(polynomial(u[i * n + j], -ku[i] - scales[j]) for j in range(n)) for i in range(n)]
        k, radii = r.section("radii", len(self.sizes), 2)
        self.radii = [listed(num(m, -e) for m, e in zip(x, k)) for x in radii]
        if h <= 0:
            raise NotCovered("time runs backwards")

    def text(self):
        groups = listed("%d" % b for b, size in enumerate(self.sizes) for _ in range(size))
        return "Step %s\n %s\n %s\n %s\n %s%%nat %d%%nat\n %s\n %s" % (
            num(*self.half), listed(self.p, ";\n  "), listed(self.V, ";\n  "), listed(self.U, ";\n  "), groups, len(self.sizes),
            *self.radii)


def fraction_of(m, e):
    return m * Fraction(2)**e


def claim(problem, c, begin, step):
    time, low, high = (checker.fraction(c[k]) for k in (0, 2, 3))
    x = (time - begin) / fraction_of(*step.half) - 1
    if not -1 <= x <= 1:
        return None
    near = Fraction(round(x * 2**200), 2**200)
    unit = lcm(low.denominator, high.denominator)
    return "(%s, Claim (%d) %d %d (%d) (%d) %d)" % (num(*dyadic(near)), time.numerator, time.denominator,
                                                    problem.state.index(c[1]), low * unit, high * unit, unit)


def start_set(problem):
    """The box of the enclosures of the initial values: exact ones as they are, if they are dyadic."""
    centre, size = [], []
    for a, b in problem.start:
        scale = 2**problem.bits
        middle = Fraction(round((a + b) / 2 * scale), scale)
        centre.append(middle)
        reach = max(b - middle, middle - a) * scale
        size.append(Fraction(-(-reach.numerator // reach.denominator), scale))
    return centre, size


def convert(text, name):
    r = checker.Reader(text)
    problem = checker.Problem(r)
    n = len(problem.right)
    unit = lcm(1, *[c.denominator for f in problem.right for c in f.values()])
    begin, steps, claims, items = problem.t0, [], list(problem.claims), []
    for _ in range(problem.steps):
        step = Step(r, n)
        found = [(c, claim(problem, c, begin, step)) for c in claims]
        claims = [c for c, x in found if x is None]
        items.append((step, [x for _, x in found if x]))
        begin += 2 * fraction_of(*step.half)
    centre, size = start_set(problem)
    out = ["From Libration Require Import Certificate.", "Local Open Scope Z_scope."]
    out.append("Definition rights : list expr := %s." % listed((expression(f, unit) for f in problem.right), ";\n "))
    for k, (step, found) in enumerate(items):
        out.append("Definition step_%d : step := %s." % (k, step.text()))
    identity = listed(listed("one" if i == j else "zero" for j in range(n)) for i in range(n))
    out.append("Definition start : states := States %s %s %s%%nat %d%%nat %s." % (
        listed(num(*dyadic(x)) for x in centre), identity, listed(str(i) for i in range(n)), n, listed(num(*dyadic(x)) for x in size)))
    out.append("Definition items : list item := %s." % listed(
        ("(step_%d, %s)" % (k, listed(found)) for k, (_, found) in enumerate(items)), ";\n "))
    out.append("Time Eval vm_compute in (chain_ok %d %d rights %s start items)." % (n, unit, num(*dyadic(problem.t0))))
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    try:
        print(convert(zlib.decompress(open(sys.argv[1], "rb").read()).decode(), sys.argv[2]), end="")
    except NotCovered as reason:
        sys.exit("convert.py: %s: not covered by the formal proof: %s" % (sys.argv[1], reason))
