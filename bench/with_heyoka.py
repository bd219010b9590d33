#!/usr/bin/env python3
# One and many solutions in double, of Lorenz' equations, Kepler's, three bodies (figure eight) and a chain of 100 masses:
# `libration trajectory --scalar double` next to heyoka.py, whose kernels LLVM compiles for the system. Both compute to the
# last bit of double (heyoka's default tolerance, its smallest). The time of one solution is CPU time on one thread, of a
# long way less that of a short one, the median of rounds in turns; the start is that of the command for a short way, and
# for heyoka the compilation of its kernels, without the start of Python. Errors are relative to the largest component,
# against proved values. Up to the stated time the command is ahead with its start, since heyoka compiles. Many
# solutions: from a thousand starts, in the lanes of SIMD vectors.
#
#   ./run bench heyoka
#
# It installs heyoka from the Python package index into build/heyoka, and is not among the benchmarks of `./run bench`
# without a name. Exits with status 1 if an error is larger than 1e-10.
import csv
import io
import os
import resource
import statistics
import subprocess
import sys
import time

import heyoka
import numpy

ROUNDS = 7
MEMBERS = 1001
SHORT = 1 / 128
ALLOWED = 1e-10
MASSES = 100


def bodies():
    """x'' = the pulls of the others, for three equal masses, as in problems/three_body_figure_8.ode."""
    names = [c + k + d for k in "123" for c in "xy" for d in ("", "'")]
    place = dict(zip(names, heyoka.make_vars(*[n.replace("'", "p") for n in names])))
    system = []
    for k in "123":
        for c in "xy":
            pull = []
            for j in "123".replace(k, ""):
                square = (place["x" + j] - place["x" + k]) ** 2 + (place["y" + j] - place["y" + k]) ** 2
                pull.append((place[c + j] - place[c + k]) * square ** (-3.0 / 2))
            system += [(place[c + k], place[c + k + "'"]), (place[c + k + "'"], pull[0] + pull[1])]
    return names, system


def lorenz():
    x, y, z = heyoka.make_vars("x", "y", "z")
    return ["x", "y", "z"], [(x, 10.0 * (y - x)), (y, x * (28.0 - z) - y), (z, x * y - 8.0 / 3 * z)]


def kepler():
    x, u, y, v = heyoka.make_vars("x", "u", "y", "v")
    cube = (x**2 + y**2) ** (-3.0 / 2)
    return ["x", "x'", "y", "y'"], [(x, u), (u, -x * cube), (y, v), (v, -y * cube)]


def chain_text():
    n = MASSES
    return (
        f"q[i]' = p[i] for i = 1..{n}; p[i]' = q[i+1] - 2*q[i] + q[i-1] + ((q[i+1] - q[i])^2 - (q[i] - q[i-1])^2)/4 "
        f"for i = 1..{n}; q[0] = 0; q[{n + 1}] = 0; q[i](0) = (i mod 3)/5 for i = 1..{n}; p[i](0) = 1/i for i = 1..{n}"
    )


def chain():
    names = [f"{c}[{i}]" for i in range(1, MASSES + 1) for c in "qp"]
    place = dict(zip(names, heyoka.make_vars(*[n.strip("]").replace("[", "") for n in names])))
    ends = {"q[0]": heyoka.expression(0.0), f"q[{MASSES + 1}]": heyoka.expression(0.0)}
    q = [(ends | place)[f"q[{i}]"] for i in range(MASSES + 2)]
    system = []
    for i in range(1, MASSES + 1):
        force = q[i + 1] - 2.0 * q[i] + q[i - 1] + ((q[i + 1] - q[i]) ** 2 - (q[i] - q[i - 1]) ** 2) / 4.0
        system += [(place[f"q[{i}]"], place[f"p[{i}]"]), (place[f"p[{i}]"], force)]
    return names, system


# Name, problem, system, the time of the error, the long way, and the initial value that varies.
PROBLEMS = [
    ("lorenz", "lorenz", lorenz, 10, 4000, "x(0)"),
    ("kepler", "kepler", kepler, 10, 16000, "x(0)"),
    ("three bodies", "three_body_figure_8", bodies, 6, 4000, "x1(0)"),
    (f"chain, {MASSES}", chain_text(), chain, 10, 300, None),
]


def run(program, *arguments):
    """The output of a command and its CPU time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, *arguments], capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def state_of(program, verb, problem, at, names, *more):
    rows = list(csv.DictReader(io.StringIO(run(program, verb, "--problem", problem, "--time", str(at), "--format", "csv", *more)[0])))
    if "value" in rows[0]:
        found = {row["quantity"]: row["value"] for row in rows}
        return numpy.array([float(found[name]) for name in names])
    return numpy.array([float(rows[0][name]) for name in names])


def error_of(found, truth):
    return float(numpy.max(numpy.abs(found - truth)) / numpy.max(numpy.abs(truth)))


def cpu_of(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin


def median(values):
    return statistics.median(list(values))


def propagate(integrator, start, until):
    integrator.time = 0.0
    integrator.state[:] = start
    integrator.propagate_until(until)


def propagate_all(integrator, starts, until):
    lanes = integrator.state.shape[1]
    for first in range(0, starts.shape[1] - lanes + 1, lanes):
        integrator.set_time(0.0)
        integrator.state[:] = starts[:, first : first + lanes]
        integrator.propagate_until([float(until)] * lanes)


def ours_of_members(program, problem, name, value, until):
    family = f"{name}={value!r}:{value + 0.125!r}:{MEMBERS}"
    return run(program, "trajectory", "--problem", problem, "--scalar", "double", "--set", family, "--time", str(until),
               "--jobs", "1", "--out", os.devnull)[1]


def main():
    program = sys.argv[1]
    heyoka.llvm_state.set_diskcache_enabled(False)  # each system is compiled
    heyoka.llvm_state.set_memcache_limit(0)
    print(f"heyoka.py {heyoka.__version__}, {heyoka.recommended_simd_size()} lanes")
    print(f"{'':<14}{'libration':>30}{'heyoka':>32}{'ratio':>8}{'ahead up to':>13}")
    print(f"{'one solution':<14}{'start ms':>10}{'us a unit':>11}{'error':>9}"
          f"{'compile ms':>12}{'us a unit':>11}{'error':>9}{'':>8}{'units':>13}")
    correct = True
    families = []
    for title, problem, system, at, far, varied in PROBLEMS:
        names, equations = system()
        start = state_of(program, "trajectory", problem, 0, names, "--scalar", "double")
        begin = time.process_time()
        integrator = heyoka.taylor_adaptive(equations, list(start))
        compile_time = time.process_time() - begin
        truth = state_of(program, "reference", problem, at, names, "--digits", "20")
        propagate(integrator, start, at)
        errors = (error_of(state_of(program, "trajectory", problem, at, names, "--scalar", "double"), truth),
                  error_of(integrator.state, truth))
        correct = correct and max(errors) <= ALLOWED
        short, long, theirs = [], [], []
        for _ in range(ROUNDS):
            for until, into in ((SHORT, short), (far, long)):
                into.append(run(program, "trajectory", "--problem", problem, "--scalar", "double", "--time", str(until),
                                "--out", os.devnull)[1])
            theirs.append(cpu_of(lambda: propagate(integrator, start, far)))
        ours_us = (median(long) - median(short)) / far * 1e6
        theirs_us = median(theirs) / far * 1e6
        ahead = max(0, (compile_time - median(short)) / (ours_us - theirs_us) * 1e6) if ours_us > theirs_us else numpy.inf
        print(f"{title:<14}{median(short) * 1e3:>10.0f}{ours_us:>11.2f}{errors[0]:>9.0e}{compile_time * 1e3:>12.0f}"
              f"{theirs_us:>11.2f}{errors[1]:>9.0e}{ours_us / theirs_us:>8.2f}"
              f"{ahead:>13.0f}", flush=True)
        if varied is not None:
            families.append((title, problem, names, equations, start, names.index(varied.split("(")[0]), varied, at))
    print(f"\n{MEMBERS} solutions")
    for title, problem, names, equations, start, place, varied, at in families:
        lanes = heyoka.recommended_simd_size()
        starts = numpy.repeat(start[:, None], MEMBERS + lanes - 1, axis=1)
        starts[place] += numpy.arange(MEMBERS + lanes - 1) / (MEMBERS - 1) / 8
        begin = time.process_time()
        integrator = heyoka.taylor_adaptive_batch(equations, starts[:, :lanes].copy())
        compile_time = time.process_time() - begin
        short, long, theirs = [], [], []
        for _ in range(ROUNDS):
            short.append(ours_of_members(program, problem, varied, float(start[place]), SHORT))
            long.append(ours_of_members(program, problem, varied, float(start[place]), at))
            theirs.append(cpu_of(lambda: propagate_all(integrator, starts, at)))
        per_member = 1e6 / MEMBERS / at
        ours_us, theirs_us = (median(long) - median(short)) * per_member, median(theirs) * per_member
        print(f"{title:<14}{median(short) * 1e3:>10.0f}{ours_us:>11.2f}{'':>9}{compile_time * 1e3:>12.0f}"
              f"{theirs_us:>11.2f}{'':>9}{ours_us / theirs_us:>8.2f}", flush=True)
    return 0 if correct else 1


if __name__ == "__main__":
    sys.exit(main())
