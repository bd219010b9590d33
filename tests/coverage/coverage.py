#!/usr/bin/env python3
"""The branch coverage of the files that docs/proved.md names, by clang.

    python3 tests/coverage/coverage.py BUILD [--jobs N]

BUILD is the folder of a build that has made liblibration.a. The tests of TESTS, and the
sources of the library that belong to the files, are compiled with counters and run. Every condition that is never true,
or never false, in any test has to stand in argued.py with a reason; where one does not, and where a reason has no such
condition left, the exit code is 1.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # a tree that is tested stays as it is
from argued import ARGUED  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
# GCC's quadmath for the archives, which GCC has compiled.
LIBRARIES = ["-lhwy", "-lflint-arb", "-lflint", "-lmpfr", "-lgmp", "-lz"]
TESTS = """
    truncation/bounds_test.cpp truncation/columns_test.cpp truncation/descent_test.cpp truncation/panels_test.cpp
    truncation/refusals_test.cpp truncation/theta_series_test.cpp
    function/functions_test.cpp
    scalar/ball/arctangent_test.cpp scalar/ball/decimal_test.cpp scalar/ball/fixed_point_test.cpp
    scalar/ball/product_guard_test.cpp scalar/ball/polynomial_test.cpp
    digits/proved_decimals_test.cpp approximant/pade_error_test.cpp
    elliptic/named_function_test.cpp elliptic/proved_elliptic_test.cpp
    elliptic/proved_functions_test.cpp
    pendulum/landen_motion_test.cpp pendulum/proved_canonical_test.cpp
    pendulum/proved_motion_test.cpp pendulum/proved_norm_test.cpp
    pendulum/decision_test.cpp pendulum/motion_test.cpp
    pendulum/lattice_coefficients_test.cpp pendulum/singularity_view_test.cpp
    pendulum/bounds_test.cpp pendulum/uniform_remainder_test.cpp
    equation/polynomial_form_test.cpp plane/complex_disc_test.cpp query/condition_numbers_test.cpp
    integration/lohner_set_test.cpp query/proved_events_test.cpp
    query/event_laws_test.cpp integration/collocation/lifted_collocation_test.cpp integration/lifted_set_test.cpp
    integration/proof_route_test.cpp integration/proved_march_test.cpp algebra/krawczyk_test.cpp query/shooting/proved_unknowns_test.cpp
    plane/proved_singularity_test.cpp query/flow_derivatives_test.cpp
    plane/radius_bound_test.cpp query/scale_test.cpp integration/singular_step_test.cpp
    integration/collocation/stiff_test.cpp expansion/tail_bound_test.cpp query/sets/solution_sets_test.cpp
    query/sets/set_events_test.cpp
    query/delay_trajectory_test.cpp query/delay_events_test.cpp
    problem/far_behaviour_test.cpp problem/known/conditions_at_infinity_test.cpp problem/known/painleve_1_test.cpp
    integration/ways_out_test.cpp plane/regular_coordinates_test.cpp
    query/shooting/solution_branch_test.cpp problem/known/kepler_test.cpp
    query/stiff_events_test.cpp integration/collocation/decay_coordinates_test.cpp equation/text/conditions_at_times_test.cpp
    problem/hybrid_solution_test.cpp problem/hybrid_attack_test.cpp problem/solution_test.cpp
""".split()


# Sources on the way to those that are named: compiled by themselves, as calls within one unit of the archive are not
# those of the sources with counters.
CALLERS = ["src/libration/integration/method_choice.cpp", "src/libration/integration/rule_for.cpp",
           "src/libration/query/delay_trajectory.cpp",
           "src/libration/problem/known_facts.cpp",
           "src/libration/problem/solve.cpp"]


def named_files():
    """The headers that the page names, and the sources of the library of the same name."""
    text = (ROOT / "docs/proved.md").read_text()
    headers = [f"include/libration/{name}" for name in sorted(set(re.findall(r"`([a-z_/]+\.hpp)`", text)))]
    sources = [h.replace("include", "src", 1).replace(".hpp", ".cpp") for h in headers]
    sources = sources + [
        "src/libration/problem/known/shooting.cpp", "src/libration/integration/integration.cpp",
        "src/libration/integration/taylor/taylor_rule.cpp", "src/libration/integration/taylor/series_step.cpp"]
    return headers, [s for s in sources if (ROOT / s).exists()]


def run(command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"{command}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    return done.stdout


def flags():
    names = {"LIBRATION_SOURCE_DIR": ROOT, "LIBRATION_REFERENCE_DIR": ROOT / "tests/reference",
             "LIBRATION_CHECKER": ROOT / "check/libration_check.py"}
    return ["clang++", "-std=c++20", "-O1", "-w", *(f'-D{name}="{value}"' for name, value in names.items()),
            *(f"-I{ROOT}/{room}" for room in ("include", "tests", "src", "src/command"))]


def compiled(folder, jobs, sources):
    """The objects of Catch2's main, of the tests and of the sources, these two with counters."""
    (folder / "main.cpp").write_text("#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
    shutil.copy(ROOT / "tests/precompiled.hpp", folder / "precompiled.hpp")
    counting = [*flags(), "-fprofile-instr-generate", "-fcoverage-mapping"]
    run([*counting, "-x", "c++-header", folder / "precompiled.hpp", "-o", folder / "precompiled.hpp.pch"])
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        work = [pool.submit(run, [*flags(), "-c", folder / "main.cpp", "-o", folder / "main.o"])]
        objects = []
        for source in [f"tests/{test}" for test in TESTS] + sources:
            objects.append(folder / (source.replace("/", "_") + ".o"))
            included = ["-include", folder / "precompiled.hpp"] if source.startswith("tests/") else []
            work.append(pool.submit(run, [*counting, *included, "-c", ROOT / source, "-o", objects[-1]]))
        for each in work:
            each.result()
    return objects


def counts_of(folder, files):
    """By file, line and column of a condition, how often it was true and false, in all instantiations together."""
    run(["llvm-profdata", "merge", "-sparse", folder / "raw", "-o", folder / "profile"])
    text = run(["llvm-cov", "export", folder / "program", f"-instr-profile={folder / 'profile'}",
                *(ROOT / name for name in files)])
    counts = collections.defaultdict(lambda: [0, 0])
    for each in json.loads(text)["data"][0]["files"]:
        name = each["filename"].removeprefix(f"{ROOT}/")
        for line, column, _, _, true, false, *_ in each["branches"]:
            counts[name, line, column][0] += true
            counts[name, line, column][1] += false
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    build = options.build.resolve()
    folder = build / "coverage"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    headers, sources = named_files()
    objects = compiled(folder, options.jobs, sources + CALLERS)
    run(["clang++", "-fprofile-instr-generate", folder / "main.o", *objects, "-Wl,--allow-multiple-definition",
         build / "liblibration.a", *LIBRARIES,
         run(["g++", "-print-file-name=libquadmath.so"]).strip(), "-o", folder / "program"])
    run([folder / "program"], cwd=folder, env={**os.environ, "LLVM_PROFILE_FILE": str(folder / "raw")})

    seen = missed = 0
    used = set()
    for (name, number, column), counts in sorted(counts_of(folder, headers + sources).items()):
        seen += sum(count > 0 for count in counts)
        if all(counts):
            continue
        text = (ROOT / name).read_text().splitlines()[number - 1].strip()
        if "if constexpr" in text:  # decided when it is compiled
            continue
        # A kind that does not occur, as no switch has a default; clang counts the one that is not written.
        if text.startswith("switch (") or (text.startswith("case ") and (text.endswith(":") or text.endswith("break;"))):
            continue
        if (name, text) in ARGUED:
            used.add((name, text))
            continue
        missed += 1
        never = "neither" if not any(counts) else "never true" if not counts[0] else "never false"
        print(f"{name}:{number}:{column}: {never}: {text}")
    idle = sorted(set(ARGUED) - used)
    for name, text in idle:
        print(f"{name}: no condition is open where argued.py has a reason: {text}")
    print(f"{seen} outcomes of conditions seen in {len(headers)} headers and {len(sources)} sources, {len(used)} lines argued, "
          f"{missed} open")
    sys.exit(1 if missed or idle else 0)


if __name__ == "__main__":
    main()
