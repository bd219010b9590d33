#!/usr/bin/env python3
"""Runs the code of the pages: every fenced block of shell, Python, C++, C and Fortran, in the order of its page.

    run_blocks.py --program PROGRAM --prefix PREFIX --python PYTHON --work FOLDER [--long] [PAGE...]

PREFIX has an installed Libration, PYTHON its package. Each page has a folder of its own, where its blocks meet the files of
the blocks before them; `./run ARGS` is the program there. What a block prints on stdout is compared with the ```text block
that comes next, before any heading or other code: a line ... there stands for any number of lines. In ```console blocks
everything after "$ " is a command and what follows up to the next one is all that it prints. Python blocks of one page share their names.
A C++ block without main() is the body of one, with <libration/libration.hpp>; what it includes goes before. Notebooks are
executed, and the text of their outputs is compared.

Comments of HTML before a block say what is special about it:

    <!-- not run: REASON -->    it cannot run here; it is listed with its reason
    <!-- long: REASON -->       it runs with --long alone, and is listed else
    <!-- exits 1 -->            the exit code that it ends with
    <!-- excerpt -->            before a ```text block: its lines stand together somewhere in what is printed
    <!-- before:                commands that make what the block takes for granted
    COMMANDS -->

A block in no language that is known, an indented one and a ```text block that nothing prints are mistakes: nothing is skipped
in silence.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ["README.md", "docs/**/*.md", "docs/**/*.ipynb"]
RUN = {"sh", "console", "python", "cpp", "c", "fortran"}
SHOWN = {"text", "cmake", "csv", "latex", "math", "json"}
SECONDS = 300
LONG_SECONDS = 900
# What ./run does by itself is no matter of a page's folder.
SHIM = """#!/bin/sh
case ${1-} in
    test | bench | lint | python | install | docs | --mpi | --no-install)
        echo "run_blocks: ./run $1 builds or installs: mark the block as <!-- not run: REASON -->" >&2
        exit 2 ;;
esac
exec libration "$@"
"""
# Runs blocks of Python as they come, a JSON line each.
INTERPRETER = """
import contextlib, io, json, sys, traceback
names = {"__name__": "__main__"}
for line in sys.stdin:
    block = json.loads(line)
    printed, said = io.StringIO(), ""
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile("\\n" * (block["line"]) + block["text"], block["page"], "exec"), names)
    except BaseException:
        said = traceback.format_exc()
    sys.__stdout__.write(json.dumps([printed.getvalue(), said]) + "\\n")
    sys.__stdout__.flush()
"""


@dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    expected: str | None = None
    not_run: str = ""
    long: str = ""
    code: int = 0
    excerpt: bool = False
    before: str = ""
    program: str = ""  # of a C++ block, the file that was built

    @property
    def place(self):
        return f"{self.page}:{self.line}"


class Mistake(Exception):
    pass


def blocks_of(page, text):
    """The blocks of a page that run, or do not for a reason."""
    found, waiting, marks = [], None, {}
    lines = text.split("\n")
    at = 0
    while at < len(lines):
        line, number = lines[at], at + 1
        at += 1
        if line.startswith("<!--"):
            comment = [line]
            while "-->" not in comment[-1]:
                if at == len(lines):
                    raise Mistake(f"{page}:{number}: the comment does not end")
                comment.append(lines[at])
                at += 1
            inside = "\n".join(comment)[4:].split("-->")[0].strip()
            word, _, rest = inside.partition(":")
            if match := re.fullmatch(r"exits (\d+)", inside):
                marks["code"] = int(match[1])
            elif inside == "excerpt":
                marks["excerpt"] = True
            elif word in ("not run", "long"):
                if not rest.strip():
                    raise Mistake(f"{page}:{number}: '{word}' gives no reason")
                marks[word.replace(" ", "_")] = " ".join(rest.split())
            elif word == "before":
                marks["before"] = rest.strip() + "\n"
            continue
        if re.match(r"#+ ", line):
            waiting = None
        if re.match(r"( {4,}|\t)\S", line) and (number == 1 or not lines[number - 2].strip()):
            above = next((each for each in reversed(lines[: number - 1]) if each.strip() and not each.startswith(" ")), "")
            if not re.match(r"([-*]|\d+\.) ", above):
                raise Mistake(f"{page}:{number}: an indented block, which nobody runs: fence it")
        match = re.match(r"( *)(```+|~~~+)(.*)", line)
        if not match:
            continue
        indent, fence, language = match[1], match[2], match[3].strip()
        inside = []
        while at < len(lines) and lines[at].strip() != fence:
            inside.append(lines[at].removeprefix(indent))
            at += 1
        if at == len(lines):
            raise Mistake(f"{page}:{number}: the block does not end")
        at += 1
        content = "".join(each + "\n" for each in inside)
        if language in RUN:
            block = Block(page, number, language, content, **marks)
            found.append(block)
            waiting = None if language == "console" else block
        elif language == "text":
            if waiting is None and "not_run" not in marks:
                raise Mistake(f"{page}:{number}: no block prints this text: say <!-- not run: WHY --> or move it")
            if waiting is not None and "not_run" not in marks:
                waiting.expected = ("...\n" + content + "...\n") if "excerpt" in marks else content
            waiting = None
        elif language not in SHOWN and not language.startswith("{"):
            raise Mistake(f"{page}:{number}: a block of '{language}': write one of {', '.join(sorted(RUN | SHOWN))}")
        marks = {}
    return found


def matches(expected, printed):
    """Equal, a line ... in `expected` standing for any number of lines."""
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else re.escape(line) + r"\n" for line in expected.split("\n")[:-1])
    return re.fullmatch(pattern, printed) is not None


def program_text(block):
    """A whole program of C++ from a block that may be the body of one."""
    if re.search(r"\bmain\s*\(", block.text):
        return block.text
    includes, body = [], []
    for line in block.text.split("\n"):
        (includes if line.startswith("#include") else body).append(line)
    head = ["#include <iostream>", "#include <vector>", "#include <libration/libration.hpp>", *includes]
    return "\n".join([*head, "using namespace libration;", "int main() {", *body, "}", ""])


def build_programs(blocks, prefix, work):
    """All blocks of C++ as one project that finds the installed library; the files by their blocks."""
    folder = work / "cpp"
    folder.mkdir(parents=True)
    project = ["cmake_minimum_required(VERSION 3.25)", "project(blocks LANGUAGES CXX)", "find_package(libration REQUIRED)"]
    for count, block in enumerate(blocks):
        name = f"block{count}"
        (folder / f"{name}.cpp").write_text(f'#line 1 "{block.place}"\n' + program_text(block))
        project += [f"add_executable({name} {name}.cpp)", f"target_link_libraries({name} PRIVATE libration::proved)"]
        block.program = str(folder / "build" / name)
    (folder / "CMakeLists.txt").write_text("\n".join(project) + "\n")
    for command in (
        ["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}"],
        ["cmake", "--build", folder / "build"],
    ):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            raise Mistake("the C++ blocks do not build:\n" + done.stdout)


class Runner:
    """The blocks of one page in one folder."""

    def __init__(self, options, page):
        self.options = options
        self.folder = options.work / "pages" / page.replace("/", "_")
        self.folder.mkdir(parents=True)
        (self.folder / "run").write_text(SHIM)
        (self.folder / "run").chmod(0o755)
        # The pages name files of the repository: copies, for a block may write.
        for name in ("readers", "examples"):
            shutil.copytree(ROOT / "docs" / name, self.folder / "docs" / name)
        shutil.copytree(ROOT / "check", self.folder / "check")
        self.python = None
        prefix = options.prefix
        self.environment = dict(
            os.environ,
            PATH=os.pathsep.join([str(options.program.parent), str(options.python.parent), os.environ["PATH"]]),
            PKG_CONFIG_PATH=os.pathsep.join(str(each.parent) for each in prefix.rglob("libration.pc")),
            LD_LIBRARY_PATH=str(next(prefix.rglob("liblibration.so")).parent),
            LC_ALL="C.UTF-8",
            MPLBACKEND="Agg",
        )

    def shell(self, text, seconds, merged=False):
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", text],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT if merged else subprocess.PIPE,
            text=True,
            timeout=seconds,
        )
        return done.returncode, done.stdout, done.stderr or ""

    def interpreted(self, block):
        if self.python is None:
            self.python = subprocess.Popen(
                [self.options.python, "-u", "-c", INTERPRETER],
                cwd=self.folder,
                env=self.environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
        order = {"text": block.text, "line": block.line, "page": block.page}
        self.python.stdin.write(json.dumps(order) + "\n")
        self.python.stdin.flush()
        printed, said = json.loads(self.python.stdout.readline())
        return (1 if said else 0), printed, said

    def compiled(self, block, seconds):
        name = f"block{block.line}"
        (self.folder / f"{name}.{'c' if block.language == 'c' else 'f90'}").write_text(block.text)
        line = {
            "c": f"cc {name}.c -o {name} $(pkg-config --cflags --libs libration)",
            "fortran": f'gfortran "$(pkg-config --variable=includedir libration)/libration.f90" {name}.f90 -o {name} '
            "$(pkg-config --libs libration)",
        }[block.language]
        return self.shell(f"{line} && ./{name}", seconds)

    def run(self, block):
        """What is wrong with a block; empty when nothing is."""
        seconds = LONG_SECONDS if block.long else SECONDS
        if block.before:
            code, printed, said = self.shell(block.before, seconds)
            if code:
                return f"what is done before it fails:\n{printed}{said}"
        if block.language == "console":
            return self.session(block, seconds)
        if block.language == "sh":
            code, printed, said = self.shell(block.text, seconds)
        elif block.language == "python":
            code, printed, said = self.interpreted(block)
        elif block.language == "cpp":
            code, printed, said = self.shell(block.program, seconds)
        else:
            code, printed, said = self.compiled(block, seconds)
        if code != block.code:
            return f"it ends with the exit code {code}, not {block.code}:\n{printed}{said}"
        if block.expected is not None and not matches(block.expected, printed):
            return f"the page says that it prints\n{block.expected}but it prints\n{printed}"
        return ""

    def session(self, block, seconds):
        commands = []
        for line in block.text.split("\n")[:-1]:
            if line.startswith("$ "):
                commands.append([line[2:], ""])
            elif not commands:
                return "it does not begin with '$ '"
            elif commands[-1][0].endswith("\\") and line.startswith("> "):
                commands[-1][0] += "\n" + line[2:]
            else:
                commands[-1][1] += line + "\n"
        for count, (command, expected) in enumerate(commands, 1):
            code, printed, _ = self.shell(command, seconds, merged=True)
            wanted = block.code if count == len(commands) else 0
            if code != wanted:
                return f"'{command}' ends with the exit code {code}, not {wanted}:\n{printed}"
            if not matches(expected, printed):
                return f"'{command}' is said to print\n{expected}but it prints\n{printed}"
        return ""

    def end(self):
        if self.python is not None:
            self.python.stdin.close()
            self.python.wait()


def texts_of(notebook):
    """The text of the outputs of every cell; pictures and addresses of objects are no text."""
    texts = []
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            parts = []
            for output in cell["outputs"]:
                text = output.get("text") or output.get("data", {}).get("text/plain", "")
                parts.append(re.sub(r"<Figure size .*>|0x[0-9a-f]+", "", "".join(text)))
            texts.append("".join(parts))
    return texts


def run_notebook(page, options, environment, folder):
    # The kernel of the notebook is PYTHON, not the one that Debian's description names; its pictures go into the page.
    kernel = options.work / "jupyter" / "kernels" / "python3"
    kernel.mkdir(parents=True, exist_ok=True)
    order = [str(options.python), "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    (kernel / "kernel.json").write_text(json.dumps({"argv": order, "display_name": "Python 3", "language": "python"}))
    environment = dict(environment, JUPYTER_PATH=str(options.work / "jupyter"))
    del environment["MPLBACKEND"]
    done = subprocess.run(
        [options.python, "-m", "nbconvert", "--to", "notebook", "--execute", "--stdout", ROOT / page],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        timeout=LONG_SECONDS,
    )
    if done.returncode:
        return f"it is not executed:\n{done.stderr[-2000:]}"
    shown, printed = texts_of(json.loads((ROOT / page).read_text())), texts_of(json.loads(done.stdout))
    for count, (expected, got) in enumerate(zip(shown, printed, strict=True), 1):
        if expected != got:
            return f"its code cell {count} is said to print\n{expected}\nbut it prints\n{got}"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--prefix", type=Path, required=True)
    parser.add_argument("--python", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--long", action="store_true", help="also what is marked as long")
    parser.add_argument("pages", nargs="*", metavar="PAGE", help="these alone, as in docs/equations.md")
    options = parser.parse_args()
    for name in ("program", "prefix", "python", "work"):
        setattr(options, name, getattr(options, name).absolute())  # a link to an interpreter stays one
    shutil.rmtree(options.work, ignore_errors=True)
    pages = sorted({str(each.relative_to(ROOT)) for pattern in PAGES for each in ROOT.glob(pattern)})
    for page in options.pages:
        if page not in pages:
            parser.error(f"there is no page '{page}': write one of {' '.join(pages)}")
    pages = options.pages or pages

    began, failures, ran, left_out = time.monotonic(), [], 0, []
    try:
        blocks = {page: blocks_of(page, (ROOT / page).read_text()) for page in pages if page.endswith(".md")}
        of_cpp = [each for of_page in blocks.values() for each in of_page if each.language == "cpp" and not each.not_run]
        if of_cpp:
            build_programs(of_cpp, options.prefix, options.work)
    except Mistake as mistake:
        sys.exit(f"run_blocks: {mistake}")

    for page in pages:
        runner = Runner(options, page)
        if page.endswith(".ipynb"):
            wrong = run_notebook(page, options, runner.environment, runner.folder)
            ran += 1
            print(f"{'FAILS' if wrong else 'ok   '} {page}", flush=True)
            if wrong:
                failures.append(f"{page}: {wrong}")
            continue
        for block in blocks[page]:
            if block.not_run:
                left_out.append(f"{block.place}: not run: {block.not_run}")
                continue
            if block.long and not options.long:
                left_out.append(f"{block.place}: long, run with --long: {block.long}")
                continue
            start = time.monotonic()
            try:
                wrong = runner.run(block)
            except subprocess.TimeoutExpired:
                wrong = "it takes too long: mark it as <!-- long: REASON --> or ask for less"
            ran += 1
            seconds = time.monotonic() - start
            print(f"{'FAILS' if wrong else 'ok   '} {block.place} ({block.language}, {seconds:.1f} s)", flush=True)
            if wrong:
                failures.append(f"{block.place}: {wrong}")
        runner.end()
    for each in left_out:
        print(each)
    for each in failures:
        print(f"\n{each}")
    print(f"\n{ran} blocks ran, {len(failures)} failed, {len(left_out)} did not run, {time.monotonic() - began:.0f} s")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
