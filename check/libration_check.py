#!/usr/bin/env python3
"""libration_check.py FILE: proves the statement of a certificate, or rejects it.

A certificate has equations, initial values, claims, and a tube around the solution, step by step.
The conditions from which the claims follow are checked by integers and fractions: exactly, or
rounded to the safe side. The format and the theorems are in docs/certificates.md. Exit status: 0 if
it is proved, 1 if a condition does not hold, 2 if the file is not a certificate of this format.
"""
import itertools
import math
import re
import sys
import zlib
from fractions import Fraction

# -------------------------------------------------------------------------- Limits and reasons
# Each limit is checked before the work that it bounds. Both checkers have the same.
MOST_TEXT = 2**28  # characters of a certificate
MOST_FORMULA, MOST_DIGITS = 100_000, 4000  # characters of a formula, digits of an integer
MOST_NESTING = 150  # signs, exponents and parentheses in one another
MOST_NUMBER = 2**17  # bits of numerators and denominators computed from formulas
MOST_POWER, MOST_START_POWER = 100, 10_000  # whole powers; in enclosures of initial values
MOST_ARGUMENT = 1000  # of exp, sin and cos in enclosures of initial values
MOST_OPERATIONS = 20  # of a start; and powers and functions of all starts together
MOST_PRODUCTS = 10**6  # products of two terms, in the polynomials of a certificate
MOST_FACTORS = 400  # of a term
MOST_UNKNOWNS, MOST_DEFINITIONS = 200, 100  # the unknowns with derivatives and added ones
MOST_CLAIMS, MOST_ZEROS, MOST_ENDS = 10_000, 10_000, 2_000_000  # characters and exponents
MOST_BITS, MOST_EXPONENT = 10_000, 20_000  # of bounds and enclosures; of polynomials and radii
MOST_SHIFT, MOST_COMMON = 2**18, 2**20  # bits of scales of a term, of the common denominator
MOST_STEP, MOST_PARTS = 2**34, 2000  # bits of its products of polynomials; its parts, for a sign


class Refused(Exception):
    status = 1  # a condition of a theorem does not hold


class Malformed(Refused):
    status = 2  # the text is not of the format


def need(condition, reason, text="", kind=Refused):
    if not condition:
        raise kind(reason.replace("%s", text if len(text) <= 60 else text[:57] + "..."))


def form(condition, reason, text=""):
    need(condition, reason, text, Malformed)


def size_in_bits(x):
    return max(x.numerator.bit_length(), x.denominator.bit_length())


def limited(x):
    form(size_in_bits(x) <= MOST_NUMBER, "a number is too large")
    return x


def two(k):
    return Fraction(2) ** k


# ----------------------------------------------------------------------- Polynomials on a step
# A polynomial in x on [-1, 1] is a list a of integers, with an exponent k that is kept apart. With
# x = (z + 1/z)/2 and the Chebyshev polynomials T_j = (z^j + z^-j)/2 it is
#     2^-k (a[0] + sum over j > 0 of 2 a[j] T_j(x)) = 2^-k (sum over all j of a[|j|] z^j).
# So products are products of polynomials in z, and, because |T_j| <= 1 on [-1, 1], the sum of all
# |a[|j|]|, j positive and negative, is at least |a(x)|.
def norm(a):  # at least |a(x)| on [-1, 1]
    return 2 * sum(map(abs, a)) - abs(a[0]) if a else 0


def value(a, x):  # a(u/v), by Clenshaw's b_j = a_j + 2 (u/v) b_(j+1) - b_(j+2), times powers of v
    u, v = x.numerator, x.denominator
    b0, b1, b2, power = 0, 0, 0, 1
    for c in reversed(a):
        b0, b1, b2 = c * power + 2 * u * b0 - v * v * b1, b0, b1
        power *= v
    return Fraction(b0 - v * v * b2, max(power // v, 1))


def derivative(a):  # the derivative by x: T_k' = 2 k (T_(k-1) + T_(k-3) + ..), T_0 counted by half
    return [sum(2 * k * a[k] for k in range(j + 1, len(a), 2)) for j in range(len(a) - 1)]


def scaled(a, c):
    return [c * x for x in a]


def add(a, b):
    longer = max(len(a), len(b))
    return [x + y for x, y in zip(a + [0] * (longer - len(a)), b + [0] * (longer - len(b)))]


def dot(u, v):  # the sum of u[i] v[i], by its value at a z of more than twice its coefficients
    pairs = [(a, b) for a, b in zip(u, v) if any(a) and any(b)]
    size = max((len(a) + len(b) for a, b in pairs), default=1) - 1
    width = (sum(norm(a) * norm(b) for a, b in pairs).bit_length() + 9) // 8
    half = 1 << (8 * width - 1)

    def halves(count):  # z/2 (1 + z + .. + z^(count-1)) makes coefficients positive
        return int.from_bytes((bytes(width - 1) + b"\x80") * count, "little")

    def at_z(a):
        digits = b"".join((c + half).to_bytes(width, "little") for c in a)
        return int.from_bytes(digits, "little") - halves(len(a))
    total = halves(2 * size - 1)
    for a, b in pairs:
        product = at_z(a[:0:-1] + a) * at_z(b[:0:-1] + b)
        total += product << (8 * width * (size + 1 - len(a) - len(b)))
    digits = total.to_bytes(width * max(2 * size - 1, 0), "little")
    places = range(width * (size - 1), width * (2 * size - 1), width)
    return [int.from_bytes(digits[i:i + width], "little") - half for i in places]


# ------------------------------------------------------------------------------------ Formulas
#     sum     = product { (+|-) product }
#     product = signed { (*|/) signed }
#     signed  = - signed  |  atom [ ^ signed ]
#     atom    = integer  |  name  |  name ( sum )  |  ( sum )
# A tree is a fraction, a name, ("+", [("+" or "-", tree), ..]), ("*", [("*" or "/", tree), ..]),
# ("^", tree, fraction), or (name of a function, tree).
TOKEN = re.compile(r"([0-9]+|[A-Za-z_][A-Za-z0-9_]*'*|[-+*/^()])")
NUMBER = r"(-?)([0-9]+)(?:/([0-9]+)|(?:\.([0-9]+))?(?:e([-+]?[0-9]{1,5}))?)"
RULES = {"exp": "w", "log": "1/u", "sin": "cos(u)", "cos": "-sin(u)"}  # dw/du of functions w of u


class Parser:  # `operations` counts + - * / ^ and calls, `functions` ^ and calls
    def __init__(self, text):
        form(len(text) <= MOST_FORMULA, "a formula is too long")
        self.text, self.nesting, self.operations, self.functions = text, 0, 0, 0
        self.tokens = [match.group() for match in TOKEN.finditer(text)][::-1]
        self.understood("".join(self.tokens[::-1]) == text.replace(" ", ""))
        self.tree = self.sum()
        self.understood(not self.tokens)

    def understood(self, condition):
        form(condition, "'%s' is not understood", self.text)

    def skip(self, tokens):  # passes the next token if it is one of these
        if not self.tokens or self.tokens[-1] not in tokens:
            return ""
        self.operations += self.tokens[-1] in "+-*/^"
        return self.tokens.pop()

    def parts(self, part, signs):
        found = [(signs[0], part())]
        while sign := self.skip(signs):
            found.append((sign, part()))
        return found[0][1] if len(found) == 1 else (signs[0], found)

    def sum(self):
        return self.parts(lambda: self.parts(self.signed, "*/"), "+-")

    def signed(self):
        self.nesting += 1
        form(self.nesting <= MOST_NESTING, "a formula is nested too deeply")
        if self.skip("-"):
            tree = ("+", [("-", self.signed())])
        else:
            tree = self.atom()
            if self.skip("^"):
                self.functions += 1
                exponent = Algebra().of(self.signed(), {}).get((), Fraction(0))  # has no names
                form(size_in_bits(exponent) <= 1000, "an exponent is out of range")
                tree = ("^", tree, exponent)
        self.nesting -= 1
        return tree

    def atom(self):
        self.understood(self.tokens)
        token = self.tokens.pop()
        if token.isdigit():
            self.understood(token == "0" or token[0] != "0")
            form(len(token) <= MOST_DIGITS, "a number has too many digits")
            return Fraction(int(token))
        self.understood(token not in "+-*/^)")
        if token != "(" and not self.skip("("):
            return token
        tree = self.sum()
        self.understood(self.skip(")"))
        if token == "(":
            return tree
        self.operations, self.functions = self.operations + 1, self.functions + 1
        return token, tree


def fraction(text):  # a number such as -2/3, 25, -0.25 or 1.5e-7
    match = re.fullmatch(NUMBER, text)
    form(match, "'%s' is not a number", text)
    sign, whole, below, decimals, exponent = match.groups(default="")
    form(max(len(whole + decimals), len(below)) <= MOST_DIGITS, "a number has too many digits")
    form(below == "" or int(below) > 0, "'%s' is not a number", text)
    power = Fraction(10) ** (int(exponent or "0") - len(decimals))
    return Fraction(int(sign + whole + decimals), int(below or "1")) * power


class Values:  # of trees, by operations of polynomials or of intervals
    def of(self, tree, names):
        if isinstance(tree, Fraction):
            return self.number(tree)
        if isinstance(tree, str):
            form(tree in names, "unknown name '%s'", tree)
            return names[tree]
        kind, inside = tree[:2]
        if kind == "+":
            return self.sum([(Fraction(sign + "1"), self.of(x, names)) for sign, x in inside])
        if kind == "*":
            result = self.of(inside[0][1], names)
            for sign, part in inside[1:]:
                factor = self.of(part, names)
                result = self.times(result, factor if sign == "*" else self.inverse(factor))
            return result
        x = self.of(inside, names)
        return self.power(x, tree[2]) if kind == "^" else self.function(kind, x)


# ----------------------------------------------------------------- Polynomials in the unknowns
# A polynomial in the variable (number 0) and the unknowns (1, 2, ..) is a dictionary {product: c}:
# products are sorted tuples of numbers, in their order, c nonzero fractions.
def collected(terms):  # the sum of terms (product, coefficient)
    total = {}
    for m, c in terms:
        total[m] = limited(total.get(m, 0) + c)
    return {m: c for m, c in sorted(total.items()) if c}


class Algebra(Values):  # `added` has unknowns for (kind, argument, exponent), by definitions
    def __init__(self):
        self.products, self.added = 0, {}

    def number(self, c):
        return {(): c} if c else {}

    def sum(self, parts):
        return collected((m, sign * c) for sign, u in parts for m, c in u.items())

    def times(self, a, b):
        self.products += len(a) * len(b)
        form(self.products <= MOST_PRODUCTS, "the polynomials have too many terms")
        degree = max(map(len, a), default=0) + max(map(len, b), default=0)
        form(degree <= MOST_FACTORS, "a term has too many factors")
        return collected((tuple(sorted(m + k)), a[m] * b[k]) for m in a for k in b)

    def inverse(self, u):
        return {(): 1 / u[()]} if set(u) == {()} else self.function("/", u)

    def function(self, kind, u, exponent=Fraction(-1)):
        key = kind, frozenset(u.items()), exponent
        form(key in self.added, "no definition is the '%s' that a formula needs", kind)
        return self.added[key]

    def power(self, u, r):  # by a whole power, by w = u^(-1/b) for r = a/b, or by an added unknown
        a, b, k = r.numerator, r.denominator, max(0, math.ceil(r))
        if b == 1:
            return self.whole_power(u if a >= 0 else self.inverse(u), abs(a))
        if abs(a) > 64 or b > 6:
            return self.function("^", u, r)
        w = self.function("^", u, Fraction(-1, b))
        return self.times(self.whole_power(u, k), self.whole_power(w, k * b - a))

    def whole_power(self, u, n):
        form(n <= MOST_POWER, "an exponent is out of range")
        result = {(): Fraction(1)}
        for _ in range(n):
            result = self.times(u, result)
        return result

    def along(self, u, way):  # the derivative of u by the chain rule, from those of its factors
        terms = []
        for k in sorted({k for product in u for k in product} & set(way)):
            places = [(m, m.index(k)) for m in u if k in m]
            partial = {m[:at] + m[at + 1:]: u[m] * m.count(k) for m, at in places}
            terms += self.times(partial, way[k]).items()
        return collected(terms)


# ---------------------------------------------------------------- Enclosures of initial values
# Values of formulas as pairs (lower, upper) of fractions, by interval arithmetic. The functions
# are sums of their series in integers, times 2^-bits.
class Enclosures(Values):
    def __init__(self, bits):
        self.bits = bits

    def number(self, c):
        return c, c

    def sum(self, parts):
        low = high = Fraction(0)
        for sign, x in parts:
            a, b = sorted(sign * end for end in x)
            low, high = limited(low + a), limited(high + b)
        return low, high

    def times(self, x, y):
        four = [limited(a * b) for a in x for b in y]
        return min(four), max(four)

    def inverse(self, x):
        need(x[0] > 0 or x[1] < 0, "a start divides by 0")
        return 1 / x[1], 1 / x[0]

    def power(self, x, r):
        if r.denominator > 1 or r < 0:  # x^r = exp(r log x)
            low, high = sorted(r * y for y in self.function("log", x))
            return self.entire("exp", low)[0], self.entire("exp", high)[1]
        form(r <= MOST_START_POWER, "an exponent is out of range")
        form((max(map(size_in_bits, x)) - 1) * r <= MOST_NUMBER, "a number is too large")
        low, high = sorted((x[0] ** r.numerator, x[1] ** r.numerator))
        return (Fraction(0) if r % 2 == 0 and x[0] <= 0 <= x[1] else low), high

    def function(self, kind, x):
        form(kind in RULES, "unknown function '%s'", kind)
        if kind == "log":
            need(x[0] > 0, "a start has log or ^ of a number that is not positive")
            return self.log(x[0])[0], self.log(x[1])[1]
        low, high = self.entire(kind, x[0])
        if kind == "exp":  # which increases
            return low, self.entire(kind, x[1])[1]
        return low - (x[1] - x[0]), high + (x[1] - x[0])  # |sin'|, |cos'| <= 1

    def entire(self, kind, x):
        # exp, sin or cos by terms x^j/j!, each with an error below 2 e^|x| units of 2^-bits; the
        # argument has one of e^|x|, the rest of the series is below 8.
        form(abs(x) < MOST_ARGUMENT, "a start has an argument that is too large")
        bits = self.bits + 2 * math.ceil(abs(x)) + 40
        factor, terms = math.floor(x * two(bits)), [1 << bits]
        while abs(terms[-1]) > 1 or len(terms) < 2 * abs(x) + 2:
            terms.append((terms[-1] * factor >> bits) // len(terms))
        own = terms[kind == "sin"::2]
        total = sum(terms) if kind == "exp" else sum(own[::2]) - sum(own[1::2])
        error = (2 * len(terms) + 10) * 3 ** math.ceil(abs(x))
        return (total - error) * two(-bits), (total + error) * two(-bits)

    def series(self, *terms):
        # The sum of c arctan(z), sign -1, or c artanh(z), |z| <= 1/3, by sign^j z^(2j+1)/(2j+1),
        # each with an error of 3 units of 2^-bits, the rest with 16.
        bits, middle, error = self.bits + 40, 0, 0
        for c, z, sign in terms:
            factor = power = math.floor(z * two(bits))
            total = count = 0
            while abs(power) > 1:
                total += sign**count * (power // (2 * count + 1))
                count += 1
                power = (power * factor >> bits) * factor >> bits
            middle, error = middle + c * total, error + abs(c) * (4 * count + 16)
        return (middle - error) * two(-bits), (middle + error) * two(-bits)

    def log(self, x):  # log(2^k m) = 2 artanh((m - 1)/(m + 1)) + 2 k artanh(1/3), 1/2 <= m <= 2
        k = x.numerator.bit_length() - x.denominator.bit_length()
        return self.series((2, (x - two(k)) / (x + two(k)), 1), (2 * k, Fraction(1, 3), 1))

    def pi(self):  # 16 arctan(1/5) - 4 arctan(1/239)
        return self.series((16, Fraction(1, 5), -1), (-4, Fraction(1, 239), -1))


# ---------------------------------------------------------------------- Lines of a certificate
class Reader:  # lists of coefficients have hexadecimal digits
    def __init__(self, text):
        self.lines, self.at = text.split("\n"), 0

    def next(self):
        form(self.at < len(self.lines), "the file ends early")
        self.at += 1
        return self.lines[self.at - 1]

    def line(self, word):  # what follows the word that the next line begins with
        line = self.next()
        form((line + " ").startswith(word + " "), "line %d: '%s' expected" % (self.at, word))
        return line[len(word) + 1:]

    def all(self, word, most):  # the same of all next lines that begin with the word
        first = self.at
        while self.at < len(self.lines) and self.lines[self.at].startswith(word + " "):
            self.at += 1
        form(self.at - first <= most, "there are more than %d lines '%s'" % (most, word))
        return [line[len(word) + 1:] for line in self.lines[first:self.at]]

    def integers(self, word, count, largest=99_999):
        fields = self.line(word).split(" ")
        good = len(fields) == count and all(re.fullmatch("-?[0-9]{1,5}", x) for x in fields)
        form(good, "line %d: %d integers of at most 5 digits expected" % (self.at, count))
        form(all(abs(int(x)) <= largest for x in fields), "line %d: out of range" % self.at)
        return [int(x) for x in fields]

    def coefficients(self):
        line = self.next()
        good = re.fullmatch("|-?[0-9a-f]+(?: -?[0-9a-f]+)*", line)
        form(good, "line %d: bad coefficients" % self.at)
        return [int(x, 16) for x in line.split(" ")] if line else []

    def section(self, word, exponents, lists):
        k = self.integers(word, exponents, MOST_EXPONENT)
        return k, [self.coefficients() for _ in range(lists)]


# ----------------------------------------------------------------------- Head of a certificate
# A statement shows equations, starts and a condition as they are typed. They say what they seem to
# say, because each name has one meaning: names of the variable and of unknowns are not functions,
# not pi, and have no primes, which are derivatives; definitions are _1, _2, .., names of nothing
# else. Equations and the condition contain the variable and the unknowns, definitions also those
# before them, starts only pi.
def sized(lines):  # lines whose fractions, with their exponents, are not too long together
    exponents = [int(e) for line in lines for e in re.findall("e[-+]?([0-9]{1,5})", line)]
    form(sum(exponents) + sum(map(len, lines)) <= MOST_ENDS, "the fractions are too long")
    return lines


class Claim:  # LOW <= NAME(TIME) <= HIGH, for all times from `first` to `last`
    def __init__(self, text, problem):
        self.fields = text.split(" ")
        form(len(self.fields) == 4 and self.fields[1] in problem.state, "an unclear claim")
        self.time, self.name, low, high = self.fields
        if self.time in problem.zero_names:
            self.first, self.last = problem.zero_names[self.time]
        else:
            ends = self.time.split(":")
            self.first, self.last = fraction(ends[0]), fraction(ends[-1])
            behind = (self.first - problem.t0) * (self.last - self.first) >= 0
            form(len(ends) == 1 or len(ends) == 2 and problem.vary and behind, "an unclear time")
        self.low, self.high = fraction(low), fraction(high)


class Problem:
    def __init__(self, reader):
        form(reader.line("libration-certificate") == "1", "not a certificate of version 1")
        self.notes = "".join("\nNot checked: " + x for x in reader.all("note", MOST_DEFINITIONS))
        self.variable, self.t0_text, self.names = reader.line("variable"), reader.line("at"), []
        self.add_name(self.variable)
        self.t0 = fraction(self.t0_text)
        self.read_equations(reader)
        self.defined = [x.split(" = ") for x in reader.all("define", MOST_DEFINITIONS)]
        for k, sides in enumerate(self.defined, 1):
            form(sides[0] == "_%d" % k and len(sides) == 2, "the definitions are not of _1, _2, ..")
        self.condition = (reader.all("condition", 1) or [None])[0]
        self.bits, self.start_bits = reader.integers("bits", 2)
        form(16 <= self.bits <= self.start_bits <= MOST_BITS, "the bits are out of range")
        self.read_zeros_and_claims(reader)
        (self.steps,) = reader.integers("steps", 1)
        form(len(self.state + self.defined) <= MOST_UNKNOWNS, "there are too many unknowns")
        make_polynomial_form(self)

    def add_name(self, name):
        good = re.fullmatch("[A-Za-z_][A-Za-z0-9_]*", name) and not re.fullmatch("_[0-9]+", name)
        form(good and name not in (*RULES, "sqrt", "pi"), "'%s' cannot be a name", name)
        form(name not in self.names, "two meanings of the name '%s'", name)
        self.names.append(name)

    def read_equations(self, reader):
        self.equations, self.state = [], []
        for line in reader.all("equation", MOST_UNKNOWNS):
            sides = tuple(line.split(" = "))
            name = sides[0].rstrip("'")
            form(len(sides) == 2 and name != sides[0], "an unclear equation")
            self.add_name(name)
            order = len(sides[0]) - len(name)
            form(len(self.state) + order <= MOST_UNKNOWNS, "there are too many unknowns")
            self.state += [name + "'" * k for k in range(order)]
            self.equations.append(sides)
        self.starts = reader.all("start", MOST_UNKNOWNS)
        form(len(self.starts) == len(self.state), "not one start for each unknown")
        self.vary = (reader.all("vary", 1) or [None])[0]
        form(self.vary in [None] + self.state, "the line 'vary' has no unknown")
        if self.vary is not None:
            self.state = self.state + ["d(%s)" % name for name in self.state]

    def read_zeros_and_claims(self, reader):
        self.zeros = [line.split(" ") for line in sized(reader.all("zero", MOST_ZEROS))]
        form(all(len(zero) == 2 for zero in self.zeros), "an unclear zero")
        form((self.condition is None) == (self.zeros == []), "a condition or zeros alone")
        self.ends = [self.t0] + [fraction(time) for zero in self.zeros for time in zero]
        pairs = list(zip(self.ends, self.ends[1:]))
        self.zero_names = {"#%d" % (k // 2 + 1): pairs[k] for k in range(1, len(pairs), 2)}
        ordered = all((b - a) * (self.ends[-1] - self.t0) >= 0 for a, b in pairs)
        need(ordered, "the zeros are not in the order of the steps")
        self.claims = [Claim(line, self) for line in sized(reader.all("claim", MOST_CLAIMS))]
        form(self.claims, "there is no claim")
        for side in "first", "last":
            distances = [abs(getattr(x, side) - self.t0) for x in self.claims]
            form(distances == sorted(distances), "the claims are not in the order of their times")
        once = len({x.name for x in self.claims}) == len(self.claims)
        once = once and len({x.time for x in self.claims}) == 1
        form(self.vary is None or once, "derivatives at several times, or twice")

    def head(self, times):
        ends, at = sorted([self.t0_text, *times], key=fraction), self.t0_text
        equations = ",  ".join("%s = %s" % sides for sides in self.equations)
        starts = ",  ".join("%s(%s) = %s" % (x, at, y) for x, y in zip(self.state, self.starts))
        parts = equations, starts, ends[0], ends[-1]
        return "solution of\n    %s,\n    %s\nexists on [%s, %s], and\n" % parts

    def statement(self):
        need(self.vary is None, "derivatives without a root")
        times = [time for zero in self.zeros for time in zero]
        text = "The " + self.head(times + [x.time for x in self.claims if x.time[0] != "#"])
        if self.condition is not None:
            parts = self.condition, self.t0_text, self.zeros[-1][1], ", ".join(self.zero_names)
            text += "%s = 0 from %s, excluded, to %s only at %s, and\n" % parts
        zeros = [sorted(zero, key=fraction) for zero in self.zeros]
        facts = ["    %s lies in [%s, %s]" % (x, *ends) for x, ends in zip(self.zero_names, zeros)]
        facts += ["    {1}({0}) lies in [{2}, {3}]".format(*x.fields) for x in self.claims]
        return text + ",\n".join(facts) + ".\nThe variable is %s.%s" % (self.variable, self.notes)


# ----------------------------------------------------------------------------- Polynomial form
# Quotients, powers that are not whole, and functions are added unknowns w of u, a polynomial. Then
# the equations are polynomials; that of w is u' times dw/du, which is a polynomial in w and further
# added unknowns. As long as the solution of this system exists, it is that of the equations.
def definition(tree):  # kind, argument and exponent of an added unknown
    kind, inside = tree[:2] if isinstance(tree, tuple) else ("", [])
    if kind == "*" and [sign for sign, _ in inside] == ["*", "/"] and inside[0][1] == Fraction(1):
        return "/", inside[1][1], Fraction(-1)
    form(kind == "^" or kind in RULES, "a definition is not that of a function")
    return tree if kind == "^" else (*tree, Fraction(-1))


def enclosed_starts(problem, values):  # the interval of each start
    parsed, functions = [], 0
    for text in problem.starts:
        bracketed = text.startswith("[") and text.endswith("]")
        texts = text[1:-1].split(", ") if bracketed else [text]
        form(len(texts) == 1 + bracketed, "'%s' is not understood", text)
        parsers = [Parser(x) for x in texts]
        parsed.append([parser.tree for parser in parsers])
        operations = sum(parser.operations for parser in parsers)
        functions += sum(parser.functions for parser in parsers)
        form(max(operations, functions) <= MOST_OPERATIONS, "the starts have too many operations")
    names = {"pi": values.pi()} if "pi" in " ".join(problem.starts) else {}
    enclosed = [list(zip(*[values.of(tree, names) for tree in trees])) for trees in parsed]
    return [(min(low), max(high)) for low, high in enclosed]


def make_polynomial_form(problem):  # sets enclosures of the unknowns, their derivatives, g and g'
    algebra, values = Algebra(), Enclosures(problem.start_bits)
    given, count = len(problem.state), len(problem.starts)
    unknowns = [{(k,): Fraction(1)} for k in range(1 + given + len(problem.defined))]
    names = dict(zip([problem.variable] + problem.state[:count], unknowns))
    start = enclosed_starts(problem, values)
    known = dict(zip(names, [(problem.t0, problem.t0)] + start))
    for name in problem.state[count:]:  # derivatives by the start of `vary`
        start.append((Fraction(name == "d(%s)" % problem.vary),) * 2)
    definitions, in_definitions = [], dict(names)
    for (name, text), w in zip(problem.defined, unknowns[given + 1:]):
        tree = Parser(text).tree
        kind, argument, exponent = definition(tree)
        u = algebra.of(argument, in_definitions)
        algebra.added[kind, frozenset(u.items()), exponent] = w
        definitions.append((kind, exponent, u, w))
        start.append(values.of(tree, known))
        in_definitions[name], known[name] = w, start[-1]
    right = []
    for left, text in problem.equations:
        name = left.rstrip("'")
        right += [names[name + "'" * k] for k in range(1, left.count("'"))]
        right.append(algebra.of(Parser(text).tree, names))
    flow = dict(enumerate([{(): Fraction(1)}] + right))  # derivatives by the time
    by_start = {k: unknowns[count + k] for k in range(1, count + 1) if problem.vary is not None}
    for k, (kind, exponent, u, w) in enumerate(definitions, given + 1):
        rule = "w^%d" % (exponent.denominator + 1) if exponent.numerator == -1 else "w/u"
        slope = algebra.of(Parser(RULES.get(kind, rule)).tree, {"u": u, "w": w})
        slope = algebra.sum([(1 if kind in RULES else exponent, slope)])
        flow[k] = algebra.times(slope, algebra.along(u, flow))
        by_start[k] = algebra.times(slope, algebra.along(u, by_start))
    for k in range(count + 1, given + 1):
        flow[k] = algebra.along(right[k - count - 1], by_start)
    problem.start, problem.right = start, [flow[k] for k in range(1, len(unknowns))]
    problem.functions, problem.zero_start = [], False
    if problem.condition is not None:
        g = algebra.of(Parser(problem.condition).tree, names)
        problem.functions = [g, algebra.along(g, flow)]
        ends = [known[problem.variable]] + start
        exact = all(ends[k][0] == ends[k][1] for m in g for k in m)
        total = sum(c * math.prod(ends[k][0] for k in m) for m, c in g.items())
        problem.zero_start = exact and total == 0


# --------------------------------------------------------------------------------------- Steps
# Theorem K. On a step t = s + (1 + x) h/2, -1 <= x <= 1, let y_i = 2^e_i Y_i and Y' = g(x, Y). Let
# p be polynomials, V an invertible matrix of polynomials, its columns in blocks b of one or two,
# and r_b(x) >= 0 affine, R0 at x = -1 and R1 at x = 1. If
#     the set in which the step begins is in the tube {p + V c, |c_b| <= r_b} at x = -1, and
#     (R1_b - R0_b)/2 >= sum_c A_bc r_c + D_b   for r = R0 and for r = R1,
# where in the tube A_bc >= ||B_bc|| for b != c, A_bb is at least the largest eigenvalue of the
# symmetric part of B_bb, B = V^-1 (g_Y V - V'), and D_b >= |V^-1 (p' - g(x, p))|_b, then every
# solution that begins in the set exists on the whole step and is in the tube.
# Bounds are integers in units of 2^-bits, rounded up. A set is (centre, frame, blocks, radii).
PARTS = 8  # of a step, on each of which the rate of a block is bounded


def matrix(n, entry):
    return [[entry(i, j) for j in range(n)] for i in range(n)]


def root_up(x):  # an integer that is at least the root of the integer x
    return math.isqrt(x - 1) + 1 if x > 0 else 0


def size_of(a, rows, columns):  # at least the norm of a block of bounds
    return root_up(sum(a[i][j] ** 2 for i in rows for j in columns))


class Step:  # of the scaled unknowns, with one exponent for each matrix
    def __init__(self, reader, problem, begin):
        self.problem, self.begin, self.bits = problem, begin, problem.bits
        self.n = n = len(problem.right)
        (k,), (length,) = reader.section("step", 1, 1)
        form(len(length) == 1 and length[0] != 0, "the length is not one integer, not 0")
        self.length, self.scales = length[0] * two(-k), reader.integers("scale", n)
        sizes = reader.line("blocks").split(" ")
        good = set(sizes) <= {"1", "2"} and sum(map(int, sizes)) == n
        form(good, "the blocks are not of 1 and 2 columns")
        ends = [0, *itertools.accumulate(map(int, sizes))]
        self.blocks = [range(*pair) for pair in zip(ends, ends[1:])]
        (self.kp,), self.p = reader.section("p", 1, n)
        kv, V = reader.section("V", n, n * n)
        ku, U = reader.section("U", n, n * n)
        self.kv, self.ku = max(0, *kv), max(0, *ku)
        self.V = matrix(n, lambda i, j: scaled(V[i * n + j], 1 << (self.kv - kv[j])))
        self.U = matrix(n, lambda i, j: scaled(U[i * n + j], 1 << (self.ku - ku[i])))
        exponents, radii = reader.section("radii", len(sizes), 2)
        good = all(len(r) == len(sizes) and min(r) >= 0 for r in radii)
        form(good, "the radii are not numbers >= 0")
        self.R0, self.R1 = [[self.up(m * two(-e)) for m, e in zip(r, exponents)] for r in radii]

    def up(self, x):  # an upper bound of the fraction x as an integer
        return -((-x.numerator << self.bits) // x.denominator)

    def bounds(self, a, unit):  # of the polynomials a/unit of a matrix
        return [[self.up(norm(entry) / unit) for entry in row] for row in a]

    def product(self, a, b):  # of two matrices of bounds
        columns = list(zip(*b))
        return [[-(-sum(map(int.__mul__, row, c)) >> self.bits) for c in columns] for row in a]

    def right_end(self):  # the tube at x = 1
        x, units = Fraction(1), [two(e) for e in self.scales]
        centre = [value(a, x) * two(-self.kp) * unit for a, unit in zip(self.p, units)]
        V = [[value(a, x) * two(-self.kv) * unit for a in row] for row, unit in zip(self.V, units)]
        return centre, V, self.blocks, self.R1

    def check_frame(self):
        # V^-1 = (1 + N) U with |1 + N| <= N1: by Neumann's series for (1 + Z)^-1, Z = U V - 1, with
        # bounds z of |Z|, row sums q <= 1/2: |N_ij| <= z_ij + (row sum i of z^2)/(1 - q).
        n, k, one, columns = self.n, self.ku + self.kv, 1 << self.bits, list(zip(*self.V))
        UV = matrix(n, lambda i, j: dot(self.U[i], columns[j]))
        Z = matrix(n, lambda i, j: add(UV[i][j], [-1 << k] if i == j else []))
        z = self.bounds(Z, two(k))
        q = max(map(sum, z))
        need(2 * q <= one, "frame: U is not nearly the inverse of V")
        rest = [-(-(sum(row) << self.bits) // (one - q)) for row in self.product(z, z)]
        self.N1 = matrix(n, lambda i, j: z[i][j] + rest[i] + (one if i == j else 0))

    def check_joint(self, centre, frame, blocks, radii):  # the set is in the tube at -1
        left, units = Fraction(-1), [two(-e) for e in self.scales]
        U = [[value(a, left) * two(-self.ku) for a in row] for row in self.U]
        p = [value(a, left) * two(-self.kp) for a in self.p]
        gap = [[c * unit - x] for c, unit, x in zip(centre, units, p)]
        turned = [[x * unit for x in row] for row, unit in zip(frame, units)]
        for a in gap, turned:  # becomes bounds of V^-1 a
            columns = list(zip(*a))
            a[:] = [[self.up(abs(sum(map(Fraction.__mul__, u, c)))) for c in columns] for u in U]
            a[:] = self.product(self.N1, a)
        for b, rows in enumerate(self.blocks):
            total = size_of(gap, rows, [0]) << self.bits
            total += sum(size_of(turned, rows, c) * radius for c, radius in zip(blocks, radii))
            need(total <= self.R0[b] << self.bits, "start or joint: radius of block %d" % (b + 1))

    def scale_equations(self):
        # The time is s + h/2 + (h/4) 2 T_1, a list of integers times 1/q. `terms` are those of the
        # scaled right-hand sides, of g, and of g' times h/2: (equation, product, coefficient).
        right, half = self.problem.right + self.problem.functions, self.length / 2
        time, timed = [self.begin + half, half / 2], any(0 in m for f in right for m in f)
        q = math.lcm(*[x.denominator for x in time]) if timed else 1
        self.k, e = max(self.kp, q.bit_length()), [0] + self.scales
        form(self.k <= 2 * MOST_EXPONENT, "a step is too large")
        self.factors = [[int(x * q) << self.k for x in time if timed]]
        self.factors += [scaled(a, 1 << (self.k - self.kp)) for a in self.p]
        self.terms, self.common = [], 1
        self.most = max([len(m) for f in right for m in f] + [1])
        for i, f in enumerate(right):
            for m, c in f.items():
                shift = sum(e[j] for j in m) - (self.scales[i] if i < self.n else 0)
                form(abs(shift) <= MOST_SHIFT, "a step is too large")
                c *= two(shift) * (1 if i == self.n else half) / q ** m.count(0)
                self.terms.append((i, m, c))
                self.common = math.lcm(self.common, c.denominator)
                form(self.common.bit_length() <= MOST_COMMON, "a step is too large")
        length = sum(len(m) + len(set(m)) for _, m, _ in self.terms)
        length *= self.most * max(map(len, self.factors))
        largest = max([abs(c) for a in self.factors for c in a] + [1])
        bits = self.most * (largest.bit_length() + self.k) + self.common.bit_length()
        form(length * bits <= MOST_STEP, "a step is too large")
        self.unit = self.common << (self.most * self.k)

    def field(self):  # p' - g along p in parts of `unit`; J = g_Y, times 2^-k; bounds of its change
        n, k, radii = self.n, self.k, list(map(max, self.R0, self.R1))
        self.size_of_V = self.bounds(self.V, two(self.kv))
        rho = [0]  # in the tube |Y_i - p_i| <= rho_i
        for row in self.size_of_V:
            total = sum(size_of([row], [0], rows) * r for rows, r in zip(self.blocks, radii))
            rho.append(-(-total >> self.bits))
        (reach,) = self.bounds([self.factors], two(k))
        products = {(): [1]}

        def product(m):
            if m not in products:
                products[m] = dot([product(m[:-1])], [self.factors[m[-1]]])
            return products[m]

        def change(m):  # of a product of factors, in the tube
            larger = math.prod(reach[j] + rho[j] for j in m) - math.prod(reach[j] for j in m)
            return Fraction(larger, 1 << (self.bits * len(m)))
        d = [scaled(derivative(a), self.unit >> k) for a in self.factors[1:]] + [[], []]
        J, change_of_J, changes = matrix(n, lambda i, j: []), matrix(n, lambda i, j: 0), [1, 1]
        for i, m, c in self.terms:
            factor = int(c * self.common) << ((self.most - len(m)) * k)
            d[i] = add(d[i], scaled(product(m), -factor))
            if i >= n:
                changes[i - n] += self.up(abs(c) * change(m))
                continue
            for j in sorted(set(m) - {0}):
                count, at = m.count(j), m.index(j)
                rest = m[:at] + m[at + 1:]
                J[i][j - 1] = add(J[i][j - 1], scaled(product(rest), count * factor))
                change_of_J[i][j - 1] += count * self.up(abs(c) * change(rest))
        self.functions = []  # g and g' along p, bounds of the slope and of the change in the tube
        for a, changed in zip(d[n:], changes):
            reach = changed * self.unit * two(-self.bits)
            self.functions.append((scaled(a, -1), norm(derivative(a)), reach))
        return d[:n], J, change_of_J

    def check_growth(self):
        # (R1_b - R0_b)/2 >= sum_c A_bc r_c + D_b at both ends. B = B0 + change, B0 = U (J V - V'),
        # and the change is at most C - |B0|, C = N1 (|B0| + |U| change_of_J |V|).
        n, (d, J, change_of_J) = self.n, self.field()
        defect = self.bounds([[dot(u, d)] for u in self.U], self.unit * two(self.ku))
        defect = self.product(self.N1, defect)
        columns, minus = list(zip(*self.V)), -self.unit >> self.k
        JV = matrix(n, lambda i, j: dot(J[i], columns[j]))
        H = matrix(n, lambda i, j: add(JV[i][j], scaled(derivative(self.V[i][j]), minus)))
        columns = list(zip(*H))
        B0 = matrix(n, lambda i, j: dot(self.U[i], columns[j]))
        unit = self.unit * two(self.ku + self.kv - self.k)
        bound = self.bounds(B0, unit)
        C = self.product(change_of_J, self.size_of_V)
        C = self.product(self.bounds(self.U, two(self.ku)), C)
        C = self.product(self.N1, matrix(n, lambda i, j: C[i][j] + bound[i][j]))
        more = matrix(n, lambda i, j: C[i][j] - bound[i][j])
        rates = [self.rate(B0, rows, unit) + size_of(more, rows, rows) for rows in self.blocks]
        for end, radii in (("left", self.R0), ("right", self.R1)):
            for b, rows in enumerate(self.blocks):
                growth = size_of(defect, rows, [0]) << self.bits
                for c, columns in enumerate(self.blocks):
                    growth += (rates[b] if c == b else size_of(C, rows, columns)) * radii[c]
                within = 2 * growth <= (self.R1[b] - self.R0[b]) << self.bits
                need(within, "growth of the radius of block %d at the %s end" % (b + 1, end))

    def rate(self, B0, rows, unit):
        # At least the largest eigenvalue of the symmetric part of a block: that of a matrix
        # ((a, m/2), (m/2, d)) is (a + d + sqrt((a - d)^2 + m^2))/2.
        def above(a):  # a(x)/unit on each part of [-1, 1], by the value in its middle
            slope = Fraction(norm(derivative(a)), PARTS)
            middles = [Fraction(2 * k + 1 - PARTS, PARTS) for k in range(PARTS)]
            return [self.up((value(a, x) + slope) / unit) for x in middles]
        i, j = rows[0], rows[-1]
        if i == j:
            return min(self.up(norm(B0[i][i]) / unit), max(above(B0[i][i])))
        mixed = add(B0[i][j], B0[j][i])
        m = [max(abs(x), abs(y)) for x, y in zip(above(mixed), above(scaled(mixed, -1)))]
        parts = zip(above(B0[i][i]), above(B0[j][j]), m)
        return max(-(-(a + d + root_up((a - d) ** 2 + y * y)) // 2) for a, d, y in parts)


# ---------------------------------------------------------------------------- Claims and zeros
# A value in the tube at x is within sum_b |V_ib(x)| r_b(x) of p_i(x). On an interval [u, v] of x,
# values, |V_ib| and r_b differ from those in the middle by at most (v - u)/2 times a bound of their
# derivatives.
# A function has on [u, v] the sign of its value in the middle if that is more than (v - u)/2 times
# a bound of the slope, plus the change in the tube; it has that of both ends if these are equal and
# its derivative has a sign. A condition with different signs before and behind an interval, where
# its derivative has a sign, has one zero there.
class Progress:  # so many claims, and intervals before, in and behind zeros, are proved
    def __init__(self, problem):
        self.problem, self.claims, self.interval, self.sign = problem, 0, 0, 0
        pairs = zip(problem.ends, problem.ends[1:] + problem.ends[-1:])
        self.intervals = list(pairs) if problem.zeros else []

    def check(self, step):  # the claims and intervals, as far as they are in a step
        forward = (self.problem.ends[-1] - self.problem.t0) * step.length >= 0
        need(forward, "the zeros are not in the order of the steps")
        for claim in itertools.islice(self.problem.claims, self.claims, None):
            u, v, ends = part(step, claim.first, claim.last)
            if u > v:
                break
            check_claim(step, claim, u, v)
            self.claims += ends
        for k, interval in itertools.islice(enumerate(self.intervals), self.interval, None):
            u, v, ends = part(step, *interval)
            if u > v:
                break
            sign = sure(step, 1, u, v) if k % 2 else sign_on(step, u, v)
            sign = -sign if (k + 1) // 2 % 2 else sign
            alternate = sign and self.sign in (0, sign)
            need(alternate, "the sign of the condition in its interval %d" % (k + 1))
            self.sign, self.interval = sign, k + ends
            if not ends:
                break


def part(step, first, last):  # times as values of x, cut to the step; whether the last is in it
    u, v = [2 * (time - step.begin) / step.length - 1 for time in (first, last)]
    return max(u, Fraction(-1)), min(v, Fraction(1)), v <= 1


def check_claim(step, claim, u, v):  # on [u, v] the tube is in the interval of the claim
    i, half, x = step.problem.state.index(claim.name), (v - u) / 2, (u + v) / 2
    unit, unit_of_V = two(step.scales[i] - step.kp), two(step.scales[i] - step.kv)
    centre, reach = value(step.p[i], x) * unit, norm(derivative(step.p[i])) * half * unit
    row = [abs(value(a, x)) + norm(derivative(a)) * half for a in step.V[i]]
    row = [[step.up(size * unit_of_V) for size in row]]
    for block, a, b in zip(step.blocks, step.R0, step.R1):
        radius = math.ceil(a + (b - a) * (x + 1) / 2) + math.ceil(abs(b - a) * half / 2)
        reach += size_of(row, [0], block) * radius * two(-2 * step.bits)
    within = claim.low <= centre - reach and centre + reach <= claim.high
    what = claim.name, claim.time
    need(within, "the value of %s at %s is not proved to be in its interval" % what)


def sure(step, k, u, v):  # the sign on [u, v] of g, k = 0, or of g', k = 1; 0 if it is not proved
    a, slope, reach = step.functions[k]
    middle = value(a, (u + v) / 2)
    return (abs(middle) > slope * (v - u) / 2 + reach) * (1 if middle > 0 else -1)


def sign_on(step, u, v):
    # The sign of the condition on [u, v], by halves; 0 if it is not proved. Where it is 0 at the
    # initial time, the sign of its derivative is that behind it.
    starts = step.problem.zero_start and step.begin == step.problem.t0
    (_, slope, reach), parts, sign = step.functions[0], [(u, v)], 0
    for _ in range(MOST_PARTS):
        u, v = parts.pop()
        way = sure(step, 1, u, v)
        left = way if starts and u == -1 else sure(step, 0, u, u)
        if left == sure(step, 0, v, v) and (way or sure(step, 0, u, v)):
            if left in (0, -sign):
                return 0
            sign = left
        elif slope * (v - u) > reach:
            parts += [((u + v) / 2, v), (u, (u + v) / 2)]
        else:
            return 0
        if not parts:
            return sign
    return 0


# -------------------------------------------------------------------------------- Certificates
# If each step begins in the tube of the step before, and the first one in the box of the initial
# values, the solution exists up to the end of the last step, and is in the tubes.
def check_one(text):  # the problem of a certificate that is proved
    reader = Reader(text)
    problem = Problem(reader)
    progress, time, boxes, n = Progress(problem), problem.t0, problem.start, len(problem.start)
    radii = [math.ceil((b - a) / 2 * two(problem.bits)) for a, b in boxes]
    blocks, unit = [range(i, i + 1) for i in range(n)], matrix(n, lambda i, j: Fraction(i == j))
    state, direction = ([(a + b) / 2 for a, b in boxes], unit, blocks, radii), 0
    for number in range(1, problem.steps + 1):
        try:
            step = Step(reader, problem, time)
            form(direction * step.length >= 0, "a step in the other direction")
            step.check_frame()
            step.check_joint(*state)
            step.scale_equations()
            step.check_growth()
            progress.check(step)
        except Refused as reason:
            raise type(reason)("step %d: %s" % (number, reason)) from None
        time, state, direction = time + step.length, step.right_end(), step.length
    form(reader.lines[reader.at:] == ["end", ""], "the steps do not end with 'end'")
    done = progress.claims == len(problem.claims) and progress.interval == len(progress.intervals)
    need(done, "no step contains the time of a claim or a zero")
    return problem


def check(text):  # the proved statement; of several certificates and conditions, that of a root
    *parts, rest = text.split("\nend\n")
    if len(parts) <= 1:
        return check_one(text).statement()
    form(len(parts) <= MOST_UNKNOWNS, "there are too many certificates")
    return check_root([check_one(part + "\nend\n") for part in parts], rest)


# --------------------------------------------------------------------------------------- Roots
# Newton's method. Let F(u) be the differences of both sides of the conditions at the end, m a
# vector, r > 0, and C a matrix. If, for the values F(m) and F' of all u with |u_j - m_j| <= r_j,
#     |C F(m)|_i + sum_j |(1 - C F')_ij| r_j < r_i   for every i,
# then F = 0 for exactly one of these u. F(m) is in the intervals of the first certificate; column j
# of F' is in those of certificate j + 1, derivatives by the start of unknown j; if the time is an
# unknown, the last column has the derivatives by it.
def unknowns_of(problems, middle, ends):  # the starts that differ; name, m and ends of unknowns
    point, near, *others = problems
    heads = [(x.equations, x.variable, x.t0) for x in problems]
    same = ":" in ends or fraction(middle) == fraction(ends)
    need(same and heads == heads[:1] * len(heads), "certificates that are not of one problem")
    moved = [k for k, x in enumerate(point.starts) if x != near.starts[k]]
    match = [x.vary for x in problems] == [None] + [point.state[k] for k in moved]
    match = match and all(x.starts == near.starts for x in others)
    need(match, "starts that do not match")
    own = all(x.startswith("[") == (k in moved) for k, x in enumerate(near.starts))
    form(own, "no interval of starts")
    found = [("%s(%s)" % (point.state[k], point.t0_text), point.starts[k],
              near.starts[k][1:-1].split(", ")) for k in moved]
    if ":" in ends:
        found.append((point.variable, middle, sorted(ends.split(":"), key=fraction)))
    return moved, found


def differences(problems, goals, moved, ends):  # F, and columns of its derivative as intervals
    (point, near), F, columns = problems[:2], [], [[] for _ in moved]
    claims = [{x.name: (x.low, x.high) for x in problem.claims} for problem in problems]

    def claimed(number, name):
        form(name in claims[number], "no claim about '%s'", name)
        return claims[number][name]

    def rate(name):  # the derivative of an unknown by the time, from the unknowns with claims
        known = {x: claims[1][x] for x in near.state[:len(near.starts)] if x in claims[1]}
        for left, text in near.equations:
            if left == name + "'":
                return Enclosures(near.bits).of(Parser(text).tree, known)
        return claimed(1, name + "'")
    for _, name, goal, *_ in goals:
        start = point.start[point.state.index(name)]
        low, high = start if goal == "start" else (fraction(goal),) * 2
        F.append((claimed(0, name)[0] - high, claimed(0, name)[1] - low))
        for number, k in enumerate(moved):
            less = goal == "start" and point.state[k] == name
            column = claimed(number + 1, "d(%s)" % name)
            columns[number].append([end - less for end in column])
    return F, columns + [[rate(goal[1]) for goal in goals] for _ in range(":" in ends)]


def distance(c, intervals, y):  # at least |sum c_i x_i - y|, for x_i in the intervals
    ends = [sorted((k * a, k * b)) for k, (a, b) in zip(c, intervals)]
    return max(abs(sum(x[side] for x in ends) - y) for side in (0, 1))


def check_root(problems, rest):  # the statement of a root
    goals = [line.split(" ") for line in rest.split("\n")]
    form(goals.pop() == [""], "the conditions do not end with a line")
    times = [{c.time for x in group for c in x.claims} for group in (problems[:1], problems[1:])]
    form([len(x) for x in times] == [1, 1], "claims at different times")
    (middle,), (ends,) = times
    moved, unknowns = unknowns_of(problems, middle, ends)
    point, n = problems[0], len(unknowns)
    good = [[x[0], len(x)] for x in goals] == [["root", n + 3]] * n
    form(good and {x[1] for x in goals} <= {*point.state}, "not one condition for each unknown")
    F, columns = differences(problems, goals, moved, ends)
    boxes = [(fraction(m), fraction(a), fraction(b)) for _, m, (a, b) in unknowns]
    radii = [max(Fraction(0), min(m - a, b - m)) for m, a, b in boxes]
    for i, goal in enumerate(goals):
        C = [fraction(x) for x in goal[3:]]
        parts = [distance(C, x, i == j) * radii[j] for j, x in enumerate(columns)]
        total = distance(C, F, 0) + sum(parts)
        need(total < radii[i], "the condition for a root in %s" % unknowns[i][0])
    at, t0 = point.variable if ":" in ends else middle, point.t0_text
    box = ", ".join("%s in [%s, %s]" % (x, *texts) for x, _, texts in unknowns)
    roots = ["    %s(%s) = %s" % (x, at, "%s(%s)" % (x, t0) if y == "start" else y)
             for _, x, y, *_ in goals]
    parts = box, problems[1].head(ends.split(":")), ",\n".join(roots), point.variable, point.notes
    return "For exactly one choice of %s the %s%s.\nThe variable is %s.%s" % parts


# ------------------------------------------------------------------------------------ The file
def text_of(content):  # the text of a certificate, of which a file is the compression
    stream = zlib.decompressobj()
    try:
        text = stream.decompress(content, MOST_TEXT + 1)
    except zlib.error:
        raise Malformed("the file is not a text compressed by zlib") from None
    form(len(text) <= MOST_TEXT, "the text is too long")
    form(stream.eof, "the file is not the whole of a text compressed by zlib")
    form(not stream.unused_data, "something follows the compressed text")
    form(not re.search(rb"[^\n -~]", text), "a character of the text is not printable ASCII")
    return text.decode("ascii")


def main():
    if len(sys.argv) != 2:
        print("usage: libration_check FILE")
        return 2
    try:
        with open(sys.argv[1], "rb") as file:
            print("Proved:\n" + check(text_of(file.read())))
    except (Refused, OSError) as reason:
        print("Not proved: %s" % reason if isinstance(reason, Refused) else "cannot read the file")
        return getattr(reason, "status", 2)
    return 0


if __name__ == "__main__":
    sys.exit(main())
