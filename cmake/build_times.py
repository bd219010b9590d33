#!/usr/bin/env python3
"""Where the time of a build goes: CPU seconds by directory.

    cmake --preset release -D CMAKE_CXX_COMPILER_LAUNCHER="$PWD/cmake/build_times.py;--record;/tmp/times"
    cmake --build --preset release
    cmake/build_times.py /tmp/times [--files N]

The first form runs the compiler and appends one line for each source: the user and system time of the compiler and its
children, which hardly depends on what else the machine does. A precompiled header, and sources that are compiled as
one, are listed by the directories of the sources that they include, in equal shares. The last form prints the table,
and the N slowest files.
"""

import collections
import os
import re
import resource
import subprocess
import sys


def record(log, command):
    """Runs the compiler; appends its CPU seconds, its output and its input to the log."""
    status = subprocess.run(command, check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if "-c" in command and "-o" in command:
        source = os.path.abspath(command[command.index("-c") + 1])
        output = os.path.abspath(command[command.index("-o") + 1])
        with open(log, "a", encoding="utf-8") as lines:
            lines.write(f"{used.ru_utime + used.ru_stime:.2f}\t{output}\t{source}\n")
    return status


def sources_of(source):
    """The sources of a batch, or the source itself."""
    if not re.search(r"unity_\d+_cxx\.cxx$", source):
        return [source]
    with open(source, encoding="utf-8") as text:
        return re.findall(r'^#include "(.*)"', text.read(), re.MULTILINE)


def directory_of(source):
    """The directory below the root of the project, at most three levels deep."""
    if "cmake_pch" in source:
        return "precompiled headers"
    if "/build/" in source or "/generated/" in source:
        return "generated"
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parts = os.path.relpath(source, root).split("/")[:-1]
    return "/".join(parts[: 3 if parts[:2] == ["src", "libration"] else 2])


def read(log):
    """The last time of each output, so that a file that was compiled again counts once."""
    times = {}
    with open(log, encoding="utf-8") as lines:
        for line in lines:
            seconds, output, source = line.rstrip("\n").split("\t")
            times[output] = (float(seconds), source)
    return times


def report(log, files):
    """Prints the table."""
    times = read(log)
    by_directory = collections.Counter()
    counts = collections.Counter()
    for seconds, source in times.values():
        sources = sources_of(source)
        for each in sources:
            by_directory[directory_of(each)] += seconds / len(sources)
            counts[directory_of(each)] += 1
    total = sum(by_directory.values())
    print(f"{'directory':<34} {'sources':>7} {'CPU s':>8} {'share':>6}")
    for directory, seconds in by_directory.most_common():
        print(f"{directory:<34} {counts[directory]:>7} {seconds:>8.1f} {100 * seconds / total:>5.1f}%")
    print(f"{'total':<34} {sum(counts.values()):>7} {total:>8.1f}")
    for seconds, source in sorted(times.values(), reverse=True)[:files]:
        print(f"{seconds:>8.1f}  {source}")


def main():
    """Dispatches on the first argument."""
    arguments = sys.argv[1:]
    if arguments[:1] == ["--record"] and len(arguments) > 2:
        return record(arguments[1], arguments[2:])
    if len(arguments) not in (1, 3) or (len(arguments) == 3 and arguments[1] != "--files"):
        print(__doc__, file=sys.stderr)
        return 2
    report(arguments[0], int(arguments[2]) if len(arguments) == 3 else 0)
    return 0


if __name__ == "__main__":
    sys.exit(main())
