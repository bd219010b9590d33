// What accuracy does each arithmetic reach before its rounding exceeds the error of the series? [paper fig:error]
#include <algorithm>
#include <utility>

#include "libration/pendulum/coefficient_route.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "shared/norms_on_interval.hpp"
#include "shared/radius_on_interval.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace precision_floor_study {

namespace {

constexpr long printed_digits = 12;

// One norm in one arithmetic.
struct floor_row {
    int order;
    std::string method;
    const scalar_spec& scalar;
    mpfr norm;
    std::optional<mpfr> exact_norm;
    mpfr epsilon;
    const sweep_energy* at;       // for the pendulum
    std::string recurrence = {};  // for the pendulum
    std::string unknown = {};     // for another equation
};

const column_list<floor_row>& columns() {
    using row = floor_row;
    const auto number = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, printed_digits); };
    };
    static const column_list<row> all{
        energy_column<row>(),
        {"order", "N, last power of the series", [](const row& r) { return r.order; }},
        {"method", "series | pade: [m/m] with 2 m <= N, without the powers that a symmetry leaves out",
         [](const row& r) { return r.method; }},
        {"scalar", "arithmetic of coefficients and evaluation; mpfr without guard digits",
         [](const row& r) { return r.scalar.name(); }},
        {"norm", "max of |approximation - solution| over the times, in the unit of the unknown", number(&row::norm)},
        {"exact_norm", "the same without rounding",
         [](const row& r) { return decimal_cell(r.exact_norm, printed_digits); }},
        {"norm_in_epsilon", "norm/epsilon", [](const row& r) { return decimal_cell(mpfr(r.norm / r.epsilon), 6); }},
        {"epsilon", "unit in the last place of 1 times the largest value of the unknown at the times",
         number(&row::epsilon)},
        {"floor", "yes where rounding is more than half of norm",
         [](const row& r) { return !r.exact_norm || *r.exact_norm * 2 < r.norm ? "yes" : "no"; }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        {"log10_exact_norm", "log10 of exact_norm", [](const row& r) { return log10_cell(r.exact_norm); }},
        {"log10_epsilon", "log10 of epsilon", [](const row& r) { return log10_cell(r.epsilon); }},
        gap_column<row>(),
        unknown_column<row>(),
        {"recurrence",
         "printed (pendseries) | squares (cos theta and omega) | omega | lattice (sums over singularities)",
         [](const row& r) { return r.recurrence; }},
    };
    return all;
}

// The unit in the last place of 1, as a number that outlives the scope of the scalar.
mpfr epsilon_of(const scalar_spec& scalar) {
    return with_scalar(scalar, 0, []<class T>() { return widen(epsilon<T>()); });
}

}  // namespace

namespace of_pendulum {

using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// Above this order the exact norm is left out where the proved bound of the error is far below every arithmetic: it
// would take thousands of digits, and only the floor is requested.
constexpr int highest_exact_order = 500;

const column_list<floor_row>& own_columns() {
    static const auto all = joined<floor_row>(
        with_typed_energy(columns_named(
            "energy,order,method,scalar,norm,exact_norm,norm_in_epsilon,epsilon,floor,log10_norm,log10_exact_norm,"
            "log10_epsilon,gap",
            with_meanings(
                columns(),
                {{"order", "N, last power of the series; last index of the resummed series"},
                 {"method", "series | resummed"},
                 {"norm",
                  "max of |approximation - theta| over 1001 points of [0, T*] and the place of exact_norm, radians"},
                 {"exact_norm",
                  "the same in exact arithmetic, as a true maximum, radians; empty where its bound is far below "
                  "epsilon"},
                 {"norm_in_epsilon", "norm over the unit in the last place of 1"},
                 {"epsilon", "unit in the last place of 1"}}))),
        columns_named("recurrence", columns()));
    return all;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (request.scalar) {
        return {*request.scalar};
    }
    return {read_scalar("double"), read_scalar("long-double"), read_scalar("quad"), read_scalar("mpfr:40")};
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

// The same with coefficients by a chosen recurrence, or without an exact norm: at all points of the grid and at `place`.
mpfr norm_by(coefficient_route route, const scalar_spec& scalar, arc_errors& errors, arc_method method, int order,
             const motion& m, const mpfr& place) {
    const long wide_digits = working_digits();
    return with_scalar(scalar, 0, [&]<class T>() {
        // A fixed scalar does not depend on the precision, in which its coefficients by lattice are computed.
        const auto in_scalar = [&](const auto& make) {
            const precision_scope scope(fixed_scalar<T> ? wide_digits : scalar.digits);
            return make();
        };
        const auto arc = in_scalar([&] { return arc_of<T>(m); });
        const auto a = in_scalar([&] { return arc_series_by(route, arc, order); });
        const T rounded_place = in_scalar([&] { return narrow<T>(place); });
        const auto largest = [&](const auto& approximation) {
            const auto value = [&](const T& x) {
                return in_scalar([&] { return widen(T(approximation.value(narrow<T>(widen(x))))); });
            };
            const precision_scope wide(wide_digits);
            return errors.rounded_norm(value, rounded_place).norm;
        };
        return method == arc_method::series ? largest(truncated_series<T>(a, T(1)))
                                            : largest(endpoint_approximant<T>(a, arc_endpoint(arc)));
    });
}

// A norm to be measured, with the exact one where that is affordable.
struct asked_floor {
    int order;
    arc_method method;
    bool floor_alone;
};

std::vector<asked_floor> floors_of(const motion& m, const std::vector<int>& orders, const mpfr& least_epsilon) {
    const precision_scope scope(20);
    const auto bounds = top_bounds<mpfr>::of(energy_level_of<mpfr>(m));
    std::vector<asked_floor> all;
    for (const int order : orders) {
        for (const auto method : {arc_method::series, arc_method::resummed}) {
            const mpfr bound = order <= highest_exact_order   ? mpfr(1)
                               : method == arc_method::series ? bounds.series_norm(order)
                                                              : bounds.resummation_norm(order);
            all.push_back({order, method, bound < least_epsilon / 1000});
        }
    }
    return all;
}

coefficient_route usual_route(const scalar_spec& scalar) {
    return scalar.kind == scalar_kind::arbitrary ? coefficient_route::lattice : coefficient_route::squares;
}

table rows_at(const sweep_energy& at, const std::vector<int>& orders, const std::vector<scalar_spec>& scalars,
              const std::vector<coefficient_route>& chosen) {
    const motion m = motion::of_energy(at.value);
    long digits = 0;
    mpfr least_epsilon(1);
    for (const scalar_spec& scalar : scalars) {
        digits = std::max(digits, scalar.digits);
        least_epsilon = std::min(least_epsilon, epsilon_of(scalar));
    }
    const auto asked = floors_of(m, orders, least_epsilon);
    int highest = 0;
    for (const asked_floor& each : asked) {
        highest = each.floor_alone ? highest : std::max(highest, each.order);
    }
    // Floors and exact norms have their printed digits correct, and the location of a norm, where theta is flat to the
    // digits below it, all digits of the scalar.
    const precision_scope scope(digits + digits_below(m, highest) + guard_digits);
    arc_errors errors(m);
    std::vector<floor_row> rows;
    for (const asked_floor& each : asked) {
        const auto exact = each.floor_alone ? std::nullopt : std::optional(errors.norm(each.method, each.order));
        const auto add = [&](const scalar_spec& scalar, coefficient_route route, const mpfr& norm) {
            rows.push_back({each.order, std::string(name_of(each.method)), scalar, norm,
                            exact ? std::optional(exact->norm) : std::nullopt, epsilon_of(scalar), &at,
                            name_of(route)});
        };
        const mpfr place = exact ? exact->place : mpfr(1);
        for (const scalar_spec& scalar : scalars) {
            const auto norm_of = [&](coefficient_route route) {
                return norm_by(route, scalar, errors, each.method, each.order, m, place);
            };
            if (chosen.empty()) {
                const coefficient_route usual = usual_route(scalar);
                add(scalar, usual, exact ? norm_in(scalar, errors, each.method, each.order, m, place) : norm_of(usual));
            }
            for (const coefficient_route route : chosen) {
                add(scalar, route, norm_of(route));
            }
        }
    }
    return make_table(own_columns(), rows);
}

study_plan plan(const study_request& request) {
    const auto scalars = scalars_of(request);
    std::vector<coefficient_route> routes;
    for (const exact& each : request.values.of("recurrence")) {
        routes.push_back(coefficient_route_named(each.text));
    }
    study_plan plan = plan_by_order({head_of("", scalars.back(), own_columns())}, sweep_of(request), request.orders(),
                                    [scalars, routes](const sweep_energy& at, const std::vector<int>& orders) {
                                        return std::vector<table>{rows_at(at, orders, scalars, routes)};
                                    });
    return plan;
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

const column_list<floor_row>& own_columns() {
    static const auto all = columns_named(
        "order,method,scalar,norm,exact_norm,epsilon,norm_in_epsilon,floor,log10_norm,log10_exact_norm,log10_epsilon,"
        "unknown",
        columns());
    return all;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (!request.scalar) {
        return {read_scalar("double"), read_scalar("long-double"), read_scalar("quad")};
    }
    if (request.scalar->kind == scalar_kind::arbitrary) {
        throw input_error("--scalar", request.scalar->name(), "has adjustable precision, so there is no floor",
                          "use double, long-double or quad");
    }
    return {*request.scalar};
}

// The rows of one order, in the order of the scalars.
void add_rows(std::vector<floor_row>& rows, agreed_norms& exact, const asked_norms& asked, int order,
              const std::vector<scalar_spec>& scalars, const equation_sweep& sweep) {
    const auto truth = exact.of_order(order);
    for (const scalar_spec& scalar : scalars) {
        const auto rounded = norms_of(asked, {order}, scalar);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const mpfr size = exact.size_of(truth[i].unknown);
            rows.push_back({order, name_of(truth[i].method), scalar, rounded[i].norm, truth[i].norm,
                            mpfr(epsilon_of(scalar) * size), nullptr, "", sweep.name_of(truth[i].unknown)});
        }
    }
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const auto times = times_of(request, 2);
    const auto scalars = scalars_of(request);
    const auto orders = orders_from(request, 0, "");
    return plan_by_numbers(
        {head_of(*sweep, "", scalars.back(), own_columns())}, sweep, "order", orders,
        [sweep, times, scalars](std::size_t i, const std::vector<int>& chosen) {
            const precision_scope scope(digits_of_truth);
            const auto system = sweep->system(i);
            const asked_norms asked{system, times, sweep->unknowns(), {approximation::series, approximation::pade}};
            agreed_norms exact(asked, *std::ranges::max_element(chosen), printed_digits + 3);
            std::vector<floor_row> rows;
            for (const int order : chosen) {
                add_rows(rows, exact, asked, order, scalars, *sweep);
            }
            return std::vector<table>{make_table(own_columns(), rows)};
        });
}

}  // namespace
}  // namespace of_equation
}  // namespace precision_floor_study

const study& precision_floor() {
    using namespace precision_floor_study;
    static const study result{
        .name = "precision_floor",
        .title = "Where rounding takes over",
        .question = "How small can the error of the series get in each arithmetic before rounding wins?",
        .reading =
            "The error norm against the order N, one panel an energy: dashed the series, solid its resummation, in "
            "double, long double, quad and mpfr of 40 digits without guard digits; thin dotted the norm in exact "
            "arithmetic, which is left out where its proved bound is far below all of them. The short lines at the "
            "right mark the epsilon of each arithmetic. Each curve follows the "
            "exact norm down to a few epsilon, stays there, and does not rise again: no order is too high. The farther "
            "the energy is from 2, the earlier the floor is reached; the resummation reaches it with fewer terms. The "
            "coefficients are by symmetric squares in the fixed arithmetics and by sums over the singularities in mpfr "
            "(column recurrence); --recurrence printed measures the floors of the paper's own recurrence in each.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1.71,1.9998,2.02,4", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders",
                        "2,5,10,15,20,30,40,50,60,80,100,120,150,200,250,300,400,600,800,1000,1300,1600,2000,2400,"
                        "2800,3200",
                        "N, last power of the series; last index of the resummed series"},
                       {"--scalar", "double, long-double, quad and mpfr:40", "arithmetic"},
                       {"--recurrence", "",
                        "recurrences of the coefficients: printed, squares, omega, lattice; default squares, in mpfr "
                        "lattice"}},
        .quick = {{"--energies", "1.71", ""}, {"--orders", "5,40", ""}},
        .seconds = 60,
        .excluded =
            no_answer_at_limits("the series is the constant 0", "the series is not defined: the period is infinite"),
        .plan = of_pendulum::plan,
        .any_equation =
            equation_form{.plan = of_equation::plan,
                          .reading = "The largest error at the times over the order N in double, long double and quad, "
                                     "of the series and of its Pade approximant; thin without rounding. The short "
                                     "lines at the right are the epsilon of each arithmetic times the size of the "
                                     "unknown. Each curve follows the norm without rounding down to its floor; how "
                                     "many epsilon that is, is the column norm_in_epsilon.",
                          .parameters = {required_times("the interval, as times at which the error is taken"),
                                         {"--orders", "4:100:25", "N, last power of the list"},
                                         {"--scalar", "double, long-double and quad", "arithmetic"}},
                          .example = {"blasius", {}},
                          .example_words = {{"--times", "0:2:21"}},
                          .quick = {{"--times", "0:2:3"}, {"--orders", "6,40"}},
                          .seconds = 2}};
    return result;
}

}  // namespace libration::studies
