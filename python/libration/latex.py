"""LaTeX of equations in the notation of the command, for notebooks."""

from __future__ import annotations

import re

_token = re.compile(r"\s*(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+|[^\W\d]\w*'*|<=|>=|==|!=|\S)")
_greek = set(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega".split()
)
_functions = set("sin cos tan cot sec csc sinh cosh tanh exp log ln max min arcsin arccos arctan".split())
_signs = {"<=": r"\le", ">=": r"\ge", "==": "=", "!=": r"\ne"}
_sum, _product, _power, _atom = range(4)


class _Unclear(Exception):
    """Not of the grammar here: then the text itself is shown."""


def _name(text: str) -> str:
    bare = text.rstrip("'")
    head, _, index = bare.partition("_")
    found = re.fullmatch(r"([^\W\d]+)(\d+)", head)
    if not index and found:
        head, index = found[1], found[2]
    shown = "\\" + head if head in _greek else head if len(head) == 1 else rf"\mathrm{{{head}}}"
    return shown + (rf"_{{{index}}}" if index else "") + "'" * (len(text) - len(bare))


class _Formula:
    """sum = product {+- product}; product = power {*/ power}; power = atom [^ power]."""

    def __init__(self, text: str) -> None:
        self.tokens = [found[1] for found in _token.finditer(text)][::-1]

    def next(self, *expected: str) -> str:
        if not self.tokens or (expected and self.tokens[-1] not in expected):
            return ""
        return self.tokens.pop()

    def whole(self) -> str:
        shown = self.sum()[0]
        while sign := self.next(*_signs, "<", ">", "=", ","):
            shown += f" {_signs.get(sign, sign)} {self.sum()[0]}"
        if self.tokens:
            raise _Unclear
        return shown

    def sum(self) -> tuple[str, int]:
        shown, level = self.product()
        while sign := self.next("+", "-"):
            shown, level = f"{shown} {sign} {self.within(self.product(), _product)}", _sum
        return shown, level

    def product(self) -> tuple[str, int]:
        if self.next("-"):
            return "-" + self.within(self.product(), _product), _sum
        shown, level = self.power()
        while sign := self.next("*", "/"):
            right = self.power()
            if sign == "/":
                shown, level = rf"\frac{{{shown}}}{{{right[0]}}}", _product
            else:
                joint = r" \cdot " if re.match(r"[\d.]", right[0]) else r" \, "
                shown, level = self.within((shown, level), _product) + joint + self.within(right, _product), _product
        return shown, level

    def power(self) -> tuple[str, int]:
        base = self.atom()
        if not self.next("^"):
            return base
        sign = self.next("-")
        return f"{self.within(base, _atom)}^{{{sign}{self.power()[0]}}}", _power

    def atom(self) -> tuple[str, int]:
        token = self.next()
        if token == "(":
            inner = self.sum()
            if not self.next(")"):
                raise _Unclear
            return inner
        if not re.match(r"[\w.]", token):
            raise _Unclear
        if not self.next("("):
            return (_name(token) if re.match(r"[^\W\d]", token) else token), _atom
        if token == "if":
            return self.cases(), _sum
        inside = self.sum()[0]
        while self.next(","):
            inside += f", {self.sum()[0]}"
        if not self.next(")"):
            raise _Unclear
        if token == "sqrt":
            return rf"\sqrt{{{inside}}}", _atom
        head = "\\" + token if token in _functions else _name(token)
        return rf"{head}\left({inside}\right)", _atom

    def cases(self) -> str:
        """The rest of if(condition, value, value)."""
        condition = self.condition()
        values = [self.sum()[0] for _ in range(2) if self.next(",")]
        if len(values) < 2 or not self.next(")"):
            raise _Unclear
        return rf"\begin{{cases}} {values[0]} & \text{{if }} {condition} \\ {values[1]} & \text{{otherwise}} \end{{cases}}"

    def condition(self) -> str:
        """not a < b {and c < d}; groups in parentheses are not of the grammar."""
        shown = self.comparison()
        while word := self.next("and", "or"):
            shown += rf" \text{{ {word} }} {self.comparison()}"
        return shown

    def comparison(self) -> str:
        shown = (r"\text{not } " if self.next("not") else "") + self.sum()[0]
        signs = 0
        while sign := self.next(*_signs, "<", ">"):
            shown, signs = f"{shown} {_signs.get(sign, sign)} {self.sum()[0]}", signs + 1
        if not signs:
            raise _Unclear
        return shown

    @staticmethod
    def within(part: tuple[str, int], least: int) -> str:
        return part[0] if part[1] >= least else rf"\left({part[0]}\right)"


def latex_of(statement: str) -> str:
    """LaTeX of an equation or an initial value; of other statements their text."""
    try:
        return _Formula(statement).whole()
    except _Unclear:
        shown = re.sub(r"([\\{}$&#%_^~])", r"\\\1", statement)
        return rf"\texttt{{{shown}}}"


def statements_of(text: str) -> list[str]:
    """The statements of a problem, without comments."""
    lines = re.sub(r"#[^\n]*", "", text).replace(";", "\n").splitlines()
    return [line.strip().rstrip(",") for line in lines if line.strip()]
