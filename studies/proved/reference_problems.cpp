// What are the solutions of the classical test problems, to enough digits for testing integrators?
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "../shared/named_choice.hpp"
#include "libration/problem/problem_family.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/query/states.hpp"
#include "reference_files.hpp"
#include "solution_facts.hpp"
#include "sweep/study.hpp"
#include "test_problems.hpp"
#include "text/members.hpp"

namespace libration::studies {

namespace reference_problems_study {

using proved::test_problem;
using proved::test_problems;

namespace {

// An unknown at a time.
struct reference_row {
    std::string problem;
    std::string time;
    std::string unknown;
    std::string value;
    long digits;
    std::optional<mpfr> by_start = {}, by_parameters = {}, by_time = {};
    std::string changed_digit = {};
    proved::nearest_singularity nearest = {};
};

cell condition_cell(const std::optional<mpfr>& number) { return number ? decimal_cell(*number, 3) : cell(); }

const column_list<reference_row>& columns() {
    using row = reference_row;
    static const column_list<row> all{
        {"problem", "name in the set", [](const row& r) { return r.problem; }},
        {"time", "value of the independent variable", [](const row& r) { return number_cell(r.time); }},
        {"unknown", "unknown or lower derivative", [](const row& r) { return r.unknown; }},
        {"value", "of it there", [](const row& r) { return cell::number(r.value, r.digits); }},
        {"digits", "significant digits, each proved to one unit in the last", [](const row& r) { return r.digits; }},
        {"rigour", "of value and condition numbers", [](const row&) { return "proved"; }},
        {"condition_start",
         "sum over the starts s of |d value/d s| |s/value|; 0 below 1e-9; none of the three for stiff problems",
         [](const row& r) { return condition_cell(r.by_start); }},
        {"condition_parameters", "the same over the parameters; exponents are none",
         [](const row& r) { return condition_cell(r.by_parameters); }},
        {"condition_time", "|d value/d time| |time/value|", [](const row& r) { return condition_cell(r.by_time); }},
        {"changed_digit",
         "the significant digit that changes, to first order, where starts and parameters are rounded to double; empty "
         "where they are doubles",
         [](const row& r) { return number_cell(r.changed_digit); }},
        {"radius",
         "distance of the nearest complex singularity from the time: heuristic, to the digits of its own "
         "uncertainty; empty where none was seen",
         [](const row& r) { return number_cell(r.nearest.radius); }},
        {"singularity_re", "Re of that singularity, as a time", [](const row& r) { return number_cell(r.nearest.re); }},
        {"singularity_im", "Im of it", [](const row& r) { return number_cell(r.nearest.im); }},
    };
    return all;
}

const column_list<proved::invariant_value>& invariant_columns() {
    using row = proved::invariant_value;
    static const column_list<row> all{
        {"problem", "name in the set", [](const row& r) { return r.problem; }},
        {"invariant", "expression that is constant along the solution", [](const row& r) { return r.expression; }},
        {"value", "of it", [](const row& r) { return cell::number(r.value, r.digits); }},
        {"digits", "significant digits, each proved to one unit in the last", [](const row& r) { return r.digits; }},
        {"rigour", "of value", [](const row&) { return "proved"; }},
        {"difference", "largest |invariant at printed values - value| over the times",
         [](const row& r) { return decimal_cell(r.difference, 3); }},
    };
    return all;
}

std::string digit_that_changes(const mpfr& relative_change) {
    if (relative_change == 0) {
        return "";
    }
    const mpfr digit = floor(mpfr(-log10(relative_change))) + 1;
    return digit < 1 ? "1" : digit.str(0, std::ios_base::fixed);
}

// Relative to a value that is exactly 0 any change is infinite.
mpfr part_of(const mpfr& moved, const mpfr& size) { return moved == 0 ? mpfr(0) : mpfr(moved / size); }

std::vector<table> tables_of_stiff(const test_problem& of, long digits) {
    const auto times = of.times();
    const proved::solution_facts facts(of, digits);
    std::vector<reference_row> rows;
    std::vector<std::vector<std::string>> printed;
    for (const auto& state : ode::proved_trajectory(ode::explicit_system(of.equations()), times, digits)) {
        const std::string time = proved::decimal_in(times[printed.size()]);
        auto& values = printed.emplace_back();
        for (const proved_decimal& each : state) {
            rows.push_back({of.name, time, facts.names()[values.size()], each.text, digits});
            values.push_back(each.text);
        }
    }
    return {make_table(columns(), rows), make_table(invariant_columns(), facts.invariants(times, printed))};
}

// The unknowns of a problem at its times, and its invariants.
std::vector<table> tables_of(const test_problem& of, long asked) {
    const long digits = of.digits_of(asked);
    if (of.is_stiff()) {
        return tables_of_stiff(of, digits);
    }
    const auto equations = of.equations();
    const auto times = of.times();
    const auto states = ode::proved_conditions(equations, times, digits);
    const proved::solution_facts facts(of, digits);
    std::vector<reference_row> rows;
    std::vector<std::vector<std::string>> printed;
    for (std::size_t i = 0; i < times.size(); ++i) {
        auto& values = printed.emplace_back();
        for (const proved_decimal& each : states[i].values) {
            values.push_back(each.text);
        }
        const auto nearest = facts.nearest_about(times[i], values);
        const precision_scope few(20);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const ode::moved_value& moved = states[i].moved[k];
            const mpfr size = abs(proved::number_in(values[k]));
            rows.push_back({of.name, proved::decimal_in(times[i]), facts.names()[k], values[k], digits,
                            part_of(moved.by_start, size), part_of(moved.by_parameters, size),
                            part_of(moved.by_time, size), digit_that_changes(part_of(moved.by_rounding, size)),
                            nearest});
        }
    }
    const precision_scope few(20);
    return {make_table(columns(), rows), make_table(invariant_columns(), facts.invariants(times, printed))};
}

const named_choice& problems_to_choose() {
    static const named_choice result{.axis = "problem",
                                     .option = "--problems",
                                     .help = "problems of the set",
                                     .forms = "LIST, or all",
                                     .remedy = "write names such as lorenz,kepler, or all",
                                     .what = "not a problem of this set",
                                     .names = members_of(test_problems(), &test_problem::name)};
    return result;
}

study_plan plan(const study_request& request) {
    std::vector<test_problem> problems;
    for (const std::string& name : chosen_names(problems_to_choose(), request.values)) {
        problems.push_back(named(test_problems(), name));
    }
    const scalar_spec scalar = request.scalar.value_or(read_scalar("ball:50", arithmetics::proved_too));
    study_plan result = plan_of_cells(
        {head_of("", scalar, columns()), head_of("invariants", scalar, invariant_columns())}, {"problem"},
        problems.size(),
        [problems](std::size_t i) {
            return cell_inputs{{"problem", problems[i].name}};
        },
        [problems, digits = scalar.digits](std::size_t i) { return tables_of(problems[i], digits); });
    result.cost = [problems](std::size_t i) { return static_cast<double>(problems[i].seconds); };
    return result;
}

const problem_family& problems_of_study() {
    static const problem_family result{.name = "test problems", .axes = {axis_of(problems_to_choose())}};
    return result;
}

}  // namespace
}  // namespace reference_problems_study

const study& reference_problems() {
    using namespace reference_problems_study;
    static const study result{
        .name = "reference_problems",
        .title = "Reference values of test problems",
        .question =
            "What are the solutions of the classical test problems, to digits that integrators can be judged by?",
        .reading =
            "How many digits each problem loses: the logarithm of its largest condition number with respect to the "
            "start, and beside it that with respect to the parameters. The table has every unknown at eight times, "
            "each digit proved, with its condition numbers and the first digit that changes where starts and "
            "parameters are rounded to double: an integrator in double that is handed rounded numbers cannot be right "
            "beyond it. Stiff problems have eleven times, each twice or ten times the one before, 30 digits "
            "and no condition numbers. The same stands in a CSV and in a text file for each problem, with its "
            "equations, its sources "
            "and its invariants.",
        .of = &problems_of_study(),
        .parameters = {{"--problems", "all", "problems of the set"}, {"--scalar", "ball:50", "digits of the values"}},
        .quick = {{"--problems", "stiff_d4", ""}, {"--scalar", "ball:20", ""}},
        .seconds = 600,
        .plan = plan,
        .version = 3,
        .offers = arithmetics::proved_too,
        .files = proved::reference_files};
    return result;
}

}  // namespace libration::studies
