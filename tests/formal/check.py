#!/usr/bin/env python3
"""check.py LIBRATION WORK [EXAMPLE...]: compiles proofs/, makes certificates with the program, converts them, and lets
Coq prove their theorems. It fails if a theorem needs an axiom other than those of Coq's reals and machine integers, and
if Coq accepts a certificate in which one number was changed."""
import pathlib
import re
import subprocess
import sys
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROOFS = ROOT / "proofs"

# Name of the theorem: problem, arguments.
EXAMPLES = {
    "tangent": ("y' = 1 + y^2; y(0) = 0", "--time", "1", "--digits", "30"),
    "lorenz_2": ("lorenz", "--time", "2", "--digits", "20"),
    "pendulum": ("pendulum", "--time", "10", "--digits", "20"),
    "van_der_pol_1e6": ("x'' = ((1 - x^2)*x' - x)/e; x(0) = 2; x'(0) = 0; e = 1/1000000", "--time", "1", "--digits", "20"),
    "robertson_40": ("robertson", "--time", "40", "--digits", "20"),
    "robertson_1e11": ("robertson", "--time", "1e11", "--digits", "20"),
    "lorenz_10": ("lorenz", "--time", "10", "--digits", "20"),
    "names": ("S' = -S*H; H' = S; x' = other_y; other_y' = -x; u_1' = B; B' = 0; S(0) = 1; H(0) = 0; x(0) = 0; other_y(0) = 1; "
              "u_1(0) = 0; B(0) = 1", "--time", "1/4", "--digits", "8"),
}

# Coq's real numbers, and its machine integers with their specification.
ALLOWED = re.compile(r"ClassicalDedekindReals\.(sig_forall_dec|sig_not_dec)|FunctionalExtensionality\."
                     r"functional_extensionality_dep|(PrimInt63|Uint63)\.\w+")


class Failure(Exception):
    pass


def coqc(work, name):
    """The output and the seconds of a compilation, and whether it succeeded."""
    begin = time.monotonic()
    run = subprocess.run(["coqc", "-q", "-R", ".", "Libration", name + ".v"], cwd=work, capture_output=True, text=True)
    return run.returncode == 0, run.stdout + run.stderr, time.monotonic() - begin


def compile_proofs(work):
    """Compiles what changed, and everything behind it."""
    names = [line for line in (PROOFS / "_CoqProject").read_text().split() if line.endswith(".v")]
    if set(names) != {p.name for p in PROOFS.glob("*.v")}:
        raise Failure("proofs/_CoqProject does not list the files of proofs/")
    fresh, seconds = True, 0.0
    for name in names:
        text = (PROOFS / name).read_text()
        code = re.sub(r"\(\*.*?\*\)", "", text, flags=re.S)
        found = re.search(r"\b(Admitted|admit|Axioms?|Conjecture|Parameters?)\b", code)
        if found:
            raise Failure("proofs/%s contains '%s'" % (name, found.group()))
        copy = work / name
        if fresh and copy.exists() and copy.read_text() == text and copy.with_suffix(".vo").exists():
            continue
        fresh = False
        copy.write_text(text)
        passed, output, used = coqc(work, copy.stem)
        if not passed:
            copy.with_suffix(".vo").unlink(missing_ok=True)
            raise Failure("proofs/%s does not compile:\n%s" % (name, output))
        seconds += used
    print("proofs/: %d files, %.0f s" % (len(names), seconds), flush=True)


def make_certificate(program, work, name):
    problem, *arguments = EXAMPLES[name]
    path, begin = work / (name + ".cert"), time.monotonic()
    subprocess.run([program, "reference", "--problem", problem, *arguments, "--certificate", str(path)], check=True,
                   stdout=subprocess.DEVNULL)
    return path, time.monotonic() - begin


def convert(work, path, name):
    run = subprocess.run([sys.executable, "-I", str(PROOFS / "convert.py"), str(path), name], capture_output=True, text=True)
    if run.returncode:
        raise Failure(run.stderr.strip())
    (work / (name + ".v")).write_text(run.stdout)


def axioms(output):
    return [line.split()[0] for line in output.splitlines() if re.match(r"[A-Za-z]\S*( |$)", line) and line != "Axioms:"]


def prove(program, work, name):
    path, made = make_certificate(program, work, name)
    convert(work, path, name)
    passed, output, used = coqc(work, name)
    if not passed:
        raise Failure("%s is not proved:\n%s" % (name, output))
    more = [x for x in axioms(output) if not ALLOWED.fullmatch(x)]
    if more or "Axioms:" not in output:
        raise Failure("%s rests on more axioms: %s" % (name, " ".join(more)))
    print("%-16s %5.0f kB, made in %.0f s, proved in %.0f s" % (name, path.stat().st_size / 1000, made, used), flush=True)
    return path


def changed(lines, word, k, position, change):
    """The lines with a changed field of the k-th line behind the first that begins with a word."""
    at = next(i for i, line in enumerate(lines) if line.startswith(word + " ")) + k
    fields = lines[at].split(" ")
    fields[position] = change(fields[position])
    return "\n".join(lines[:at] + [" ".join(fields)] + lines[at + 1:])


def hexadecimal(change):
    return lambda x: "%x" % change(int(x, 16))


def reject_changes(work, path):
    """One number changed: the conditions must not hold."""
    lines = zlib.decompress(path.read_bytes()).decode().split("\n")
    decimal = lambda x: x[:-1] + str((int(x[-1]) + 5) % 10)  # noqa: E731
    changes = {
        "the length of the first step": changed(lines, "step", 1, 0, hexadecimal(lambda h: h + 1)),
        "a coefficient of the curve": changed(lines, "p", 1, 2, hexadecimal(lambda c: c + 2**20)),
        "a coefficient of the frame": changed(lines, "V", 1, 0, hexadecimal(lambda c: 3 * c)),
        "a coefficient of its inverse": changed(lines, "U", 1, 0, hexadecimal(lambda c: 3 * c)),
        "a radius at the beginning": changed(lines, "radii", 1, 0, hexadecimal(lambda r: r << 340)),
        "a radius at the end": changed(lines, "radii", 2, 0, hexadecimal(lambda r: r >> 8)),
        "the exponents of the curve": changed(lines, "p", 0, 1, lambda k: str(int(k) + 1)),
        "an initial value": changed(lines, "start", 0, 1, lambda x: "1/1000000"),
        "a constant": changed(lines, "equation", 0, 3, lambda x: x + "^3"),
    }
    claim = next(line for line in lines if line.startswith("claim ")).split(" ")
    moved = claim[:3] + [decimal(claim[3]), decimal(claim[4])]
    changes["a claim"] = "\n".join(lines).replace(" ".join(claim), " ".join(moved))
    for number, (what, text) in enumerate(changes.items()):
        name = "wrong_%d" % number
        wrong = work / (name + ".cert")
        wrong.write_bytes(zlib.compress(text.encode()))
        convert(work, wrong, name)
        passed, output, _ = coqc(work, name)
        if passed or "data_ok" not in failing_lemma(work / (name + ".v"), output):
            raise Failure("Coq accepted a certificate with %s changed:\n%s" % (what, output[:2000]))
    print("%d certificates with one number changed: none accepted" % len(changes), flush=True)


def reject_what_is_not_covered(work, path):
    """The converter ends with one line."""
    text = zlib.decompress(path.read_bytes()).decode()
    claim = next(line for line in text.split("\n") if line.startswith("claim ")).split(" ")
    later = claim[:1] + ["1000"] + claim[2:]
    cases = {
        "a claim in no step": text.replace("\nsteps", "\n%s\nsteps" % " ".join(later)),
        "a name that is reserved": text.replace("equation y'", "equation pi'").replace(" y ", " pi "),
        "a definition of pi": text.replace("\nbits", "\ndefine pi = exp(y)\nbits"),
        "names that are confused": text.replace("equation y' = ", "equation the_t' = 0\nequation t' = "),
        "two certificates": text + text,
    }
    for what, changed_text in cases.items():
        wrong = work / "uncovered.cert"
        wrong.write_bytes(zlib.compress(changed_text.encode()))
        run = subprocess.run([sys.executable, "-I", str(PROOFS / "convert.py"), str(wrong), "name"], capture_output=True, text=True)
        if run.returncode != 1 or run.stdout or run.stderr.count("\n") != 1:
            raise Failure("%s: the converter ends with status %d: %s" % (what, run.returncode, run.stdout + run.stderr))
    print("%d certificates that are not covered: each refused in one line" % len(cases), flush=True)


def failing_lemma(path, output):
    """The lines around an error of coqc."""
    found = re.search(r"line (\d+)", output)
    if not found:
        return ""
    k = int(found.group(1))
    return "\n".join(path.read_text().split("\n")[max(0, k - 2):k])


def main():
    program, work, names = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:] or list(EXAMPLES)
    unknown = [x for x in names if x not in EXAMPLES]
    if unknown:
        sys.exit("unknown example '%s': write one of %s" % (unknown[0], ", ".join(EXAMPLES)))
    work.mkdir(parents=True, exist_ok=True)
    try:
        compile_proofs(work)
        for name in names:
            path = prove(program, work, name)
            if name == "tangent":
                reject_what_is_not_covered(work, path)
                reject_changes(work, path)
    except (Failure, subprocess.CalledProcessError) as reason:
        sys.exit("test --formal: %s" % reason)


if __name__ == "__main__":
    main()
