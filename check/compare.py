#!/usr/bin/env python3
"""compare.py CERTIFICATE TABLE [TOLERANCE]: compares a table of numbers with what a certificate proves.

The certificate is proved first, by libration_check.py beside this file. The table has names in its first line, a column time or
that of the variable of the equations, and columns of unknowns, x, x'; cells are separated by commas, semicolons, tabulators or
blanks, and lines that begin with # are left out. A value is ok if it differs from the proved value by at most TOLERANCE, by
default one unit of its last digit. Exit status: 0 if all values are ok, 1 if one misses or the certificate is not proved, 2 if
a file cannot be read, or the certificate does not contain a value.
"""
import importlib.util
import re
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
_spec = importlib.util.spec_from_file_location("libration_check", Path(__file__).with_name("libration_check.py"))
checker = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(checker)


class Unclear(Exception):
    """A table that cannot be compared."""


def fraction(text):
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        raise Unclear("'%s' is not a number" % text) from None


def unit(text):  # of the last digit of a decimal; 0 for a fraction
    found = re.fullmatch(r"[-+]?([0-9]*)\.?([0-9]*)(?:[eE]([-+]?[0-9]+))?", text)
    return Fraction(10) ** (int(found[3] or 0) - len(found[2])) if found else Fraction(0)


def rows_of(text):  # lists of cells, the first one of names
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    if not lines:
        raise Unclear("the table is empty")
    mark = next((mark for mark in ",;\t" if mark in lines[0]), None)
    rows = [[cell.strip().strip('"') for cell in line.split(mark)] for line in lines]
    if any(len(row) != len(rows[0]) for row in rows):
        raise Unclear("a line of the table has another number of cells than the first one")
    return rows


def proved_values(problem):  # bounds by (time, name), also by the double next to the time
    found = {}
    for claim in problem.claims:
        if claim.first == claim.last:
            found[claim.first, claim.name] = (claim.low, claim.high)
    return found


def misses(problem, rows, tolerance):
    names, values = rows[0], proved_values(problem)
    at = next((k for k, name in enumerate(names) if name in ("time", problem.variable)), None)
    if at is None:
        raise Unclear("the table has no column time: its columns are " + ", ".join(names))
    count = 0
    for row in rows[1:]:
        time = fraction(row[at])
        for name, cell in zip(names, row):
            if name not in problem.state:
                continue
            bounds = values.get((time, name)) or values.get((Fraction(float(time)), name))
            if bounds is None:
                raise Unclear("the certificate has no value of %s at time %s" % (name, row[at]))
            value, allowed = fraction(cell), unit(cell) if tolerance is None else tolerance
            error = max(bounds[0] - value, value - bounds[1], Fraction(0))
            if error > allowed:
                count += 1
                print("miss: %s(%s) = %s has an error of at least %.3g" % (name, row[at], cell, float(error)))
    return count


def main():
    if len(sys.argv) not in (3, 4):
        print("usage: compare.py CERTIFICATE TABLE [TOLERANCE]")
        return 2
    try:
        tolerance = fraction(sys.argv[3]) if len(sys.argv) == 4 else None
        rows = rows_of(Path(sys.argv[2]).read_text(encoding="utf-8"))
        problem = checker.check_one(checker.text_of(Path(sys.argv[1]).read_bytes()))
        unknowns = [name for name in rows[0] if name in problem.state]
        for name in rows[0]:
            if name not in (*unknowns, "time", problem.variable):
                raise Unclear("the column %s is none of %s" % (name, ", ".join(problem.state)))
        if not unknowns:
            raise Unclear("the table has none of the columns " + ", ".join(problem.state))
        count = misses(problem, rows, tolerance)
    except checker.Refused as reason:
        print("Not proved: %s" % reason)
        return reason.status
    except (Unclear, OSError, UnicodeDecodeError) as reason:
        print("not compared: %s" % reason)
        return 2
    print("Proved:\n" + problem.statement())
    print("%d rows of %s compared, %d values miss" % (len(rows) - 1, ", ".join(unknowns), count))
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
