"""Equations of SymPy as the text that the library reads. SymPy is imported where it is used alone."""

from __future__ import annotations

from typing import Any

# Of SymPy, and their names here.
_functions = {
    **{name: name for name in "exp log sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh erf erfc sinc".split()},
    **{name: name for name in "cot sec csc acot asec acsc coth sech csch acoth asech acsch sign floor".split()},
    "Abs": "abs", "ceiling": "ceil", "LambertW": "lambertw",
    "airyai": "airy_ai", "airyaiprime": "airy_ai_prime", "airybi": "airy_bi", "airybiprime": "airy_bi_prime",
}
_functions_of_two = {"atan2": "atan2", "Mod": "mod", "Heaviside": "heaviside", "besselj": "bessel_j", "bessely": "bessel_y", "besseli": "bessel_i", "besselk": "bessel_k"}


def _printer(variable: Any) -> Any:
    import sympy
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):
        def _print_Float(self, expr: Any) -> str:
            raise TypeError(f"the float {expr} is in the equations: write Rational(...), or an exact text as a parameter")

        def _print_Exp1(self, expr: Any) -> str:
            return "exp(1)"

        def _print_Derivative(self, expr: Any) -> str:
            if any(symbol != variable for symbol, _ in expr.variable_count):
                raise ValueError(f"{expr} is a derivative by something else than {variable}")
            return self._print(expr.expr) + "'" * sum(int(count) for _, count in expr.variable_count)

        def _print_Function(self, expr: Any) -> str:
            name = expr.func.__name__
            if isinstance(expr, sympy.core.function.AppliedUndef):
                if expr.args != (variable,):
                    raise ValueError(f"{expr} is not a function of {variable} alone")
                return name
            names = _functions if len(expr.args) == 1 else _functions_of_two if len(expr.args) == 2 else {}
            if name not in names:
                raise ValueError(f"the library has no function {name}")
            return f"{names[name]}({', '.join(self._print(each) for each in expr.args)})"

        def _print_LambertW(self, expr: Any) -> str:
            return self._print_Function(expr)

        def _print_Piecewise(self, expr: Any) -> str:
            pieces = (f"({self._print(value)}, {self._print(holds)})" for value, holds in expr.args)
            return f"piecewise({', '.join(pieces)})"

        def _print_Relational(self, expr: Any) -> str:
            return f"{self._print(expr.lhs)} {expr.rel_op} {self._print(expr.rhs)}"

        def _print_And(self, expr: Any) -> str:
            return " and ".join(f"({self._print(each)})" for each in expr.args)

        def _print_Or(self, expr: Any) -> str:
            return " or ".join(f"({self._print(each)})" for each in expr.args)

        def _print_Not(self, expr: Any) -> str:
            return f"not ({self._print(expr.args[0])})"

        def emptyPrinter(self, expr: Any) -> str:
            raise ValueError(f"{expr} of the type {type(expr).__name__} is nothing that the library reads")

    return Printer()


def constant_text(number: Any) -> str:
    """A constant of SymPy, sqrt(2)*pi, as a text. Raises TypeError for floats and for what is not a real constant."""
    import sympy

    if not isinstance(number, sympy.Expr) or number.free_symbols or number.is_real is not True:
        raise TypeError(f"{number} is not a real constant")
    return _printer(None).doprint(number)


def text_of_equations(equations: Any) -> str:
    """Equalities of SymPy, or expressions that are 0, in functions of one variable: Eq(x(t).diff(t), y(t)). Symbols
    besides the variable are parameters. Raises ValueError for what the library has not, TypeError for floats."""
    import sympy

    listed = list(equations) if isinstance(equations, (list, tuple)) else [equations]
    if not all(isinstance(each, (sympy.Eq, sympy.Expr)) for each in listed):
        raise TypeError("a problem is a text, or equations of SymPy")
    unknowns = {each for equation in listed for each in equation.atoms(sympy.core.function.AppliedUndef)}
    variables = {argument for each in unknowns for argument in each.args}
    if len(variables) != 1:
        raise ValueError(f"the unknowns {sorted(map(str, unknowns))} are not functions of one variable")
    variable = variables.pop()
    printer = _printer(variable)
    lines = [] if str(variable) == "t" else [f"variable {variable}"]
    for each in listed:
        left, right = (each.lhs, each.rhs) if isinstance(each, sympy.Eq) else (each, sympy.Integer(0))
        lines.append(f"{printer.doprint(left)} = {printer.doprint(right)}")
    return "\n".join(lines)
