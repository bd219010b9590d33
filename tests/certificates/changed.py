#!/usr/bin/env python3
"""changed.py WORK: check/certified.py accepts copies of three certificates of results/certified, and reports each change:
of a byte of a certificate, also where MANIFEST has its new sum; of a statement; of a printed value; a missing file, and one
that MANIFEST does not list."""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
PUBLISHED = ROOT / "results" / "certified"
NAMES = ["logistic", "harmonic", "painleve_2"]


def run(folder, *names):
    done = subprocess.run([sys.executable, "-I", str(ROOT / "check" / "certified.py"), "--folder", str(folder), *names],
                          capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def copy(folder):
    """Three certificates with their part of MANIFEST and of values.csv."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in NAMES:
        shutil.copy(PUBLISHED / (name + ".cert"), folder)
    entries = (PUBLISHED / "MANIFEST").read_text().split("#\n")
    (folder / "MANIFEST").write_text("#\n".join(e for e in entries if e.split("\n")[0][66:-5] in NAMES))
    lines = (PUBLISHED / "values.csv").read_text().splitlines(keepends=True)
    (folder / "values.csv").write_text("".join([lines[0]] + [x for x in lines[1:] if x.split(",")[0] in NAMES]))


def replace(path, old, new):
    text = path.read_text()
    if text.count(old) != 1:
        sys.exit("%s does not contain '%s' once" % (path, old))
    path.write_text(text.replace(old, new))


def change_byte(folder):
    file = folder / "logistic.cert"
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def change_start(folder):
    """Another equation, in a valid file whose sum is that of MANIFEST."""
    file = folder / "logistic.cert"
    old = file.read_bytes()
    text = zlib.decompress(old)
    new = zlib.compress(text.replace(b"\nstart 1/2\n", b"\nstart 1/3\n"))
    if zlib.decompress(new) == text:
        sys.exit("%s does not contain the start that this test changes" % file)
    file.write_bytes(new)
    replace(folder / "MANIFEST", hashlib.sha256(old).hexdigest(), hashlib.sha256(new).hexdigest())


def change_value(folder):
    """The last digit of a value of the table."""
    path = folder / "values.csv"
    lines = path.read_text().splitlines(keepends=True)
    at = next(k for k, line in enumerate(lines) if line.startswith("logistic,"))
    lines[at] = lines[at][:-2] + str((int(lines[at][-2]) + 1) % 10) + "\n"
    path.write_text("".join(lines))


#: What is changed, and part of the message.
CHANGES = {
    "a byte of a certificate": (change_byte, "the SHA-256 is not that of MANIFEST"),
    "the start in a certificate": (change_start, "not proved: Not proved: step 1: start or joint"),
    "a statement": (lambda f: replace(f / "MANIFEST", "y' = y*(-y + 1)", "y' = y*(-y + 2)"),
                    "the proved statement is not that of MANIFEST"),
    "a printed value": (change_value, "is not the claim with"),
    "a certificate without its file": (lambda f: (f / "logistic.cert").unlink(), "the file is missing"),
    "a certificate that is not listed": (lambda f: shutil.copy(f / "logistic.cert", f / "other.cert"),
                                         "MANIFEST does not list other"),
}


def main():
    folder = pathlib.Path(sys.argv[1])
    copy(folder)
    status, out = run(folder)
    if status != 0 or "3 of 3 certificates are proved" not in out:
        sys.exit("the unchanged certificates: exit status %d\n%s" % (status, out))
    for what, (change, message) in CHANGES.items():
        copy(folder)
        change(folder)
        status, out = run(folder, "logistic") if "not listed" not in what else run(folder)
        if status != 1 or message not in out:
            sys.exit("%s was changed: exit status %d, expected 1 and '%s'\n%s" % (what, status, message, out))
        print("%s: reported" % what)


if __name__ == "__main__":
    main()
