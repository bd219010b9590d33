#!/usr/bin/env python3
"""certify.py LIBRATION [--folder FOLDER] [--jobs N]: makes certificates with the command LIBRATION, then MANIFEST,
values.csv and README.md; in results/certified without --folder. certified.py checks them.

Times are those of results/reference_problems, as far as a certificate takes less than 30 seconds of processor time and
300 kB, and a few later ones of stiff problems. A certificate that takes more is an error: the others are written, and
the exit status is 1.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import io
import os
import pathlib
import resource
import shlex
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import certified  # noqa: E402

SECONDS, BYTES = 30, 300000


def every(step, count):
    """step, 2 step, .. as decimals."""
    times = [k * Decimal(step) for k in range(1, count + 1)]
    return ",".join(str(int(t)) if t == int(t) else format(t.normalize(), "f") for t in times)


#: Certificate: digits, times, and what `reference` needs besides the problem of the same name.
PLAN = {
    "blasius": (20, every("1", 8)),
    "brusselator": (20, every("2.5", 8)),
    "detest_a1": (50, every("2.5", 8)),
    "detest_a2": (20, every("2.5", 8)),
    "detest_a3": (20, every("2.5", 8)),
    "detest_a4": (20, every("2.5", 8)),
    "detest_b1": (20, every("2.5", 4)),
    "detest_b5": (20, every("2.5", 8)),
    "detest_e2": (20, every("2.5", 8)),
    "detest_e4": (20, every("2.5", 8)),
    "double_pendulum": (20, every("1.25", 1)),
    "duffing": (20, every("2.5", 8)),
    "falkner_skan": (20, every("1", 8)),
    "falkner_skan_flat": (20, every("1", 8), "falkner_skan", "b=0", "s=0.469599988361"),
    "fitzhugh_nagumo": (20, every("5", 8)),
    "harmonic": (20, every("2.5", 8)),
    "henon_heiles": (20, every("5", 4)),
    "hires": (15, every("40.226525", 1)),
    "kepler": (20, every("2.5", 1)),
    "logistic": (20, every("2.5", 8)),
    "lorenz": (20, every("2.5", 4)),
    "lorenz_periodic": (20, every("1.25", 2), "lorenz", "r=100.5"),
    "lotka_volterra": (20, every("2.5", 8)),
    "oregonator": (20, every("2.5", 8)),
    "painleve_1": (20, every("0.25", 8)),
    "painleve_2": (20, every("0.25", 8)),
    "pendulum": (20, every("2.5", 4)),
    "pendulum_179deg": (20, every("2.5", 2), "pendulum", "theta(0)=179/180*pi", "theta'(0)=0"),
    "rayleigh": (20, every("0.1", 8)),
    "riccati": (50, every("0.1875", 8)),
    "robertson": (20, every("5", 8)),
    "robertson_late": (20, "40,4e5,1e11", "robertson"),
    "sakiadis": (20, every("1", 8)),
    "seir": (20, every("5", 8)),
    "sir": (20, every("0.5", 8)),
    "sir_japan": (20, every("5", 8)),
    "stiff_d6": (20, "1"),
    "stiff_e5": (15, "1000"),
    "toda": (20, every("2.5", 4)),
    "van_der_pol": (20, every("5", 2)),
    "van_der_pol_100": (20, every("25", 8), "van_der_pol", "m=100"),
    "van_der_pol_1000": (20, every("125", 8), "van_der_pol", "m=1000"),
    "weierstrass": (20, every("0.1125", 8)),
}


def command_of(name):
    digits, times, *options = PLAN[name]
    problem, sets = (options[0], options[1:]) if options else (name, [])
    words = ["reference", "--problem", problem, *[w for each in sets for w in ("--set", each)],
             "--times", times, "--digits", str(digits)]
    return problem, sets, words


def make(program, folder, name):
    """The entry of MANIFEST, the rows of values.csv and the processor seconds of making and of checking."""
    problem, sets, words = command_of(name)
    file = name + ".cert"
    process = subprocess.Popen([program, *words, "--format", "csv", "--certificate", file], cwd=folder,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS)))
    out, err = process.stdout.read(), process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stdout.close()
    process.stderr.close()
    if process.returncode != 0:
        raise certified.Failure("%s: exit status %d: %s" % (name, process.returncode, err.strip()))
    content = (folder / file).read_bytes()
    if len(content) > BYTES:
        raise certified.Failure("%s: %d bytes are more than %d" % (name, len(content), BYTES))
    statement, checking = certified.prove(certified.CHECKER, folder / file)
    line = "./run %s --certificate %s" % (shlex.join(words), file)
    entry = certified.Entry(hashlib.sha256(content).hexdigest(), name, [line, *statement.split("\n")])
    rows = [[name, problem, "; ".join(sets), *row] for row in values_of(out, PLAN[name][0])]
    return entry, rows, len(content), used.ru_utime + used.ru_stime, checking


def values_of(out, digits):
    """Rows of time, unknown, digits and value from the table that the command prints."""
    for row in csv.DictReader(io.StringIO(out)):
        for unknown, value in row.items():
            if unknown not in ("time", "digits", "rigour", "time_typed"):
                yield [row["time"], unknown, digits, value]


def table_row(name, made):
    entry, rows, size, making, checking = made
    problem, sets, _ = command_of(name)
    shown = problem + (", " + "; ".join(sets) if sets else "")
    last = max((row[3] for row in rows), key=Fraction)
    return "| [%s](%s.cert) | %s | %s | %d | %d | %.1f | %.1f | %.1f |" % (
        name, name, shown, last, PLAN[name][0], len(rows), size / 1000, making, checking)


README = """# Certificates of reference values

Values of classical test problems, each with a file from which
[check/libration_check.py](../../check/libration_check.py) proves it again, in integers, without Libration
([docs/certificates.md](../../docs/certificates.md)). Made by `python3 check/certify.py build/release/libration`; do not edit.

- `./run check` checks all of them: it needs `python3` alone, compiles nothing and installs nothing. `./run check lorenz` checks one.
  `./run check --c` uses [check/c](../../check/c/check.h), with a compiler of C, GMP and zlib.
- `python3 -I check/libration_check.py results/certified/lorenz.cert` prints what one file proves.
- [MANIFEST](MANIFEST) has for each file its SHA-256, the command that made it, and the proved statement.
  In this folder `sha256sum -c MANIFEST` compares the sums.
- [values.csv](values.csv) has for each value the certificate that proves it to one unit in its last digit.

`./run check` also compares the statements with MANIFEST and values.csv, and the values of 50 digits in
[results/reference_problems](../reference_problems), which another computation proved, with the intervals of the certificates.

To the extent possible under law, the authors of Libration have dedicated these data to the public domain:
CC0 1.0 Universal, https://creativecommons.org/publicdomain/zero/1.0/

| certificate | problem | up to | digits | values | kB | s to make | s to check |
| --- | --- | --- | --- | --- | --- | --- | --- |
%s

%d certificates of %d values, together %.0f kB; %.0f s to make and %.0f s to check, in seconds of one processor.
The exact commands:

```text
%s
```
"""


def readme(made):
    rows = [table_row(name, each) for name, each in made.items()]
    total = [sum(each[k] for each in made.values()) for k in (2, 3, 4)]
    return README % ("\n".join(rows), len(made), sum(len(each[1]) for each in made.values()), total[0] / 1000, *total[1:],
                     "\n".join(each[0].command for each in made.values()))


def write(folder, made):
    (folder / "MANIFEST").write_text("#\n".join(each[0].text() for each in made.values()))
    with (folder / "values.csv").open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["certificate", "problem", "set", "time", "unknown", "digits", "value"])
        for each in made.values():
            table.writerows(each[1])
    (folder / "README.md").write_text(readme(made))


def main():
    parser = argparse.ArgumentParser(prog="certify.py", description="makes the certificates of results/certified")
    parser.add_argument("libration", type=pathlib.Path, help="the command")
    parser.add_argument("--folder", type=pathlib.Path, default=certified.HERE.parent / "results" / "certified")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="certificates at a time; one for each core")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    program, made, failed = str(given.libration.resolve()), {}, 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        tasks = {name: pool.submit(make, program, given.folder, name) for name in PLAN}
        for name, task in tasks.items():
            try:
                made[name] = task.result()
            except (certified.Failure, OSError) as reason:
                failed += 1
                print("certify: %s" % reason, file=sys.stderr, flush=True)
                continue
            print("%s: %d bytes" % (name, made[name][2]), file=sys.stderr, flush=True)
    for path in given.folder.glob("*.cert"):
        if path.stem not in made:
            path.unlink()
    write(given.folder, made)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
