// What are the solutions of the classical test problems, to digits that integrators can be judged by?
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "libration/ode/first_order_form.hpp"
#include "libration/ode/opened_system.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/problem.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace reference_problems_study {

namespace {

constexpr int times_of_each = 8;
constexpr long most_bits_of_conditions = 20'000;

// Where the last of the times is.
struct ending {
    const char* problem;
    int end;
};
constexpr auto endings = std::to_array<ending>({
    {"arenstorf", 8},
    {"blasius", 8},
    {"brusselator", 20},
    {"detest_a1", 20},
    {"detest_a2", 20},
    {"detest_a3", 20},
    {"detest_a4", 20},
    {"detest_a5", 20},
    {"detest_b1", 20},
    {"detest_b2", 20},
    {"detest_b3", 20},
    {"detest_b4", 20},
    {"detest_b5", 20},
    {"detest_c1", 20},
    {"detest_c2", 20},
    {"detest_c3", 20},
    {"detest_d1", 20},
    {"detest_d2", 20},
    {"detest_d3", 20},
    {"detest_d4", 20},
    {"detest_d5", 20},
    {"detest_e1", 20},
    {"detest_e2", 20},
    {"detest_e3", 20},
    {"detest_e4", 20},
    {"detest_e5", 20},
    {"double_pendulum", 10},
    {"duffing", 20},
    {"falkner_skan", 8},
    {"fitzhugh_nagumo", 40},
    {"harmonic", 20},
    {"henon_heiles", 40},
    {"hires", 20},
    {"kepler", 20},
    {"logistic", 20},
    {"lorenz", 20},
    {"lotka_volterra", 20},
    {"oregonator", 10},
    {"painleve_1", 2},
    {"painleve_2", 2},
    {"pendulum", 20},
    {"robertson", 40},
    {"sakiadis", 8},
    {"seir", 40},
    {"sir", 4},
    {"sir_japan", 40},
    {"three_body_figure_8", 6},
    {"toda", 20},
    {"van_der_pol", 40},
    {"weierstrass", 1},
});

// An unknown at a time.
struct reference_row {
    std::string problem;
    std::string time;
    std::string unknown;
    std::string value;
    long digits;
    mpfr by_start, by_parameters, by_time;
    std::string changed_digit;
};

const column_list<reference_row>& columns() {
    using row = reference_row;
    static const column_list<row> all{
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"time", "value of the independent variable", [](const row& r) { return number_cell(r.time); }},
        {"unknown", "unknown or lower derivative", [](const row& r) { return r.unknown; }},
        {"value", "of it there", [](const row& r) { return cell::number(r.value, r.digits); }},
        {"digits", "significant digits, each proved to one unit in the last", [](const row& r) { return r.digits; }},
        {"rigour", "of value", [](const row&) { return "proved"; }},
        {"condition_start", "sum over the starts s of |d value/d s| |s/value|",
         [](const row& r) { return decimal_cell(r.by_start, 3); }},
        {"condition_parameters", "the same over the parameters; exponents are none",
         [](const row& r) { return decimal_cell(r.by_parameters, 3); }},
        {"condition_time", "|d value/d time| |time/value|", [](const row& r) { return decimal_cell(r.by_time, 3); }},
        {"changed_digit",
         "the significant digit that changes, to first order, where starts and parameters are rounded to double; empty "
         "where they are doubles",
         [](const row& r) { return number_cell(r.changed_digit); }},
    };
    return all;
}

// Parameters that can be opened: not exponents, and not those that other ones are made of alone.
std::vector<std::string> open_names(const ode::equation_system& system) {
    std::vector<std::string> names;
    for (const ode::definition& each : system.parameters) {
        names.push_back(each.name);
        try {
            ode::opened(system, names);
        } catch (const error&) {
            names.pop_back();
        }
    }
    return names;
}

ball rounding_of(const ball& x) {
    ball nearest;
    arf_set_round(arb_midref(nearest.handle()), arb_midref(x.handle()), 53, ARF_RND_NEAR);
    return nearest - x;
}

mpfr size_of(const ball& x) {
    const precision_scope few(20);
    return is_finite(x) ? midpoint_of(abs(x) + 0) : mpfr(1) / mpfr(0);  // of an unknown that is 0
}

// How the unknowns of one problem depend on what goes in.
class dependence {
public:
    explicit dependence(const ode::equation_system& given)
        : open_(ode::opened(given, open_names(given))), form_(open_.system) {
        for (const ode::number& each : open_.values) {
            values_.push_back(ode::constant_value<ball>::of(each));
        }
        ode::expression_values<ball> by_numbers(open_.leaves, ball(0));
        for (const ball& each : values_) {
            by_numbers.push_back(each);
        }
        for (const ode::expression& each : open_.starts) {
            starts_.push_back(by_numbers.of(each));
            auto& row = by_values_.emplace_back();
            for (const ode::expression& leaf : open_.leaves) {
                row.push_back(by_numbers.of(partial(each, leaf)));
            }
        }
        const auto unknowns = given.unknowns();
        for (const ode::unknown_function& each : open_.system.unknowns()) {
            const bool of_problem = std::ranges::find(unknowns, each.name) != unknowns.end();
            is_open_.insert(is_open_.end(), static_cast<std::size_t>(each.order), !of_problem);
        }
    }

    // Calls done(name, value, by_start, by_parameters, by_time, change) for each unknown of the problem.
    template <class Done>
    void at(ode::proved_march& march, const ode::number& time, const Done& done) const {
        const ball t = ode::constant_value<ball>::of(time);
        const auto state = march.at(t);
        if (!state) {
            throw precision_exhausted("a condition number");
        }
        const ode::ball_matrix flow = march.derivative_at(t);
        const ode::ball_matrix by_values = ode::product(flow, by_values_);
        const auto slopes = form_.slopes_at(*state, t);
        for (std::size_t i = 0; i < state->size(); ++i) {
            if (is_open_[i]) {
                continue;
            }
            ball by_start(0);
            ball by_parameters(0);
            ball change(0);
            for (std::size_t j = 0; j < starts_.size(); ++j) {
                if (!is_open_[j]) {
                    by_start += abs(flow[i][j]) * abs(starts_[j]);
                    change += flow[i][j] * rounding_of(starts_[j]);
                }
            }
            for (std::size_t p = 0; p < values_.size(); ++p) {
                by_parameters += abs(by_values[i][p]) * abs(values_[p]);
                change += by_values[i][p] * rounding_of(values_[p]);
            }
            const ball size = abs((*state)[i]);
            done(form_.names[i], size_of(by_start / size), size_of(by_parameters / size),
                 size_of(abs(slopes[i]) * abs(t) / size), size_of(change / size));
        }
    }

    const ode::explicit_system& system() const { return open_.system; }

private:
    ode::opened_system open_;
    ode::first_order_form form_;
    std::vector<ball> values_, starts_;
    ode::ball_matrix by_values_;
    std::vector<bool> is_open_;
};

std::string digit_that_changes(const mpfr& relative_change) {
    if (relative_change == 0) {
        return "";
    }
    const mpfr digit = floor(mpfr(-log10(relative_change))) + 1;
    return digit < 1 ? "1" : digit.str(0, std::ios_base::fixed);
}

void add_conditions(std::vector<reference_row>& rows, const ode::equation_system& equations,
                    const std::vector<ode::number>& times) {
    for (long bits = 200; bits <= most_bits_of_conditions; bits *= 2) {
        const precision_scope scope(decimal_digits(bits));
        try {
            const dependence on(equations);
            ode::proved_march march(on.system(), bits);
            march.keep_derivative();
            std::size_t next = 0;
            for (const ode::number& time : times) {
                on.at(march, time,
                      [&](const std::string&, const mpfr& by_start, const mpfr& by_parameters, const mpfr& by_time,
                          const mpfr& change) {
                          reference_row& row = rows[next++];
                          row.by_start = by_start;
                          row.by_parameters = by_parameters;
                          row.by_time = by_time;
                          row.changed_digit = digit_that_changes(change);
                      });
            }
            return;
        } catch (const precision_exhausted&) {
            continue;
        }
    }
    throw error(error_kind::undecided, "condition number", rows.front().problem, "is not decided");
}

table rows_of_problem(const ending& of, long digits) {
    const auto equations = ode::parse(std::string(problem_text(of.problem)));
    const ode::explicit_system system(equations);
    std::vector<ode::number> times;
    std::vector<std::string> decimals;
    for (int k = 1; k <= times_of_each; ++k) {
        times.push_back(system.point() + ode::number(rational(of.end * k, times_of_each)));
        decimals.push_back(decimal_of(rational(*times.back().fraction()), digits));
    }
    const auto values = ode::proved_trajectory(system, times, digits);
    const ode::first_order_form form(system);
    std::vector<reference_row> rows;
    for (std::size_t i = 0; i < times.size(); ++i) {
        for (std::size_t k = 0; k < form.names.size(); ++k) {
            rows.push_back({of.problem, decimals[i], form.names[k], values[i][k].text, digits, {}, {}, {}, ""});
        }
    }
    add_conditions(rows, equations, times);
    return make_table(columns(), rows);
}

std::vector<ending> chosen(const study_request& request) {
    std::vector<ending> result;
    for (const exact& each : request.values.of("problem")) {
        for (const ending& known : endings) {
            if (each.text == known.problem || each.text == "all") {
                result.push_back(known);
            }
        }
    }
    return result;
}

study_plan plan(const study_request& request) {
    const auto problems = chosen(request);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("ball:50", arithmetics::proved_too));
    return plan_of_cells(
        {head_of("", scalar, columns())}, {"problem"}, problems.size(),
        [problems](std::size_t i) {
            return cell_inputs{{"problem", problems[i].problem}};
        },
        [problems, digits = scalar.digits](std::size_t i) {
            return std::vector<table>{rows_of_problem(problems[i], digits)};
        });
}

void check_name(const exact& each) {
    if (each.text != "all" &&
        std::ranges::none_of(endings, [&](const ending& known) { return each.text == known.problem; })) {
        throw error(error_kind::argument, "list", "", "has '" + each.text + "', which is no problem of this set");
    }
}

const problem& problems_of_study() {
    static const problem result{.name = "problems with a regular start",
                                .axes = {{.name = "problem",
                                          .option = "--problems",
                                          .help = "problems of the catalogue with a regular start: LIST, or all",
                                          .unit = "",
                                          .form = axis_form::words,
                                          .remedy = "write names such as lorenz,kepler, or all",
                                          .check = check_name,
                                          .coordinate = "problem",
                                          .to_coordinate = {}}}};
    return result;
}

}  // namespace
}  // namespace reference_problems_study

const study& reference_problems() {
    using namespace reference_problems_study;
    static const study result{
        .name = "reference_problems",
        .title = "Reference values of test problems",
        .label = "",
        .question =
            "What are the solutions of the classical test problems, to digits that integrators can be judged by?",
        .reading =
            "How many digits each problem loses: the logarithm of the condition number with respect to the start at "
            "its "
            "last time, and beside it that with respect to the parameters. The table has every unknown at eight times, "
            "each digit proved, with its condition numbers and the first digit that changes where starts and "
            "parameters "
            "are rounded to double: an integrator in double that is handed rounded numbers cannot be right beyond it.",
        .of = &problems_of_study(),
        .parameters = {{"--problems", "all", "problems of the catalogue"},
                       {"--scalar", "ball:50", "digits of the values"}},
        .quick = {{"--problems", "logistic,kepler", ""}, {"--scalar", "ball:20", ""}},
        .seconds = 60,
        .excluded = {},
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
