"""Added unknowns that are sin, cos or exp: their arguments, and certificates of their initial values."""
import math
from fractions import Fraction

from converter.terms import NotCovered, checker, definition, dyadic, evaluated_text, listed, num, polynomial, real


class Function:
    """An added unknown that is sin, cos or exp of a polynomial in the variable and the unknowns of the text."""

    def __init__(self, problem, text, number):
        self.kind, argument, _ = checker.definition(checker.Parser(text).tree)
        own = {x: {(k,): Fraction(1)} for k, x in enumerate([problem.variable] + problem.state)}
        if self.kind not in ("sin", "cos", "exp"):
            raise NotCovered("the function '%s'" % self.kind)
        self.number, self.u = number, checker.Algebra().of(argument, own)
        at = [problem.t0] + [a for a, b in problem.start[:len(problem.state)] if a == b]
        if any(c.denominator != 1 for c in self.u.values()) or len(at) <= len(problem.state):
            raise NotCovered("an argument or an initial value that is not exact")
        self.start = sum((c * math.prod(at[k] for k in m) for m, c in self.u.items()), Fraction(0))
        if abs(self.start) > 50:
            raise NotCovered("a function of a large initial value")

    def text(self, terms):
        return "%s (%s)" % (self.kind, evaluated_text(self.u, terms))


def functions_of(problem):
    """The added unknowns as functions, or None if one of them is not of a kind whose values Coq proves."""
    try:
        found = [Function(problem, x, len(problem.state) + k) for k, (_, x) in enumerate(problem.defined)]
    except (NotCovered, checker.Refused):
        return None
    sines = [f.u for f in found if f.kind == "sin"]
    return found if sines == [f.u for f in found if f.kind == "cos"] else None


def times_x(a):
    """x times a polynomial a_0 + sum of 2 a_j T_j."""
    a = a + [Fraction(0)] * 2
    return [a[1]] + [(a[k - 1] + a[k + 1]) / 2 for k in range(1, len(a) - 1)]


class FunctionValues:
    """A certificate of sin and cos, or of exp, at a positive fraction: Taylor polynomials in the middles of short steps."""

    def __init__(self, kind, argument, bits, name):
        self.kind, self.argument, self.bits, self.name = kind, argument, bits, name
        self.time, self.sign = abs(argument), 1 if argument >= 0 else -1
        self.log_half = -2 if kind == "exp" else -1            # steps of the lengths 1/2 and 1
        self.length = 2 * Fraction(2)**self.log_half
        self.steps = max(1, math.ceil(self.time / self.length))
        # Radii: exp grows by less than 4 in a step of the length 1/2; the frame of sin and cos, one block, has the norm
        # sqrt(2), by which joints widen the tube.
        self.radii, r = [], 1
        for _ in range(self.steps):
            last = (4 if kind == "exp" else 1) * r + 1
            self.radii.append((r, last))
            r = (1 if kind == "exp" else 2) * last + 1
        self.enclosures = checker.Enclosures(bits + 60)

    def values(self, x):
        """The functions at x, in the order of their unknowns, and the constants of their derivatives."""
        kinds = ("sin", "cos") if self.kind != "exp" else ("exp",)
        return [sum(self.enclosures.entire(k, self.sign * x if k == "exp" else x)) / 2 for k in kinds]

    def curve(self, middle):
        """Polynomials of the unknowns in x on a step, by their derivatives in the middle."""
        v = self.values(middle)
        turn = (lambda d: [d[1], -d[0]]) if self.kind != "exp" else (lambda d: [self.sign * d[0]])
        rows, size = [], Fraction(1)
        while size * 2**(self.bits + 40) > 1:
            rows.append([x * size for x in v])
            v, size = turn(v), size * self.length / (2 * len(rows))
        unit = self.bits + 30
        for k in range(len(rows[0])):
            a = []
            for row in reversed(rows):
                a = times_x(a) if a else []
                a = [row[k] + (a[0] if a else 0)] + a[1:]
            while len(a) > 1 and abs(a[-1]) * 2**unit < 1:
                a.pop()
            yield polynomial([round(x * 2**unit) for x in a], -unit)

    def interval(self, k):
        """Integers low, high in units of 2^-bits."""
        value = self.values(self.time)[k] * 2**self.bits
        margin = 2 * self.radii[-1][1] + 4
        return math.floor(value) - margin, math.ceil(value) + margin

    def bounds(self, kind):
        """low/2^bits <= kind(argument) <= high/2^bits"""
        low, high = self.interval(1 if kind == "cos" else 0)
        return (-high, -low) if kind == "sin" and self.sign < 0 else (low, high)

    def text(self):
        n = 1 if self.kind == "exp" else 2
        diagonal = [[("([1%bigZ], 0)" if i == j else "([], 0)") for j in range(n)] for i in range(n)]
        one = listed(listed(row) for row in diagonal)
        rights = "circle" if n == 2 else "[Times (Const (%d)) (Unknown 0)]" % self.sign
        out, entries = [], []
        for k, (first, last) in enumerate(self.radii):
            curve = listed(self.curve((k + Fraction(1, 2)) * self.length), ";\n  ")
            out.append(definition("%s_step_%d" % (self.name, k), "step", "Step %s %s %s %s %s%%nat 1%%nat [%s] [%s]" % (
                num(1, self.log_half), curve, one, one, listed(["0"] * n), num(first, -self.bits), num(last, -self.bits))))
            entries.append("(%s_step_%d, " % (self.name, k))
        place = Fraction(round((2 * (self.time / self.length - self.steps + 1) - 1) * 2**502), 2**502)
        claims = []
        for k in range(n):
            claims.append("%s_claim_%d" % (self.name, k))
            out.append(definition(claims[-1], "claim", "Claim %d %d %d (%d) (%d) %d" % (
                self.time.numerator, self.time.denominator, k, *self.interval(k), 2**self.bits)))
        last = listed("(%s, %s)" % (num(*dyadic(place)), x) for x in claims)
        items = listed((x + ("[])" if k + 1 < self.steps else last + ")") for k, x in enumerate(entries)), ";\n  ")
        box = ["exactly 0 1", "exactly 1 1"][2 - n:]
        out.append(definition(self.name, "certificate", "Certificate 1 %s (0, 1) (%d, %d) %s zero %s %s\n  %s" % (
            rights, self.time.numerator, self.time.denominator, listed(box), listed(["zero", "one"][2 - n:]), listed(["zero"] * n), items)))
        out.append("Lemma %s_ok : certificate_ok %s = true.\nProof. vm_cast_no_check (eq_refl true). Qed." % (self.name, self.name))
        out.append("Lemma %s_claims : all_claims (items %s) = %s.\nProof. reflexivity. Qed." % (self.name, self.name, listed(claims)))
        return "\n".join(out + [self.lemma(k) for k in (["exp"] if n == 1 else ["sin", "cos"])])

    def fact(self, kind):
        low, high = self.bounds(kind)
        return "%s <= %s (%s) <= %s" % (real(Fraction(low, 2**self.bits)), kind, real(self.argument), real(Fraction(high, 2**self.bits)))

    def lemma(self, kind):
        k = 1 if kind == "cos" else 0
        claim = "%s_claim_%d" % (self.name, k)
        there = "ltac:(rewrite %s_claims; simpl; auto)" % self.name
        if kind == "exp":
            use = "exponential_values %s %s (%d) ltac:(%s; reflexivity) %s_ok eq_refl eq_refl eq_refl eq_refl %s eq_refl" % (
                self.name, claim, self.sign, "left" if self.sign > 0 else "right", self.name, there)
            turn = "replace (%d * %s)%%R with (%s)%%R in P by lra." % (self.sign, real(self.time), real(self.argument))
        else:
            use = "circle_values %s %s %s_ok eq_refl eq_refl eq_refl eq_refl %s" % (self.name, claim, self.name, there)
            turn = "" if self.sign > 0 else "replace (%s)%%R with (- %s)%%R by lra. rewrite %s_neg." % (
                real(self.argument), real(self.time), kind)
        return ("Lemma %s_%s : (%s)%%R.\nProof.\n  assert (P := %s).\n"
                "  assert (T : (claim_time %s = %s)%%R) by (unfold claim_time; simpl; lra).\n"
                "  rewrite T in P. unfold claim_holds, functions in P. simpl in P. %s lra.\nQed." % (
                    self.name, kind, self.fact(kind), use, claim, real(self.time), turn))
