"""The readable theorem of a certificate, and its proof."""
import math
from fractions import Fraction
from math import lcm

from converter.functions import FunctionValues
from converter.terms import NotCovered, cases, checker, formula_text, identifier, listed, polynomial_text, real

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


class Statement:
    """The readable theorem: equations, initial values, claims; and its proof from `data`. With added unknowns it is about the
    equations of the text if `functions` gives them all, and otherwise about the polynomial form."""

    def __init__(self, problem, unit, ordered, functions):
        self.problem, self.unit, self.n, self.ordered = problem, unit, len(problem.right), ordered
        self.functions = functions or []
        count = len(problem.state) if functions is not None else self.n
        names = problem.state + ["added_%d" % (k + 1) for k in range(count - len(problem.state))]
        self.names = [identifier(x) for x in problem.state] + names[len(problem.state):]
        both = set(self.names) | {"other_" + x for x in self.names}
        if len(both) != 2 * count:
            raise NotCovered("names that Coq would confuse")
        self.polynomial_form = count > len(problem.state)
        self.first, self.last = problem.t0, max(c.first for c in problem.claims)
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
            result.append(formula_text(checker.Parser(text).tree, table, self.functions))
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
        for c in self.ordered:
            yield "%s <= %s %s <= %s" % (real(c.low), identifier(c.name), real(c.first), real(c.high))

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
            inner = "eval_deriv %d a b (functions %s) (fun j => nth j %s 0) t u_%d eq_refl D" % (
                len(self.names), listed(self.names), rights, f.number)
            steps.append("eapply deriv_eq; [|exact (deriv_%s a b _ t _ (%s))];\n    unfold right, functions, u_%d; simpl; field" % (
                f.kind, inner, f.number))
        return before + cases("i", steps)

    def returning(self):
        """The proof that a solution of the polynomial form, with the initial values of the functions, solves the equations."""
        conclusion = "equations a b %s" % " ".join("(y %d%%nat)" % k for k in range(len(self.names)))
        form = "a <= b -> solution %d (%d) right_sides a b y ->" % (self.n, self.unit)
        starts = " ".join("y %d%%nat a = %s (eval a (fun j => y j a) u_%d) ->" % (f.number, f.kind, f.number) for f in self.functions)
        out = ["Lemma solution_equations a b y : %s %s\n  %s." % (form, starts, conclusion), "Proof."]
        out.append("  intros Hab H %s t Ht." % " ".join("F%d" % f.number for f in self.functions))
        if self.functions:
            out.append("  assert (D : forall e, below %d e = true -> forall z, a <= z <= b ->\n"
                       "    deriv_on a b (fun s => eval s (fun j => y j s) e) z\n"
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
                           "  { apply (exp_unique a b _ _ (y %d%%nat) Hab (D u_%d eq_refl)); [%s | exact F%d | exact Ht]. }" % (
                               k, k, k, k, k, equation, k))
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
        found = " | ".join("rewrite (H0 %d%%nat) by (change (unknowns data) with %d%%nat; lia);\n"
                           "      unfold u_%d; simpl; %sfirst [reflexivity | f_equal; lra]" % (f.number, n, f.number, known)
                           for f in self.functions)
        parts = {
            "name": name, "n": n, "unit": self.unit, "a": a, "b": b, "x": x,
            "full": self.full(""), "others": self.full("other_"),
            "comment": "(* The polynomial form, with one more unknown for each function. *)\n" if self.polynomial_form else "",
            "each": " /\\\n  ".join("deriv_on a b %s t (%s)" % pair for pair in zip(self.names, self.right_sides())),
            "same": " /\\ ".join("%s t = other_%s t" % (y, y) for y in self.names), "y": " ".join("other_" + y for y in self.names),
            "starts": " /\\ ".join(self.starts()), "claims": " /\\\n    ".join(self.claims()),
            "equal": " /\\ ".join("%s %s = other_%s %s" % (y, a, y, a) for y in self.names),
            "hyps": "destruct (H t Ht) as (%s)" % " & ".join("H%d" % k for k in range(count)) if count > 1 else "assert (H0 := H t Ht)",
            "solving": self.solving(), "returning": self.returning(),
            "bounds": " ".join("assert (B%d := %s_%s)." % (f.number, f.source.name, f.kind) for f in self.functions),
            "places": " ".join("assert (G%d : %s = %s) by (f_equal; lra)." % (f.number, f.text(at), self.value(f.number))
                               for f in self.functions),
            "box_cases": cases("i", ["unfold in_interval, initial_get, functions; change (box data) with start_box; simpl; lra"] * n),
            "same_cases": cases("i", ["unfold functions; simpl; first [assumption | f_equal; lra]"] * n),
            "values": "match i with %s | _ => 0 end" % " ".join("| %d%%nat => %s" % (k, self.value(k)) for k in range(n)),
            "witness": ", ".join("(y %d%%nat)" % k for k in range(count)), "zero": zero,
            "known": ", ".join("Z%d" % k for k in range(count)),
            "found": "[%s]" % found if found else "idtac",
            "ones": " | ".join("exact (P %d%%nat t ltac:(lia) Ht)" % k for k in range(count)),
            "facts": "\n    ".join("assert (C%d := claim_of _ _ P %d ltac:(simpl; lia) %s ltac:(unfold claim_time; simpl; lra))." % (
                k, k, real(c.first)) for k, c in enumerate(self.ordered))}
        return TEMPLATE % parts
