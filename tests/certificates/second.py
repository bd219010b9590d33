#!/usr/bin/env python3
"""second.py [--mutations N] [--seed S] [--attacks] [--conditions COMPILER] PROGRAM CERTIFICATE...: compares PROGRAM, made
of check/libration_check.c, with check/libration_check.py.

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

SOURCE = attack.CHECKER.with_suffix(".c")

# Conditions: (name, text of the program, the text with which the condition always holds).
CONDITIONS = [
    ("V is invertible", "need(at_most(plus(most, most), q(1)),", "need(1,"),
    ("start and joint", "need(at_most(total, s->R0[b]),", "need(1,"),
    ("gap of the centres", "Q total = size_of(moved, 1, s->at[b], s->at[b + 1], 0, 1);", "Q total = q(0);"),
    ("old set", "total = plus(total, times(size, old->radii[c]));", "(void)size;"),
    ("growth at the left end", "for (int end = 0; end < 2; ++end)", "for (int end = 1; end < 2; ++end)"),
    ("growth at the right end", "for (int end = 0; end < 2; ++end)", "for (int end = 0; end < 1; ++end)"),
    ("defect", "growth = size_of(f->defect, 1, i, j, 0, 1)", "growth = q(0)"),
    ("change of the derivative", "plus(f.change_of_J[entry], change(rest, reach, rho))", "f.change_of_J[entry]"),
    ("V' in the frame", "derivative(s->V[i]), negative(f->unit)", "nothing, negative(f->unit)"),
    ("claim", "need(at_most(fraction(claim[2]), minus(centre, reach)) && at_most(plus(centre, reach), fraction(claim[3])),",
     "need(1,"),
    ("lower end of a claim", "at_most(fraction(claim[2]), minus(centre, reach)) && ", ""),
    ("upper end of a claim", " && at_most(plus(centre, reach), fraction(claim[3]))", ""),
    ("a claim is in a step", "need(zeros && missing == 0,", "need(zeros,"),
    ("text behind the end", "form(line_at + 2 == line_count && strcmp(lines[line_at], \"end\") == 0 && "
     "lines[line_at + 1][0] == 0,", "form(1,"),
    ("names are different", "form(find_name(&p->scope, name) == NULL,", "form(1,"),
    ("functions of a start", "need(mpq_sgn(a) > 0 && (t->kind == '^' || strcmp(t->name, \"log\") == 0),", "need(1,"),
    ("start of quotients", "need(mpq_sgn(c) > 0 || mpq_sgn(d) < 0,", "need(1,"),
    ("one condition with zeros", "form(conditions == (p->zeros > 0),", "form(1,"),
    ("all zeros are in steps", "need(zeros && missing == 0,", "need(missing == 0,"),
    ("order of the zeros", "need(at_most(place(s, p->ends[k]), place(s, p->ends[k + 1])),", "need(1,"),
    ("a sign between zeros", "need(sign != 0 && (p->sign == 0 || p->sign == sign),", "need(1,"),
    ("signs alternate", "need(sign != 0 && (p->sign == 0 || p->sign == sign),", "need(sign != 0,"),
    ("the derivative at a zero", "if (!at_most(u, v)) continue;", "if (!at_most(u, v) || k % 2 == 1) continue;"),
    ("bound of the slope", "plus(over(times(s->function[k].slope, minus(v, u)), q(2)), s->function[k].reach)",
     "s->function[k].reach"),
    ("distance of the tube", "plus(over(times(s->function[k].slope, minus(v, u)), q(2)), s->function[k].reach)",
     "over(times(s->function[k].slope, minus(v, u)), q(2))"),
    ("change of the condition", "plus(change_of[x->i - n], change(t, reach, rho))", "change_of[x->i - n]"),
    ("a sign over the whole part", " && (way != 0 || sure(s, 0, u, v) != 0)) return left;", ") return left;"),
    ("a sign at the right end", "if (left == sure(s, 0, v, v) && ", "if ("),
    ("the condition is 0 at the start", "p->zero_start = exact && mpq_sgn(total) == 0;", "p->zero_start = exact;"),
    ("an exact start", "p->zero_start = exact && ", "p->zero_start = "),
    ("values move at a zero", "shift(times(norm(derivative(s->p[i])), d), e - s->kp)", "q(0)"),
    ("the frame moves at a zero", "plus(absolute(set.frame[i * n + j]), more)", "absolute(set.frame[i * n + j])"),
    ("radii change at a zero", "up(over(times(absolute(minus(s->R1[b], s->R0[b])), d), two))", "q(0)"),
    ("certificates of one problem", "equal = equal && of_one_problem(point, r->problem[k]);", ";"),
    ("conditions at one time", "mpq_equal(fraction(r->middle), fraction(r->ends))", "1"),
    ("equal starts", "match = match && same_texts(r->problem[k]->start[i], near->start[i]);", ";"),
    ("derivatives by each unknown start", "match = vary != NULL && same_texts(vary, point->scope.name[r->moved[k] + 1].name);", "match = vary != NULL;"),
    ("as many conditions as unknowns", "form(*each[r->goals] == 0 && r->goals == unknowns,", "form(1,"),
    ("a contraction", "need(mpq_cmp(total, r->unknown[i].radius) < 0,", "need(1,"),
    ("the distance of the middle", "Q total = distance(C + i * n, r->F, n, 0);", "Q total = q(0);"),
    ("the matrix is near the inverse", "total = plus(total, times(distance(C + i * n, r->columns + j * n, n, i == j), "
     "r->unknown[j].radius));", ";"),
    ("the middle is in the box", "least(minus(middle, fraction(u->low)), minus(fraction(u->high), middle))",
     "minus(fraction(u->high), middle)"),
    ("derivatives alone", "need(p->vary == NULL,", "need(1,"),
    ("times behind the start", "p->vary != NULL && ordered", "p->vary != NULL"),
    ("derivatives of added unknowns", "p->vary == NULL ? terms(0) : poly_times(rule, along(a->u, p->by_start, p->n))", "terms(0)"),
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
    """Texts by verdict. Both checkers say the same, but in other words about what is not of the format."""

    def __init__(self, module, program):
        self.module, self.program, self.counts = module, program, [0, 0, 0]

    def of(self, name, text):
        expected, found = verdict(self.module, text), self.program.verdict(text)
        if found[0] != expected[0] or (found[0] < 2 and found[1] != expected[1]):
            pathlib.Path("differs.cert").write_bytes(zlib.compress(text.encode()))
            sys.exit("%s, in differs.cert: %s\nbut in C: %s" % (name, expected, found))
        self.counts[found[0]] += 1


def program_without(condition, compiler, folder):
    """Compiles the program without a condition, however its lines are broken."""
    name, old, new = condition
    source, pattern = SOURCE.read_text(), r"\s+".join(map(re.escape, old.split(" ")))
    if len(re.findall(pattern, source)) != 1:
        sys.exit("%s: the program does not contain '%s' once" % (name, old))
    place = pathlib.Path(folder) / "weaker.c"
    place.write_text(re.sub(pattern, lambda _: new, source))
    subprocess.run([compiler, "-std=c11", "-O1", "-w", place, "-lgmp", "-lz", "-o", place.with_suffix("")], check=True)
    return Program(place.with_suffix(""), folder)


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
