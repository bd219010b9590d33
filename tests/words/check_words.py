#!/usr/bin/env python3
"""Looks in documents for expressions that are not idiomatic technical English, and for private terms.

    check_words.py [--readme-lines N] PATH...      files, or directories whose documents are checked
    check_words.py --present [--update] PATH...    the same for sources, except for the hits in present.txt
    check_words.py --sentences FILE                checks the list itself

banned.txt, next to this file, lists the expressions with their replacements, allowed.txt the places where one of them is legitimate,
each with its reason. What is not prose is skipped: in Markdown, printed output (text and console blocks), inline code, formulas and
link targets, and in other code blocks everything but comments; in sources, everything but comments and string literals; in
notebooks, code cells. Every hit is printed as FILE:LINE with the pattern and the replacement; the exit code is then 1.

present.txt lists how often which pattern is still found in which source. These hits may only become fewer: one more in a file
is printed, and so is a list that has to be shortened. --update writes it again, for hits that were mended and for files that were
moved; it fails if a pattern is found more often than before.

FILE of --sentences has pairs of lines: "- " with a sentence in which a pattern has to be found, and "+ " with its rewrite, in which
none may be found.
"""

import argparse
import fnmatch
import functools
import json
import re
import sys
from bisect import bisect_right
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MARKDOWN = {".md", ".in"}
C_LIKE = {".cpp", ".hpp", ".h", ".c"}
HASH_LIKE = {".py", ".cmake", ".gp", ".sh", ".ode", ".jl"}
SUFFIXES = MARKDOWN | C_LIKE | HASH_LIKE | {".ipynb", ".txt", ".f90", ".m"}
CODE = "\x01"  # what stands for code in the prose: it matches no word of a pattern


def read_table(name, columns):
    """The lines of a list, split at tabs; comments and blank lines are skipped."""
    rows = []
    for number, line in enumerate((HERE / name).read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        fields = line.split("\t")
        if len(fields) != columns or not all(field.strip() for field in fields):
            sys.exit(f"{HERE / name}:{number}: expected {columns} fields separated by tabs")
        rows.append(fields)
    return rows


def masked(text, expression, flags=0):
    """The text with every match replaced by code marks, line breaks kept."""
    return re.sub(expression, lambda match: re.sub(r"[^\n]", CODE, match.group()), text, flags=flags)


def markdown_prose(text):
    lines = []
    language = None
    for line in text.split("\n"):
        fence = re.match(r"\s*```(\w*)", line)
        if fence:
            language = (fence.group(1) or "text") if language is None else None
            lines.append(CODE)
        elif language is None:
            lines.append(line)
        elif language in {"text", "console", "math", "csv", "latex", "json"}:
            lines.append(CODE)
        else:
            comment = re.search(r"(?://|(?:^|\s)#(?!!)\s?)(.*)$", line)
            lines.append(CODE + " " + comment.group(1) if comment else CODE)
    prose = "\n".join(lines)
    prose = masked(prose, r"<!--.*?-->", re.DOTALL)
    prose = masked(prose, r"\$\$.*?\$\$", re.DOTALL)
    prose = masked(prose, r"`[^`]*`")
    prose = masked(prose, r"(?<!\\)\$[^$\n]*(\n[^$\n]*)?\$")
    return masked(prose, r"\]\([^)\s]*\)")


def source_prose(text, comment):
    """Comments, without the code in them, and the contents of string literals."""
    text = re.sub(r'^[ \t]*#[ \t]*include.*$', "", text, flags=re.M)
    literal = r'"(?:[^"\\\n]|\\.)*"'
    kept, end = [], 0
    for match in re.finditer(rf"{literal}|{comment}[^\n]*|/\*.*?\*/|\n", text, flags=re.DOTALL):
        part = match.group()
        if text[end : match.start()].strip():
            kept.append(CODE)
        end = match.end()
        if part == "\n":
            kept.append("\n")
        elif part.startswith('"'):
            kept.append(" " + part[1:-1] + " ")  # adjacent literals are one message
        else:
            words = re.sub(rf"^(?:{comment}|/\*)[/!<]*|\*/$", "", part)
            words = masked(words, r"`[^`\n]*`|\w+(?:(?:::|\.|->)\w+)+|\w+(?=\()")
            kept.append(" " + words + " ")
    return "".join(kept)


def prose_of(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".ipynb":
        cells = json.loads(text)["cells"]
        return "\n".join(markdown_prose("".join(cell["source"])) for cell in cells if cell["cell_type"] == "markdown")
    if path.suffix in MARKDOWN:
        return markdown_prose(text)
    if path.suffix in C_LIKE:
        return source_prose(text, "//")
    if path.suffix in HASH_LIKE:
        return source_prose(text, "#")
    if path.suffix == ".f90":
        return source_prose(text, "!")
    if path.suffix == ".m":
        return source_prose(text, "%")
    return text


def collapsed(prose):
    """The prose with single blanks, and a function that gives the line of a position in it."""
    words, starts, lines = [], [], []
    start, line, end = 0, 1, 0
    for match in re.finditer(r"\S+", prose):
        line += prose.count("\n", end, match.start())
        end = match.end()
        words.append(match.group())
        starts.append(start)
        lines.append(line)
        start += end - match.start() + 1
    return " ".join(words), lambda position: lines[bisect_right(starts, position) - 1]


@functools.cache
def literal_of(pattern):
    """Characters that every match of a pattern contains one after the other; maybe none."""
    rest, before = pattern, None
    while rest != before:
        rest, before = re.sub(r"\((?:[^()\\]|\\.)*\)|\[[^\]]*\]", "\0", rest), rest
    if "|" in rest:
        return ""
    rest = re.sub(r"\\.|[^\\](?=[?*{])|\{[^}]*\}", "\0", rest)
    return max(re.split(r"[^a-z0-9 ,'-]", rest), key=len)


def hits_in(text, patterns):
    text = text.lower()  # faster than patterns for both cases
    for pattern, replacement in patterns:
        if literal_of(pattern.pattern) in text:
            for match in pattern.finditer(text):
                yield match, pattern.pattern, replacement


def files_of(paths):
    for name in paths:
        path = Path(name)
        path = path if path.is_absolute() else ROOT / path
        if path.is_dir():
            yield from sorted(p for p in path.rglob("*") if p.suffix in SUFFIXES and p.is_file())
        elif path.is_file():
            yield path
        else:
            sys.exit(f"check_words: there is no {name}")


def hits_of_files(paths, patterns):
    """The hits, as path, pattern and message, and how many entries of allowed.txt nothing needs."""
    allowed = [[glob, re.compile(phrase, re.IGNORECASE), reason, False] for glob, phrase, reason in read_table("allowed.txt", 3)]
    scanned, hits, count = [], [], 0
    for path in files_of(paths):
        name = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)
        scanned.append(name)
        text, line_at = collapsed(prose_of(path))
        fitting = [entry for entry in allowed if fnmatch.fnmatch(name, entry[0])]
        spans = [(match.span(), entry) for entry in fitting for match in entry[1].finditer(text)]
        for match, pattern, replacement in hits_in(text, patterns):
            covering = [entry for (begin, end), entry in spans if begin <= match.start() and match.end() <= end]
            for entry in covering:
                entry[3] = True
            if not covering:
                message = f'{name}:{line_at(match.start())}: "{text[slice(*match.span())]}": write {replacement}    [{pattern}]'
                hits.append((name, pattern, message))
    for glob, phrase, _, used in allowed:
        if not used and any(fnmatch.fnmatch(name, glob) for name in scanned):
            count += 1
            print(f"allowed.txt: nothing in {glob} needs the entry {phrase.pattern!r}: remove it")
    return hits, count


def beyond_present(hits, update):
    """The number of complaints about hits that present.txt does not list, and about its lines that list too many."""
    listed = Counter({(name, pattern): int(times) for name, times, pattern in read_table("present.txt", 3)})
    found = Counter((name, pattern) for name, pattern, _ in hits)
    if update:
        more = totals(found) - totals(listed)
        for pattern in sorted(more):
            print(f"{more[pattern]} more than present.txt lists of {pattern}, in files of which it lists fewer:")
            print(*(f"    {each[2]}" for each in hits if each[1] == pattern and found[each[:2]] > listed[each[:2]]), sep="\n")
        if not more:
            head = "".join(line for line in (HERE / "present.txt").open(encoding="utf-8") if line.startswith("#"))
            rows = "".join(f"{name}\t{times}\t{pattern}\n" for (name, pattern), times in sorted(found.items()))
            (HERE / "present.txt").write_text(head + rows, encoding="utf-8")
        return more.total()
    more, fewer = found - listed, listed - found
    print(*(message for name, pattern, message in hits if more[name, pattern]), sep="\n", end="\n" if more else "")
    for (name, pattern), times in sorted(fewer.items()):
        print(f"present.txt lists {times} more of {pattern} than {name} has: run tests/words/sources --update")
    return more.total() + fewer.total()


def totals(counted):
    """How often each pattern is found in all files."""
    sums = Counter()
    for (_, pattern), times in counted.items():
        sums[pattern] += times
    return sums


def check_sentences(name, patterns):
    count = 0
    for number, line in enumerate(Path(name).read_text(encoding="utf-8").splitlines(), 1):
        if not line.startswith(("- ", "+ ")):
            continue
        found = [pattern for _, pattern, _ in hits_in(line[2:], patterns)]
        if line.startswith("- ") and not found:
            count += 1
            print(f"{name}:{number}: no pattern of banned.txt finds: {line[2:]}")
        if line.startswith("+ ") and found:
            count += 1
            print(f"{name}:{number}: the rewrite is found by {found[0]}: {line[2:]}")
    return count


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("paths", nargs="*", metavar="PATH")
    options.add_argument("--sentences", metavar="FILE", help="pairs of sentences that check the list")
    options.add_argument("--readme-lines", type=int, metavar="N", help="README.md may have at most N lines")
    options.add_argument("--present", action="store_true", help="the hits in present.txt may remain")
    options.add_argument("--update", action="store_true", help="write present.txt again, if no pattern is found more often")
    given = options.parse_args()
    patterns = [(re.compile(pattern), hint) for pattern, hint in read_table("banned.txt", 2)]
    hits, count = hits_of_files(given.paths, patterns)
    if given.present:
        count += beyond_present(hits, given.update)
    else:
        print(*(message for _, _, message in hits), sep="\n", end="\n" if hits else "")
        count += len(hits)
    if given.sentences:
        count += check_sentences(given.sentences, patterns)
    if given.readme_lines:
        lines = len((ROOT / "README.md").read_text(encoding="utf-8").splitlines())
        if lines > given.readme_lines:
            count += 1
            print(f"README.md has {lines} lines; at most {given.readme_lines} are allowed: move the rest to docs/")
    if count:
        print(f"{count} found")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
