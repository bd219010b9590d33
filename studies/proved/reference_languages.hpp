// The published reference values as source text of C, Julia and Python: numbers are decimal text in all of them, so that
// the reader chooses the type.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace libration::studies::proved {

/// The values of a problem: values[i][j] is unknown j at time i.
struct value_grid {
    std::string problem;
    std::vector<std::string> unknowns;
    std::vector<std::string> times;
    std::vector<std::vector<std::string>> values;
};

/// What is written in a language: the start, a part for each problem, a second part for each, and the end. {problem},
/// {unknowns}, {times} and {values} are replaced by those of a problem, {m} and {n} by the numbers of unknowns and times,
/// {count} by the number of problems; a line of values is between `before` and `after`.
struct reference_language {
    std::string_view file, start, part, before, after;
    std::string_view middle = {}, second_part = {};
    std::string_view end;
};

inline constexpr auto reference_languages = std::to_array<reference_language>(
    {{.file = "reference_problems.h",
      .start =
          "/* Reference values of test problems, each digit proved to one unit in the last place; public domain (CC0 "
          "1.0).\n"
          "   value[i*unknown_count + j] is unknown j at time i: decimal text for strtod, strtoflt128 or "
          "mpfr_set_str. */\n"
          "#ifndef LIBRATION_REFERENCE_PROBLEMS_H\n#define LIBRATION_REFERENCE_PROBLEMS_H\n\n"
          "typedef struct {{\n    const char *problem;\n    int unknown_count, time_count;\n"
          "    const char *const *unknown, *const *time, *const *value;\n}} libration_reference;\n\n",
      .part = "static const char *const libration_{problem}_unknown[] = {{{unknowns}}};\n"
              "static const char *const libration_{problem}_time[] = {{{times}}};\n"
              "static const char *const libration_{problem}_value[] = {{\n{values}}};\n",
      .before = "    ",
      .after = ",\n",
      .middle = "\nstatic const libration_reference libration_references[] = {{\n",
      .second_part = "    {{\"{problem}\", {m}, {n}, libration_{problem}_unknown, libration_{problem}_time, "
                     "libration_{problem}_value}},\n",
      .end = "}};\nenum {{ libration_reference_count = {count} }};\n\n#endif\n"},
     {.file = "reference_problems.jl",
      .start =
          "# Reference values of test problems, each digit proved to one unit in the last place; public domain (CC0 "
          "1.0).\n"
          "# u[i][j] is unknown j at time t[i], as decimal text.\nmodule ReferenceProblems\n\n"
          "const problems = Dict(\n",
      .part = "    \"{problem}\" => (unknowns = [{unknowns}],\n        t = [{times}],\n        u = [\n{values}        "
              "]),\n",
      .before = "            [",
      .after = "],\n",
      .end = ")\n\n\"\"\"\nThe times and states of a problem as numbers of type T.\n"
             "With DiffEqDevTools: `TestSolution(ReferenceProblems.reference(\"kepler\")...)`.\n\"\"\"\n"
             "reference(problem, T = Float64) =\n"
             "    (parse.(T, problems[problem].t), [parse.(T, state) for state in problems[problem].u])\n\nend\n"},
     {.file = "reference_problems.py",
      .start =
          "\"\"\"Reference values of test problems, each digit proved to one unit in the last place; public domain "
          "(CC0 1.0).\n\nPROBLEMS[name][\"u\"][i][j] is unknown j at time i, as decimal text for float, "
          "decimal.Decimal or mpmath.mpf.\n\"\"\"\n\nPROBLEMS = {{\n",
      .part =
          "    \"{problem}\": {{\n        \"unknowns\": [{unknowns}],\n        \"t\": [{times}],\n        \"u\": [\n"
          "{values}        ],\n    }},\n",
      .before = "            [",
      .after = "],\n",
      .end = "}}\n"}});

inline std::string one_line(const std::vector<std::string>& texts) {
    std::string line;
    for (const std::string& each : texts) {
        line += (line.empty() ? "\"" : ", \"") + each + '"';
    }
    return line;
}

/// The values of these problems in a language.
inline std::string text_in(const reference_language& in, const std::vector<value_grid>& grids) {
    std::string first;
    std::string second;
    for (const value_grid& each : grids) {
        std::string values;
        for (const auto& state : each.values) {
            values += std::string(in.before) + one_line(state) + std::string(in.after);
        }
        const auto filled = [&](std::string_view text) {
            return fmt::format(fmt::runtime(text), fmt::arg("problem", each.problem),
                               fmt::arg("unknowns", one_line(each.unknowns)), fmt::arg("times", one_line(each.times)),
                               fmt::arg("values", values), fmt::arg("m", each.unknowns.size()),
                               fmt::arg("n", each.times.size()));
        };
        first += filled(in.part);
        second += filled(in.second_part);
    }
    const auto outside = [&](std::string_view text) {
        return fmt::format(fmt::runtime(text), fmt::arg("count", grids.size()));
    };
    return outside(in.start) + first + outside(in.middle) + second + outside(in.end);
}

}  // namespace libration::studies::proved
