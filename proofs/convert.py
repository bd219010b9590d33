#!/usr/bin/env python3
"""convert.py CERTIFICATE NAME: writes the Coq text of a certificate of docs/certificates.md to stdout.

Nothing here is trusted: the text states equations, initial values, times and intervals in a readable form, and Coq
proves them from the numbers, or fails. Exit status 1, with one line on stderr, for what the formal proof does not cover.
"""
import functools
import math
import pathlib
import re
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
        factors = ["Unknown %d" % (k - 1) if k else "Time" for k in monomial]
        if c * unit != 1 or not factors:
            factors.insert(0, "Const (%d)" % (c * unit))
        terms.append(functools.reduce("Times ({}) ({})".format, factors))
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
    """A claim whose time is in the step: the place of the time, and the text of the claim."""
    time, low, high = (checker.fraction(c[k]) for k in (0, 2, 3))
    x = (time - begin) / fraction_of(*step.half) - 1
    if not -1 <= x <= 1:
        return None
    place = Fraction(round(x * 2**502), 2**502)
    unit = lcm(low.denominator, high.denominator)
    return num(*dyadic(place)), "Claim (%d) %d %d (%d) (%d) %d" % (
        time.numerator, time.denominator, problem.state.index(c[1]), low * unit, high * unit, unit)


RESERVED = {"R", "t", "a", "b", "i", "v", "exp", "ln", "sin", "cos", "sqrt", "PI", "equations", "starts", "data", "fun", "in",
            "at", "as", "if", "then", "else", "let", "match", "end", "return", "with", "for", "using", "where", "fix",
            "cofix", "forall", "exists", "Prop", "Set", "Type", "pow", "up", "real", "add", "mul", "sub", "opp", "abs"}


def identifier(name):
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*'*", name):
        name = "u" + re.sub("[^A-Za-z0-9_']", "_", name)
    return name + "_" if name in RESERVED else name


def real(x):
    """A fraction as a real number of Coq."""
    top = "%d" % x.numerator if x >= 0 else "(%d)" % x.numerator
    return top if x.denominator == 1 else "(%s / %d)" % (top, x.denominator)


def formula_text(tree, names, functions=()):
    """A formula of the certificate as a term of Coq; `names`: the terms of the variable and of the unknowns."""
    if isinstance(tree, Fraction):
        return real(tree)
    if isinstance(tree, str):
        return names[tree]
    if tree[0] in ("sin", "cos", "exp"):
        own = {x: {(k,): Fraction(1)} for k, x in enumerate(names)}
        u = checker.as_polynomial(tree[1], own, {})
        return "(%s)" % next(f for f in functions if f.kind == tree[0] and f.u == u).text(list(names.values()))
    kind, a = tree[0], formula_text(tree[1], names, functions)
    if kind in "+*":
        return "(%s %s %s)" % (a, kind, formula_text(tree[2], names, functions))
    if kind == "/" and isinstance(tree[2], Fraction):
        return "(%s / %s)" % (a, real(tree[2]))
    if kind == "^" and tree[2].denominator == 1 and tree[2] >= 0:
        return "(%s ^ %d)" % (a, tree[2])
    raise NotCovered("the function or quotient '%s'" % kind)


def polynomial_text(f, terms):
    """A polynomial as a term of Coq; `terms`: those of the variable and of the unknowns."""
    parts = [" * ".join([real(c)] + [terms[k] for k in m]) for m, c in f.items()]
    return " + ".join(parts) if parts else "0"


def evaluated_text(f, terms):
    """The value of an expression as Coq simplifies it."""
    parts = []
    for monomial, c in f.items():
        factors = [terms[k] for k in monomial]
        parts.append(" * ".join(factors if c == 1 and factors else [real(c)] + factors))
    return " + ".join(parts) if parts else "0"


class Function:
    """An added unknown that is sin, cos or exp of a polynomial in the variable and the unknowns of the text."""

    def __init__(self, problem, text, number):
        tree = checker.formula(text)
        own = {x: {(k,): Fraction(1)} for k, x in enumerate([problem.variable] + problem.state)}
        if tree[0] not in ("sin", "cos", "exp"):
            raise NotCovered("the function '%s'" % tree[0])
        self.kind, self.number, self.u = tree[0], number, checker.as_polynomial(tree[1], own, {})
        at = [problem.t0] + [a for a, b in problem.start[:len(problem.state)] if a == b]
        if any(c.denominator != 1 for c in self.u.values()) or len(at) <= len(problem.state):
            raise NotCovered("an argument or an initial value that is not exact")
        self.start = sum((c * math.prod(at[k] for k in m) for m, c in self.u.items()), Fraction(0))
        if abs(self.start) > 50:
            raise NotCovered("a function of a large initial value")

    def text(self, terms):
        return "%s (%s)" % (self.kind, evaluated_text(self.u, terms))


def functions_of(problem, text):
    """The added unknowns as functions, or None if one of them is not of a kind whose values Coq proves."""
    lines = [x[7:].split(" = ", 1)[1] for x in text.split("\n") if x.startswith("define ")]
    try:
        found = [Function(problem, x, len(problem.state) + k) for k, x in enumerate(lines)]
    except (NotCovered, checker.Refused):
        return None
    sines = [f.u for f in found if f.kind == "sin"]
    return found if sines == [f.u for f in found if f.kind == "cos"] else None


def times_x(a):
    """x times a polynomial a_0 + sum of 2 a_j T_j."""
    a = a + [Fraction(0)] * 2
    return [a[1]] + [(a[k - 1] + a[k + 1]) / 2 for k in range(1, len(a) - 1)]


class FunctionValues:
    """A certificate of sin and cos, or of exp, at a positive fraction: Taylor polynomials in the middles of steps of length 1."""

    def __init__(self, kind, argument, bits, name):
        self.kind, self.argument, self.bits, self.name = kind, argument, bits, name
        self.time, self.sign = abs(argument), 1 if argument >= 0 else -1
        self.steps = max(1, math.ceil(self.time))
        # Radii: exp grows by less than 4 in a step; the norm of the frame of sin and cos, in which joints are bounded, is sqrt(2).
        self.radii, r = [], 1
        for _ in range(self.steps):
            last = (4 if kind == "exp" else 1) * r + 1
            self.radii.append((r, last))
            r = (1 if kind == "exp" else 2) * last + 1
        self.enclosures = checker.Enclosures(bits + 60)

    def values(self, x):
        """The functions at x, in the order of their unknowns, and the constants of their derivatives."""
        kinds = ("sin", "cos") if self.kind != "exp" else ("exp",)
        return [sum(self.enclosures.entire(self.sign * x if k == "exp" else x, k)) / 2 for k in kinds]

    def curve(self, middle):
        """Polynomials of the unknowns at middle + x/2, by their derivatives there."""
        v = self.values(middle)
        turn = (lambda d: [d[1], -d[0]]) if self.kind != "exp" else (lambda d: [self.sign * d[0]])
        rows, size = [], Fraction(1)
        while size * 2**(self.bits + 40) > 1:
            rows.append([x * size for x in v])
            v, size = turn(v), size / (2 * len(rows))
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
            out.append(definition("%s_step_%d" % (self.name, k), "step", "Step (1%%bigZ, (-1)) %s %s %s %s%%nat 1%%nat [%s] [%s]" % (
                listed(self.curve(k + Fraction(1, 2)), ";\n  "), one, one, listed(["0"] * n), num(first, -self.bits), num(last, -self.bits))))
            entries.append("(%s_step_%d, " % (self.name, k))
        place = Fraction(round((2 * (self.time - self.steps + 1) - 1) * 2**502), 2**502)
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
            turn = "" if self.sign > 0 else "replace (%s)%%R with (- %s)%%R by lra. rewrite %s_neg." % (real(self.argument), real(self.time), kind)
        return ("Lemma %s_%s : (%s)%%R.\nProof.\n  assert (P := %s).\n  assert (T : (claim_time %s = %s)%%R) by (unfold claim_time; simpl; lra).\n"
                "  rewrite T in P. unfold claim_holds, functions in P. simpl in P. %s lra.\nQed." % (
                    self.name, kind, self.fact(kind), use, claim, real(self.time), turn))


class Statement:
    """The readable theorem: equations, initial values, claims; and its proof from `data`. With added unknowns it is about the
    equations of the text if `functions` gives them all, and otherwise about the polynomial form."""

    def __init__(self, problem, unit, ordered, functions):
        self.problem, self.unit, self.n, self.ordered = problem, unit, len(problem.right), ordered
        self.functions = functions or []
        count = len(problem.state) if functions is not None else self.n
        names = problem.state + ["added_%d" % (k + 1) for k in range(count - len(problem.state))]
        self.names = [identifier(x) for x in names]
        if len(set(self.names)) != count:
            raise NotCovered("names that Coq would confuse")
        self.polynomial_form = count > len(problem.state)
        self.first, self.last = problem.t0, max(checker.fraction(c[0]) for c in problem.claims)
        self.values = {}
        for f in self.functions:
            key = "exp" if f.kind == "exp" else "circle", f.start
            if key not in self.values:
                self.values[key] = FunctionValues(f.kind, f.start, problem.bits - 64, "%s_%d" % (key[0], len(self.values)))
            f.source = self.values[key]

    def right_sides(self):
        if self.polynomial_form:
            return [polynomial_text(f, ["t"] + ["(%s t)" % x for x in self.names]) for f in self.problem.right]
        terms = ["t"] + ["%s t" % x for x in self.names]
        table, result = dict(zip([self.problem.variable] + self.problem.state, terms)), []
        for name, text in self.problem.equations:
            base, order = name.rstrip("'"), name.count("'")
            result += [table[base + "'" * k] for k in range(1, order)]
            result.append(formula_text(checker.formula(text), table, self.functions))
        return result

    def initial(self, k):
        """The initial value of unknown k as an exact fraction, or an interval."""
        low, high = self.problem.start[k]
        if k < len(self.problem.state) and low == high:
            return low, low
        if self.functions and k >= len(self.names):
            f = self.functions[k - len(self.names)]
            return [Fraction(x, 2**f.source.bits) for x in f.source.bounds(f.kind)]
        unit = 2**self.problem.bits
        return Fraction(math.floor(low * unit), unit), Fraction(math.ceil(high * unit), unit)

    def starts(self):
        at = real(self.first)
        for k, name in enumerate(self.names):
            low, high = self.initial(k)
            yield "%s %s = %s" % (name, at, real(low)) if low == high else "%s <= %s %s <= %s" % (real(low), name, at, real(high))

    def box(self):
        for k in range(self.n):
            low, high = self.initial(k)
            unit = lcm(low.denominator, high.denominator)
            yield "Initial (%d) (%d) %d" % (low * unit, high * unit, unit)

    def value(self, k):
        if self.functions and k >= len(self.names):
            f = self.functions[k - len(self.names)]
            return "%s (%s)" % (f.kind, real(f.start))
        low, high = self.initial(k)
        return real((low + high) / 2)

    def claims(self):
        for time, name, low, high in self.ordered:
            low, high, time = (checker.fraction(x) for x in (low, high, time))
            yield "%s <= %s %s <= %s" % (real(low), identifier(name), real(time), real(high))

    def full(self, prefix):
        """The functions of all unknowns, for unknowns of the statement with a prefix."""
        terms = ["t"] + ["%s%s t" % (prefix, x) for x in self.names]
        return listed([prefix + x for x in self.names] + ["(fun t => %s)" % f.text(terms) for f in self.functions])

    def solving(self):
        """The proof that the functions solve the polynomial form."""
        steps = ["(eapply deriv_eq; [|eassumption]); unfold right, functions; simpl; field"] * len(self.names)
        before = ""
        if self.functions:
            rights = listed("(%s)" % x for x in self.right_sides())
            before = "assert (D : forall j, (j < %d)%%nat -> deriv_on a b (functions %s j) t (nth j %s 0)).\n  { intros j Hj. %s. }\n  " % (
                len(self.names), listed(self.names), rights, cases("j", ["exact H%d" % k for k in range(len(self.names))]))
        for f in self.functions:
            steps.append("eapply deriv_eq; [|exact (deriv_%s a b _ t _ (eval_deriv %d a b (functions %s) (fun j => nth j %s 0) t u_%d eq_refl D))];\n"
                         "    unfold right, functions, u_%d; simpl; field" % (f.kind, len(self.names), listed(self.names), rights, f.number, f.number))
        return before + cases("i", steps)

    def returning(self):
        """The proof that a solution of the polynomial form, with the initial values of the functions, solves the equations."""
        conclusion = "equations a b %s" % " ".join("(y %d%%nat)" % k for k in range(len(self.names)))
        form = "a <= b -> solution %d (%d) right_sides a b y ->" % (self.n, self.unit)
        starts = " ".join("y %d%%nat a = %s (eval a (fun j => y j a) u_%d) ->" % (f.number, f.kind, f.number) for f in self.functions)
        out = ["Lemma solution_equations a b y : %s %s\n  %s." % (form, starts, conclusion), "Proof."]
        out.append("  intros Hab H %s t Ht." % " ".join("F%d" % f.number for f in self.functions))
        if self.functions:
            out.append("  assert (D : forall e, below %d e = true -> forall z, a <= z <= b -> deriv_on a b (fun s => eval s (fun j => y j s) e) z\n"
                       "    (slope z (fun j => y j z) (fun j => eval z (fun l => y l z) (right right_sides j) / IZR (%d)) e)).\n"
                       "  { intros e He z Hz. apply (eval_deriv %d); [exact He | intros j Hj; apply H; auto]. }" % (self.n, self.unit, self.n))
        cosines = [f for f in self.functions if f.kind == "cos"]
        for f in self.functions:
            k = f.number
            equation = "intros z Hz; (eapply deriv_eq; [|apply H; [lia | exact Hz]]); unfold right, u_%d; simpl; field" % k
            if f.kind == "sin":
                m = next(g for g in cosines if g.u == f.u).number
                out.append("  destruct (sin_cos_at a b (D u_%d eq_refl) (y %d%%nat) (y %d%%nat) Hab) with (t := t) as [E%d E%d];\n"
                           "    [%s | %s | exact F%d | exact F%d | exact Ht |]." % (k, k, m, k, m, equation, equation, k, m))
            elif f.kind == "exp":
                out.append("  assert (E%d : y %d%%nat t = exp (eval t (fun j => y j t) u_%d)).\n"
                           "  { apply (exp_unique a b _ _ (y %d%%nat) Hab (D u_%d eq_refl)); [%s | exact F%d | exact Ht]. }" % (k, k, k, k, k, equation, k))
        for f in self.functions:
            out.append("  unfold u_%d in E%d; simpl in E%d." % ((f.number,) * 3))
        rewriting = "rewrite %s; " % ", ".join("?E%d" % f.number for f in self.functions) if self.functions else ""
        out.append("  conjuncts; (eapply deriv_eq; [|apply H; [lia | exact Ht]]); unfold right; simpl; %sfield." % rewriting)
        return "\n".join(out + ["Qed."])

    def text(self, name):
        n, count, x = self.n, len(self.names), " ".join(self.names)
        a, b = real(self.first), real(self.last)
        at = [real(self.first)] + ["%s %s" % (y, a) for y in self.names]
        zero = " ".join("assert (Z%d : y %d%%nat %s = %s) by (apply (H0 %d%%nat); change (unknowns data) with %d%%nat; lia)." % (
            k, k, a, self.value(k), k, n) for k in range(count))
        known = "rewrite %s; " % ", ".join("?Z%d" % k for k in range(count))
        found = " | ".join("rewrite (H0 %d%%nat) by (change (unknowns data) with %d%%nat; lia); unfold u_%d; simpl; %sfirst [reflexivity | f_equal; lra]" % (
            f.number, n, f.number, known) for f in self.functions)
        parts = {
            "name": name, "n": n, "count": count, "unit": self.unit, "a": a, "b": b, "x": x, "full": self.full(""), "others": self.full("other_"),
            "comment": "(* The polynomial form, with one more unknown for each function. *)\n" if self.polynomial_form else "",
            "each": " /\\\n  ".join("deriv_on a b %s t (%s)" % pair for pair in zip(self.names, self.right_sides())),
            "same": " /\\ ".join("%s t = other_%s t" % (y, y) for y in self.names), "y": " ".join("other_" + y for y in self.names),
            "starts": " /\\ ".join(self.starts()), "claims": " /\\\n    ".join(self.claims()),
            "equal": " /\\ ".join("%s %s = other_%s %s" % (y, a, y, a) for y in self.names),
            "hyps": "destruct (H t Ht) as (%s)" % " & ".join("H%d" % k for k in range(count)) if count > 1 else "assert (H0 := H t Ht)",
            "solving": self.solving(), "returning": self.returning(),
            "bounds": " ".join("assert (B%d := %s_%s)." % (f.number, f.source.name, f.kind) for f in self.functions),
            "places": " ".join("assert (G%d : %s = %s) by (f_equal; lra)." % (f.number, f.text(at), self.value(f.number)) for f in self.functions),
            "box_cases": cases("i", ["unfold in_interval, initial_get, functions; change (box data) with start_box; simpl; lra"] * n),
            "same_cases": cases("i", ["unfold functions; simpl; first [assumption | f_equal; lra]"] * n),
            "values": "match i with %s | _ => 0 end" % " ".join("| %d%%nat => %s" % (k, self.value(k)) for k in range(n)),
            "witness": ", ".join("(y %d%%nat)" % k for k in range(count)), "zero": zero,
            "known": ", ".join("Z%d" % k for k in range(count)),
            "found": "[%s]" % found if found else "idtac",
            "ones": " | ".join("exact (P %d%%nat t ltac:(lia) Ht)" % k for k in range(count)),
            "facts": "\n    ".join("assert (C%d := claim_of _ _ P %d ltac:(simpl; lia) %s ltac:(unfold claim_time; simpl; lra))." % (
                k, k, real(checker.fraction(c[0]))) for k, c in enumerate(self.ordered))}
        return TEMPLATE % parts


def cases(i, tactics):
    """One tactic for each of the numbers i < n."""
    n = len(tactics)
    return "destruct %s as %s; [%s | exfalso; lia]" % (i, "[|" * n + i + "]" * n, " | ".join(tactics))


TEMPLATE = r"""
Open Scope R_scope.

%(comment)sDefinition equations (a b : R) (%(x)s : R -> R) : Prop := forall t, a <= t <= b ->
  %(each)s.
Definition starts (%(x)s : R -> R) : Prop :=
  %(starts)s.

Lemma equations_solve a b %(x)s : equations a b %(x)s -> solution %(n)d (%(unit)d) right_sides a b (functions %(full)s).
Proof.
  intros H i t Hi Ht. %(hyps)s.
  %(solving)s.
Qed.
%(returning)s
Lemma starts_box %(x)s : starts %(x)s -> in_box data (fun i => functions %(full)s i %(a)s).
Proof.
  intros H i Hi. unfold starts in H. change (i < %(n)d)%%nat in Hi. decompose [and] H. %(bounds)s %(places)s
  %(box_cases)s.
Qed.

Theorem %(name)s :
  (* there is a solution, *)
  (exists %(x)s : R -> R, equations %(a)s %(b)s %(x)s /\ starts %(x)s) /\
  (* only one for its initial values, *)
  (forall %(x)s %(y)s : R -> R,
    equations %(a)s %(b)s %(x)s -> starts %(x)s -> equations %(a)s %(b)s %(y)s ->
    %(equal)s ->
    forall t, %(a)s <= t <= %(b)s -> %(same)s) /\
  (* and its values are *)
  (forall %(x)s : R -> R, equations %(a)s %(b)s %(x)s -> starts %(x)s ->
    %(claims)s).
Proof.
  assert (E := certified_existence data data_ok). assert (U := certified_uniqueness data data_ok).
  assert (V := certified_values data data_ok).
  assert (A : quotient (begin_time data) = %(a)s) by (unfold quotient; simpl; lra).
  assert (B : quotient (final_time data) = %(b)s) by (unfold quotient; simpl; lra).
  rewrite A in E, U, V. rewrite B in E, U, V. split; [|split].
  - destruct (E (fun i => %(values)s)) as (y & Hy & H0).
    { intros i Hi. change (i < %(n)d)%%nat in Hi. %(bounds)s
      %(box_cases)s. }
    %(zero)s
    exists %(witness)s. split; [apply (solution_equations %(a)s %(b)s y ltac:(lra) Hy); %(found)s|].
    unfold starts. rewrite %(known)s. conjuncts; lra.
  - intros %(x)s %(y)s H S H' S' t Ht.
    assert (S2 : forall i, (i < %(n)d)%%nat -> functions %(full)s i %(a)s = functions %(others)s i %(a)s)
      by (decompose [and] S'; intros i Hi; %(same_cases)s).
    assert (P := U _ _ (equations_solve _ _ %(x)s H) (equations_solve _ _ %(y)s H') (starts_box %(x)s S) S2).
    change (unknowns data) with %(n)d%%nat in P.
    conjuncts; [%(ones)s].
  - intros %(x)s H S. assert (P := V _ (equations_solve _ _ %(x)s H) (starts_box %(x)s S)). rewrite claims_listed in P.
    %(facts)s
    unfold claim_holds, functions in *. simpl in *. conjuncts; lra.
Qed.
Print Assumptions %(name)s.
"""


def start_box(problem, statement):
    """Dyadic boxes around the initial values of the statement."""
    scale = 2**(problem.bits + 8)
    for k in range(statement.n):
        low, high = statement.initial(k)
        middle = Fraction(round((low + high) / 2 * scale), scale)
        reach = max(high - middle, middle - low) * scale
        yield middle, Fraction(math.ceil(reach), scale)


def definition(name, kind, value):
    return "Definition %s : %s := %s." % (name, kind, value)


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
    return items, ordered


def convert(text, name):
    r = checker.Reader(text)
    problem = checker.Problem(r)
    unit = lcm(1, *[c.denominator for f in problem.right for c in f.values()])
    items, ordered = read_steps(r, problem)
    statement = Statement(problem, unit, ordered, functions_of(problem, text) if len(problem.right) > len(problem.state) else [])
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
    out.append("Lemma claims_listed : all_claims (items data) = %s.\nProof. reflexivity. Qed." % listed("claim_%d" % k for k in range(count)))
    return "\n".join(out) + "\n" + statement.text(name)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: convert.py CERTIFICATE NAME")
    try:
        print(convert(zlib.decompress(pathlib.Path(sys.argv[1]).read_bytes()).decode(), sys.argv[2]), end="")
    except (NotCovered, checker.Refused, OSError) as reason:
        sys.exit("convert.py: %s is not covered by the formal proof: %s" % (sys.argv[1], reason))


if __name__ == "__main__":
    main()
