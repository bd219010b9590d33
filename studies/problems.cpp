// What do the solutions of the catalogue look like, how fast do their series converge, and what limits them?
#include <algorithm>
#include <optional>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "problem/catalogue_axis.hpp"
#include "problem/solution_on_interval.hpp"
#include "shared/list_answers.hpp"

namespace libration::studies {

namespace problems_study {

namespace {

constexpr long working_digits_of_solutions = 30;
constexpr long printed_digits = 12;
constexpr int instants = 101;
const scalar_spec& arithmetic_of_lists() {
    static const scalar_spec chosen = read_scalar("mpfr:30");
    return chosen;
}

template <class Row>
column_of<Row> problem_column() {
    return {"problem", "name in the catalogue", [](const Row& r) { return cell(r.problem); }};
}

struct value_row {
    std::string problem;
    mpfr time, value;
    std::string unknown;
};

const column_list<value_row>& value_columns() {
    using row = value_row;
    static const column_list<row> all{
        problem_column<row>(),
        {"time", "in the unit of the variable: from the start to five radii of convergence, or as far as steps lead",
         [](const row& r) { return decimal_cell(r.time, printed_digits); }},
        {"value", "of the unknown, by one march of 30 digits (heuristic)",
         [](const row& r) { return decimal_cell(r.value, printed_digits); }},
        unknown_column<row>(),
    };
    return all;
}

struct size_row {
    std::string problem;
    int n;
    mpfr value;
    std::string unknown;
};

const column_list<size_row>& size_columns() {
    using row = size_row;
    static const column_list<row> all{
        problem_column<row>(),
        {"n", "index of the coefficient about the start; those that are 0 are left out",
         [](const row& r) { return r.n; }},
        {"log10_abs", "log10 of its size", [](const row& r) { return log10_cell(r.value); }},
        unknown_column<row>(),
    };
    return all;
}

struct nearest_row {
    std::string problem;
    answered_list of;
    std::string unknown;
};

const column_list<nearest_row>& nearest_columns() {
    using row = nearest_row;
    static const column_list<row> all = joined(
        joined<row>({problem_column<row>()}, columns_within(result_columns(), &row::of)), {unknown_column<row>()});
    return all;
}

// The verdicts on the lists of all unknowns.
std::vector<nearest_row> nearest_in(const std::string& name, const std::vector<unknown_series>& lists, int order) {
    std::vector<nearest_row> rows;
    for (const unknown_series& list : lists) {
        const auto verdict = answers_to(list.name, list.coefficients(), order, arithmetic_of_lists(), is_verdict,
                                        lists.front().lists.root);
        rows.push_back({name, verdict.front(), list.name});
    }
    return rows;
}

// Five times the least radius; 10 if there is none.
rational length_for(const std::vector<nearest_row>& nearest) {
    constexpr int times = 5;
    std::optional<mpfr> least;
    for (const nearest_row& each : nearest) {
        const auto& radius = each.of.found.radius;
        if (radius && (!least || *radius < *least)) {
            least = radius;
        }
    }
    if (!least) {
        return 10;
    }
    const mpfr thousandths = mpfr(*least * times * 1000);
    return rational(std::max(integer(1), nearest_integer(thousandths))) / 1000;
}

// Times on [start, start + length] and the states there; shorter if the integration ends before.
solution_on_interval march_over(const ode::explicit_system& system, rational length) {
    constexpr int attempts = 8;
    for (int attempt = 1;; ++attempt, length = length * 2 / 3) {
        std::vector<ode::number> times;
        times.reserve(instants);
        for (int i = 0; i < instants; ++i) {
            times.push_back(system.point() + ode::number(rational(length * i / (instants - 1))));
        }
        try {
            return solve_on(system, times);
        } catch (const error&) {
            if (attempt == attempts) {
                throw;
            }
        }
    }
}

std::vector<table> tables_of_problem(const std::string& name, int order) {
    const ode::explicit_system system(ode::parse(problem_text(name)));
    const long digits = arithmetic_of_lists().digits + guard_of_lists;
    const precision_scope scope(digits);
    const auto lists = lists_about_start(system, order, digits);
    const auto nearest = nearest_in(name, lists, order);
    std::vector<size_row> sizes;
    for (const unknown_series& list : lists) {
        for (int n = 0; n <= order; ++n) {
            if (list.coefficients()[n] != 0) {
                sizes.push_back({name, n, list.coefficients()[n], list.name});
            }
        }
    }
    std::vector<value_row> values;
    {
        const precision_scope shorter(working_digits_of_solutions);
        const auto solution = march_over(system, length_for(nearest));
        for (std::size_t i = 0; i < lists.size(); ++i) {
            for (std::size_t k = 0; k < solution.times.size(); ++k) {
                values.push_back({name, solution.times[k], solution.values[i][k], lists[i].name});
            }
        }
    }
    return {make_table(value_columns(), values), make_table(size_columns(), sizes),
            make_table(nearest_columns(), nearest)};
}

study_plan plan(const study_request& request) {
    const auto names = problem_names_of(request.values.of("problem"));
    const auto orders = request.orders();
    const int order = *std::ranges::max_element(orders);
    if (order < least_order_of_lists) {
        throw input_error("--orders", std::to_string(order), "is too short a list for a radius test",
                          "write orders from 4 on");
    }
    const scalar_spec& scalar = arithmetic_of_lists();
    return plan_of_cells(
        {head_of("", scalar, value_columns()), head_of("coefficients", scalar, size_columns()),
         head_of("singularities", scalar, nearest_columns())},
        {"problem"}, names.size(),
        [names](std::size_t i) {
            return cell_inputs{{"problem", names[i]}};
        },
        [names, order](std::size_t i) { return tables_of_problem(names[i], order); });
}

}  // namespace
}  // namespace problems_study

const study& problems() {
    using namespace problems_study;
    static const study result{
        .name = "problems",
        .title = "The catalogue of problems",
        .question = "What do the solutions of the catalogue look like, and how far do their series reach?",
        .reading =
            "Every problem of the catalogue with its usual parameters. First its solution from the start to five radii "
            "of convergence, or as far as it can be marched; then the size of its coefficients about the start; then "
            "the nearest singularities that the radius tests see in them, in the complex plane of time around the "
            "start, with the circle of convergence. Nothing here is proved: positions are those of the verdict of the "
            "tests, whose uncertainty stands in the third table.",
        .of = &catalogue_as_problem(),
        .parameters = {{"--problems", "all", "names of the catalogue"},
                       {"--orders", "80", "N, last power of the lists; the largest is used"}},
        .quick = {{"--problems", "blasius,riccati,thomas_fermi", ""}, {"--orders", "20", ""}},
        .seconds = 30,
        .plan = plan,
        .version = 2};
    return result;
}

}  // namespace libration::studies
