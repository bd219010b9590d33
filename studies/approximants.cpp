// Do asymptotic approximants converge, and how many digits are lost in the systems from which they are computed?
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "libration/problem/known/sakiadis.hpp"
#include "published_numbers.hpp"
#include "shared/catalogue_system.hpp"
#include "shared/equation_plan.hpp"
#include "shared/named_choice.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"
#include "vandermonde_loss.hpp"

namespace libration::studies {

namespace approximants_study {

namespace of_catalogue {

using namespace approximant_norms;

namespace {

const column_list<norm_row>& columns() {
    using row = norm_row;
    static const column_list<row> all = joined(
        joined<row>({{"problem", "of the catalogue", [](const row& r) { return r.problem; }}}, columns_of_norms()),
        {{"unknown", "of the problem", [](const row& r) { return r.unknown; }}});
    return all;
}

// A printed number and the computed one.
struct verdict_row {
    published_number number;
    mpfr ours;
    bool decided;
};

mpfr unit_in_last_place(const std::string& decimal) {
    const auto point = decimal.find('.');
    return pow(mpfr(10), -static_cast<int>(decimal.size() - 1 - point));
}

const column_list<verdict_row>& verdict_columns() {
    using row = verdict_row;
    const auto units = [](const row& r) {
        return mpfr((from_exact<mpfr>(read_exact(r.number.printed)) - r.ours) / unit_in_last_place(r.number.printed));
    };
    static const column_list<row> all{
        {"problem", "of the catalogue", [](const row& r) { return r.number.problem; }},
        {"changes", "parameters and starts, those sought as a first guess",
         [](const row& r) { return fmt::format("{}", fmt::join(r.number.changes, "; ")); }},
        {"quantity", "what is printed", [](const row& r) { return r.number.quantity; }},
        {"coefficients", "that the approximant predicts it from; empty: of the solution itself",
         [](const row& r) { return r.number.known > 0 ? cell(r.number.known) : cell(); }},
        {"published", "as printed", [](const row& r) { return cell(r.number.printed); }},
        {"ours", "two runs with other digits and other distances agree on it",
         [](const row& r) { return decimal_cell(r.ours, static_cast<long>(r.number.printed.size()) + 2); }},
        {"units", "(published - ours) in units of the last printed place",
         [units](const row& r) { return decimal_cell(units(r), 3); }},
        {"verdict", "holds: within a unit of the last printed place | fails | undecided",
         [units](const row& r) { return !r.decided           ? "undecided"
                                        : abs(units(r)) <= 1 ? "holds"
                                                             : "fails"; }},
        {"source", "of the printed number", [](const row& r) { return r.number.source; }},
    };
    return all;
}

mpfr value_of(const published_number& number, long digits) {
    const auto system = catalogue_system(number.problem, number.changes);
    if (number.known == 0) {
        return far_behaviour_of(number.problem, system, digits, number.free).values.at(number.quantity);
    }
    const precision_scope scope(2 * digits + 20);
    const auto found = predicted_sakiadis(system, number.known);
    return number.quantity == "G" ? found.amplitude : number.quantity == "f(inf)" ? found.limit : found.wall_shear;
}

std::vector<verdict_row> verdicts_of(const std::string& problem) {
    std::vector<verdict_row> rows;
    for (const published_number& each : published_numbers(problem)) {
        const auto digits = static_cast<long>(each.printed.size());
        const mpfr ours = value_of(each, digits);
        const mpfr again = value_of(each, digits + 6);
        rows.push_back({each, again, abs(mpfr(ours - again)) * 10 <= unit_in_last_place(each.printed)});
    }
    return rows;
}

std::vector<table> tables_of_problem(const std::string& problem, const std::vector<int>& orders, long digits) {
    const int highest = *std::max_element(orders.begin(), orders.end());
    const precision_scope scope(digits + 20 + 3L * highest);
    const solved_problem of = solve(problem, catalogue_system(problem), highest, digits);
    return {make_table(columns(), norms_of(of, orders)), make_table(loss_columns(), losses_of(of, orders)),
            make_table(verdict_columns(), verdicts_of(problem))};
}

const named_choice& problems_to_choose() {
    static const named_choice result{.axis = "problem",
                                     .option = "--problems",
                                     .help = "problems of the catalogue with a known asymptotic behaviour",
                                     .forms = "LIST, or all",
                                     .remedy = "write names such as blasius,sir, or all",
                                     .what = "not a problem with a known asymptotic behaviour: choose among " +
                                             fmt::format("{}", fmt::join(problems_with_far_behaviour(), ", ")),
                                     .names = problems_with_far_behaviour()};
    return result;
}

study_plan plan(const study_request& request) {
    const auto problems = chosen_names(problems_to_choose(), request.values);
    const auto orders = orders_from(request, 1, "is not an order of an approximant");
    const auto all_digits = request.digits();
    const scalar_spec scalar{scalar_kind::arbitrary, *std::max_element(all_digits.begin(), all_digits.end())};
    return plan_of_cells(
        {head_of("", scalar, columns()), head_of("digits", scalar, loss_columns()),
         head_of("published", scalar, verdict_columns())},
        {"problem"}, problems.size(),
        [problems](std::size_t i) {
            return cell_inputs{{"problem", problems[i]}};
        },
        [problems, orders, digits = scalar.digits](std::size_t i) {
            return tables_of_problem(problems[i], orders, digits);
        });
}

const problem_family& problems_of_study() {
    static const problem_family result{.name = "problems with a known far behaviour",
                                       .axes = {axis_of(problems_to_choose())}};
    return result;
}

}  // namespace
}  // namespace of_catalogue

namespace of_equation {

using namespace approximant_norms;

namespace {

const column_list<norm_row>& columns() {
    using row = norm_row;
    static const column_list<row> all = joined(columns_of_norms(), {unknown_column<row>()});
    return all;
}

// A number of the asymptotic behaviour.
struct value_row {
    std::string quantity;
    mpfr value;
    std::string unknown;
};

const column_list<value_row>& value_columns() {
    using row = value_row;
    static const column_list<row> all{
        {"quantity", "of the far behaviour, by its name in the literature; end: where the solution has come to it",
         [](const row& r) { return r.quantity; }},
        {"value", "two-method: the one that meets the condition at infinity",
         [](const row& r) { return decimal_cell(r.value, norm_digits); }},
        unknown_column<row>(),
    };
    return all;
}

ode::equation_system changed_system(const swept_problem& of, const cell_inputs& inputs) {
    auto system = of.system;
    for (const auto& [name, value] : inputs) {
        system = ode::changed(std::move(system), name + " = " + value);
    }
    return system;
}

// The first guess of the wall shear of Falkner and Skan is for one b only: continue from there in steps of b.
ode::equation_system with_near_guess(const swept_problem& of, ode::equation_system system) {
    constexpr int steps_a_unit = 16;
    constexpr long rough = 8;
    const bool given = std::ranges::any_of(of.sets, [](const set_axis& each) { return each.name == "s"; });
    if (of.said != "falkner_skan" || given) {
        return system;
    }
    const precision_scope scope(30);
    const auto value_of = [](const ode::equation_system& in, const char* name) {
        return ode::constant_value<mpfr>::of(with_values(ode::parameter(name), in).constant());
    };
    const mpfr first = value_of(of.system, "b");
    const mpfr last = value_of(system, "b");
    const int steps = static_cast<int>(ceil(mpfr(abs(mpfr(last - first)) * steps_a_unit)));
    mpfr before = value_of(of.system, "s");
    mpfr guess = before;
    for (int i = 1; i < steps; ++i) {
        const mpfr b = first + (last - first) * i / steps;
        const auto near =
            ode::changed(ode::changed(system, "s = " + to_decimal(guess, 12)), "b = " + to_decimal(b, 20));
        const mpfr now = far_behaviour_of(of.said, near, rough).values.at("s");
        guess = now * 2 - before;
        before = now;
    }
    return ode::changed(std::move(system), "s = " + to_decimal(guess, 12));
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders, long digits) {
    const precision_scope scope(digits + 20 + 3L * orders.back());
    const auto system = with_near_guess(sweep.of(), changed_system(sweep.of(), sweep.inputs(i)));
    const solved_problem found = solve(sweep.of().said, system, orders.back(), digits);
    std::vector<value_row> values;
    for (const auto& [name, value] : found.far.values) {
        values.push_back({name, value, found.far.unknown});
    }
    values.push_back({"end", found.far.end, found.far.unknown});
    return {make_table(columns(), norms_of(found, orders)), make_table(value_columns(), values)};
}

void require_far_behaviour(const swept_problem& of) {
    const auto& known = problems_with_far_behaviour();
    if (std::ranges::find(known, of.said) == known.end()) {
        throw input_error("--problem", of.said, "has no known asymptotic behaviour",
                          fmt::format("choose one of {}", fmt::join(known, ", ")));
    }
}

study_plan plan(const study_request& request) {
    require_far_behaviour(*request.equation);
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, 1, "is not an order of an approximant");
    const auto all_digits = request.digits();
    const long digits = *std::ranges::max_element(all_digits);
    const scalar_spec scalar{scalar_kind::arbitrary, digits};
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "values", scalar, value_columns())}, sweep,
        [sweep, orders, digits](std::size_t i) { return tables_at(*sweep, i, orders, digits); });
}

}  // namespace
}  // namespace of_equation
}  // namespace approximants_study

const study& approximants() {
    using namespace approximants_study;
    static const study result{
        .name = "approximants",
        .title = "Asymptotic approximants",
        .question = "Do asymptotic approximants converge, and how many digits are lost on the way to them?",
        .reading =
            "Solid: the largest error of the asymptotic approximant from the start to where the solution has become "
            "its far behaviour, against the order N of the series; dashed the series itself, dash-dotted its Pade "
            "approximants, dotted what the form of the approximant predicts. The sums of exponentials are polynomials "
            "in z = 1 - e^(-a t): they converge geometrically where what they stand for is analytic in |z| < rho with "
            "rho > 1, as for sakiadis and sir, and they do not for sir_japan, where rho < 1: its error is least, {{min "
            "norm of approximants where problem=sir_japan method=asymptotic to 2}}, at a moderate N. The published "
            "Vandermonde system takes {{the lost_digits of approximants_digits where problem=sir terms=21 to 2}} of "
            "the 16 digits of double at 21 terms of sir and {{the lost_digits of approximants_digits where problem=sir "
            "terms=81 to 2}} at 81; in powers of z nothing is lost. The approximants of Blasius and of Falkner and "
            "Skan do not converge on the whole axis either: for blasius the least error, {{min norm of approximants "
            "where problem=blasius method=asymptotic to 2}}, belongs to a moderate N, and beyond it the error goes to "
            "the distance of the solution from its far behaviour at the radius of convergence of the bracket, {{max "
            "predicted of approximants where problem=blasius to 2}}. For the collapse of a bubble the branch point "
            "takes the error from N^-(2/5) to N^-(8/5). The damped Pade approximants of seir and flierl_petviashvili "
            "converge here, not evenly, and nothing is predicted of them. The table of published numbers says of each "
            "whether it holds.",
        .of = &of_catalogue::problems_of_study(),
        .parameters = {{"--problems", "blasius,falkner_skan,flierl_petviashvili,rayleigh,sakiadis,seir,sir,sir_japan",
                        "problems of the catalogue"},
                       {"--orders", "4:60:15,80:200:7", "N, last power of the series"},
                       {"--digits", "24", "digits of the solution; the largest of a list"}},
        .quick = {{"--problems", "rayleigh,sir", ""}, {"--orders", "4,10,20", ""}, {"--digits", "12", ""}},
        .seconds = 16,
        .plan = of_catalogue::plan,
        .version = 2,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .title = "Asymptotic approximants over parameters",
            .question = "How large is the error of the asymptotic approximants of a problem over its parameters?",
            .reading = "The largest error from the start to where the solution has become its far behaviour, against "
                       "the order N of the series: of the asymptotic approximant, one curve for each value of the "
                       "parameters; beside it, the error at the largest N against a parameter, with that of the Pade "
                       "approximants and of the series. A free start, as the wall shear of Falkner and Skan, is the "
                       "one that meets the condition at infinity: the second table has it.",
            .parameters = {{"--orders", "4:60:15", "N, last power of the series"},
                           {"--digits", "20", "digits of the solution; the largest of a list"}},
            .example = {"falkner_skan", {"b=0,1/2,1"}},
            .quick = {{"--orders", "4,10"}, {"--digits", "10"}},
            .seconds = 10}};
    return result;
}

}  // namespace libration::studies
