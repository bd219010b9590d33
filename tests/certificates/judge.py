"""Whether a statement that a checker prints is true, read as a reader would: by numerical integration of the equations as
they are printed, with a tolerance of 1e-7, for forge.py. Its problems have values of about 1 and claims of 6 digits."""
import math
import re

TOLERANCE = 1e-7
NAME = re.compile(r"[A-Za-z_]\w*'*")
KNOWN = {"exp": math.exp, "log": math.log, "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt}


class Unread(Exception):
    """What a reader cannot read, or a value that is not there."""


def number(text):
    """A fraction, a decimal, or a formula of numbers and pi."""
    return Formula(text, ["pi"])([math.pi])


class Formula:
    """A formula with these names, of which a derivative has primes."""

    def __init__(self, text, names):
        self.names = names
        if not re.fullmatch(r"[\w'+\-*/^(). ]+", text, re.ASCII):
            raise Unread(text)
        for name in re.findall(r"(?<![\w.])" + NAME.pattern, text):
            if name not in names and name not in KNOWN:
                raise Unread("'%s' in '%s' is not a name of the problem" % (name, text))
        code = re.sub(r"[\d.]+(?:e-?\d+)?|" + NAME.pattern, self.token, text).replace("^", "**")
        while "((" in code:  # of pairs of parentheses one is sufficient, as far as Python is concerned
            shorter = re.sub(r"\(\(([^()]*)\)\)", r"(\1)", code)
            if shorter == code:
                break
            code = shorter
        self.code = compile(code, text, "eval")

    def token(self, match):
        """A number, a function, or the place of a name."""
        name = match.group()
        if not NAME.fullmatch(name):
            return "%r" % float(name)
        called = match.string[match.end():].lstrip().startswith("(")
        return name if name in KNOWN and called else "v[%d]" % self.names.index(name)

    def __call__(self, values):
        return eval(self.code, dict(KNOWN), {"v": values})


class Solution:
    """The solution of printed equations with other starts of some unknowns."""

    def __init__(self, text, variable):
        lines = text.split("\n")
        at = lines.index(next(x for x in lines if x.endswith("solution of")))
        equations = [x.split(" = ", 1) for x in lines[at + 1].strip().rstrip(",").split(",  ")]
        starts = [x.split(" = ", 1) for x in re.split(r",  (?=[^\[\]]*\()", lines[at + 2].strip())]
        self.names, self.starts, self.t0 = [], [], None
        for left, right in starts:
            name, time = re.fullmatch(r"(.+)\(([^()]*)\)", left).groups()
            if self.t0 not in (None, number(time)):
                raise Unread(left)
            self.t0 = number(time)
            self.names.append(name)
            ends = [number(x) for x in right.strip("[]").split(", ")]
            self.starts.append(sum(ends) / len(ends))
        self.equations = {left[:-1]: Formula(right, [variable] + self.names) for left, right in equations}
        self.variable = variable

    def slope(self, t, y):
        values = [t] + y
        result = []
        for name in self.names:
            if name in self.equations:
                result.append(self.equations[name](values))
            else:
                result.append(y[self.names.index(name + "'")])
        return result

    def path(self, end, starts=None, steps=600):
        """Times and states of a Runge-Kutta method of order 4."""
        t, y = self.t0, list(starts or self.starts)
        h = (end - t) / steps
        yield t, y
        for k in range(steps):
            a = self.slope(t, y)
            b = self.slope(t + h / 2, [x + h / 2 * s for x, s in zip(y, a)])
            c = self.slope(t + h / 2, [x + h / 2 * s for x, s in zip(y, b)])
            d = self.slope(t + h, [x + h * s for x, s in zip(y, c)])
            y = [x + h / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(y, a, b, c, d)]
            t = self.t0 + (k + 1) * h
            yield t, y

    def at(self, end, starts=None):
        return list(self.path(end, starts))[-1][1]


def within(x, low, high):
    return number(low) - TOLERANCE <= x <= number(high) + TOLERANCE


def zeros_of(solution, condition, end):
    """The zeros behind the start and up to the end, by signs on a fine path and a secant."""
    g, found, before = Formula(condition, [solution.variable] + solution.names), [], None
    for t, y in solution.path(end, steps=4000):
        now = t, g([t] + y)
        if before and before[1] * now[1] < 0 and abs(before[0] - solution.t0) > 1e-9:
            u, v = before, now
            for _ in range(6):
                t = u[0] - u[1] * (v[0] - u[0]) / (v[1] - u[1])
                w = t, g([t] + solution.at(t))
                u, v = (u, w) if u[1] * w[1] < 0 else (w, v)
                if w[1] == 0 or u[1] == v[1]:
                    break
            found.append(t)
        if abs(now[1]) > 1e-12:
            before = now
    return found


def check_values(text, variable):
    """Intervals of values, and zeros."""
    solution, times = Solution(text, variable), {}
    condition = re.search(r"^(.+) = 0 from (\S+), excluded, to (\S+) only at (.+), and$", text, re.M)
    if condition:
        end = number(condition.group(3))
        listed = condition.group(4).split(", ")
        found = zeros_of(solution, condition.group(1), end)
        if len(found) != len(listed):
            raise Unread("the zeros are %s" % found)
        times = dict(zip(listed, found))
        for name, low, high in re.findall(r"^    (#\d+) lies in \[(\S+), (\S+)\]", text, re.M):
            if not within(times[name], low, high):
                raise Unread("%s is at %s" % (name, times[name]))
    for name, time, low, high in re.findall(r"^    ([^#(\s]+)\((\S+?)\) lies in \[(\S+), (\S+)\]", text, re.M):
        state = solution.at(times[time] if time in times else number(time))
        value = state[solution.names.index(name)]
        if not within(value, low, high):
            raise Unread("%s(%s) is %s" % (name, time, value))


def solved(matrix, right):
    """Gauss's elimination."""
    n, rows = len(right), [list(a) + [b] for a, b in zip(matrix, right)]
    for i in range(n):
        rows[i:] = sorted(rows[i:], key=lambda row: -abs(row[i]))
        if abs(rows[i][i]) < 1e-9:
            raise Unread("the root is not isolated")
        for j in range(n):
            if j != i:
                c = rows[j][i] / rows[i][i]
                rows[j] = [x - c * y for x, y in zip(rows[j], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def check_root(text, variable):
    """Newton's method from the middle of the box ends in the box, and its matrix is invertible there."""
    solution = Solution(text, variable)
    first = text.split("\n")[0]
    box = re.findall(r"(\S+) in \[(\S+), (\S+)\]", first)
    goals = re.findall(r"^    (\S+)\(([^()]+)\) = (.+?)[,.]$", "\n".join(text.split("\n")[4:]), re.M)
    if len(box) != len(goals) or not box:
        raise Unread("a root without its conditions")
    u = [(number(a) + number(b)) / 2 for _, a, b in box]
    at = goals[0][1]

    def residuals(u):
        starts, end = list(solution.starts), None if at == variable else number(at)
        for (name, _, _), x in zip(box, u):
            if name == variable:
                end = x
            else:
                starts[solution.names.index(re.fullmatch(r"(.+)\([^()]*\)", name).group(1))] = x
        state = solution.at(end, starts)
        result = []
        for name, _, goal in goals:
            k = solution.names.index(name)
            result.append(state[k] - (starts[k] if goal.startswith(name + "(") else number(goal)))
        return result
    for _ in range(5):
        F = residuals(u)
        columns = []
        for j in range(len(u)):
            moved = [x + 1e-6 * (i == j) for i, x in enumerate(u)]
            columns.append([(a - b) / 1e-6 for a, b in zip(residuals(moved), F)])
        u = [x - d for x, d in zip(u, solved(list(zip(*columns)), F))]
    for x, (name, low, high) in zip(u, box):
        if not within(x, low, high):
            raise Unread("the root has %s = %s" % (name, x))


def falsehood(text):
    """What is false about a statement, or nothing."""
    try:
        variable = re.search(r"\nThe variable is (\S+)\.$", text).group(1)
        if text.startswith("For exactly one choice of "):
            check_root(text, variable)
        else:
            check_values(text, variable)
    except (Unread, ValueError, ArithmeticError, AttributeError, LookupError, TypeError, SyntaxError, StopIteration,
            RecursionError) as reason:
        return "%s: %s" % (type(reason).__name__, reason)
    return ""
