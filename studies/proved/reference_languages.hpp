// The published reference values as source text of C, Julia and Python: numbers are decimal text in all of them, so that
// the reader chooses the type.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <string>
#include <vector>

#include "sweep/study.hpp"

namespace libration::studies::proved {

/// The values of a problem: values[i][j] is unknown j at time i.
struct value_grid {
    std::string problem;
    std::vector<std::string> unknowns;
    std::vector<std::string> times;
    std::vector<std::vector<std::string>> values;
};

inline std::vector<std::string> quoted(const std::vector<std::string>& texts) {
    std::vector<std::string> all;
    for (const std::string& each : texts) {
        all.push_back('"' + each + '"');
    }
    return all;
}

inline std::string one_line(const std::vector<std::string>& texts) {
    return fmt::format("{}", fmt::join(quoted(texts), ", "));
}

/// A line for each of the lists, with these texts around it.
inline std::string lines_of(const std::vector<std::vector<std::string>>& lists, const std::string& before,
                            const std::string& after) {
    std::string text;
    for (const auto& each : lists) {
        text += before + one_line(each) + after + "\n";
    }
    return text;
}

/// reference_problems.h
inline std::string c_header_of(const std::vector<value_grid>& grids) {
    std::string text =
        "/* Reference values of test problems, each digit proved to one unit in the last place; public domain (CC0 "
        "1.0).\n"
        "   value[i*unknown_count + j] is unknown j at time i: decimal text for strtod, strtoflt128 or mpfr_set_str. "
        "*/\n"
        "#ifndef LIBRATION_REFERENCE_PROBLEMS_H\n#define LIBRATION_REFERENCE_PROBLEMS_H\n\n"
        "typedef struct {\n    const char *problem;\n    int unknown_count, time_count;\n"
        "    const char *const *unknown, *const *time, *const *value;\n} libration_reference;\n\n";
    std::string list;
    for (const value_grid& each : grids) {
        const auto declare = [&](const std::string& name, const std::string& content) {
            text += fmt::format("static const char *const libration_{}_{}[] = {{{}}};\n", each.problem, name, content);
        };
        declare("unknown", one_line(each.unknowns));
        declare("time", one_line(each.times));
        declare("value", "\n" + lines_of(each.values, "    ", ","));
        list +=
            fmt::format("    {{\"{0}\", {1}, {2}, libration_{0}_unknown, libration_{0}_time, libration_{0}_value}},\n",
                        each.problem, each.unknowns.size(), each.times.size());
    }
    return text + "\nstatic const libration_reference libration_references[] = {\n" + list +
           fmt::format("}};\nenum {{ libration_reference_count = {} }};\n\n#endif\n", grids.size());
}

/// reference_problems.jl
inline std::string julia_module_of(const std::vector<value_grid>& grids) {
    std::string text =
        "# Reference values of test problems, each digit proved to one unit in the last place; public domain (CC0 "
        "1.0).\n"
        "# u[i][j] is unknown j at time t[i], as decimal text.\nmodule ReferenceProblems\n\nconst problems = Dict(\n";
    for (const value_grid& each : grids) {
        text += fmt::format("    \"{}\" => (unknowns = [{}],\n        t = [{}],\n        u = [\n{}        ]),\n",
                            each.problem, one_line(each.unknowns), one_line(each.times),
                            lines_of(each.values, "            [", "],"));
    }
    return text +
           ")\n\n\"\"\"\nThe times and states of a problem as numbers of type T.\n"
           "With DiffEqDevTools: `TestSolution(ReferenceProblems.reference(\"kepler\")...)`.\n\"\"\"\n"
           "reference(problem, T = Float64) =\n"
           "    (parse.(T, problems[problem].t), [parse.(T, state) for state in problems[problem].u])\n\nend\n";
}

/// reference_problems.py
inline std::string python_module_of(const std::vector<value_grid>& grids) {
    std::string text =
        "\"\"\"Reference values of test problems, each digit proved to one unit in the last place; public domain "
        "(CC0 1.0).\n\nPROBLEMS[name][\"u\"][i][j] is unknown j at time i, as decimal text for float, decimal.Decimal "
        "or "
        "mpmath.mpf.\n\"\"\"\n\nPROBLEMS = {\n";
    for (const value_grid& each : grids) {
        text += fmt::format(
            "    \"{}\": {{\n        \"unknowns\": [{}],\n        \"t\": [{}],\n        \"u\": [\n{}        ],\n    "
            "}},\n",
            each.problem, one_line(each.unknowns), one_line(each.times), lines_of(each.values, "            [", "],"));
    }
    return text + "}\n";
}

}  // namespace libration::studies::proved
