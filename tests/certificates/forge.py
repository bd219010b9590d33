#!/usr/bin/env python3
"""forge.py [--count N] [--seed S] LIBRATION CHECKER: forges N certificates and lets both checkers judge each.

Honest certificates are made by the program LIBRATION. Each forgery is one of them with a line changed, added, left out,
repeated or moved, with a name that is reserved, with something behind the compressed text, or with narrower numbers.
check/libration_check.py and CHECKER, the program made of check/c, must have the same verdict in the same words, each
within SECONDS; and what they accept must be true as it is printed, by judge.py. The certificates in forged/ must be
refused. Exit status 1 for the first forgery for which that is not so, which is then in forgery.cert.
"""
import argparse
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import zlib
from fractions import Fraction

sys.dont_write_bytecode = True
import judge  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "check"))
import libration_check as checker  # noqa: E402

sys.setrecursionlimit(10000)  # of judge.py
SECONDS = 30  # of a check, on a machine that is busy
RESERVED = ["pi", "e", "exp", "log", "sin", "sqrt", "t", "s", "y'", "x'", "y''", "_1", "_2", "_", "1", "", "d(y)", "#1"]
# Lines for equations and starts, and the conditions of roots and of events.
HONEST = {
    "exponential": ("reference", "--problem", "y' = y; y(0) = 1", "--time", "1/4"),
    "function": ("reference", "--problem", "y' = exp(-y); y(0) = 0", "--time", "1/4,1/2"),
    "variable": ("reference", "--problem", "y' = t*y + sin(y); y(0) = 1", "--time", "1/4"),
    "quotient": ("reference", "--problem", "y' = 1/(1 + y); z' = -z*sqrt(1 + y); y(0) = 0; z(0) = 1", "--time", "1/4"),
    "multiple": ("reference", "--problem", "x'' = -sin(x); x(0) = pi/3; x'(0) = 0", "--time=-1/4"),
    "zeros": ("reference", "--problem", "y'' = -y; y(0) = 0; y'(0) = 1", "--until", "y = 1/2", "--count", "2"),
    "root": ("find", "--problem", "x' = 1; y' = z*y; z' = 0; x(0) = 0; y(0) = 1; z(0) = 1", "--unknown", "z(0)",
             "--such-that", "y(1/4) = 6/5"),
    "two": ("find", "--problem", "y'' = -y; y(0) = 1; y'(0) = 1", "--unknown", "y(0)", "--unknown", "y'(0)",
            "--such-that", "y(1/2) = 1", "--such-that", "y'(1/2) = 0"),
    "orbit": ("find", "--problem", "van_der_pol", "--periodic"),
}


def honest(program, folder):
    """The texts of the honest certificates."""
    texts = {}
    for name, arguments in HONEST.items():
        path = pathlib.Path(folder) / (name + ".cert")
        done = subprocess.run([program, *arguments, "--digits", "8", "--certificate", path], capture_output=True, text=True)
        if done.returncode:
            sys.exit("%s: %s" % (name, done.stderr))
        texts[name] = zlib.decompress(path.read_bytes()).decode()
    texts["other"] = re.sub(r"\bt\b", "s", texts["variable"])  # another variable
    return texts


class Forger:
    """Each method makes a text, or the bytes of a file, from the text of an honest certificate."""

    def __init__(self, seed, texts):
        self.random, self.texts = random.Random(seed), list(texts)

    def pick(self, lines, pattern="."):
        """The place of a line, more often one before the steps."""
        places = [i for i, x in enumerate(lines) if re.match(pattern, x)]
        words = [i for i in places if re.match("[a-z]", lines[i]) and " " in lines[i]]
        return self.random.choice(words if words and self.random.random() < 0.7 else places or [0])

    def remove(self, text):
        lines = text.split("\n")
        del lines[self.pick(lines)]
        return "\n".join(lines)

    def repeat(self, text):
        lines = text.split("\n")
        at = self.pick(lines)
        return "\n".join(lines[:at] + [lines[at]] * self.random.choice([2, 2, 2, 3, 500]) + lines[at + 1:])

    def move(self, text):
        lines = text.split("\n")
        line = lines.pop(self.pick(lines))
        lines.insert(self.pick(lines), line)
        return "\n".join(lines)

    def add(self, text):
        lines = text.split("\n")
        name = self.random.choice(RESERVED)
        line = self.random.choice([
            "define %s = exp(y)" % name, "define %s = 1/y" % name, "define %s = y^(1/2)" % name, "variable %s" % name,
            "equation %s' = 1" % name, "equation %s = 1" % name, "start 0", "start %s" % name, "vary %s" % name,
            "condition %s - 11/10" % name, "zero 1/10 1/5", "claim 1/4 %s 0 9" % name, "claim #1 y 0 9", "claim 0:1/4 y 0 9",
            "root %s 1/4 1" % name, "end", "steps 0", "bits 100 200", "bits 9999 99999", "", "more"])
        lines.insert(self.pick(lines), line)
        return "\n".join(lines)

    def other_line(self, text):
        """A line of another honest certificate instead of one that begins with the same word."""
        lines, others = text.split("\n"), self.random.choice(self.texts).split("\n")
        at = self.pick(lines, "[a-z]")
        same = [x for x in others if x.split(" ")[0] == lines[at].split(" ")[0]]
        lines[at] = self.random.choice(same or others)
        return "\n".join(lines)

    def names(self, text):
        return sorted(set(re.findall(r"(?<![\w'])[A-Za-z_]\w*'*(?=[^\w'])", "\n".join(
            re.findall(r"^(?:variable|equation|define|condition|claim|start|vary|root) (.*)$", text, re.M) + [""]))))

    def rename(self, text):
        """A name becomes a reserved one, or another one, everywhere, in one line, or once."""
        old, new = self.random.choice(self.names(text)), self.random.choice(RESERVED + self.names(text))
        pattern = r"(?<![\w'])%s(?![\w'])" % re.escape(old)
        if self.random.random() < 0.5:
            return re.sub(pattern, lambda _: new, text)
        lines = text.split("\n")
        at = self.pick(lines, ".*" + pattern)
        lines[at] = re.sub(pattern, lambda _: new, lines[at], count=self.random.choice([0, 1]))
        return "\n".join(lines)

    def hide(self, text):
        """A function in an equation or condition becomes the name of its definition, which is a reserved one."""
        found = re.search(r"^define (\S+) = (.*)$", text, re.M)
        if not found:
            return self.rename(text)
        new = self.random.choice(RESERVED)
        lines = [x.replace(found.group(2), new) if x.startswith(("equation", "condition")) else
                 re.sub(r"(?<![\w'])%s(?![\w'])" % found.group(1), lambda _: new, x) for x in text.split("\n")]
        return "\n".join(lines)

    def hide_variable(self, text):
        """The variable or an unknown has a reserved name, in all lines but one."""
        old, new = self.random.choice(self.names(text)), self.random.choice(RESERVED)
        lines = text.split("\n")
        kept = self.pick(lines, "(equation|variable|start|claim|condition)")
        return "\n".join(x if i == kept else re.sub(r"(?<![\w'])%s(?!\w)" % re.escape(old), lambda _: new, x)
                         for i, x in enumerate(lines))

    def narrow(self, text):
        """The interval of a claim, or a zero, is narrower or moved."""
        lines = text.split("\n")
        at = self.pick(lines, "claim|zero")
        fields = lines[at].split(" ")
        try:
            low, high = Fraction(fields[-2]), Fraction(fields[-1])
        except ValueError:
            return self.change(text)
        width, share = high - low, Fraction(self.random.randrange(-40, 40), self.random.choice([10, 40]))
        ends = self.random.choice([(low + share * width, high + share * width), (low + share * width, high),
                                   (low, low + share * width), (low + width * 49 / 100, high - width * 49 / 100)])
        lines[at] = " ".join(fields[:-2] + [str(x) for x in ends])
        return "\n".join(lines)

    def change(self, text):
        """One field of a line, or one character."""
        lines = text.split("\n")
        at = self.pick(lines)
        if self.random.random() < 0.3 and lines[at]:
            k = self.random.randrange(len(lines[at]))
            character = self.random.choice("0123456789abcdef-+*/^()[]., #:'_yxztse\x1b\t\r\0\x7f\u00e9")
            lines[at] = lines[at][:k] + character + lines[at][k + self.random.choice([0, 1]):]
            return "\n".join(lines)
        fields = lines[at].split(" ")
        k = self.random.randrange(len(fields))
        number = self.random.choice(["0", "1", "-1", "2", "7", "1/3", "-1/4", "1e-99999", "1e99999", "1e100000", "99999", "-99999",
                                     "1" * 4400, "1/0", "007", "1_0", "+1", "x'1", "y(1)", "[0, 1]", "[1/4, 1/3]", "pi", "pi - pi",
                                     "#1", "1/4:1/2", "1/4:1/3:1/2", "_1", "(" * 201 + "y" + ")" * 201, "-" * 200 + "y", ""])
        fields[k] = number if self.random.random() < 0.6 or not fields[k] else self.near(fields[k])
        lines[at] = " ".join(fields)
        return "\n".join(lines)

    def near(self, field):
        """A number that is close to this one, by digits."""
        k = self.random.randrange(len(field))
        return field[:k] + self.random.choice("0123456789abcdef") + field[k + 1:]

    def formula(self, text):
        """A formula that holds up a reader, or that only one of two readers might accept."""
        lines = text.split("\n")
        at = self.pick(lines, "equation|define|condition|start")
        begin = lines[at].rfind(" = ") + 3 if " = " in lines[at] else lines[at].index(" ") + 1
        old = lines[at][begin:]
        new = self.random.choice([
            "%s + 0*y", "%s*1", "(%s)", "%s + 1/1000", "%s - 0", "-(-(%s))", "%s^1", "%s/1", "exp(%s, ^pi)", "%s'1", "%s 1",
            "%s^2^3^4", "((10^10000)^10000)^10000", "exp(999)" + "+exp(998)" * 99, "log(2)" + "*log(2)" * 60, "1" * 35 + ";",
            "1" * 60 + "x" + "1" * 60 + "!", "(1+y+y^2)^100", "((1+y)^100)^4 - ((1+y)^100)^4 + %s", "(" * 140 + "%s" + ")" * 140,
            "(" * 160 + "%s" + ")" * 160, "+".join(["%s"] * 300) + "-299*(%s)", "y^(1/10^500)", "y^(10^90)", "%s**1", "%s//1",
            "1e0*(%s)", "0x1*(%s)", "pi*(%s)/pi", "sum(%s)", "product(%s)", "tan(%s)", "sqrt(%s)", "%s + t - t", "1/(y-y) + %s"])
        lines[at] = lines[at][:begin] + new.replace("%s", old)
        return "\n".join(lines)

    def many(self, text):
        """Very many lines of a kind."""
        lines, count = text.split("\n"), self.random.choice([150, 1000, 20000])
        kind = self.random.choice(["claim", "define", "equation", "zero", "start"])
        at = next((i for i, x in enumerate(lines) if x.startswith(kind)), 3)
        made = {"claim": "claim 1/4 y 0 9", "define": "define _%d = exp(y + %d)", "equation": "equation q%d' = %d",
                "zero": "zero 1/10 1/5", "start": "start %d/7%d"}[kind]
        more = [made % (k + 1, k + 1) if "%" in made else made for k in range(count)]
        return "\n".join(lines[:at] + more + lines[at:])

    def numbers(self, text):
        """Numbers of a step: lengths, exponents, radii, coefficients."""
        lines = text.split("\n")
        first = next(i for i, x in enumerate(lines) if x.startswith("step "))
        at = self.random.randrange(first, len(lines))
        fields = lines[at].split(" ")
        k = self.random.randrange(len(fields))
        try:
            n = int(fields[k], 16)
            fields[k] = "%x" % self.random.choice([0, -n, n + 1, n - 1, 2 * n, n >> 1, n << 40, n >> 40, 1])
        except ValueError:
            fields[k] = self.random.choice(["", "0", "g", "--1"])
        lines[at] = " ".join(fields)
        return "\n".join(lines)

    def behind(self, text):
        """Bytes behind the compressed text, or a part of them."""
        whole = zlib.compress(text.encode())
        return self.random.choice([whole + b"x", whole + b"\0", whole + whole, whole[:-1], whole[:-5], whole[1:], b"", b"\n" + whole,
                                   whole[:20] + b"\xff" + whole[21:], text.encode(), zlib.compress(text.encode(), 0) + b"\n"])

    def join(self, text):
        """Several certificates in one text, and their parts."""
        other = self.random.choice(self.texts)
        parts = text.split("\nend\n")
        return self.random.choice([text + other, text + "\n", text + "root y 1 1\n", "\nend\n".join(parts[::-1]), parts[0] + "\nend\n",
                                   "\nend\n".join(parts[1:]), text + text, parts[0] + "\nend\n" + text])

    def forgery(self):
        kinds = [self.remove, self.repeat, self.move, self.add, self.add, self.other_line, self.rename, self.rename, self.hide,
                 self.hide_variable, self.narrow, self.narrow, self.change, self.change, self.formula, self.numbers, self.numbers,
                 self.behind, self.join]
        if self.random.random() < 0.02:
            kinds = [self.many]
        kind, text = self.random.choice(kinds), self.random.choice(self.texts)
        made = kind(text)
        if isinstance(made, str):
            if kind != self.behind and self.random.random() < 0.1:
                made = self.rename(made) if self.names(made) else made
            made = zlib.compress(made.encode("latin-1"), 1)
        return kind.__name__, made


def late(*_):
    raise TimeoutError


def by_python(content):
    """Status and output of check/libration_check.py."""
    signal.signal(signal.SIGVTALRM, late)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
    try:
        return 0, "Proved:\n%s\n" % checker.check(checker.text_of(content))
    except checker.Refused as reason:
        return reason.status, "Not proved: %s\n" % reason
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)


def by_c(program, path):
    done = subprocess.run([program, path], capture_output=True, text=True, errors="replace",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS)))
    return done.returncode, done.stdout + done.stderr


def fault_of(content, program, path):
    """The fault of the verdicts, and the status."""
    path.write_bytes(content)
    try:
        first = by_python(content)
    except TimeoutError:
        return "check/libration_check.py needs more than %d s" % SECONDS, 3
    except Exception as reason:
        return "check/libration_check.py ends with %r" % reason, 3
    second = by_c(program, path)
    if first != second:
        return "the verdicts differ:\n%s\n%s" % (first, second), 3
    if re.search(r"[^\n -~]", first[1]) or (first[0] and first[1].count("\n") != 1):
        return "a message of several lines, or with characters that are not printable: %r" % first[1], 3
    if first[0] == 0:
        stated = first[1][len("Proved:\n"):].splitlines()
        false = judge.falsehood("\n".join(line for line in stated if not line.startswith("Not checked: ")))
        if false:
            return "a FALSE statement is accepted (%s):\n%s" % (false, first[1]), 3
    return "", first[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("libration")
    parser.add_argument("checker")
    asked = parser.parse_args()
    begin, counts = time.monotonic(), [0, 0, 0]
    with tempfile.TemporaryDirectory() as folder:
        path, texts = pathlib.Path(folder) / "text.cert", honest(asked.libration, folder)
        for name, text in texts.items():
            fault, status = fault_of(zlib.compress(text.encode()), asked.checker, path)
            if fault or status:
                sys.exit("the honest certificate '%s' has status %d: %s" % (name, status, fault))
        for file in sorted((HERE / "forged").glob("*.cert")):
            fault, status = fault_of(file.read_bytes(), asked.checker, path)
            if fault or not status:
                sys.exit("%s has status %d: %s" % (file.name, status, fault))
        forger = Forger(asked.seed, texts.values())
        for number in range(asked.count):
            kind, content = forger.forgery()
            fault, status = fault_of(content, asked.checker, path)
            if fault:
                pathlib.Path("forgery.cert").write_bytes(content)
                sys.exit("forgery %d of seed %d (%s), in forgery.cert: %s" % (number, asked.seed, kind, fault))
            counts[status] += 1
    print("%d forgeries: %d accepted with true statements, %d with a condition that does not hold, %d not of the format; "
          "%.0f s" % (asked.count, *counts, time.monotonic() - begin))


if __name__ == "__main__":
    main()
