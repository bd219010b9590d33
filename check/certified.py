#!/usr/bin/env python3
"""certified.py [--c] [--folder FOLDER] [NAME...]: checks the certificates of a folder, results/certified without
--folder, or those that are named. It needs Python's standard library alone; with --c a compiler of C, GMP and zlib, for
the checker in check/c instead of check/libration_check.py.

For each certificate of MANIFEST: its file has the SHA-256; the checker proves exactly the statement; the
rows of values.csv are its claims, each value within one unit of its last digit; and where results/reference_problems has
the value too, that lies in the proved interval. Prints a table; exit status 1 if a certificate fails, 2 for wrong usage.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from decimal import Decimal
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
CHECKER = [sys.executable, "-I", str(HERE / "libration_check.py")]
REFERENCE = HERE.parent / "results" / "reference_problems"
CLAIM = re.compile(r"^    (\S+)\((\S+)\) lies in \[(\S+), (\S+)\][,.]$", re.M)
ENTRY = re.compile(r"^([0-9a-f]{64})  (\w+)\.cert$")


class Failure(Exception):
    pass


class Entry:
    """The part of MANIFEST about one certificate."""
    def __init__(self, sha256, name, lines):
        self.sha256, self.name = sha256, name
        self.command = lines[0] if lines else ""
        self.statement = "\n".join(lines[1:])

    def text(self):
        comments = [self.command, *self.statement.split("\n")]
        return "\n".join(["%s  %s.cert" % (self.sha256, self.name), *["# " + line for line in comments]]) + "\n"


def read_manifest(path):
    """The entries of a file that `sha256sum -c` accepts: a line for each file, comments behind it."""
    entries, found = [], None
    for line in path.read_text().splitlines():
        match = ENTRY.match(line)
        if match:
            found = (*match.groups(), [])
            entries.append(found)
        elif not line.startswith("#"):
            raise Failure("%s has the line '%s', which is neither a file nor a comment" % (path, line))
        elif found and line.startswith("# "):
            found[2].append(line[2:])
    return [Entry(*each) for each in entries]


def checker_in_c(folder):
    """The command of the checker in check/c, compiled in a folder."""
    program, compiler = str(pathlib.Path(folder) / "libration_check"), os.environ.get("CC", "cc")
    try:
        subprocess.run([compiler, "-O2", *map(str, sorted((HERE / "c").glob("*.c"))), "-lgmp", "-lz", "-o", program], check=True)
    except (OSError, subprocess.CalledProcessError) as reason:
        raise Failure("--c: %s; install a compiler of C, GMP and zlib (Debian: gcc libgmp-dev zlib1g-dev), or set CC"
                      % reason) from None
    return [program]


def prove(checker, file):
    """The statement that the checker proves from a file, without its last line, which names the variable, and its
    processor seconds."""
    process = subprocess.Popen([*checker, str(file)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    out = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stdout.close()
    if process.returncode != 0 or not out.startswith("Proved:\n"):
        raise Failure(out.strip().replace("\n", "; ") or "the checker ended without a message")
    statement, _, variable = out[len("Proved:\n"):].rpartition("\nThe variable is ")
    if not re.fullmatch(r"\w+\.\n", variable):
        raise Failure("the checker does not name the variable")
    return statement, used.ru_utime + used.ru_stime


def claims_of(statement):
    """{(time, unknown): (low, high)}"""
    return {(Fraction(time), name): (Decimal(low), Decimal(high))
            for name, time, low, high in CLAIM.findall(statement)}


def reference_values(name):
    """The values of results/reference_problems with that name, if there are any: 50 digits of another proof."""
    path = REFERENCE / (name + ".csv")
    if not path.exists():
        return {}
    with path.open(newline="") as file:
        return {(Fraction(row["time"]), row["unknown"]): Decimal(row["value"]) for row in csv.DictReader(file)}


def check_values(rows, statement, name):
    claims = claims_of(statement)
    keys = [(Fraction(row["time"]), row["unknown"]) for row in rows]
    if sorted(keys) != sorted(claims):
        raise Failure("the rows of values.csv are not the claims of the statement")
    known = reference_values(name)
    for key, row in zip(keys, rows):
        low, high = claims[key]
        value = Decimal(row["value"])
        unit = Decimal(1).scaleb(value.as_tuple().exponent)
        if len(value.as_tuple().digits) != int(row["digits"]) or value - low != unit or high - value != unit:
            raise Failure("%s(%s) = %s of values.csv is not the claim with %s digits"
                          % (key[1], row["time"], row["value"], row["digits"]))
        if key in known and not low <= known[key] <= high:
            raise Failure("%s(%s) = %s of results/reference_problems is not in the proved interval"
                          % (key[1], row["time"], known[key]))
    return len(rows)


def check(checker, folder, entry, rows):
    """The bytes, the processor seconds and the number of values of a certificate; raises Failure."""
    file = folder / (entry.name + ".cert")
    if not file.exists():
        raise Failure("the file is missing")
    content = file.read_bytes()
    if hashlib.sha256(content).hexdigest() != entry.sha256:
        raise Failure("the SHA-256 is not that of MANIFEST")
    statement, seconds = prove(checker, file)
    if statement != entry.statement:
        raise Failure("the proved statement is not that of MANIFEST")
    return len(content), seconds, check_values(rows, statement, entry.name)


def rows_by_certificate(path):
    rows = {}
    with path.open(newline="") as file:
        for row in csv.DictReader(file):
            rows.setdefault(row["certificate"], []).append(row)
    return rows


def select(folder, entries, rows, names):
    known = [entry.name for entry in entries]
    unlisted = {p.stem for p in folder.glob("*.cert")} | set(rows)
    if unlisted - set(known):
        raise Failure("MANIFEST does not list %s" % ", ".join(sorted(unlisted - set(known))))
    if not entries or len(set(known)) != len(known):
        raise Failure("MANIFEST lists no certificate, or one twice")
    for name in names:
        if name not in known:
            raise Failure("there is no certificate '%s': write one of %s" % (name, " ".join(known)))
    return [entry for entry in entries if not names or entry.name in names]


def check_folder(checker, folder, names):
    """Prints a table; the number of certificates that fail."""
    rows = rows_by_certificate(folder / "values.csv")
    entries = select(folder, read_manifest(folder / "MANIFEST"), rows, names)
    failed, size, values = 0, 0, 0
    width = max(len(entry.name) for entry in entries)
    print("%-*s  values      kB  seconds  result" % (width, "certificate"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        tasks = [pool.submit(check, checker, folder, entry, rows.get(entry.name, [])) for entry in entries]
        for entry, task in zip(entries, tasks):
            try:
                done = task.result()
            except (Failure, ArithmeticError, ValueError, OSError) as reason:
                failed += 1
                print("%-*s  %6s  %6s  %7s  not proved: %s" % (width, entry.name, "", "", "", reason))
                continue
            print("%-*s  %6d  %6.1f  %7.2f  proved" % (width, entry.name, done[2], done[0] / 1000, done[1]))
            size, values = size + done[0], values + done[2]
    print("%d of %d certificates are proved: %d values, %.0f kB" % (len(entries) - failed, len(entries), values, size / 1000))
    return failed


def main():
    parser = argparse.ArgumentParser(prog="./run check", description="checks the certificates of results/certified")
    parser.add_argument("--folder", type=pathlib.Path, default=HERE.parent / "results" / "certified")
    parser.add_argument("--c", action="store_true", help="by the checker in check/c, which is compiled")
    parser.add_argument("names", nargs="*", metavar="NAME", help="a certificate; all of them without a name")
    given = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as place:
            checker = checker_in_c(place) if given.c else CHECKER
            return 1 if check_folder(checker, given.folder, given.names) else 0
    except (Failure, OSError, KeyError) as reason:
        print("check: %s" % reason, file=sys.stderr)
        return 2 if given.names or given.c else 1


if __name__ == "__main__":
    sys.exit(main())
