#!/usr/bin/env python3
"""Plants the faults of faults.py one at a time in a copy of the tree and lists the tests that catch each.

    python3 tests/faults/plant.py BUILD [--jobs N] [--only WORD...]
    python3 tests/faults/plant.py --places

BUILD is the folder of a build that has made liblibration.a, release for one. For each fault
only the tests named beside it are compiled, and a source of the library where the fault is in one. A test catches a
fault by failing, by a crash, by running SLOWER times as long as without it, or by a static assertion. First the same
tests have to pass as they are. Exit code: 0 where every fault is caught; 1 where one is not or does not compile, or
where a test fails without any; 2 where a fault cannot be planted, because its text does not stand in its file exactly
once. --places checks only the latter.
"""

import argparse
import concurrent.futures
import pathlib
import queue
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as xml

sys.dont_write_bytecode = True  # a tree that is tested stays as it is
from faults import FAULTS  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST = 900  # seconds, of a test program without a fault
ASSERTS = "static assertion failed"  # in messages of the compiler
SLOWER, SHORTEST = 10, 60  # with one: so many times as long as without, and at least so many seconds
LIBRARIES = ["-lhwy", "-lflint-arb", "-lflint", "-lmpfr", "-lgmp", "-lz", "-lquadmath"]


def flags(tree, build):
    boost = re.search(r"^Boost_DIR:PATH=(/.*)/lib/.*$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    names = {"LIBRATION_SOURCE_DIR": ROOT, "LIBRATION_REFERENCE_DIR": ROOT / "tests/reference",
             "LIBRATION_CHECKER": ROOT / "check/libration_check.py"}
    return ["-std=c++20", "-O1", "-DLIBRATION_COMPILED", *(f'-D{name}="{value}"' for name, value in names.items()),
            f"-I{tree}/include", f"-I{tree}/tests", f"-I{tree}/src", f"-I{tree}/src/command",
            "-isystem", "/usr/include/eigen3", *(["-isystem", f"{boost[1]}/include"] if boost and boost[1] != "/usr" else [])]


def run(command, **more):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)


class Workshop:
    """A copy of the tree in which one fault at a time stands, with the objects of its tests."""

    def __init__(self, folder, build, shared, limits):
        self.folder, self.build, self.shared = folder, build, shared
        self.limits = limits  # seconds, of each test
        for room in ("include", "src/libration", "tests", "studies/population"):
            shutil.copytree(ROOT / room, folder / room)

    def compile(self, source, target):
        precompiled = ["-include", self.shared / "precompiled.hpp"] if source.parts[0] == "tests" else []
        done = run(["g++", *flags(self.folder, self.build), *precompiled, "-c", self.folder / source, "-o", target])
        return done.returncode == 0, done.stderr

    def failures(self, test, sources=(), kept=None):
        """The test cases of a file that fail, with so many sources of the library compiled anew before it, and with the
        kept object of the test if there is one."""
        objects = [kept] if kept else []
        for i, source in enumerate([*([] if kept else [pathlib.Path("tests") / test]), *map(pathlib.Path, sources)]):
            target = self.folder / f"{i}.o"
            fine, said = self.compile(source, target)
            if not fine:
                return [f"{source} {ASSERTS if ASSERTS in said else 'does not compile'}"], said
            objects.append(target)
        program = self.folder / "program"
        archives = [self.build / "liblibration.a"]
        # What is compiled here comes first, so that it is taken instead of the same in the archives.
        linked = run(["g++", self.shared / "main.o", *objects, "-Wl,--allow-multiple-definition", *archives,
                      *LIBRARIES, "-o", program])
        if linked.returncode != 0:
            return [f"{test} does not link"], linked.stderr
        return self.run_tests(program, test)

    def object_of(self, test):
        """Where the object of a test without any fault is kept."""
        return self.shared / (test.replace("/", "-") + ".o")

    def failures_without_fault(self, test):
        failed, said = self.failures(test)
        if not failed:
            (self.folder / "0.o").rename(self.object_of(test))
        return failed, said

    def run_tests(self, program, test):
        begin = time.monotonic()
        try:
            done = run([program, "-r", "xml"], timeout=self.limits.get(test, LONGEST))
        except subprocess.TimeoutExpired:
            return [f"{test} does not end"], ""
        self.limits.setdefault(test, max(SHORTEST, SLOWER * (time.monotonic() - begin)))
        try:
            cases = xml.fromstring(done.stdout).iter("TestCase")
            failed = [case.get("name") for case in cases if case.find("OverallResult").get("success") != "true"]
        except (xml.ParseError, AttributeError):
            failed = [f"{test} crashes"]
        if done.returncode != 0 and not failed:
            failed = [f"{test} fails"]
        return failed, done.stdout

    def sources_with(self, path):
        """What of the library a fault is compiled into beside the test: the source, and those beside it that include it,
        a header of src/, or its header. In the archives of a unity build, the code of a source may be inlined there."""
        named = f'#include "{path.with_suffix(".hpp").name}"'
        paths = [p for p in path.parent.glob("*.cpp") if p == path or named in p.read_text()]
        return [p.relative_to(self.folder) for p in paths]

    def planted(self, fault):
        """Who catches a fault: all failing cases of the first of its tests that has some."""
        path = self.folder / fault.file
        text = path.read_text()
        path.write_text(text.replace(fault.old, fault.new))
        sources = [*self.sources_with(path), *map(pathlib.Path, fault.sources)]
        in_headers = path.suffix == ".hpp"  # which the test may include
        try:
            for test in fault.tests:
                failed, said = self.failures(test, sources, None if in_headers else self.object_of(test))
                if failed and failed[0].endswith("does not compile"):
                    raise SyntaxError(f"{fault.file}: {fault.what}:\n{said[-3000:]}")
                if failed:
                    return failed
            return []
        finally:
            path.write_text(text)


def check_places(faults):
    lost = [f"{f.file}: {(ROOT / f.file).read_text().count(f.old)} times: {f.old}" for f in faults
            if (ROOT / f.file).read_text().count(f.old) != 1 or f.old == f.new]
    if lost:
        print("these faults cannot be planted:", *lost, sep="\n", file=sys.stderr)
        sys.exit(2)


def share(folder, build):
    """What all tests have in common: the main of Catch2 and the precompiled header."""
    (folder / "main.cpp").write_text("#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
    shutil.copy(ROOT / "tests/precompiled.hpp", folder / "precompiled.hpp")
    for command in (["-c", folder / "main.cpp", "-o", folder / "main.o"],
                    ["-x", "c++-header", folder / "precompiled.hpp", "-o", folder / "precompiled.hpp.gch"]):
        done = run(["g++", *flags(ROOT, build), *command])
        if done.returncode != 0:
            sys.exit(done.stderr)


def spread(jobs, tasks, free):
    """The results of tasks, each of which takes a workshop, as they come."""
    def work(task):
        workshop = free.get()
        try:
            return task(workshop)
        finally:
            free.put(workshop)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(work, tasks)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, nargs="?")
    parser.add_argument("--places", action="store_true", help="check the places of the faults only")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", nargs="+", default=[""], help="faults with one of these in file or description")
    options = parser.parse_args()
    faults = [f for f in FAULTS if any(word in f"{f.file}: {f.what}" for word in options.only)]
    check_places(faults)
    if options.places:
        return
    if not options.build:
        parser.error("the folder of a build is missing")

    begin = time.monotonic()
    work = options.build.resolve() / "faults"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    share(work, options.build.resolve())
    free = queue.Queue()
    limits = {}
    for i in range(options.jobs):
        free.put(Workshop(work / f"tree{i}", options.build.resolve(), work, limits))

    tests = sorted({test for fault in faults for test in fault.tests})
    for test, (failed, said) in zip(tests, spread(options.jobs, [lambda w, t=t: w.failures_without_fault(t) for t in tests], free)):
        if failed:
            print(said[-3000:], f"without any fault: {failed}", sep="\n", file=sys.stderr)
            sys.exit(1)
    print(f"{len(faults)} faults, {len(tests)} files of tests, which pass without any", flush=True)

    def catching(workshop, fault):
        try:
            return workshop.planted(fault)
        except SyntaxError as problem:
            print(problem, file=sys.stderr)
            return []

    missed = 0
    for fault, caught in zip(faults, spread(options.jobs, [lambda w, f=f: catching(w, f) for f in faults], free)):
        missed += not caught
        where = fault.file.removeprefix("include/libration/").removeprefix("src/libration/")
        more = f" and {len(caught) - 1} more" if len(caught) > 1 else ""
        print(f"{where}: {fault.what}: {'caught by ' + repr(caught[0]) + more if caught else 'NOT CAUGHT'}", flush=True)
    shutil.rmtree(work, ignore_errors=True)
    print(f"{len(faults) - missed} of {len(faults)} faults caught in {time.monotonic() - begin:.0f} s")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
