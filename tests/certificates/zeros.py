"""Certificates of zeros of a condition that are false or not proved, for attack.py: each is refused for one reason."""
import math
from fractions import Fraction

# Conditions: (name, text of the checker, the text with which the condition always holds).
CONDITIONS = [
    ("one condition", 'reader.all("condition", 1)', 'reader.all("condition", 2)'),
    ("all zeros are in steps", " and progress.interval == len(progress.intervals)", ""),
    ("a sign between zeros", "need(alternate,", "need(True,"),
    ("signs alternate", "alternate = sign and self.sign in (0, sign)", "alternate = sign"),
    ("the derivative at a zero", "sign = sure(step, 1, u, v) if k % 2 else",
     "sign = self.sign * (-1) ** ((k + 1) // 2) if k % 2 else"),
    ("bound of the slope", "abs(middle) > slope * (v - u) / 2 + reach", "abs(middle) > reach"),
    ("distance of the tube", "abs(middle) > slope * (v - u) / 2 + reach", "abs(middle) > slope * (v - u) / 2"),
    ("change of the condition", "changes[i - n] += self.up(abs(c) * change(m))", "pass"),
    ("a sign over the whole part", " and (way or sure(step, 0, u, v))", ""),
    ("a sign at the right end", "if left == sure(step, 0, v, v) and (", "if ("),
    ("the condition is 0 at the start", "problem.zero_start = exact and total == 0", "problem.zero_start = exact"),
    ("an exact start", "exact = all(ends[k][0] == ends[k][1] for m in g for k in m)", "exact = True"),
    ("values move at a zero", "norm(derivative(step.p[i])) * half * unit", "0 * unit"),
    ("the frame moves at a zero", "abs(value(a, x)) + norm(derivative(a)) * half", "abs(value(a, x))"),
    ("radii change at a zero", " + math.ceil(abs(b - a) * half / 2)", ""),
]


def with_zeros(text, conditions, zeros, claims):
    """A certificate with other claims, and with zeros."""
    text = text.replace("\nbits ", "".join("\ncondition " + g for g in conditions) + "\nbits ")
    lines = ["zero %s %s" % x for x in zeros] + ["claim %s %s %s %s" % x for x in claims]
    return text[:text.index("claim ")] + "\n".join(lines) + text[text.index("\nsteps"):]


def log_between(x, digits):
    """Decimals with that many digits on both sides of log(x), 1 < x < 2, by its series in (x - 1)/(x + 1)."""
    z = (x - 1) / (x + 1)
    units = math.floor(2 * sum(z**k / k for k in range(1, 8 * digits, 2)) * 10**digits)
    return "%de-%d" % (units - 1, digits), "%de-%d" % (units + 2, digits)


def linear(start, condition, zero):
    """One step for y' = -1 with a constant radius, y(0) at the decimal `start` within 2^-180."""
    bits = 200
    middle = round((Fraction(start) - Fraction(1, 2)) * 2**bits)
    return "\n".join([
        "libration-certificate 1", "variable t", "at 0", "equation y' = -1", "start pi", "condition " + condition,
        "bits 300 400", "zero %s %s" % zero, "claim #1 y 2 4", "steps 1", "step 0", "1", "scale 0", "blocks 1",
        "p %d" % bits, "%x %x" % (middle, -2**(bits - 2)), "V 0", "1", "U 0", "1", "radii 180", "1", "1", "end", ""])


def narrowest(accepted, whole, make):
    """The certificate with claims half a width apart that is just refused, make(width) with whole numbers of 2^-60."""
    low, high = 0, 1 << 60
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if accepted(whole, make(Fraction(middle, 1 << 60))) else (middle, high)
    return make(Fraction(low, 1 << 60))


def made_certificates(accepted, whole, exponential):
    """(name, text); `exponential` makes a step of y' = y, y(0) = 1."""
    step = exponential(Fraction(1, 2), (1 << 100, 1 << 120), size=24)
    at = {x: log_between(Fraction(x), 20) for x in ("11/10", "6/5", "5/4", "13/10")}
    wide = [("#1", "y", 0, 9)]

    def of(conditions, zeros, claims=wide):
        return with_zeros(step, conditions, zeros, claims)
    good = of(["(y - 6/5)*(y - 5/4)"], [at["6/5"], at["5/4"]])
    if not accepted(whole, good):
        raise SystemExit("zeros.py: the true certificate is refused")
    yield "a zero is missing", of(["(y - 6/5)*(y - 5/4)"], [at["5/4"]])
    yield "two zeros are missing", of(["(y - 6/5)*(y - 61/50)*(y - 13/10)"], [at["13/10"]])
    yield "no condition", of([], [at["5/4"]])
    yield "two conditions", of(["y - 5/4", "y - 6/5"], [at["5/4"]])
    yield "no zero", of(["y - 5/4"], [("1e-1", "2e-1")])
    yield "no zero behind one", of(["y - 5/4"], [at["5/4"], ("0.3", "0.4")])
    yield "a zero before the interval", of(["y - 5/4"], [("3e-1", "4e-1")])
    yield "three zeros in one interval", of(["(y - 6/5)*(y - 5/4)*(y - 13/10)"], [("0.17", "0.28")])
    yield "a zero before the start", of(["y - 5/4"], [("-2", "-1")], [("1/4", "y", 0, 9)])
    yield "a zero behind the end", of(["y - 5"], [("1.6", "1.7")], [("1/4", "y", 0, 9)])
    yield "too narrow an interval", of(["y - 5/4"], [log_between(Fraction(5, 4), 40)])
    yield "a zero that is taken for the start", of(["(y - 11/10)*(13/10 - y)"], [at["13/10"]])
    yield "a zero directly after an exact start", of(["(y - 1 - 1/10^20)*(y - 5/4)"], [at["5/4"]])
    low = Fraction(whole.Enclosures(400).pi()[0])
    middle = str(low.limit_denominator(10**70))
    yield "a zero directly after the start", linear(middle, "(y - %s)*(y - 3)" % low, ("0.1415", "0.1416"))
    moving = exponential(Fraction(1, 4), (1 << 180, 1 << 183), 1, "0 9", "V 4\n10 -1", "U 0\n1", size=24)
    growing = exponential(Fraction(1, 4), (1 << 190, 1 << 194), size=24)
    first, last = Fraction(1, 20), Fraction(1, 5)
    for name, text in (("a moving frame", moving), ("growing radii", growing)):
        def make(width, text=text):
            middle = Fraction("1.1331484530668263")      # exp of the middle of the interval
            return with_zeros(text, ["y - 11/10"], [(first, last)], [("#1", "y", middle - width, middle + width)])
        yield "values at a zero, " + name, narrowest(accepted, whole, make)


def false_certificates(parts):
    """(name, text) for a certificate with zeros, by lines."""
    for i, line in enumerate(parts.head):
        changed = parts.copy()
        if line.startswith("condition "):
            changed.head[i] = line + " + 1/1000"
            yield "another condition", changed.text()
        if line.startswith("zero "):
            ends = [Fraction(x) for x in line.split(" ")[1:]]
            for what, by in (("later", ends[1] - ends[0]), ("earlier", ends[0] - ends[1])):
                changed.head[i] = "zero %s %s" % tuple(x + by for x in ends)
                yield "zero " + what, changed.text()
            del changed.head[i]
            yield "a zero left out", changed.text()
