# The same as peers/equation_code.hpp, for peers in Python that solve initial value problems. The right-hand sides
# become a function of Python, made of their elementary operations.
import sys


class Stopped(Exception):
    """More evaluations than a run may take."""


FORMS = {
    "constant": "c{k}",
    "variable": "t",
    "sum": "v{a} + v{b}",
    "difference": "v{a} - v{b}",
    "scaled": "v{a} * c{k} * {n:.0f} / {d:.0f}",
    "raised": "v{a} + c{k}",
    "by_time": "t * v{a}",
    "product": "v{a} * v{b}",
    "quotient": "v{a} / v{b}",
    "power": "v{a} ** c{k}",
    "root_beside": "sqrt(1 - v{a} * v{a})",
}
FUNCTIONS = "sqrt exp log sin cos tan atan asin sinh cosh tanh".split()


class Equations:
    """y' = f(t, y): __call__(t, y) counts its evaluations."""

    def __init__(self, words, functions, number):
        def counted(head):
            if next(words) != head:
                sys.exit("expected '" + head + "'")
            return int(next(words))

        real = lambda: float.fromhex(next(words))
        self.limit = int(next(words))  # its word was read
        lines = []
        space = {name: getattr(functions, name) for name in FUNCTIONS}
        for k in range(counted("steps")):
            kind, a, b = next(words), next(words), next(words)
            c, n, d = real(), real(), real()
            space["c%d" % k] = number(c)
            if kind in FUNCTIONS:
                lines.append("v%d = %s(v%s)" % (k, kind, a))
            elif kind not in ("state", "nothing"):
                lines.append("v%d = %s" % (k, FORMS[kind].format(a=a, b=b, k=k, n=n, d=d)))
        states = [(next(words), next(words), real(), real()) for _ in range(counted("states"))]
        self.start = [number(state[2]) for state in states]
        self.scale = [number(state[3]) for state in states]
        times = counted("times")
        self.begin = number(real())
        self.times = [number(real()) for _ in range(times)]
        head = ", ".join("v" + state[0] for state in states) + ", = y"
        body = [head] + lines + ["return [" + ", ".join("v" + state[1] for state in states) + "]"]
        exec("def f(t, y):\n    " + "\n    ".join(body), space)
        self.slopes = space["f"]
        self.evaluations = 0

    def __call__(self, t, y):
        self.evaluations += 1
        if self.evaluations > self.limit:
            raise Stopped
        return self.slopes(t, y)


def answer(version, functions, number, solve):
    """Reads the problem and prints what solve(equations, method, tolerance) returns, the states at all times as floats,
    for each method and tolerance that is asked. None is no answer."""
    words = iter(sys.stdin.read().split())
    if next(words) == "version":
        print(version)
        return
    equations = Equations(words, functions, number)
    next(words)
    for _ in range(int(next(words))):
        method, tolerance = next(words), float.fromhex(next(words))
        equations.evaluations = 0
        try:
            states = solve(equations, method, tolerance)
            outcome = "failed" if states is None else "ended"
        except Stopped:
            outcome = "stopped"
        except (ArithmeticError, ValueError):  # outside the domain of a function
            outcome = "failed"
        print(outcome, equations.evaluations)
        if outcome == "ended":
            for state in states:
                for value in state:
                    print(float(value).hex())
