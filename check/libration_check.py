#!/usr/bin/env python3
"""libration_check.py FILE: checks a certificate of values of a differential equation and prints the proved statement.
The format and the theorem are in docs/certificates.md. Integers and fractions only.
Exit status: 0 if it is proved, 1 if a condition does not hold, 2 if the file is not a certificate of this format.

A polynomial in x on [-1, 1] is a list a of integers, with an exponent k that is kept apart:
    2^-k (a[0] + sum over j > 0 of 2 a[j] T_j(x)) = 2^-k (sum over |j| < len(a) of a[|j|] z^j),   x = (z + 1/z)/2,
so that the sum of all |a[|j|]| is a bound, and products are products of polynomials in z."""
import ast, itertools, math, re, sys, zlib
from fractions import Fraction
from functools import cache, reduce

PARTS, ONE, NAME = 8, Fraction(1), r"[^\W\d]\w*'*"          # on each PART of a step the rate of a mode is bounded
class Refused(Exception): status = 1
class Malformed(Refused): status = 2
def need(condition, reason, error=Refused):
    if not condition: raise error(reason)
def form(condition, reason): need(condition, reason, Malformed)
def two(k): return Fraction(2)**k
def root_up(x): return math.isqrt(x - 1) + 1 if x > 0 else 0                            # an integer >= sqrt(x)
def norm(a): return 2 * sum(map(abs, a)) - abs(a[0]) if a else 0                        # at least |a(x)|
def value(a, x):
    """a(x) by Clenshaw's recurrence b_j = a_j + 2 x b_(j+1) - b_(j+2), times powers of the denominator of x."""
    u, v, b, power = x.numerator, x.denominator, [0, 0, 0], 1
    for c in reversed(a):
        b, power = [c * power + 2 * u * b[0] - v * v * b[1], b[0], b[1]], power * v
    return Fraction(b[0] - v * v * b[2], max(power // v, 1))
def derivative(a): return [sum(2 * k * a[k] for k in range(j + 1, len(a), 2)) for j in range(len(a) - 1)]
def scaled(a, c): return [c * x for x in a]
def add(a, b):
    return [x + y for x, y in zip(a + [0] * (len(b) - len(a)), b + [0] * (len(a) - len(b)))]
def dot(u, v):
    """The sum of u[i] v[i], by products of values at z = 256^w, w so large that the coefficients can be read off."""
    pairs = [(a, b) for a, b in zip(u, v) if any(a) and any(b)]
    n = max((len(a) + len(b) for a, b in pairs), default=1) - 1
    w = (sum(norm(a) * norm(b) for a, b in pairs).bit_length() + 9) // 8
    half, halves = 1 << 8 * w - 1, lambda k: int.from_bytes((bytes(w - 1) + b"\x80") * k, "little")    # half sum_i z^i
    def at_z(f): return int.from_bytes(b"".join((c + half).to_bytes(w, "little") for c in f), "little") - halves(len(f))
    total = sum(at_z(a[:0:-1] + a) * at_z(b[:0:-1] + b) << 8 * w * (n + 1 - len(a) - len(b)) for a, b in pairs)
    digits = (total + halves(2 * n - 1)).to_bytes(w * max(2 * n - 1, 0), "little")
    return [int.from_bytes(digits[w * i:w * i + w], "little") - half for i in range(n - 1, 2 * n - 1)]

DERIVATIVES = {"exp": "w", "log": "1/u", "sin": "cos(u)", "cos": "-sin(u)"}
OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^"}
def formula(text):
    """Nested tuples ("+", a, b), ("*", a, b), ("/", a, b), ("^", a, fraction), (function, a); names; fractions."""
    names = []
    def tree(node):
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            kind, a, b = OPERATORS[type(node.op)], tree(node.left), tree(node.right)
            if kind == "^": return kind, a, as_polynomial(b, {}, {}).get((), Fraction(0))
            return ("+", a, ("*", -ONE, b)) if kind == "-" else (kind, a, b)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub): return "*", -ONE, tree(node.operand)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and len(node.args) == 1:
            return names[int(node.func.id[1:])], tree(node.args[0])
        if isinstance(node, ast.Name): return names[int(node.id[1:])]
        if isinstance(node, ast.List) and len(node.elts) == 2: return "between", tree(node.elts[0]), tree(node.elts[1])
        form(isinstance(node, ast.Constant) and type(node.value) is int, "'%s' is not understood" % text)
        return Fraction(node.value)
    code = re.sub(r"(?<!\w)" + NAME, lambda m: names.append(m.group()) or "n%d" % (len(names) - 1), text, 0, re.ASCII)
    form(re.fullmatch(r"(n?\d+|(?!\*\*)[-+*/^()\[\], ])*", code, re.ASCII), "'%s' is not understood" % text)
    return tree(ast.parse(code.strip().replace("^", "**"), mode="eval").body)
# A polynomial in the variable (number 0) and the unknowns (1, 2, ...): {sorted tuple of numbers: coefficient}.
def plus(a, b):
    return {m: x for m in {**a, **b} if (x := a.get(m, 0) + b.get(m, 0))}
def times(a, b):
    form(len(a) * len(b) <= 10**6 and all(len(m) <= 400 for m in [*a, *b]), "a polynomial is too large")
    return reduce(plus, [{tuple(sorted(m + k)): x * y for k, y in b.items()} for m, x in a.items()], {})
def power(a, n):
    form(0 <= n <= 100, "an exponent is out of range")
    return times(a, power(a, n - 1)) if n else {(): ONE}
def partial(a, k):
    return {m[:m.index(k)] + m[m.index(k) + 1:]: x * m.count(k) for m, x in a.items() if k in m}
def along(a, way):                                                 # the derivative of a, from those of its factors
    return reduce(plus, [times(partial(a, k), f) for k, f in way.items()], {})
def as_polynomial(tree, names, added):
    """`names`: polynomials of the names; `added`: those of the added unknowns, by (kind, argument, exponent)."""
    def find(kind, u, exponent=-ONE):
        key = kind, frozenset(u.items()), exponent
        form(key in added, "no added unknown is defined as the '%s' that an equation needs" % kind)
        return added[key]
    if isinstance(tree, Fraction): return {(): tree} if tree else {}
    if isinstance(tree, str):
        form(tree in names, "unknown name '%s'" % tree)
        return names[tree]
    kind, u = tree[0], as_polynomial(tree[1], names, added)
    if kind in ("+", "*", "/"):
        v = as_polynomial(tree[2], names, added)
        if kind == "/": v = {(): 1 / v[()]} if set(v) == {()} else find("/", v)
        return plus(u, v) if kind == "+" else times(u, v)
    if kind != "^": return find(kind, u)
    r = tree[2]
    if r.denominator == 1:
        inverse = {(): ONE / u[()]} if set(u) == {()} else find("/", u) if r < 0 else {}
        return power(u, r.numerator) if r >= 0 else power(inverse, -r.numerator)
    if abs(r.numerator) > 64 or r.denominator > 6: return find("^", u, r)
    k = max(0, math.ceil(r))
    return times(power(u, k), power(find("^", u, Fraction(-1, r.denominator)), k * r.denominator - r.numerator))
class Enclosures:   # values of formulas as pairs (lower, upper) of fractions, to about `bits` bits behind the point
    def __init__(self, bits): self.bits = bits
    def of(self, tree, names):
        if isinstance(tree, Fraction): return tree, tree
        if isinstance(tree, str):
            form(tree in names or tree == "pi", "unknown name '%s'" % tree)
            return names[tree] if tree in names else self.pi()
        kind, (a, b) = tree[0], self.of(tree[1], names)
        if kind in ("+", "*", "/", "between"):
            c, d = self.of(tree[2], names)
            need(kind != "/" or c > 0 or d < 0, "a start divides by 0")
            c, d = (1 / d, 1 / c) if kind == "/" else (c, d)
            four = (a, b, c, d) if kind == "between" else (a * c, a * d, b * c, b * d)
            return (a + c, b + d) if kind == "+" else (min(four), max(four))
        if kind in ("exp", "sin", "cos"):                      # |sin'|, |cos'| <= 1, and exp increases
            low, high = self.entire(a, kind)
            return (low, self.entire(b, kind)[1]) if kind == "exp" else (low - (b - a), high + (b - a))
        r = tree[2] if kind == "^" else ONE
        if kind == "^" and r.denominator == 1 and r >= 0:
            form(r <= 10000, "an exponent is out of range")
            low, high = sorted((a**r.numerator, b**r.numerator))
            return low if r % 2 or a * b > 0 else Fraction(0), high
        need(a > 0 and kind in ("^", "log"), "a start takes the '%s' of a number that is not positive" % kind)
        low, high = sorted((r * self.log(a)[0], r * self.log(b)[1]))                                # a^r = exp(r log a)
        return (low, high) if kind == "log" else (self.entire(low, "exp")[0], self.entire(high, "exp")[1])
    def entire(self, x, kind):
        """By terms x^j/j!: each has an error below 2 e^|x| units, the argument one of e^|x|, the rest is below 8."""
        form(abs(x) < 1000, "a start has an argument that is too large")
        bits = self.bits + 2 * math.ceil(abs(x)) + 40
        factor, t = math.floor(x * two(bits)), [1 << bits]
        while abs(t[-1]) > 1 or len(t) < 2 * abs(x) + 2:
            t.append((t[-1] * factor >> bits) // len(t))
        total = sum(t) if kind == "exp" else sum((-1)**k * c for k, c in enumerate(t[kind == "sin"::2]))
        error = (2 * len(t) + 10) * 3**math.ceil(abs(x))
        return (total - error) * two(-bits), (total + error) * two(-bits)
    def odd_series(self, z, sign):
        """The sum of sign^j z^(2j+1)/(2j+1), |z| <= 1/3, and a bound of its error: 3 units a power, the rest."""
        bits = self.bits + 40
        factor = p = math.floor(z * two(bits))
        total = n = 0
        while abs(p) > 1:
            total, n, p = total + sign**n * (p // (2 * n + 1)), n + 1, (p * factor >> bits) * factor >> bits
        return total * two(-bits), (4 * n + 16) * two(-bits)
    def log(self, x):
        """log(2^k m) = 2 artanh((m - 1)/(m + 1)) + 2 k artanh(1/3), 1/2 <= m <= 2."""
        k = x.numerator.bit_length() - x.denominator.bit_length()
        (a, da), (b, db) = self.odd_series((x - two(k)) / (x + two(k)), 1), self.odd_series(ONE / 3, 1)
        return 2 * (a + k * b - da - abs(k) * db), 2 * (a + k * b + da + abs(k) * db)
    def pi(self):                                  # 16 arctan(1/5) - 4 arctan(1/239)
        (a, da), (b, db) = self.odd_series(ONE / 5, -1), self.odd_series(ONE / 239, -1)
        return 16 * (a - da) - 4 * (b + db), 16 * (a + da) - 4 * (b - db)

class Reader:
    def __init__(self, text): self.lines, self.at = text.split("\n"), 0
    def line(self, word=None):                     # the fields of the next line, behind a word that it begins with
        form(self.at < len(self.lines), "the file ends early")
        t = self.lines[self.at].split(" ") if self.lines[self.at] else []
        self.at += 1
        form(word is None or t[:1] == [word], "line %d: '%s' expected" % (self.at, word))
        return t if word is None else t[1:]
    def all(self, word):                           # the lines that begin with a word
        begins = lambda x: x.startswith(word + " ")
        return [" ".join(self.line(word)) for _ in itertools.takewhile(begins, self.lines[self.at:])]
    def integers(self, word, count):
        t = self.line(word)
        form(len(t) == count and all(re.fullmatch("-?[0-9]{1,5}", x, re.ASCII) for x in t),
             "line %d: %d integers of at most 5 digits expected" % (self.at, count))
        return [int(x) for x in t]
    def section(self, word, exponents, lists):     # a line with exponents, and lists of integers
        k, found = self.integers(word, exponents), [self.line() for _ in range(lists)]
        form(all(re.fullmatch("-?[0-9a-f]+", x, re.ASCII) for t in found for x in t), "'%s': bad coefficients" % word)
        return k, [[int(x, 16) for x in t] for t in found]
def fraction(text):
    form(re.fullmatch(r"-?\d+(/0*[1-9]\d*|(\.\d+)?(e[-+]?\d{1,5})?)", text, re.ASCII), "'%s' is not a number" % text)
    return Fraction(text)
class Problem:      # the head of a certificate: equations, their polynomial form, enclosures of the start, claims
    def __init__(self, r):
        form(r.line("libration-certificate") == ["1"], "not a certificate of version 1")
        self.variable, self.t0 = " ".join(r.line("variable")), fraction(" ".join(r.line("at")))
        self.equations = [x.split(" = ") for x in r.all("equation")]
        form(all(len(x) == 2 and x[0][-1:] == "'" for x in self.equations), "an unclear equation")
        self.state = [x[:len(x) - k] for x, _ in self.equations for k in range(x.count("'"), 0, -1)]
        self.starts, self.vary = r.all("start"), r.all("vary")
        defined, own = [x.split(" = ") for x in r.all("define")], self.state
        names = [self.variable] + own + [x[0] for x in defined]
        form(all(re.fullmatch(NAME, x, re.ASCII) for x in names) and len(self.starts) == len(own)
             and len(set(names)) == len(names) and self.vary in [[]] + [[x] for x in own], "names that do not match")
        self.state = own + ["d(%s)" % x for x in own if self.vary]
        self.condition, (self.bits, start_bits) = r.all("condition"), r.integers("bits", 2)
        form(16 <= self.bits <= start_bits, "the numbers of bits are out of range")
        self.zeros = {"#%d" % (k + 1): x.split(" ") for k, x in enumerate(r.all("zero"))}
        form(len(self.condition) == min(len(self.zeros), 1), "there are zeros without a condition, or two conditions")
        self.ends = [self.t0] + [fraction(t) for first, last in self.zeros.values() for t in (first, last)]
        self.claims = [x.split(" ") for x in r.all("claim")]
        form(self.claims and all(len(x) == 4 and x[1] in self.state for x in self.claims), "an unclear claim")
        for t in [[fraction(y) for y in x[0].split(":")] for x in self.claims if x[0] not in self.zeros]:
            form(len(t) == 1 or len(t) == 2 and self.vary and (t[0] - self.t0) * (t[1] - t[0]) >= 0, "an unclear time")
        (self.steps,), names[1:len(own) + 1] = r.integers("steps", 1), self.state
        self.make_polynomial_form(names, [(name, formula(text)) for name, text in defined], Enclosures(start_bits))
    def make_polynomial_form(self, names, defined, values):
        """right[i] with y_(i+1)' = right[i], by the chain rule if i is not given, and enclosures of the start."""
        own = {x: {(k,): ONE} for k, x in enumerate(names)}
        start, added, arguments = {self.variable: (self.t0, self.t0)}, {}, []
        start.update({name: values.of(formula(text), {}) for name, text in zip(self.state, self.starts)})
        start.update({x: (Fraction(x == "d(%s)" % self.vary[0]),) * 2 for x in self.state if x not in start})
        for name, tree in defined:
            form(type(tree) is tuple and (tree[0] in DERIVATIVES or tree[0] == "^" or tree[:2] == ("/", ONE)),
                 "%s is not defined as a function" % name)
            u = as_polynomial(tree[2 if tree[0] == "/" else 1], {x: own[x] for x in start}, added)
            arguments.append((tree[0], tree[2] if tree[0] == "^" else -ONE, u, name))
            added[tree[0], frozenset(u.items()), arguments[-1][1]] = own[name]
            start[name] = values.of(tree, start)
        self.start, self.functions, self.sign, right = [start[x] for x in names[1:]], [], 0, []
        for name, text in self.equations:
            right += [own[name[:len(name) - k]] for k in range(name.count("'") - 1, 0, -1)]
            right.append(as_polynomial(formula(text), own, added))
        flow = dict(enumerate([{(): ONE}] + right))                # the derivatives by the time, and those by a start
        vary = {k + 1: own["d(%s)" % names[k + 1]] for k, _ in enumerate(right) if self.vary}
        for kind, r, u, name in arguments:
            rule = "(%s)*w" % r + ("^%d" % (r.denominator + 1) if r.numerator == -1 else "/u")          # for powers
            slope = as_polynomial(formula(DERIVATIVES.get(kind, rule)), {"u": u, "w": own[name]}, added)
            for way in flow, vary: way[names.index(name)] = times(slope, along(u, way))
        flow.update({len(right) + k: along(f, vary) for k, f in enumerate(right, 1) if self.vary})
        self.right = [flow[k] for k in range(1, len(names))]
        for g in [as_polynomial(formula(text), own, added) for text in self.condition]:
            exact = all(start[names[l]][0] == start[names[l]][1] for m in g for l in m)
            self.zero_start = exact and sum(c * math.prod(start[names[l]][0] for l in m) for m, c in g.items()) == 0
            self.functions = [g, along(g, flow)]
    def head(self, times):
        ends = sorted([str(self.t0), *times], key=fraction)
        starts = ",  ".join("%s(%s) = %s" % (x, self.t0, y) for x, y in zip(self.state, self.starts))
        equations = ",  ".join("%s = %s" % tuple(x) for x in self.equations)
        return "solution of\n    %s,\n    %s\nexists on [%s, %s], and\n" % (equations, starts, ends[0], ends[-1])
    def statement(self):
        need(not self.vary, "derivatives without a root")
        times = [x[0] for x in self.claims if x[0] not in self.zeros]
        text = "The " + self.head(sum(self.zeros.values(), []) + times)
        for g in self.condition:
            last, all_of_them = self.zeros["#%d" % len(self.zeros)][1], ", ".join(self.zeros)
            text += "%s = 0 from %s, excluded, to %s only at %s, and\n" % (g, self.t0, last, all_of_them)
        zeros = ["    %s lies in [%s, %s]" % (k, *sorted(x, key=fraction)) for k, x in self.zeros.items()]
        return text + ",\n".join(zeros + ["    {1}({0}) lies in [{2}, {3}]".format(*x) for x in self.claims]) + "."
def matrix(n, entry): return [[entry(i, j) for j in range(n)] for i in range(n)]
def size_of(a, rows, columns): return root_up(sum(a[i][j]**2 for i in rows for j in columns))  # at least the norm

class Step:         # polynomials of the scaled unknowns and their frame, brought to one exponent each
    def __init__(self, r, problem, begin):
        self.n, self.problem, self.begin = n, problem, begin = len(problem.right), problem, begin
        (k,), ((h,),) = r.section("step", 1, 1)
        self.length = h * two(-k)
        form(h != 0, "the length is 0")
        self.scales, sizes = r.integers("scale", n), r.line("blocks")
        form(set(sizes) <= {"1", "2"} and sum(map(int, sizes)) == n, "the blocks are not of 1 and 2 columns")
        at = [sum(map(int, sizes[:b])) for b in range(len(sizes) + 1)]
        self.blocks = [range(*x) for x in zip(at, at[1:])]
        (self.kp,), self.p = r.section("p", 1, n)
        (kv, v), (ku, u) = r.section("V", n, n * n), r.section("U", n, n * n)
        self.kv, self.ku = max(0, *kv), max(0, *ku)
        self.V = matrix(n, lambda i, j: scaled(v[i * n + j], 1 << self.kv - kv[j]))
        self.U = matrix(n, lambda i, j: scaled(u[i * n + j], 1 << self.ku - ku[i]))
        k, (first, last) = r.section("radii", len(sizes), 2)
        form(len(first) == len(last) == len(sizes) and min(first + last) >= 0, "the radii are not numbers >= 0")
        self.R0, self.R1 = [[self.up(m * two(-e)) for m, e in zip(x, k)] for x in (first, last)]
    def up(self, x): return math.ceil(x * (1 << self.problem.bits))
    def bound(self, a, k): return self.up(norm(a) * two(-k))  # of |2^-k a(x)|
    def times(self, a, b):                         # the product of two matrices of bounds
        return [[-(-sum(x * y for x, y in zip(row, column)) >> self.problem.bits) for column in zip(*b)] for row in a]
    def check(self, old):
        n, V = self.n, self.V
        Z = matrix(n, lambda i, j: add(dot(self.U[i], [row[j] for row in V]), [-(i == j) << self.ku + self.kv]))
        z = [[self.bound(a, self.ku + self.kv) for a in row] for row in Z]
        one, q = 1 << self.problem.bits, max(map(sum, z))
        need(2 * q <= one, "frame: U is not nearly the inverse of V")
        zz = [-(-(sum(row) << self.problem.bits) // (one - q)) for row in self.times(z, z)]
        self.N1 = matrix(n, lambda i, j: z[i][j] + zz[i] + one * (i == j))            # V^-1 = M U, |M| <= N1
        self.check_joint(old)
        delta, J, DJ, size, Q, k = self.field()
        kb = self.ku + self.kv + k
        H = matrix(n, lambda i, j: add(dot(J[i], [row[j] for row in V]), scaled(derivative(V[i][j]), -Q << k)))
        B = matrix(n, lambda i, j: dot(self.U[i], [row[j] for row in H]))
        bound = [[self.up(norm(a) / (Q * two(kb))) for a in row] for row in B]
        C = self.times([[self.bound(a, self.ku) for a in row] for row in self.U], self.times(DJ, size))
        C = self.times(self.N1, [[x + y for x, y in zip(*rows)] for rows in zip(bound, C)])
        more = matrix(n, lambda i, j: C[i][j] - bound[i][j])                            # |V^-1(..) - B| in the tube
        rates = [self.rate(B, rows, Q * two(kb)) + size_of(more, rows, rows) for rows in self.blocks]
        for end, r in (("left", self.R0), ("right", self.R1)):
            for b, rows in enumerate(self.blocks):
                growth = size_of(delta, rows, range(1)) << self.problem.bits
                growth += sum((rates[b] if c == b else size_of(C, rows, columns)) * r[c]
                              for c, columns in enumerate(self.blocks))
                need(2 * growth <= self.R1[b] - self.R0[b] << self.problem.bits,
                     "growth of the radius of block %d at the %s end" % (b + 1, end))
    def rate(self, B, rows, unit):                 # at least the largest eigenvalue of the symmetric part of a block
        def above(a):
            slope = Fraction(norm(derivative(a)), PARTS)
            return [self.up((value(a, Fraction(2 * k + 1 - PARTS, PARTS)) + slope) / unit) for k in range(PARTS)]
        i = rows[0]
        if len(rows) == 1:
            return min(self.up(norm(B[i][i]) / unit), max(above(B[i][i])))
        a, d, mixed = above(B[i][i]), above(B[i + 1][i + 1]), add(B[i][i + 1], B[i + 1][i])
        c = [max(abs(x), abs(y)) for x, y in zip(above(mixed), above(scaled(mixed, -1)))]
        return max(-(-(x + y + root_up((x - y)**2 + w * w)) // 2) for x, y, w in zip(a, d, c))
    def check_joint(self, old):                    # {centre + frame e}, in which the step begins, is in its tube
        centre, frame, blocks, radii = old
        R, U = range(self.n), [[value(a, -ONE) * two(-self.ku) for a in row] for row in self.U]
        gap = [centre[i] * two(-self.scales[i]) - value(self.p[i], -ONE) * two(-self.kp) for i in R]
        F = [[x * two(-self.scales[i]) for x in frame[i]] for i in R]
        turned = self.times(self.N1, matrix(self.n, lambda i, j: self.up(abs(sum(U[i][l] * F[l][j] for l in R)))))
        moved = self.times(self.N1, [[self.up(abs(sum(U[i][l] * gap[l] for l in R)))] for i in R])
        for b, rows in enumerate(self.blocks):
            total = size_of(moved, rows, range(1)) << self.problem.bits
            total += sum(size_of(turned, rows, columns) * r for columns, r in zip(blocks, radii))
            need(total <= self.R0[b] << self.problem.bits, "start or joint: radius of block %d" % (b + 1))
    def field(self):
        """Bounds of V^-1 (p' - f), J = f_y(p) in units of 1/(Q 2^k), bounds of its change in the tube, and of V."""
        n, right, e = self.n, self.problem.right + self.problem.functions, [0] + self.scales
        unit = [self.length / 2 * two(-x) for x in self.scales] + [ONE, self.length / 2]
        time = [self.begin + self.length / 2, self.length / 4]
        q = math.lcm(*[x.denominator for x in time if any(0 in m for f in right for m in f)])
        kp = max(self.kp, q.bit_length())
        p = [[math.floor(x * q) << kp for x in time]] + [scaled(a, 1 << kp - self.kp) for a in self.p]
        terms = [(i, m, c * unit[i] / q**m.count(0) * two(sum(e[l] for l in m)))
                 for i, f in enumerate(right) for m, c in f.items()]                    # of f in scaled unknowns
        Q, most = math.lcm(*[c.denominator for _, _, c in terms]), max([len(m) for _, m, _ in terms] + [1])
        @cache
        def product(m):
            return dot([product(m[:-1])], [p[m[-1]]]) if m else [1]
        d, J = [scaled(derivative(a), Q << (most - 1) * kp) for a in p[1:]] + [[], []], matrix(n, lambda i, j: [])
        size = [[self.bound(a, self.kv) for a in row] for row in self.V]
        radii = [max(x) for x in zip(self.R0, self.R1)]
        rho = [0] + [-(-sum(size_of([row], [0], rows) * r for rows, r in zip(self.blocks, radii)) >> self.problem.bits)
                     for row in size]
        reach, DJ, Dg = [self.bound(a, kp) for a in p], matrix(n, lambda i, j: 0), [ONE, ONE]
        def change(m):                             # in the tube, of a product of factors
            larger = math.prod(reach[x] + rho[x] for x in m) - math.prod(reach[x] for x in m)
            return Fraction(larger, 1 << self.problem.bits * len(m))
        for i, m, c in terms:
            d[i] = add(d[i], scaled(product(m), -int(c * Q) << (most - len(m)) * kp))
            if i >= n:
                Dg[i - n] += self.up(abs(c) * change(m))
            for at, l in enumerate(m):
                if l and i < n:
                    rest = m[:at] + m[at + 1:]
                    J[i][l - 1] = add(J[i][l - 1], scaled(product(rest), int(c * Q) << (most - len(m)) * kp))
                    DJ[i][l - 1] += self.up(abs(c) * change(rest))
        self.functions = [(scaled(a, -1), norm(derivative(a)), x * Q * two(most * kp - self.problem.bits))
                          for a, x in zip(d[n:], Dg)]
        turned = [[self.up(norm(dot(row, d)) / (Q * two(self.ku + most * kp)))] for row in self.U]
        return self.times(self.N1, turned), J, DJ, size, Q, (most - 1) * kp
    def at(self, x):                               # the set at x: centre, frame, blocks and radii
        return ([value(a, x) * two(e - self.kp) for a, e in zip(self.p, self.scales)],
                [[value(a, x) * two(e - self.kv) for a in row] for row, e in zip(self.V, self.scales)], self.blocks,
                [math.ceil(a + (b - a) * (x + 1) / 2) for a, b in zip(self.R0, self.R1)])
    def places(self, times): return [2 * (t - self.begin) / self.length - 1 for t in times]  # as values of x
    def check_claim(self, claim):                  # true if its last time is in the step: its interval has the tube
        times = self.places(map(fraction, self.problem.zeros.get(claim[0], claim[0].split(":"))))
        u, v = max(times[0], -ONE), min(times[-1], ONE)
        if u > v: return False
        i, d, (centre, frame, blocks, radii) = self.problem.state.index(claim[1]), (v - u) / 2, self.at((u + v) / 2)
        slopes, unit = [norm(derivative(a)) * d for a in [self.p[i]] + self.V[i]], two(self.scales[i])
        row = [[self.up(abs(a) + b * unit * two(-self.kv)) for a, b in zip(frame[i], slopes[1:])]]
        radii = [r + math.ceil(abs(b - a) * d / 2) for r, a, b in zip(radii, self.R0, self.R1)]
        reach = sum(size_of(row, [0], rows) * r for rows, r in zip(blocks, radii)) * two(-2 * self.problem.bits)
        reach += slopes[0] * unit * two(-self.kp)
        need(fraction(claim[2]) <= centre[i] - reach and centre[i] + reach <= fraction(claim[3]),
             "the value of %s at %s is not proved to be in its interval" % (claim[1], claim[0]))
        return times[-1] <= 1
    def sure(self, k, u, v):                       # the sign on [u, v] of the condition, k = 0, or of its derivative,
        a, slope, reach = self.functions[k]        # if the middle and a bound of the slope prove it, or 0
        y = value(a, (u + v) / 2)
        return (y > 0) - (y < 0) if abs(y) > slope * (v - u) / 2 + reach else 0
    def sign(self, u, v):
        """The sign of the condition on [u, v], but for a zero at the start, by halves; 0 if it is not proved."""
        way, starts = self.sure(1, u, v), self.problem.zero_start and self.begin == self.problem.t0 and u == -1
        left = way if starts else self.sure(0, u, u)
        if left == self.sure(0, v, v) and (way or self.sure(0, u, v)):
            return left
        s = self.functions[0][1] * (v - u) > self.functions[0][2] and self.sign(u, (u + v) / 2)
        return s and s * (s == self.sign((u + v) / 2, v))
    def check_zeros(self):                         # true if the last one is before the end of the step
        ends = self.places(self.problem.ends)
        need(ends == sorted(ends), "the zeros are not in the order of the steps")
        for k, (u, v) in enumerate(zip(ends, ends[1:] + ends[-1:])):
            u, v = max(u, -ONE), min(v, ONE)
            if u <= v:                             # signs alternate, those of the derivative at zeros too
                s = (-1)**((k + 1) // 2) * (self.sure(1, u, v) if k % 2 else self.sign(u, v))
                need(s and self.problem.sign in (0, s), "the sign of the condition in its interval %d" % (k + 1))
                self.problem.sign = s
        return ends[-1] <= 1

def check(text):
    """The proved statement; of certificates for one start and, with derivatives, all around it, that of a root."""
    *parts, rest = text.split("\nend\n")
    if len(parts) > 1: return root([check_one(part + "\nend\n") for part in parts], rest.split("\n"))
    return check_one(text).statement()
def distance(c, x, y):                             # at least |sum c_i x_i - y|, x_i intervals
    return max(abs(sum(f(k * a, k * b) for k, (a, b) in zip(c, x)) - y) for f in (min, max))
def root(problems, lines):
    """F(u) = 0 for one u in a box, m in the middle, r at most half of its widths, since |C F(m)| + |1 - C F'| r < r."""
    point, near, names, goals = *problems[:2], problems[0].state, [x.split(" ") for x in lines[:-1]]
    (middle,), (ends,) = [{c[0] for x in y for c in x.claims} for y in (problems[:1], problems[1:])]
    need(len({(x.variable, x.t0, str(x.equations)) for x in problems}) == 1
         and (":" in ends or fraction(middle) == fraction(ends)), "certificates that are not of one problem")
    moved = [k for k, x in enumerate(point.starts) if x != near.starts[k]]
    need(all(x.starts == near.starts for x in problems[1:])
         and [x.vary for x in problems] == [[]] + [[names[k]] for k in moved], "starts that do not match")
    claims = [{x: (fraction(a), fraction(b)) for _, x, a, b in y.claims} for y in problems]
    def gap(k, x, goal):                           # the value less that at the start, or less a number; its derivative
        name, by = "d(%s)" % x if k else x, problems[k]
        a, b = by.start[by.state.index(name)] if goal == "start" else (0 if k else fraction(goal),) * 2
        return claims[k][name][0] - b, claims[k][name][1] - a
    F, *columns = [[gap(k, x, goal) for _, x, goal, *_ in goals] for k in range(len(problems))]
    unknowns = [("%s(%s)" % (names[k], point.t0), point.starts[k], near.starts[k][1:-1].split(", ")) for k in moved]
    if ":" in ends:                                # the time is an unknown, and the derivatives by it are y'
        unknowns.append((point.variable, middle, sorted(ends.split(":"), key=fraction)))
        rates = {x: Enclosures(near.bits).of(formula(y), claims[1]) for x, y in near.equations}
        columns.append([{**claims[1], **rates}[x + "'"] for _, x, *_ in goals])
    radii = [max(0, min(fraction(m) - fraction(a), fraction(b) - fraction(m))) for _, m, (a, b) in unknowns]
    form(not lines[-1] and [x[:1] + [len(x)] for x in goals] == [["root", len(radii) + 3] for _ in radii], "no such roots")
    for i, c in enumerate([[fraction(y) for y in x[3:]] for x in goals]):
        total = distance(c, F, 0) + sum(distance(c, x, i == j) * r for j, (x, r) in enumerate(zip(columns, radii)))
        need(total < radii[i], "the condition for a root in %s" % unknowns[i][0])
    at = "(%s)" % (point.variable if ":" in ends else middle)
    roots = [x + at + " = " + (x + "(%s)" % point.t0 if goal == "start" else goal) for _, x, goal, *_ in goals]
    box = ", ".join("%s in [%s, %s]" % (x, *y) for x, _, y in unknowns)
    return "For exactly one choice of %s the %s    %s." % (box, near.head(ends.split(":")), ",\n    ".join(roots))
def check_one(text):                               # a certificate that is proved
    r = Reader(text)
    problem = Problem(r)
    n, time, claims, zeros = range(len(problem.right)), problem.t0, problem.claims, not problem.condition
    state = ([(a + b) / 2 for a, b in problem.start], matrix(len(n), lambda i, j: ONE * (i == j)),
             [range(i, i + 1) for i in n], [math.ceil((b - a) / 2 * two(problem.bits)) for a, b in problem.start])
    for number in range(1, problem.steps + 1):
        try:
            step = Step(r, problem, time)
            step.check(state)
            claims = [x for x in claims if not step.check_claim(x)]
            zeros = zeros or step.check_zeros()
        except Refused as reason:
            raise type(reason)("step %d: %s" % (number, reason)) from None
        time, state = time + step.length, step.at(ONE)
    form(r.lines[r.at:] == ["end", ""], "the steps do not end with 'end'")
    need(zeros and not claims, "no step contains the time of a claim or a zero")
    return problem

if __name__ == "__main__":
    try:
        form(len(sys.argv) == 2, "usage: python3 -I libration_check.py FILE")
        print("Proved:\n" + check(zlib.decompress(open(sys.argv[1], "rb").read()).decode("ascii")))
    except Exception as reason:                        # Refused, or not a text of the format
        print("Not proved: %s" % (reason if isinstance(reason, (Refused, OSError)) else "no certificate, %r" % reason))
        sys.exit(getattr(reason, "status", 2))
