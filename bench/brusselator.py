#!/usr/bin/env python3
"""Prints the Brusselator with diffusion on N points of a line, 2 N unknowns: for N = 20 the equations of the problem
brusselator_1d of the catalogue.

    python3 bench/brusselator.py 100 > b.ode
    ./run reference --problem ./b.ode --times 10 --digits 20 --integrator collocation
"""

import sys


def equations(points):
    factor = f"alpha*{(points + 1) ** 2}"
    for i in range(1, points + 1):
        def diffusion(name, border):
            before = f"{name}{i - 1}" if i > 1 else border
            after = f"{name}{i + 1}" if i < points else border
            return f"{factor}*({before} - 2*{name}{i} + {after})"

        yield f"u{i}' = 1 + u{i}^2*v{i} - 4*u{i} + {diffusion('u', '1')}"
        yield f"v{i}' = 3*u{i} - u{i}^2*v{i} + {diffusion('v', '3')}"
    for i in range(1, points + 1):
        yield f"u{i}(0) = 1 + sin({2 * i}/{points + 1}*pi)/2; v{i}(0) = 3"
    yield "alpha = 1/50"


if __name__ == "__main__":
    print("\n".join(equations(int(sys.argv[1]))))
