#!/usr/bin/env python3
"""convert.py CERTIFICATE NAME: writes the Coq text of a certificate of docs/certificates.md to stdout.

Nothing here is trusted: the text states equations, initial values, times and intervals in a readable form, and Coq
proves them from the numbers, or fails. Exit status 1, with one line on stderr, for what the formal proof does not cover.
"""
import math
import pathlib
import re
import sys
from fractions import Fraction
from math import lcm

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from converter.functions import functions_of  # noqa: E402
from converter.statement import Statement  # noqa: E402
from converter.terms import NotCovered, checker, definition, dyadic, expression, listed, num, polynomial  # noqa: E402


class Step:
    def __init__(self, r, n):
        (k,), ((h,),) = r.section("step", 1, 1)
        self.half, scales = (h, -k - 1), r.integers("scale", n)
        self.sizes = [int(x) for x in r.line("blocks").split(" ")]
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
    """A claim whose time is in the step: the place of the time, and the text of the claim."""
    time, low, high = c.first, c.low, c.high
    x = (time - begin) / fraction_of(*step.half) - 1
    if not -1 <= x <= 1:
        return None
    place = Fraction(round(x * 2**502), 2**502)
    unit = lcm(low.denominator, high.denominator)
    return num(*dyadic(place)), "Claim (%d) %d %d (%d) (%d) %d" % (
        time.numerator, time.denominator, problem.state.index(c.name), low * unit, high * unit, unit)


def start_box(problem, statement):
    """Dyadic boxes around the initial values of the statement."""
    scale = 2**(problem.bits + 8)
    for k in range(statement.n):
        low, high = statement.initial(k)
        middle = Fraction(round((low + high) / 2 * scale), scale)
        reach = max(high - middle, middle - low) * scale
        yield middle, Fraction(math.ceil(reach), scale)


def read_steps(r, problem):
    """The steps, with the claims whose times are in them, and these claims in their order."""
    begin, remaining, items, ordered = problem.t0, list(problem.claims), [], []
    for _ in range(problem.steps):
        step = Step(r, len(problem.right))
        found = [(c, claim(problem, c, begin, step)) for c in remaining]
        remaining = [c for c, x in found if x is None]
        items.append((step, [(c, x) for c, x in found if x]))
        ordered += [c for c, x in found if x]
        begin += 2 * fraction_of(*step.half)
    if remaining:
        raise NotCovered("no step contains the time of the claim about %s at %s" % (remaining[0].name, remaining[0].time))
    checker.form(r.lines[r.at:] == ["end", ""], "the steps do not end with 'end'")
    return items, ordered


def convert(text, name):
    r = checker.Reader(text)
    problem = checker.Problem(r)
    if problem.condition or problem.vary or text.count("\nend\n") != 1 or not text.endswith("\nend\n"):
        raise NotCovered("zeros of a condition, or a root")
    unit = lcm(1, *[c.denominator for f in problem.right for c in f.values()])
    items, ordered = read_steps(r, problem)
    statement = Statement(problem, unit, ordered, functions_of(problem) if len(problem.right) > len(problem.state) else [])
    out = ["From Libration Require Import Certificate Functions.", "Local Open Scope Z_scope."]
    out += [definition("u_%d" % f.number, "expr", expression(f.u, 1)) for f in statement.functions]
    out += [x.text() for x in statement.values.values()]
    out.append(definition("right_sides", "list expr", listed((expression(f, unit) for f in problem.right), ";\n  ")))
    entries, count = [], 0
    for k, (step, found) in enumerate(items):
        out.append(definition("step_%d" % k, "step", step.text()))
        inside = []
        for _, (place, text) in found:
            out.append(definition("claim_%d" % count, "claim", text))
            inside.append("(%s, claim_%d)" % (place, count))
            count += 1
        entries.append("(step_%d, %s)" % (k, listed(inside)))
    box = list(start_box(problem, statement))
    out.append(definition("start_box", "list initial", listed(statement.box())))
    out.append(definition("data", "certificate", "Certificate %d right_sides (%d, %d) (%d, %d)\n  %s\n  %s\n  %s\n  %s\n  %s" % (
        unit, statement.first.numerator, statement.first.denominator, statement.last.numerator, statement.last.denominator,
        "start_box", num(*dyadic(problem.t0)), listed(num(*dyadic(x)) for x, _ in box),
        listed(num(*dyadic(x)) for _, x in box), listed(entries, ";\n   "))))
    out.append("Lemma data_ok : certificate_ok data = true.\nProof. vm_cast_no_check (eq_refl true). Qed.")
    out.append("Lemma claims_listed : all_claims (items data) = %s.\nProof. reflexivity. Qed." % (
        listed("claim_%d" % k for k in range(count))))
    return "\n".join(out) + "\n" + statement.text(name)


def main():
    if len(sys.argv) != 3 or not re.fullmatch("[a-z][a-z0-9_]*", sys.argv[2]):
        sys.exit("usage: convert.py CERTIFICATE NAME, a name of small letters, digits and _")
    try:
        print(convert(checker.text_of(pathlib.Path(sys.argv[1]).read_bytes()), sys.argv[2]), end="")
    except (NotCovered, checker.Refused, OSError) as reason:
        sys.exit("convert.py: %s is not covered by the formal proof: %s" % (sys.argv[1], reason))


if __name__ == "__main__":
    main()
