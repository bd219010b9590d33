#!/usr/bin/env python3
"""convert.py CERTIFICATE NAME: writes the Coq text of a certificate of docs/certificates.md to stdout.

Nothing here is trusted: the text states equations, initial values, times and intervals in a readable form, and Coq
proves them from the numbers, or fails. Exit status 1, with one line on stderr, for what the formal proof does not cover.
"""
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
    """A claim whose time is in the step: the place of the time, and the text of the claim."""
    time, low, high = (checker.fraction(c[k]) for k in (0, 2, 3))
    x = (time - begin) / fraction_of(*step.half) - 1
    if not -1 <= x <= 1:
        return None
    place = Fraction(round(x * 2**200), 2**200)
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


def formula_text(tree, names):
    """A formula of the certificate as a term of Coq; `names`: the terms of the variable and of the unknowns."""
    if isinstance(tree, Fraction):
        return real(tree)
    if isinstance(tree, str):
        return names[tree]
    kind, a = tree[0], formula_text(tree[1], names)
    if kind in "+*":
        return "(%s %s %s)" % (a, kind, formula_text(tree[2], names))
    if kind == "/" and isinstance(tree[2], Fraction):
        return "(%s / %s)" % (a, real(tree[2]))
    if kind == "^" and tree[2].denominator == 1 and tree[2] >= 0:
        return "(%s ^ %d)" % (a, tree[2])
    raise NotCovered("the function or quotient '%s'" % kind)


def polynomial_text(f, terms):
    """A polynomial as a term of Coq; `terms`: those of the variable and of the unknowns."""
    parts = [" * ".join([real(c)] + [terms[k] for k in m]) for m, c in f.items()]
    return " + ".join(parts) if parts else "0"


class Statement:
    """The readable theorem: equations, initial values, claims; and its proof from `data`."""

    def __init__(self, problem, unit, ordered):
        self.problem, self.unit, self.n, self.ordered = problem, unit, len(problem.right), ordered
        self.added = self.n - len(problem.state)
        names = problem.state + ["added_%d" % (k + 1) for k in range(self.added)]
        self.names = [identifier(x) for x in names]
        if len(set(self.names)) != self.n:
            raise NotCovered("names that Coq would confuse")
        self.first, self.last = problem.t0, max(checker.fraction(c[0]) for c in problem.claims)

    def right_sides(self):
        terms = ["t"] + ["%s t" % x for x in self.names]
        if self.added:
            return [polynomial_text(f, ["t"] + ["(%s t)" % x for x in self.names]) for f in self.problem.right]
        table = dict(zip([self.problem.variable] + self.problem.state, terms))
        result = []
        for name, text in self.problem.equations:
            base, order = name.rstrip("'"), name.count("'")
            result += [table[base + "'" * k] for k in range(1, order)] + [formula_text(checker.formula(text), table)]
        return result

    def initial(self, k):
        """The initial value of unknown k as an exact fraction, or an interval."""
        low, high = self.problem.start[k]
        if k < len(self.problem.state) and low == high:
            return low, low
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
        low, high = self.initial(k)
        return real((low + high) / 2)

    def claims(self):
        for time, name, low, high in self.ordered:
            low, high, time = (checker.fraction(x) for x in (low, high, time))
            yield "%s <= %s %s <= %s" % (real(low), identifier(name), real(time), real(high))

    def text(self, name):
        n, x = self.n, " ".join(self.names)
        other = " ".join("other_" + y for y in self.names)
        pattern = "[|" * n + "i" + "]" * n
        a, b = real(self.first), real(self.last)
        comment = "(* The polynomial form, with one more unknown for each function. *)\n" if self.added else ""
        each = " /\\\n  ".join("deriv_on a b %s t (%s)" % pair for pair in zip(self.names, self.right_sides()))
        same = " /\\ ".join("%s t = other_%s t" % (y, y) for y in self.names)
        values = "match i with %s | _ => 0 end" % " ".join("| %d%%nat => %s" % (k, self.value(k)) for k in range(n))
        values = [self.value(k) for k in range(n)]
        parts = {
            "name": name, "n": n, "unit": self.unit, "a": a, "b": b, "comment": comment, "each": each, "same": same,
            "x": x, "y": other, "list": listed(self.names), "others": listed("other_" + y for y in self.names),
            "x_args": x, "starts": " /\\ ".join(self.starts()), "claims": " /\\\n    ".join(self.claims()),
            "equal": " /\\ ".join("%s %s = other_%s %s" % (y, a, y, a) for y in self.names),
            "cases": "destruct i as %s; [%s | exfalso; lia]" % (pattern, " | " * (n - 1)),
            "hyps": "destruct (H t Ht) as (%s)" % " & ".join("H%d" % k for k in range(n)) if n > 1 else "assert (H0 := H t Ht)",
            "values": "match i with %s | _ => 0 end" % " ".join("| %d%%nat => %s" % x for x in enumerate(values)),
            "picked": " ".join("(y %d%%nat)" % k for k in range(n)), "witness": ", ".join("(y %d%%nat)" % k for k in range(n)),
            "ones": " | ".join("exact (P %d%%nat t ltac:(lia) Ht)" % k for k in range(n)),
            "facts": "\n    ".join("assert (C%d := claim_of _ _ P %d ltac:(simpl; lia) %s ltac:(unfold claim_time; simpl; lra))." % (
                k, k, real(checker.fraction(c[0]))) for k, c in enumerate(self.ordered))}
        return TEMPLATE % parts


TEMPLATE = r"""
Open Scope R_scope.

%(comment)sDefinition equations (a b : R) (%(x)s : R -> R) : Prop := forall t, a <= t <= b ->
  %(each)s.
Definition starts (%(x)s : R -> R) : Prop :=
  %(starts)s.

Lemma equations_solve a b %(x)s : equations a b %(x)s -> solution %(n)d (%(unit)d) right_sides a b (functions %(list)s).
Proof.
  intros H i t Hi Ht. %(hyps)s.
  %(cases)s; (eapply deriv_eq; [|eassumption]); unfold right, functions; simpl; field.
Qed.
Lemma solution_equations a b y : solution %(n)d (%(unit)d) right_sides a b y -> equations a b %(picked)s.
Proof.
  intros H t Ht. conjuncts; (eapply deriv_eq; [|apply H; [lia | exact Ht]]); unfold right; simpl; field.
Qed.
Lemma starts_box %(x)s : starts %(x)s -> in_box data (fun i => functions %(list)s i %(a)s).
Proof.
  intros H i Hi. unfold starts in H. change (i < %(n)d)%%nat in Hi. decompose [and] H.
  %(cases)s; unfold in_interval, initial_get, functions; change (box data) with start_box; simpl; lra.
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
    { intros i Hi. change (i < %(n)d)%%nat in Hi. %(cases)s; unfold in_interval, initial_get; change (box data) with start_box; simpl; lra. }
    exists %(witness)s. split; [apply solution_equations; exact Hy|].
    unfold starts. conjuncts; rewrite H0 by (change (unknowns data) with %(n)d%%nat; lia); lra.
  - intros %(x)s %(y)s H S H' S' t Ht.
    assert (S2 : forall i, (i < %(n)d)%%nat -> functions %(list)s i %(a)s = functions %(others)s i %(a)s)
      by (decompose [and] S'; intros i Hi; %(cases)s; assumption).
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
    statement = Statement(problem, unit, ordered)
    out = ["From Libration Require Import Certificate.", "Local Open Scope Z_scope."]
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
