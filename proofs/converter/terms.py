"""Numbers, polynomials and formulas as text of Coq."""
import functools
import pathlib
import re
import sys
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "check"))
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


def definition(name, kind, value):
    return "Definition %s : %s := %s." % (name, kind, value)


def cases(i, tactics):
    """One tactic for each of the numbers i < n."""
    n = len(tactics)
    return "destruct %s as %s; [%s | exfalso; lia]" % (i, "[|" * n + i + "]" * n, " | ".join(tactics))


# Names of the text that the converter writes, of what it uses of the files of proofs/, and of Coq.
RESERVED = re.compile(
    r"[A-Z]\w*'*|[abijtv]|other_.*|added_\d+|u_\d+|(circle|exp|step|claim)_.*|deriv_.*|eval.*|solution.*|certif.*|claims?.*|"
    r"functions?|right.*|starts?.*|equations.*|data.*|zero|one|exactly|quotient|unknowns|items|all_claims|box|initial.*|"
    r"begin_time|final_time|in_\w+|slope|below|listed|num|"
    r"exp|ln|log|sin|cos|tan|sqrt|pow|up|real|add|mul|sub|opp|abs|fst|snd|pair|nil|cons|nth|list|nat|bool|true|false|negb|"
    r"fun|in|at|as|if|is|then|else|let|match|end|return|with|for|using|where|fix|cofix|forall|exists|mod|conjuncts|lra|lia")


def identifier(name):
    """A name of Coq that is none of the text around it: with the_ before it, if it would be."""
    if re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*'*", name) and not RESERVED.fullmatch(name):
        return name
    return "the_" + name


def real(x):
    """A fraction as a real number of Coq."""
    top = "%d" % x.numerator if x >= 0 else "(%d)" % x.numerator
    return top if x.denominator == 1 else "(%s / %d)" % (top, x.denominator)


def formula_text(tree, names, functions=()):
    """A formula of the certificate as a term of Coq; `names`: the terms of the variable and of the unknowns."""
    def text(part):
        return formula_text(part, names, functions)
    if isinstance(tree, Fraction):
        return real(tree)
    if isinstance(tree, str):
        return names[tree]
    if tree[0] == "+":
        parts = [text(part) if sign == "+" else "(-1) * %s" % text(part) for sign, part in tree[1]]
        return "(%s)" % " + ".join(parts)
    if tree[0] == "*":
        if any(sign == "/" and not isinstance(part, Fraction) for sign, part in tree[1]):
            raise NotCovered("a quotient by an unknown")
        return "(%s)" % "".join((" %s " % sign if k else "") + text(part) for k, (sign, part) in enumerate(tree[1]))
    if tree[0] == "^":
        if tree[2].denominator > 1 or tree[2] < 0:
            raise NotCovered("the power %s" % tree[2])
        return "(%s ^ %d)" % (text(tree[1]), tree[2])
    own = {x: {(k,): Fraction(1)} for k, x in enumerate(names)}
    u = checker.Algebra().of(tree[1], own)
    found = [f for f in functions if f.kind == tree[0] and f.u == u]
    if not found:
        raise NotCovered("the function '%s'" % tree[0])
    return "(%s)" % found[0].text(list(names.values()))


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
