// What can each arithmetic reach before its rounding is larger than the error of the series? [paper fig:error]
#include <algorithm>

#include "libration/pendulum/error/error_norm.hpp"
#include "sweep_columns.hpp"
#include "sweep_plan.hpp"

namespace libration::studies {

namespace precision_floor_study {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long printed_digits = 12;
constexpr long guard_digits = 15;

// One norm in one arithmetic.
struct floor_row {
    const sweep_energy& at;
    int order;
    arc_method method;
    const scalar_spec& scalar;
    mpfr norm;
    mpfr exact_norm;
    mpfr epsilon;
};

const column_list<floor_row>& columns() {
    using row = floor_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"order", "N, last power of the series; last index of the resummed series",
         [](const row& r) { return r.order; }},
        {"method", "series | resummed", [](const row& r) { return name_of(r.method); }},
        {"scalar", "arithmetic of coefficients and evaluation; mpfr without guard digits",
         [](const row& r) { return r.scalar.name(); }},
        {"norm", "max of |approximation - theta| over 1001 points of [0, T*] and the place of exact_norm, radians",
         [](const row& r) { return decimal_cell(r.norm, printed_digits); }},
        {"exact_norm", "the same in exact arithmetic, as a true maximum, radians",
         [](const row& r) { return decimal_cell(r.exact_norm, printed_digits); }},
        {"norm_in_epsilon", "norm over the unit in the last place of 1",
         [](const row& r) { return decimal_cell(mpfr(r.norm / r.epsilon), 6); }},
        {"epsilon", "unit in the last place of 1",
         [](const row& r) { return decimal_cell(r.epsilon, printed_digits); }},
        {"floor", "yes where rounding is more than half of norm",
         [](const row& r) { return r.exact_norm * 2 < r.norm ? "yes" : "no"; }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        {"log10_exact_norm", "log10 of exact_norm", [](const row& r) { return log10_cell(r.exact_norm); }},
        {"log10_epsilon", "log10 of epsilon", [](const row& r) { return log10_cell(r.epsilon); }},
        gap_column<row>(),
    });
    return all;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (request.scalar) {
        return {*request.scalar};
    }
    return {read_scalar("double"), read_scalar("long-double"), read_scalar("quad"), read_scalar("mpfr:40")};
}

// The unit in the last place of 1, as a number that outlives the scope of the scalar.
mpfr epsilon_of(const scalar_spec& scalar) {
    return with_scalar(scalar, 0, []<class T>() { return widen(epsilon<T>()); });
}

mpfr norm_in(const scalar_spec& scalar, arc_errors& errors, arc_method method, int order, const motion& m,
             const mpfr& place) {
    switch (scalar.kind) {
        case scalar_kind::binary64: return errors.norm_in<double>(method, order, m, place).norm;
        case scalar_kind::extended: return errors.norm_in<long double>(method, order, m, place).norm;
        case scalar_kind::binary128: return errors.norm_in<quad>(method, order, m, place).norm;
        default: return errors.norm_in_digits(scalar.digits, method, order, m, place).norm;
    }
}

table rows_at(const sweep_energy& at, const std::vector<int>& orders, const std::vector<scalar_spec>& scalars) {
    const motion m = motion::of_energy(at.value);
    long digits = 0;
    for (const scalar_spec& scalar : scalars) {
        digits = std::max(digits, scalar.digits);
    }
    const int highest = orders.empty() ? 0 : *std::max_element(orders.begin(), orders.end());
    // Floors and exact norms are to have their printed digits, and the place of a norm, where theta is flat to the
    // digits below it, all of the scalar's.
    const precision_scope scope(digits + digits_below(m, highest) + guard_digits);
    arc_errors errors(m);
    std::vector<floor_row> rows;
    rows.reserve(orders.size() * scalars.size() * 2);
    for (const int order : orders) {
        for (const auto method : {arc_method::series, arc_method::resummed}) {
            const norm_at<mpfr> exact = errors.norm(method, order);
            for (const scalar_spec& scalar : scalars) {
                const mpfr norm = norm_in(scalar, errors, method, order, m, exact.place);
                rows.push_back({at, order, method, scalar, norm, exact.norm, epsilon_of(scalar)});
            }
        }
    }
    return make_table(columns(), rows);
}

study_plan plan(const study_request& request) {
    const auto scalars = scalars_of(request);
    return plan_by_order({head_of("", scalars.back(), columns())}, sweep_of(request), request.orders(),
                         [scalars](const sweep_energy& at, const std::vector<int>& orders) {
                             return std::vector<table>{rows_at(at, orders, scalars)};
                         });
}

}  // namespace
}  // namespace precision_floor_study

const study& precision_floor() {
    using namespace precision_floor_study;
    static const study result{
        .name = "precision_floor",
        .title = "Where rounding takes over",
        .label = "",
        .question = "How small can the error of the series get in each arithmetic before rounding wins?",
        .reading =
            "The error norm against the order N, one panel an energy: dashed the series, solid its resummation, in "
            "double, long double, quad and mpfr of 40 digits without guard digits; thin dotted the norm in exact "
            "arithmetic. The short lines at the right mark the epsilon of each arithmetic. Each curve follows the "
            "exact norm down to a few epsilon, stays there, and does not rise again: no order is too high. The farther "
            "the energy is from 2, the earlier the floor is reached; the resummation reaches it with fewer terms.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1.71,1.9998,2.02,4", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "2,5,10,15,20,30,40,50,60,80,100,120,150,200,250,300",
                        "N, last power of the series; last index of the resummed series"},
                       {"--scalar", "double, long-double, quad and mpfr:40", "arithmetic"}},
        .quick = {{"--energies", "1.71", ""}, {"--orders", "5,40", ""}},
        .seconds = 2,
        .excluded =
            no_answer_at_limits("the series is the constant 0", "the series is not defined: the period is infinite"),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
