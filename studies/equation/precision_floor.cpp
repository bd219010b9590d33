// What can each arithmetic reach on any equation before its rounding is larger than the error of the series?
#include <algorithm>
#include <utility>

#include "norms_on_interval.hpp"
#include "radius_on_interval.hpp"

namespace libration::studies::of_equation {

namespace precision_floor_of_equation {

namespace {

constexpr long printed_digits = 12;

struct floor_row {
    int order;
    approximation method;
    const scalar_spec& scalar;
    mpfr norm, exact_norm, epsilon, size;
    std::string unknown;
};

const column_list<floor_row>& columns() {
    using row = floor_row;
    const auto number = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, printed_digits); };
    };
    static const column_list<row> all{
        {"order", "N, last power of the series about the start", [](const row& r) { return r.order; }},
        {"method", "series | pade: [m/m] with 2 m <= N, without the powers that a symmetry leaves out",
         [](const row& r) { return name_of(r.method); }},
        {"scalar", "arithmetic of coefficients and evaluation", [](const row& r) { return r.scalar.name(); }},
        {"norm", "max of |approximation - solution| over the times, in the unit of the unknown", number(&row::norm)},
        {"exact_norm", "the same without rounding", number(&row::exact_norm)},
        {"epsilon", "unit in the last place of 1 times the largest value of the unknown at the times",
         number(&row::epsilon)},
        {"norm_in_epsilon", "norm/epsilon", [](const row& r) { return decimal_cell(mpfr(r.norm / r.epsilon), 6); }},
        {"floor", "yes where rounding is more than half of norm",
         [](const row& r) { return r.exact_norm * 2 < r.norm ? "yes" : "no"; }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        {"log10_exact_norm", "log10 of exact_norm", [](const row& r) { return log10_cell(r.exact_norm); }},
        {"log10_epsilon", "log10 of epsilon", [](const row& r) { return log10_cell(r.epsilon); }},
        unknown_column<row>(),
    };
    return all;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (!request.scalar) {
        return {read_scalar("double"), read_scalar("long-double"), read_scalar("quad")};
    }
    if (request.scalar->kind == scalar_kind::arbitrary) {
        throw input_error("--scalar", request.scalar->name(), "rounds as its digits are chosen: there is no floor",
                          "use double, long-double or quad");
    }
    return {*request.scalar};
}

mpfr epsilon_of(const scalar_spec& scalar) {
    return with_scalar(scalar, 0, []<class T>() { return widen(epsilon<T>()); });
}

// The rows of one order, in the order of the scalars.
void add_rows(std::vector<floor_row>& rows, agreed_norms& exact, const asked_norms& asked, int order,
              const std::vector<scalar_spec>& scalars, const equation_sweep& sweep) {
    const auto truth = exact.of_order(order);
    for (const scalar_spec& scalar : scalars) {
        const auto rounded = norms_of(asked, {order}, scalar);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const mpfr size = exact.size_of(truth[i].unknown);
            rows.push_back({order, truth[i].method, scalar, rounded[i].norm, truth[i].norm,
                            mpfr(epsilon_of(scalar) * size), size, sweep.name_of(truth[i].unknown)});
        }
    }
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto times = times_of(request, 2);
    const auto scalars = scalars_of(request);
    const auto orders = orders_from(request, 0, "");
    return plan_by_numbers(
        {head_of(*sweep, "", scalars.back(), columns())}, sweep, "order", orders,
        [sweep, times, scalars](std::size_t i, const std::vector<int>& chosen) {
            const precision_scope scope(digits_of_truth);
            const auto system = sweep->system(i);
            const asked_norms asked{system, times, sweep->unknowns(), {approximation::series, approximation::pade}};
            agreed_norms exact(asked, *std::ranges::max_element(chosen), printed_digits + 3);
            std::vector<floor_row> rows;
            for (const int order : chosen) {
                add_rows(rows, exact, asked, order, scalars, *sweep);
            }
            return std::vector<table>{make_table(columns(), rows)};
        });
}

}  // namespace
}  // namespace precision_floor_of_equation

const equation_study& precision_floor() {
    using namespace precision_floor_of_equation;
    static const equation_study result{
        .name = "precision_floor",
        .title = "Where rounding takes over",
        .question = "How small can the error of the series get in each arithmetic before rounding wins?",
        .reading =
            "The largest error at the times over the order N in double, long double and quad, of the series and of its "
            "Pade approximant; thin without rounding. The short lines at the right are the epsilon of each arithmetic "
            "times the size of the unknown. Each curve follows the norm without rounding down to its floor; how many "
            "epsilon that is, is the column norm_in_epsilon.",
        .parameters = {{"--times", "", "the interval, as times at which the error is taken"},
                       {"--orders", "4:100:25", "N, last power of the list"},
                       {"--scalar", "double, long-double and quad", "arithmetic"}},
        .example = {"blasius", {}},
        .example_words = {{"--times", "0:2:21"}},
        .quick = {{"--times", "0:2:3"}, {"--orders", "6,40"}},
        .seconds = 2,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
