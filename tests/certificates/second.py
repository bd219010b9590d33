#!/usr/bin/env python3
"""second.py [--mutations N] [--seed S] [--attacks] [--conditions COMPILER] PROGRAM CERTIFICATE...: compares PROGRAM, made
of check/c, with check/libration_check.py.

Both must have the same verdict, in the same words, on the certificates, on N certificates with one character changed of
each, and with --attacks on the false and the boundary certificates of attack.py. With --conditions, each condition of the
program in C is switched off in turn: at least one of these must then be accepted.
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import zlib

sys.dont_write_bytecode = True
import attack  # noqa: E402

SOURCES = {path.name: path.read_text() for path in sorted((attack.CHECKER.parent / "c").glob("*.[ch]"))}

# Conditions: (name, text of the program, the text with which the condition always holds).
CONDITIONS = [
    ("V is invertible", "need(at_most(plus(most, most), q(1)),", "need(1,"),
    ("start and joint", "need(at_most(total, s->R0[b]),", "need(1,"),
    ("gap of the centres", "Q total = size_of(gap, 1, s->at[b], s->at[b + 1], 0, 1);", "Q total = q(0);"),
    ("old set", "total = plus(total, times(size, old->radii[c]));", "(void)size;"),
    ("growth at the left end", 'check_end(s, f, &by, s->R0, "left");', ""),
    ("growth at the right end", 'check_end(s, f, &by, s->R1, "right");', ""),
    ("defect", "growth = size_of(f->defect, 1, i, j, 0, 1)", "growth = q(0)"),
    ("change of the derivative", "plus(f->change_of_J[entry], more)", "f->change_of_J[entry]"),
    ("V' in the frame", "add(JV, derivative(s->V[i]), negative(f->unit))", "JV"),
    ("claim", 'need(within, "the value', 'need(1, "the value'),
    ("lower end of a claim", "at_most(c->low, minus(centre, reach)) && ", ""),
    ("upper end of a claim", " && at_most(plus(centre, reach), c->high)", ""),
    ("a claim is in a step", "return done->claims == p->claims && ", "return "),
    ("text behind the end", "form(ends, ", "form(1, "),
    ("names are different", 'form(!known, "two', 'form(1, "two'),
    ("names without primes", " && strchr(name, '\\'') == NULL", ""),
    ("definitions in equations", "polynomial(by, t, (Names){p->names.name, 1 + p->own})", "polynomial(by, t, (Names){p->names.name, 1 + p->n})"),
    ("functions of a start", 'form(is_function(name), "unknown', 'form(1, "unknown'),
    ("start of quotients", "need(mpq_sgn(x.low) > 0 || mpq_sgn(x.high) < 0,", "need(1,"),
    ("one condition", 'all(r, "condition", 1, &conditions)', 'all(r, "condition", 2, &conditions)'),
    ("all zeros are in steps", " && done->interval == intervals", " + 0 * intervals"),
    ("a sign between zeros", 'need(alternate, "the', 'need(1, "the'),
    ("signs alternate", "sign != 0 && (done->sign == 0 || done->sign == sign)", "sign != 0"),
    ("the derivative at a zero", "sign = k % 2 == 1 ? sure(s, 1, u, v)", "sign = k % 2 == 1 ? done->sign * ((k + 1) / 2 % 2 == 1 ? -1 : 1)"),
    ("bound of the slope", "Q reach = plus(slope, s->function[k].reach);", "Q reach = s->function[k].reach; (void)slope;"),
    ("distance of the tube", "Q reach = plus(slope, s->function[k].reach);", "Q reach = slope;"),
    ("change of the condition", "plus(changes[x->i - n], change(x->t, reach, rho))", "changes[x->i - n]"),
    ("a sign over the whole part", " && (way != 0 || sure(s, 0, u, v) != 0)", ""),
    ("a sign at the right end", "known = left == sure(s, 0, v, v) && ", "known = "),
    ("the condition is 0 at the start", "return mpq_sgn(total) == 0;", "return 1;"),
    ("an exact start", "if (!mpq_equal(start.low, start.high)) return 0;", ""),
    ("values move at a zero", "shift(times(norm(derivative(s->p[i])), half), e - s->kp)", "q(0)"),
    ("the frame moves at a zero", "plus(absolute(value(entry, x)), more)", "absolute(value(entry, x))"),
    ("radii change at a zero", "plus(radius_at(s, b, x), up(more))", "radius_at(s, b, x)"),
    ("certificates of one problem", "same = same && of_one_problem(point, r->problem[k]);", ";"),
    ("conditions at one time", "mpq_equal(fraction(r->middle), fraction(r->ends))", "1"),
    ("equal starts", "match = match && same_texts(r->problem[k]->start[i], near->start[i]);", ";"),
    ("derivatives by each unknown start",
     "match = vary != NULL && same_texts(vary, point->names.name[r->place[k] + 1].name);", "match = vary != NULL;"),
    ("as many conditions as unknowns", 'form(good, "not one condition', 'form(1, "not one condition'),
    ("a contraction", "need(contracts, ", "need(1, "),
    ("the distance of the middle", "Q total = distance(C, r->F, n, 0);", "Q total = q(0);"),
    ("the matrix is near the inverse", "total = plus(total, times(apart, r->unknown[j].radius));", "(void)apart;"),
    ("the middle is in the box", "least(minus(middle, low), minus(high, middle))", "minus(high, middle)"),
    ("derivatives alone", "need(p->vary == NULL,", "need(1,"),
    ("times behind the start", "p->vary != NULL && mpq_sgn(way) >= 0", "p->vary != NULL"),
    ("derivatives of added unknowns", "by_start[k] = poly_times(by, slope, along(by, a->u, by_start, k));",
     "by_start[k] = nothing_at_all();"),
]


class Program:
    """A compiled checker, which reads texts from a file."""

    def __init__(self, path, folder):
        self.path, self.file = path, pathlib.Path(folder) / "text.cert"

    def run(self, text):
        self.file.write_bytes(zlib.compress(text.encode(), 1))
        return subprocess.run([self.path, self.file], capture_output=True, text=True, timeout=600)

    def accepts(self, text):
        return self.run(text).returncode == 0

    def verdict(self, text):
        done = self.run(text)
        lines = done.stdout.count("\n")
        if done.returncode not in (0, 1, 2) or done.stderr or lines < 1 or (done.returncode > 0 and lines > 1):
            sys.exit("%s ends with status %d: %s" % (self.path, done.returncode, done.stdout + done.stderr))
        return done.returncode, done.stdout


def verdict(module, text):
    """Status and output of check/libration_check.py."""
    try:
        return 0, "Proved:\n%s\n" % module.check(text)
    except Exception as reason:
        return getattr(reason, "status", 2), "Not proved: %s\n" % reason


class Comparison:
    """Texts by verdict. Both checkers say the same in the same words."""

    def __init__(self, module, program):
        self.module, self.program, self.counts = module, program, [0, 0, 0]

    def of(self, name, text):
        expected, found = verdict(self.module, text), self.program.verdict(text)
        if found != expected:
            pathlib.Path("differs.cert").write_bytes(zlib.compress(text.encode()))
            sys.exit("%s, in differs.cert: %s\nbut in C: %s" % (name, expected, found))
        self.counts[found[0]] += 1


def program_without(condition, compiler, folder):
    """Compiles the program without a condition, however its lines are broken."""
    name, old, new = condition
    pattern = r"\s+".join(map(re.escape, old.split(" ")))
    found = [file for file, text in SOURCES.items() for _ in re.findall(pattern, text)]
    if len(found) != 1:
        sys.exit("%s: the program does not contain '%s' once" % (name, old))
    for file, text in SOURCES.items():
        (pathlib.Path(folder) / file).write_text(re.sub(pattern, lambda _: new, text) if file == found[0] else text)
    program = pathlib.Path(folder) / "weaker"
    files = sorted(pathlib.Path(folder).glob("*.c"))
    subprocess.run([compiler, "-std=c11", "-O1", "-w", *files, "-lgmp", "-lz", "-o", program], check=True)
    return Program(program, folder)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--mutations", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--attacks", action="store_true", help="compare the false certificates of attack.py, too")
    parser.add_argument("--conditions", metavar="COMPILER", help="switch off each condition")
    parser.add_argument("program")
    parser.add_argument("certificates", nargs="+")
    asked = parser.parse_args()
    module, source = attack.checker(), random.Random(asked.seed)
    texts = [attack.read(path) for path in asked.certificates]
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(module, Program(asked.program, folder))
        for path, text in zip(asked.certificates, texts):
            comparison.of(path, text)
        if comparison.counts[0] < len(texts):
            sys.exit("a certificate is not proved")
        for path, text in zip(asked.certificates, texts):
            for changed in attack.changed_texts(text, asked.mutations, source):
                comparison.of("a changed character of " + path, changed)
        attacks = attack.attacks_on(module, texts) if asked.attacks or asked.conditions else []
        for name, text in attacks:
            comparison.of(name, text)
        print("the same verdicts: %d proved, %d with a condition that does not hold, %d not of the format"
              % tuple(comparison.counts))
        if asked.conditions:
            unseen = attack.first_accepted(
                CONDITIONS, attacks, lambda x: program_without(x, asked.conditions, folder).accepts)
            if unseen:
                sys.exit("conditions that no test sees: " + ", ".join(unseen))


if __name__ == "__main__":
    main()
