#!/usr/bin/env python3
"""The problems of problems/arch/ as in the table of the ARCH competition, category NLN, on stdout:

    benchmark,instance,result,time,accuracy,timesteps

result is 1 if what is asked is proved, and 0 otherwise; time is that of the commands in seconds; accuracy is the width
that the competition compares; timesteps counts the steps of all integrations. Why a result is 0 is on stderr: what is
not decided, or a solution that is proved to violate what is asked, as in QUAD20 with D = 0.8.

    bench/arch_comp.py [--libration FILE] [--timeout 10min] [BENCHMARK ...]
"""

import argparse
import csv
import io
import pathlib
import re
import subprocess
import sys
import time
from decimal import Decimal

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "problems" / "arch"


class Undecided(Exception):
    """A command that ends without all of its enclosures, with its last line."""


class Enclosures:
    """Runs the command, and adds up its steps."""

    def __init__(self, libration, timeout, problem, changes, parts):
        self.line = [libration, "reference", "--problem", str(FOLDER / f"{problem}.ode"), "--timeout", timeout]
        self.line += [word for change in changes for word in ("--set", change)]
        self.line += ["--parts", str(parts)] if parts else []
        self.steps = 0

    def rows(self, *options):
        """The rows of the table of the command with these options."""
        ran = subprocess.run([*self.line, *options, "--format", "csv"], capture_output=True, text=True, check=False)
        counted = re.search(r" (\d+) steps?[,\n]", ran.stderr)
        self.steps += int(counted[1]) if counted else 0
        if ran.returncode != 0:
            raise Undecided(ran.stderr.strip().splitlines()[-1])
        return list(csv.DictReader(io.StringIO(ran.stdout)))

    def over(self, spans, *changes):
        """(lower, upper) of each unknown, for each of the spans."""
        bounds = {}
        changed = [word for change in changes for word in ("--set", change)]
        for row in self.rows("--over", spans, *changed):
            bounds.setdefault((row["from"], row["to"]), {})[row["unknown"]] = Decimal(row["lower"]), Decimal(row["upper"])
        return list(bounds.values())

    def numbers_of_events(self, condition, before):
        """The possible numbers of events before a time."""
        rows = self.rows("--until", condition, "--before", before, "--how-many")
        return {int(row["events"]) for row in rows}


def width(bounds):
    """The width of an interval."""
    return bounds[1] - bounds[0]


def robertson(enclosures):
    """The width of x + y + z at time 40."""
    reached = width(enclosures.over("40:40")[0]["s"])
    return reached < Decimal("1e-5"), reached


def laub_loomis(limit):
    """x4 is below the limit up to time 20, and its width there."""

    def question(enclosures):
        below = all(span["x4"][1] < limit for span in enclosures.over("0:20:20"))
        return below, width(enclosures.over("20:20")[0]["x4"])

    return question


def van_der_pol(enclosures):
    """y1 and y2 are below 2.75 up to time 7."""
    spans = enclosures.over("0:7:7")
    return all(span[name][1] < Decimal("2.75") for span in spans for name in ("y1", "y2")), None


def lotka_volterra(enclosures):
    """All solutions cross the circle two or four times; the area of the box at time 3.64."""
    numbers = enclosures.numbers_of_events("(x - 1)^2 + (y - 1)^2 = 0.161^2", "3.64")
    last = enclosures.over("3.64:3.64")[0]
    return numbers <= {2, 4}, width(last["x"]) * width(last["y"])


def quadrotor(d):
    """The height is below 1.4, from time 1 on above 0.9, and within 0.02 of 1 at time 5."""

    def question(enclosures):
        spans = enclosures.over("0:5:5")
        last = enclosures.over("5:5")[0]["x3"]
        safe = all(span["x3"][1] < Decimal("1.4") for span in spans)
        risen = all(span["x3"][0] > Decimal("0.9") for span in spans[1:])
        if not safe:
            report_high_quadrotor(enclosures, [f"x3(0)=-{d}", f"x6(0)=-{d}"])
        return safe and risen and Decimal("0.98") <= last[0] and last[1] <= Decimal("1.02"), width(last)

    return question


def report_high_quadrotor(enclosures, start):
    """Prints whether a single solution of the set is above 1.4 at time 1.2."""
    lower = enclosures.over("1.2:1.2", "D=0", *start)[0]["x3"][0]
    if lower > Decimal("1.4"):
        print(f"QUAD20: violated by the solution with {', '.join(start)}: x3 > 1.4 at time 1.2", file=sys.stderr)


# Benchmark, instance, problem, changes, the most parts of its set, which is None for a single solution, and the question.
INSTANCES = [
    ("ROBE25", "1", "robe25", ["b=100", "c=1000"], None, robertson),
    ("ROBE25", "2", "robe25", ["b=1000", "c=1e5"], None, robertson),
    ("ROBE25", "3", "robe25", ["b=1000", "c=1e7"], None, robertson),
    ("LOVO25", "", "lovo25", [], 64, lotka_volterra),
    ("CVDP23", "", "cvdp23", [], 64, van_der_pol),
    ("LALO20", "W001", "lalo20", ["W=0.01"], 1, laub_loomis(Decimal("4.5"))),
    ("LALO20", "W005", "lalo20", ["W=0.05"], 64, laub_loomis(Decimal("4.5"))),
    ("LALO20", "W01", "lalo20", ["W=0.1"], 64, laub_loomis(Decimal("5"))),
    ("QUAD20", "D01", "quad20", ["D=0.1"], 1, quadrotor("0.1")),
    ("QUAD20", "D04", "quad20", ["D=0.4"], 1, quadrotor("0.4")),
    ("QUAD20", "D08", "quad20", ["D=0.8"], 1, quadrotor("0.8")),
]


def main():
    """The table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--libration", default="build/release/libration", metavar="FILE")
    options.add_argument("--timeout", default="10min", help="of each command")
    options.add_argument("benchmarks", nargs="*", metavar="BENCHMARK")
    asked = options.parse_args()
    print("benchmark,instance,result,time,accuracy,timesteps", flush=True)
    for benchmark, instance, problem, changes, parts, question in INSTANCES:
        if asked.benchmarks and benchmark not in asked.benchmarks:
            continue
        enclosures = Enclosures(asked.libration, asked.timeout, problem, changes, parts)
        start = time.monotonic()
        result, accuracy = False, None
        try:
            result, accuracy = question(enclosures)
        except Undecided as reason:
            print(f"{benchmark} {instance}: {reason}", file=sys.stderr)
        seconds = time.monotonic() - start
        shown = "" if accuracy is None else f"{accuracy:.3g}"
        print(f"{benchmark},{instance},{int(result)},{seconds:.3g},{shown},{enclosures.steps}", flush=True)


if __name__ == "__main__":
    main()
