#!/usr/bin/env python3
"""Reaction networks of many unknowns, with the structures of SBML models, as problem files:

    bench/networks.py DIRECTORY
    for each in DIRECTORY/*.ode; do ./run reference --problem "$each" --time 1 --digits 12; done

Chains of conversions, enzymes by Michaelis and Menten and by mass action, cascades of kinases, genes with Hill
functions, receptors and a periodic input; rates from 1e-3 to 1e4, initial values that are 0, conserved totals. The
names are those of the structure and of the number of unknowns. Every number is a decimal, so that the files are exact.
"""

import pathlib
import random
import sys


def rate(chance, least=-3, most=2):
    """A rate of two digits, of any size between 10^least and 10^most."""
    return f"{chance.randint(10, 99)}e{chance.randint(least, most) - 1}"


class Network:
    """The right-hand sides by reactions."""

    def __init__(self):
        self.right, self.start, self.lines = {}, {}, []

    def unknown(self, name, start="0"):
        self.right[name], self.start[name] = [], start

    def reaction(self, consumed, produced, speed):
        """A reaction of this speed; a name may occur on both sides."""
        for name in consumed:
            self.right[name].append(f"- {speed}")
        for name in produced:
            self.right[name].append(f"+ {speed}")

    def text(self):
        lines = [f"{name}' = {' '.join(terms) or '0'}" for name, terms in self.right.items()]
        return "\n".join(lines + [f"{name}(0) = {value}" for name, value in self.start.items()]) + "\n"


def conversions(n, chance):
    """A chain x0 -> x1 -> .. with some reactions back."""
    net = Network()
    for i in range(n):
        net.unknown(f"x{i}", "1" if i == 0 else "0")
    for i in range(n - 1):
        net.reaction([f"x{i}"], [f"x{i + 1}"], f"{rate(chance)}*x{i}")
        if i % 3 == 0:
            net.reaction([f"x{i + 1}"], [f"x{i}"], f"{rate(chance)}*x{i + 1}")
    return net


def enzymes(n, chance):
    """Michaelis and Menten, with an inflow and an inhibitor."""
    net = Network()
    for i in range(n):
        net.unknown(f"s{i}", f"{chance.randint(1, 50)}e-1" if i % 4 else "0")
    net.reaction([], ["s0"], rate(chance, -1, 1))
    for i in range(n - 1):
        inhibition = f"(1 + s{(7 * i + 3) % n}/{rate(chance, 0, 1)})" if i % 5 == 2 else "1"
        speed = f"{rate(chance, -1, 2)}*s{i}/({rate(chance, -1, 1)}*{inhibition} + s{i})"
        net.reaction([f"s{i}"], [f"s{i + 1}"], speed)
    net.reaction([f"s{n - 1}"], [], f"{rate(chance, -1, 0)}*s{n - 1}")
    return net


def mass_action(n, chance):
    """E + S <-> C -> E + P, groups of four that share substrates."""
    net = Network()
    groups = n // 4
    for g in range(groups):
        net.unknown(f"e{g}", "1")
        net.unknown(f"s{g}", "5" if g % 3 == 0 else "0")
        net.unknown(f"c{g}")
        net.unknown(f"p{g}")
    for g in range(groups):
        net.reaction([f"e{g}", f"s{g}"], [f"c{g}"], f"{rate(chance, 0, 3)}*e{g}*s{g}")
        net.reaction([f"c{g}"], [f"e{g}", f"s{g}"], f"{rate(chance, -1, 2)}*c{g}")
        net.reaction([f"c{g}"], [f"e{g}", f"p{g}"], f"{rate(chance, -1, 2)}*c{g}")
        net.reaction([f"p{g}"], [f"s{(g + 1) % groups}"], f"{rate(chance, -2, 1)}*p{g}")
    return net


def cascade(n, chance):
    """Kinases in three states, each phosphorylated by the last state of the level above, as in the MAPK cascade."""
    net = Network()
    levels = n // 3
    for k in range(levels):
        net.unknown(f"m{k}", f"{chance.randint(1, 12)}e2")
        net.unknown(f"mp{k}")
        net.unknown(f"mpp{k}")
    for k in range(levels):
        above = f"mpp{k - 1}" if k else "(1 + sin(3*t)/2)"
        for low, high in ((f"m{k}", f"mp{k}"), (f"mp{k}", f"mpp{k}")):
            net.reaction([low], [high], f"{rate(chance, -2, 0)}*{above}*{low}/({rate(chance, 1, 2)} + {low})")
            net.reaction([high], [low], f"{rate(chance, -1, 1)}*{high}/({rate(chance, 1, 2)} + {high})")
    return net


def genes(n, chance):
    """Messengers and proteins in rings that repress each other by Hill functions."""
    net = Network()
    pairs = n // 2
    for k in range(pairs):
        net.unknown(f"m{k}")
        net.unknown(f"p{k}", f"{chance.randint(0, 9)}")
    for k in range(pairs):
        power = (2, 3, "5/2")[k % 3]
        net.reaction([], [f"m{k}"], f"{rate(chance, 0, 2)}/(1 + (p{(k + 1) % pairs}/{rate(chance, 0, 1)} + 1/10)^({power}))")
        net.reaction([f"m{k}"], [], f"{rate(chance, -1, 1)}*m{k}")
        net.reaction([], [f"p{k}"], f"{rate(chance, -1, 1)}*m{k}")
        net.reaction([f"p{k}"], [], f"{rate(chance, -2, 1)}*p{k}")
    return net


NETWORKS = [(conversions, 25), (enzymes, 25), (mass_action, 28), (genes, 34), (enzymes, 94), (mass_action, 124),
            (conversions, 280), (mass_action, 500), (cascade, 24), (cascade, 120)]


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for make, n in NETWORKS:
        net = make(n, random.Random(n))
        (folder / f"{make.__name__}_{n}.ode").write_text(f"# {n} unknowns: {make.__doc__.splitlines()[0]}\n" + net.text())


if __name__ == "__main__":
    main()
