// How good are the asymptotic approximants of a problem over its parameters?
#include <map>

#include "approximant_norms.hpp"
#include "equation_plan.hpp"
#include "libration/ode/parse.hpp"
#include "text/input_error.hpp"

namespace libration::studies::of_equation {

namespace approximants_of_equation {

using namespace approximant_norms;

namespace {

const column_list<norm_row>& columns() {
    using row = norm_row;
    static const column_list<row> all = joined(columns_of_norms(), {unknown_column<row>()});
    return all;
}

// A number that belongs to the far behaviour.
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

// Falkner and Skan's first guess of the wall shear belongs to one b: from there in steps, each the guess of the next.
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
        std::string names;
        for (const std::string& each : known) {
            names += (names.empty() ? "" : ", ") + each;
        }
        throw input_error("--problem", of.said, "has no known far behaviour", "choose one of " + names);
    }
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    require_far_behaviour(*problem);
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, 1, "is no order of an approximant");
    const auto all_digits = request.digits();
    const long digits = *std::ranges::max_element(all_digits);
    const scalar_spec scalar{scalar_kind::arbitrary, digits};
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "values", scalar, value_columns())}, sweep,
        [sweep, orders, digits](std::size_t i) { return tables_at(*sweep, i, orders, digits); });
}

}  // namespace
}  // namespace approximants_of_equation

const equation_study& approximants() {
    using namespace approximants_of_equation;
    static const equation_study result{
        .name = "approximants",
        .title = "Asymptotic approximants over parameters",
        .question = "How large is the error of the asymptotic approximants of a problem over its parameters?",
        .reading =
            "The largest error from the start to where the solution has become its far behaviour, against the order N "
            "of the series: of the asymptotic approximant, one curve for each value of the parameters; beside it, the "
            "least error over all N against a parameter, with that of the Pade approximants and of the series. A free "
            "start, as the wall shear of Falkner and Skan, is the one that meets the condition at infinity: the second "
            "table has it.",
        .parameters = {{"--orders", "4:60:15", "N, last power of the series"},
                       {"--digits", "20", "digits of the solution; of a list the largest"}},
        .example = {"falkner_skan", {"b=0,1/2,1"}},
        .example_words = {},
        .quick = {{"--orders", "4,10"}, {"--digits", "10"}},
        .seconds = 10,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
