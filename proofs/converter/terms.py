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
