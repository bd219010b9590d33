#!/usr/bin/env python3
"""attack.py [--mutations N] [--seed S] CERTIFICATE...: tests of check/libration_check.py.

Each certificate must be accepted as it is. Then: certificates made false on purpose must be refused; certificates of
which one radius is lowered until they are just refused must be accepted just above; each condition of the checker is
switched off in turn, and at least one false certificate must then be accepted, which shows that the tests see the
condition; and N certificates with one character changed must be refused or have a statement that is true.
"""
import argparse
import math
import pathlib
import random
import re
import sys
import types
import zlib
from fractions import Fraction

sys.dont_write_bytecode = True
import roots  # noqa: E402
import zeros  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CHECKER = HERE.parents[1] / "check" / "libration_check.py"
SOURCE = CHECKER.read_text()

# Conditions: (name, text of the checker, the text with which the condition always holds). That radii are >= 0 follows
# from the others: the first one by the start, the last one by the growth at one of the ends, depending on the sign of
# the rate.
CONDITIONS = [
    ("V is invertible", "need(2 * q <= one,", "need(True,"),
    ("start and joint", "need(total <= self.R0[b] << self.bits,", "need(True,"),
    ("gap of the centres", "total = size_of(gap, rows, [0]) << self.bits", "total = 0"),
    ("old set", "total += sum(size_of(turned, rows, c) * radius for c, radius in zip(blocks, radii))", "pass"),
    ("growth at the left end", '(("left", self.R0), ("right", self.R1))', '(("right", self.R1),)'),
    ("growth at the right end", '(("left", self.R0), ("right", self.R1))', '(("left", self.R0),)'),
    ("defect", "growth = size_of(defect, rows, [0]) << self.bits", "growth = 0"),
    ("change of the derivative", "change_of_J[i][j - 1] += count * self.up(", "change_of_J[i][j - 1] += 0 * self.up("),
    ("V' in the frame", "scaled(derivative(self.V[i][j]), minus)", "[]"),
    ("claim", 'need(within, "the value', 'need(True, "the value'),
    ("lower end of a claim", "claim.low <= centre - reach and ", ""),
    ("upper end of a claim", " and centre + reach <= claim.high", ""),
    ("a claim is in a step", "done = progress.claims == len(problem.claims) and ", "done = "),
    ("text behind the end", 'form(reader.lines[reader.at:] == ["end", ""],', "form(True,"),
    ("names are different", "form(name not in self.names,", "form(True,"),
    ("names without primes", "good and name not in", "name not in"),
    ("definitions in equations", "right.append(algebra.of(Parser(text).tree, names))",
     "right.append(algebra.of(Parser(text).tree, in_definitions))"),
    ("functions of a start", 'form(kind in RULES, "unknown', 'form(True, "unknown'),
    ("start of quotients", "need(x[0] > 0 or x[1] < 0,", "need(True,"),
] + zeros.CONDITIONS + roots.CONDITIONS


def checker(old="", new=""):
    if old and SOURCE.count(old) != 1:
        sys.exit("the checker does not contain '%s' once" % old)
    module = types.ModuleType("checker")
    exec(compile(SOURCE.replace(old, new) if old else SOURCE, str(CHECKER), "exec"), module.__dict__)
    return module


def accepted(module, text):
    try:
        return module.check(text)
    except Exception:
        return None


class Parts:
    """A certificate by lines: those of the head, those of each step, and what follows the last one. The heads of further
    certificates are parts of the steps before them."""

    def __init__(self, text):
        lines = text.split("\n")
        end = max(i for i, x in enumerate(lines) if x == "end")
        starts = [i for i, x in enumerate(lines) if x.startswith("step ")] + [end]
        self.head, self.steps = lines[:starts[0]], [lines[a:b] for a, b in zip(starts, starts[1:])]
        self.rest = lines[end:]

    def text(self):
        return "\n".join(self.head + [x for step in self.steps for x in step] + self.rest)

    def copy(self):
        return Parts(self.text())


def place(step, word, below=0):
    return next(i for i, x in enumerate(step) if x.split(" ")[0] == word) + below


def edited(parts, number, word, below, edit):
    """With the integers of a line of a step edited: edit(list) -> list."""
    result = parts.copy()
    step = result.steps[number]
    at = place(step, word, below)
    step[at] = " ".join("%x" % x for x in edit([int(x, 16) for x in step[at].split()]))
    return result


def false_certificates(parts):
    """(name, text) of certificates whose statement is false or not proved by them."""
    middle = len(parts.steps) // 2
    claims = [i for i, x in enumerate(parts.head) if x.startswith("claim ")]
    for i in claims:
        word, time, name, low, high = parts.head[i].split(" ")
        if time.startswith("#"):
            continue
        digits = Fraction(high) - Fraction(low)
        for what, ends in (("above", (Fraction(high), Fraction(high) + 9)), ("below", (Fraction(low) - 9, Fraction(low))),
                           ("empty", (Fraction(high) + digits, Fraction(low) - digits))):
            changed = parts.copy()
            changed.head[i] = "claim %s %s %s" % (time, name, " ".join(str(x) for x in ends))
            yield "claim " + what, changed.text()
        changed = parts.copy()
        changed.head[i] = " ".join([word, str(Fraction(time) * 10**6), name, low, high])
        yield "claim at a later time", changed.text()
    for i, line in enumerate(parts.head):
        changed = parts.copy()
        if line.startswith("start "):
            changed.head[i] = line + " + 1/1000"
            yield "other start", changed.text()
        if line.startswith("equation "):
            changed.head[i] = line + " + 1/1000"
            yield "other equation", changed.text()
        if line.startswith("define "):
            for old, new in (("sin", "cos"), ("cos", "sin"), ("exp", "log"), (" = 1/", " = 2/")):
                if old in line:
                    changed.head[i] = line.replace(old, new)
                    yield "other definition", changed.text()
    yield from zeros.false_certificates(parts)
    yield "text behind the end", parts.text() + "more"
    for bits in range(10, 100, 10):                      # growth is linear but for the change of the derivative
        changed = parts.copy()
        changed.head = [" ".join(x.split(" ")[:3] + ["-1e99", "1e99"]) if x.startswith("claim ") else x
                        for x in changed.head]
        for number in range(len(changed.steps)):
            for end in (1, 2):
                changed = edited(changed, number, "radii", end, lambda x: [y << bits for y in x])
        yield "radii times 2^%d" % bits, changed.text()
    if len(parts.steps) > 1:
        changed = parts.copy()
        del changed.steps[middle]
        changed.head[-1] = "steps %d" % len(changed.steps)
        yield "a step left out", changed.text()
    for number in {0, middle, len(parts.steps) - 1}:
        step = parts.steps[number]
        blocks, n = len(step[place(step, "blocks")].split()) - 1, len(step[place(step, "scale")].split()) - 1
        for b in range(blocks):
            for end in (1, 2):
                for factor in (Fraction(1, 2), Fraction(1, 10**6), Fraction(0), Fraction(-1), Fraction(2), Fraction(10**6)):
                    def change(x, b=b, factor=factor):
                        return [math.floor(y * factor) if j == b else y for j, y in enumerate(x)]
                    yield "radius %d times %s" % (end, factor), edited(parts, number, "radii", end, change).text()
                    both = edited(edited(parts, number, "radii", 1, change), number, "radii", 2, change)
                    yield "both radii times %s" % factor, both.text()
        for i in range(n):
            for bits in (20, 50, 80):
                yield "p with another constant", edited(parts, number, "p", 1 + i, lambda x: [x[0] + (x[0] >> bits) + 1] + x[1:]
                                                        if x else [1]).text()
                yield "p with another slope", edited(parts, number, "p", 1 + i, lambda x: x[:1] + [x[1] + (x[1] >> bits) + 1] + x[2:]
                                                     if len(x) > 1 else [1, 1]).text()
        for word in ("V", "U"):
            for i in range(n * n):
                yield word + " doubled", edited(parts, number, word, 1 + i, lambda x: [2 * y for y in x]).text()
        yield "another length", edited(parts, number, "step", 1, lambda x: [2 * x[0]]).text()


# ------------------------------------------------------------------------------------- certificates made for a purpose
HEAD = "libration-certificate 1\nvariable t\nat 0\n"


def exponential(length, radii, growth=1, claim="0 1000000", frame="V 0\n1", inverse="U 0\n1", size=80,
                start="1", middle=1):
    """One step for y' = y, y(0) = `start`, with the Taylor polynomial of `middle` exp(growth t) as curve."""
    bits = 300
    powers, term = [], Fraction(1)
    for k in range(size):                                # exp(g h/2 (1 + x)) = exp(g h/2) sum (g h x/2)^k/k!
        powers.append(term)
        term = term * growth * length / 2 / (k + 1)
    chebyshev = [sum(powers[k] * math.comb(k, (k - j) // 2) / Fraction(2)**(k - 1 if j else k)
                     for k in range(j, size, 2)) * sum(powers) for j in range(size)]
    lists = [round((c / 2 if j else c) * middle * 2**bits) for j, c in enumerate(chebyshev)]
    return HEAD + "\n".join([
        "equation y' = y", "start " + start, "bits 400 500", "claim %s y %s" % (length, claim), "steps 1", "step 4",
        "%x" % int(length * 16), "scale 0", "blocks 1", "p %d" % bits, " ".join("%x" % x for x in lists), frame, inverse,
        "radii 200", "%x" % radii[0], "%x" % radii[1], "end", ""])


def constant(start, definition, exponent=0):
    """One step for y' = 0 with an added unknown, in a tube about (y(0), 0) of the radii 1 and 2^exponent."""
    return HEAD + "\n".join([
        "equation y' = 0", "start " + start, "define _1 = " + definition, "bits 100 200", "claim 1 y -9 9", "steps 1",
        "step 0", "1", "scale 0 0", "blocks 1 1", "p 0", "", "", "V 0 0", "1", "", "", "1",
        "U 0 0", "1", "", "", "1", "radii 0 %d" % -exponent, "1 1", "1 1", "end", ""])


def without_frame():
    """a' = 0 and b' = 1 with b = 5 as curve, V = diag(1, 0) and U = diag(3, 0): no error of b is seen."""
    return HEAD + "\n".join([
        "equation a' = 0", "equation b' = 1", "start 1", "start 0", "bits 100 200", "claim 1 b 4 6", "steps 1", "step 0",
        "1", "scale 0 0", "blocks 1 1", "p 0", "1", "5", "V 0 0", "1", "", "", "", "U 0 0", "3", "", "", "", "radii 0 0",
        "0 0", "0 0", "end", ""])


def with_time_for_unknown():
    """y = t^2/2 as curve of a' = 0, y' = a, a(0) = 5, where the variable is called a, too."""
    return HEAD.replace("variable t", "variable a") + "\n".join([
        "equation a' = 0", "equation y' = a", "start 5", "start 0", "bits 100 200", "claim 1 y 0 1", "steps 1", "step 0",
        "1", "scale 0 0", "blocks 1 1", "p 5", "a0", "6 4 1", "V 0 0", "1", "", "", "1", "U 0 0", "1", "", "", "1",
        "radii 0 0", "0 0", "0 0", "end", ""])


def two_equations():
    """x = 1 and x = t as curves of x' = 0 and x' = 1."""
    return HEAD + "\n".join([
        "equation x' = 0", "equation x' = 1", "start 1", "start 0", "bits 100 200", "claim 1 x 0 2", "steps 1", "step 0", "1",
        "scale 0 0", "blocks 1 1", "p 5", "20", "10 8", "V 0 0", "1", "", "", "1", "U 0 0", "1", "", "", "1", "radii 0 0",
        "0 0", "0 0", "end", ""])


def made_certificates():
    unit = 1 << 200
    yield "a singular V", without_frame()
    yield "a moving V", exponential(Fraction(1, 4), (unit, 5 * unit), 1, "-100 100", "V 1\n4 -1", "U 1\n1")
    known = exponential(Fraction(1, 4), (unit, 5 * unit), claim="-100 100")
    yield "a function that is not known", known.replace("start 1", "start tan(1)")
    yield "a function that is not known, of a constant", constant("tan(1)", "exp(y)", 2)
    yield "the inverse of 0", constant("pi - pi", "1/y", 900)
    yield "two meanings of a name", constant("1", "1/y").replace("variable t", "variable y")
    yield "the variable for an unknown", with_time_for_unknown()
    yield "two equations for an unknown", two_equations()
    for path in sorted((HERE / "forged").glob("*.cert")):
        yield path.name, read(path)


# ------------------------------------------------------------------------------------------------------------- tests
def boundary(module, parts):
    """The first radius of each block of a step, lowered by halving until it is just refused."""
    found = 0
    for number in {0, len(parts.steps) // 2}:
        step = parts.steps[number]
        for b in range(len(step[place(step, "blocks")].split()) - 1):
            def with_radius(value, number=number, b=b):
                changed = edited(parts, number, "radii", 2, lambda x: [value if j == b else y for j, y in enumerate(x)])
                return accepted(module, changed.text())
            high = int(step[place(step, "radii", 2)].split()[b], 16)
            low = 0
            if with_radius(low):
                continue
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (low, middle) if with_radius(middle) else (middle, high)
            found += 1
            yield "boundary", edited(parts, number, "radii", 2, lambda x: [low if j == b else y for j, y in enumerate(x)]).text()
    if not found:
        sys.exit("no boundary was found")


def changed_texts(text, count, source):
    """One character of a word or number changed."""
    places = [i for i, x in enumerate(text) if x.isalnum()]
    for _ in range(count):
        at = source.choice(places)
        yield text[:at] + source.choice([x for x in "0123456789abcdef" if x != text[at]]) + text[at + 1:]


def mutations(module, text, statement, count, source):
    """Changed texts are refused, or accepted with the same or another true statement."""
    refused = same = other = 0
    head = text[:text.index("\nbits ")]
    for changed in changed_texts(text, count, source):
        found = accepted(module, changed)
        if found is None:
            refused += 1
        elif found == statement:
            same += 1
        elif changed.startswith(head):                   # another claim about the same problem
            other += 1
            for mine, theirs in zip(intervals(statement), intervals(found)):
                if not (theirs[0] <= mine[1] and mine[0] <= theirs[1]):
                    sys.exit("FALSE: accepted with a claim that excludes the value:\n" + found)
        else:
            if found.count("=") != statement.count("=") or not names_only(head, changed):
                sys.exit("FALSE: accepted for another problem:\n" + found)
            other += 1
    print("mutations: %d refused, %d with the same statement, %d with another true one" % (refused, same, other))


def names_only(head, changed):
    """Whether the problem of a changed certificate is the same but for names and unused text."""
    def plain(x):
        return [y for y in x if not y.startswith(("variable", "define"))]
    return plain(head.split("\n")) == plain(changed[:changed.index("\nbits ")].split("\n"))


def intervals(statement):
    """Those of values and of the unknowns of a root."""
    return [[Fraction(a), Fraction(b)] for a, b in re.findall(r" in \[([^],]*), ([^]]*)\]", statement)]


def read(path):
    return zlib.decompress(pathlib.Path(path).read_bytes()).decode()


def attacks_on(whole, texts):
    """(name, text) of certificates that are false or not proved, made from true ones and for a purpose."""
    attacks = list(made_certificates())
    for text in texts:
        parts = Parts(text)
        attacks += list(false_certificates(parts)) + list(boundary(whole, parts))
    attacks += zeros.made_certificates(accepted, whole, exponential)
    attacks += roots.made_certificates(accepted, whole)
    # A larger radius may be proved as well: those certificates are true.
    return [(name, text) for name, text in attacks if accepted(whole, text) is None]


def first_accepted(conditions, attacks, checker_without):
    """Prints which attack each checker without one condition accepts; the names of conditions that no attack shows."""
    unseen, late = [], [x[0] for x in zeros.CONDITIONS + roots.CONDITIONS]
    for condition in conditions:
        weaker = checker_without(condition)
        order = attacks[::-1] if condition[0] in late else attacks
        passed = next((what for what, text in order if weaker(text)), None)
        print("without '%s': %s" % (condition[0], "accepts '%s'" % passed if passed else "NOTHING MORE IS ACCEPTED"))
        if not passed:
            unseen.append(condition[0])
    return unseen


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--mutations", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("certificates", nargs="+")
    asked = parser.parse_args()
    whole, source = checker(), random.Random(asked.seed)
    good = accepted(whole, exponential(Fraction(1, 2), (1 << 100, 1 << 120), claim="1.6487212 1.6487213"))
    texts = [read(path) for path in asked.certificates]
    for text in texts:
        mutations(whole, text, whole.check(text), asked.mutations, source)
    attacks = attacks_on(whole, texts)
    print("%d certificates that are refused" % len(attacks))

    def checker_without(condition):
        weaker = checker(*condition[1:])
        return lambda text: accepted(weaker, text)
    unseen = first_accepted(CONDITIONS, attacks, checker_without)
    if unseen or not good:
        sys.exit("conditions that no test sees: %s; certificate made by hand: %s" % (", ".join(unseen), bool(good)))


if __name__ == "__main__":
    main()
