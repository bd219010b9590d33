#!/usr/bin/env python3
"""Compares the printed values of the SBML semantic test suite with proved ones.

    python3 peers/sbml_suite.py SUITE [--program PATH] [--cases 1-100] [--timeout SECONDS]

SUITE is the folder cases/semantic of the suite, which is not part of this project. Each case is imported, and its
unknowns are proved at its times by `libration reference`. The table on stdout has one row for each case: compared,
beyond its tolerance (with the first such value, its time and the proved one), or the reason for which nothing was
compared. Exit status: 1 if a printed value is beyond its tolerance.
"""

import argparse
import csv
import io
import pathlib
import subprocess
import sys
import tempfile
from decimal import Decimal

VERSIONS = ("l3v2", "l3v1", "l2v5", "l2v4", "l2v3", "l2v2", "l2v1")


def settings_of(folder):
    """The lines `name: value` of the settings of a case."""
    lines = (folder / f"{folder.name}-settings.txt").read_text(encoding="utf-8").splitlines()
    return {name.strip(): value.strip() for name, _, value in (line.partition(":") for line in lines)}


def run(words, limit):
    """Standard output of a program, or the reason for which there is none."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return None, f"no answer in {limit} s"
    return (done.stdout, "") if done.returncode == 0 else (None, done.stderr.strip().splitlines()[-1])


def variables_of(settings):
    return [name.strip() for name in settings["variables"].split(",")]


def named_expressions(text, settings):
    """The variables of a case that are names for expressions, not unknowns or numbers."""
    unknowns = {line.partition("'")[0] for line in text.splitlines() if "' = " in line}
    found = []
    for line in text.splitlines():
        name, _, value = line.partition(" = ")
        if name in variables_of(settings) and name not in unknowns and any(c.isalpha() for c in value):
            found.append(name)
    return found


def proved_rows(program, folder, settings, limit):
    """The rows of the proved table by time, and the reason if there is none."""
    models = [folder / f"{folder.name}-sbml-{version}.xml" for version in VERSIONS]
    model = next((each for each in models if each.exists()), None)
    if model is None:
        return None, "no model"
    text, reason = run([program, "import", str(model)], limit)
    if text is None:
        return None, reason
    start, duration = Decimal(settings["start"] or 0), Decimal(settings["duration"])
    times = f"{start}:{start + duration}:{int(settings['steps']) + 1}"
    with tempfile.TemporaryDirectory() as room:
        problem = pathlib.Path(room) / "model.ode"
        problem.write_text(text, encoding="utf-8")
        shown = named_expressions(text, settings)
        table, reason = run([program, "reference", "--problem", str(problem), f"--times={times}", "--digits", "15",
                             "--format", "csv", *(["--show", ",".join(shown)] if shown else [])], limit)
    if table is None:
        return None, reason
    lines = [line for line in table.splitlines() if not line.startswith("#")]
    return {Decimal(row["time"]): row for row in csv.DictReader(io.StringIO("\n".join(lines)))}, ""


def compared(folder, proved, settings):
    """The number of values compared, and the first one that is beyond the tolerance of the case."""
    absolute, relative = Decimal(settings["absolute"]), Decimal(settings["relative"])
    names = variables_of(settings)
    count, wrong = 0, None
    with open(folder / f"{folder.name}-results.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, skipinitialspace=True):
            row = {name.strip(): value for name, value in row.items() if name}
            time = Decimal(row.get("time", row.get("Time")))
            truth = proved.get(time)
            for name in names if truth else ():
                if not truth.get(name) or name not in row:
                    continue
                count += 1
                difference = abs(Decimal(row[name]) - Decimal(truth[name]))
                if wrong is None and difference > absolute + relative * abs(Decimal(truth[name])):
                    wrong = f"{name}({time}) = {row[name]}, proved {truth[name]}"
    return count, wrong


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("suite", type=pathlib.Path)
    words.add_argument("--program", default="libration")
    words.add_argument("--cases", default="1-99999")
    words.add_argument("--timeout", type=float, default=20)
    given = words.parse_args()
    first, _, last = given.cases.partition("-")
    cases = [each for each in sorted(given.suite.iterdir())
             if each.name.isdigit() and int(first) <= int(each.name) <= int(last or first)]
    if not cases:
        words.error(f"SUITE '{given.suite}' has no cases with these numbers: give the folder cases/semantic")
    status = 0
    for case in cases:
        settings = settings_of(case)
        proved, reason = proved_rows(given.program, case, settings, given.timeout)
        if proved is None:
            print(f"{case.name}  not compared  {reason}", flush=True)
            continue
        count, wrong = compared(case, proved, settings)
        verdict = f"beyond its tolerance  {wrong}" if wrong else f"{count} values agree" if count else \
            "not compared  no value is that of an unknown"
        status = 1 if wrong else status
        print(f"{case.name}  {verdict}", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main())
