// What do the coefficients of the series and of its resummation cost, by each method? [paper sec:A1, sec:series]
#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/ode/taylor_expansion.hpp"
#include "libration/pendulum/arc/resummation.hpp"
#include "libration/pendulum/singularity/singularities.hpp"
#include "libration/pendulum/taylor/other_recurrences.hpp"
#include "libration/scalar/counted.hpp"
#include "shared/equation_plan.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace cost_study {

namespace of_pendulum {

using namespace series;
using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;
constexpr int runs = 9;
constexpr int least_order = 2;

enum class route {
    direct,
    direct_parity,
    symmetric_squares,
    speed,
    arcsine,
    arcsine_parity,
    convolution,
    running_sums,
    alpha_beta
};

struct named_route {
    route which;
    std::string name;
    bool resums = false;
};

const std::vector<named_route>& routes() {
    static const std::vector<named_route> all{{route::direct, "direct"},
                                              {route::direct_parity, "direct_parity"},
                                              {route::symmetric_squares, "symmetric_squares"},
                                              {route::speed, "speed"},
                                              {route::arcsine, "arcsine"},
                                              {route::arcsine_parity, "arcsine_parity"},
                                              {route::convolution, "convolution", true},
                                              {route::running_sums, "running_sums", true},
                                              {route::alpha_beta, "alpha_beta", true}};
    return all;
}

const std::string& meaning_of_routes() {
    static const std::string text =
        "of a_n: direct (pendseries), direct_parity (the same without half of the zeros), symmetric_squares (of cos "
        "theta and omega), speed (omega alone), arcsine (Jacobi function under the arcsine), arcsine_parity; from a_n "
        "to the resummation: convolution (approxcoeffs), running_sums, alpha_beta (efficient)";
    return text;
}

// The input of every route: the top with its symmetry, R, T*, and for the resummation a_n T*^n and both ends.
template <class T>
struct given {
    taylor_start<T> top;
    T radius;
    T height;  // K~'
    power_series<T> series;
    std::vector<T> endpoint;
};

given<mpfr> given_by(const motion& m, int order) {
    const auto arc = arc_of<mpfr>(m);
    const auto lattice = *singularities<mpfr>(m);
    const auto top = phase_map<mpfr>::at_quarter(exact_solution<mpfr>::top_quarter(m));
    return {arc.start(), lattice.radius(top), lattice.height, arc_series(arc, order), arc_endpoint(arc)};
}

// The same numbers in another arithmetic.
template <class T>
given<T> in(const given<mpfr>& exact) {
    const auto to = [](const mpfr& x) { return narrow<T>(x); };
    const auto& [state, pair, of_theta] = exact.top;
    std::vector<T> series;
    std::vector<T> endpoint;
    std::transform(exact.series.coefficients().begin(), exact.series.coefficients().end(), std::back_inserter(series),
                   to);
    std::transform(exact.endpoint.begin(), exact.endpoint.end(), std::back_inserter(endpoint), to);
    return {{{to(state.theta), to(state.omega), to(state.half_sine), to(state.half_cosine)},
             {to(pair.energy), to(pair.gap)},
             of_theta},
            to(exact.radius),
            to(exact.height),
            power_series<T>(std::move(series)),
            std::move(endpoint)};
}

template <class T>
power_series<T> by(route which, const given<T>& from, int order) {
    taylor_start<T> blind = from.top;
    blind.of_theta = parity::any;
    switch (which) {
        case route::direct: return taylor_by_sine_cosine(blind, order, from.radius);
        case route::direct_parity: return taylor_by_sine_cosine(from.top, order, from.radius);
        case route::symmetric_squares: return taylor_by_symmetric_squares(from.top, order, from.radius);
        case route::speed: return taylor_by_speed(from.top, order, from.radius);
        case route::arcsine: return taylor_by_arcsine(blind, order, from.radius);
        case route::arcsine_parity: return taylor_by_arcsine(from.top, order, from.radius);
        case route::convolution: return inner_series_by_convolution(from.series, from.endpoint);
        case route::running_sums: return inner_series(from.series, from.endpoint);
        default: return endpoint_corrected(from.series, from.endpoint);
    }
}

// The reason why a route does not exist here.
std::optional<std::string> refusal(route which, const given<mpfr>& from) {
    try {
        by(which, from, 2);
    } catch (const error& problem) {
        return problem.what();
    }
    return std::nullopt;
}

// The coefficients of (1-x)^2 h plus the two at the end: the polynomial that alpha and beta give directly.
power_series<mpfr> as_polynomial(const power_series<mpfr>& inner, const std::vector<mpfr>& endpoint) {
    auto result = power_series<mpfr>::zero(inner.order() + 2);
    for (int n = 0; n <= inner.order(); ++n) {
        result[n] += inner[n];
        result[n + 1] -= inner[n] * 2;
        result[n + 2] += inner[n];
    }
    const auto straight = expand_at_zero(endpoint);
    result[0] += straight[0];
    result[1] += straight[1];
    return result;
}

// The expected results of the routes; computed in the precision in force, before that of the routes is set.
struct expected_results {
    power_series<mpfr> coefficients;
    power_series<mpfr> inner;
    power_series<mpfr> polynomial;

    const power_series<mpfr>& of(const named_route& r) const {
        return !r.resums ? coefficients : r.which == route::alpha_beta ? polynomial : inner;
    }
};

expected_results expected_of(const given<mpfr>& exact, int order) {
    auto inner = by(route::running_sums, exact, order);
    auto polynomial = as_polynomial(inner, exact.endpoint);
    return {by(route::symmetric_squares, exact, order), std::move(inner), std::move(polynomial)};
}

// The largest |found_n - expected_n|, for the resummation relative to the largest |expected_n|.
template <class T>
cell difference_cell(const named_route& r, const power_series<T>& found, const power_series<mpfr>& expected) {
    mpfr largest(0);
    mpfr scale(r.resums ? 0 : 1);
    for (int n = 0; n <= expected.order(); ++n) {
        largest = std::max(largest, mpfr(abs(widen(found[n]) - expected[n])));
        scale = r.resums ? std::max(scale, mpfr(abs(expected[n]))) : scale;
    }
    return largest == 0 ? number_cell("-inf") : decimal_cell(mpfr(log10(mpfr(largest / scale))), 4);
}

// The median time of `runs` runs, each of enough repetitions to take longer than the clock's resolution.
template <class T>
double seconds_of(route which, const given<T>& from, int order) {
    using clock = std::chrono::steady_clock;
    const int repetitions = 1 + 20'000 / (order * order + 1);
    std::vector<double> times(runs);
    for (double& time : times) {
        const auto start = clock::now();
        for (int i = 0; i < repetitions; ++i) {
            by(which, from, order);
        }
        time = std::chrono::duration<double>(clock::now() - start).count() / repetitions;
    }
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[runs / 2];
}

template <class Number>
cell ratio_cell(const Number& value, const Number& unit) {
    return decimal_cell(mpfr(mpfr(value) / mpfr(unit)), 4);
}

// The operation counts and the accuracy of a route; the reason if it does not exist.
struct count_row {
    const sweep_energy& at;
    int order;
    const named_route& of;
    std::optional<operation_count> count;
    long direct_products;
    cell difference;
    cell growth;
    std::string note;
};

template <class Of>
std::function<cell(const count_row&)> counted_cell(const Of& of) {
    return [of](const count_row& r) { return r.count ? cell(of(*r.count)) : cell(); };
}

const column_list<count_row>& columns() {
    using row = count_row;
    static const auto all = with_typed_energy<row>({
        {"route", meaning_of_routes(), [](const row& r) { return r.of.name; }},
        {"order", "N, last power of the series; last index of the resummed series",
         [](const row& r) { return r.order; }},
        energy_column<row>(),
        {"multiplications", "of two numbers of the arithmetic",
         counted_cell([](const operation_count& c) { return c.multiplications; })},
        {"nonzero_multiplications", "those where neither factor is 0; empty where rounding decides that",
         [](const row& r) {
             const bool structural_zeros = r.count && r.of.which != route::alpha_beta;
             return structural_zeros ? cell(r.count->multiplications - r.count->by_zero) : cell();
         }},
        {"divisions", "of two numbers of the arithmetic",
         counted_cell([](const operation_count& c) { return c.divisions; })},
        {"additions", "and subtractions", counted_cell([](const operation_count& c) { return c.additions; })},
        {"by_integers", "operations of a number with a small integer",
         counted_cell([](const operation_count& c) { return c.by_integers; })},
        {"ratio", "multiplications in units of those of the route direct",
         [](const row& r) { return r.count ? ratio_cell(r.count->multiplications, r.direct_products) : cell(); }},
        {"log10_difference",
         "log10 of the largest difference from the same coefficients by symmetric squares and running "
         "sums with 30 digits more: of a_n R^n, or of the resummation relative to its largest coefficient",
         [](const row& r) { return r.difference; }},
        {"expected_growth", "log10 of (R/K~')^N, by which the arcsine's quotient 0/0 at i K~' makes rounding grow",
         [](const row& r) { return r.growth; }},
        {"note", "why a route does not exist", [](const row& r) { return r.note; }},
    });
    return all;
}

struct time_row {
    const sweep_energy& at;
    int order;
    const named_route& of;
    double seconds;
    double direct_seconds;
};

const column_list<time_row>& time_columns() {
    using row = time_row;
    static const auto all = with_typed_energy<row>({
        {"route", meaning_of_routes(), [](const row& r) { return r.of.name; }},
        {"order", "N, last power of the series; last index of the resummed series",
         [](const row& r) { return r.order; }},
        energy_column<row>(),
        {"seconds", "median of nine runs on this machine, one thread, s",
         [](const row& r) { return decimal_cell(r.seconds, 4); }},
        {"ratio", "in units of the route direct", [](const row& r) { return ratio_cell(r.seconds, r.direct_seconds); }},
    });
    return all;
}

cell growth_cell(const named_route& r, const given<mpfr>& exact, int order) {
    const bool unstable = r.which == route::arcsine || r.which == route::arcsine_parity;
    return unstable ? decimal_cell(mpfr(log10(exact.radius / exact.height) * order), 4) : cell();
}

// Both tables of one energy and order.
std::vector<table> tables_at(const sweep_energy& at, int order, const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + 2 * guard_digits + 30);
    const given<mpfr> exact = given_by(motion::of_energy(at.value), order);
    const given<counted> tally = in<counted>(exact);
    const expected_results expected = expected_of(exact, order);
    std::vector<count_row> counts;
    std::vector<time_row> times;
    with_scalar(scalar, guard_digits, [&]<class T>() {
        energies<T>(motion::of_energy(at.value));  // throws for what T cannot represent
        const given<T> own = in<T>(exact);
        const auto operations = [&](route which) { return count_operations([&] { by(which, tally, order); }); };
        const long direct_products = operations(route::direct).multiplications;
        const double direct_seconds = seconds_of(route::direct, own, order);
        for (const named_route& r : routes()) {
            if (const auto reason = refusal(r.which, exact)) {
                counts.push_back({at, order, r, std::nullopt, direct_products, {}, {}, *reason});
                continue;
            }
            const double seconds = r.which == route::direct ? direct_seconds : seconds_of(r.which, own, order);
            times.push_back({at, order, r, seconds, direct_seconds});
            counts.push_back({at, order, r, operations(r.which), direct_products,
                              difference_cell(r, by(r.which, own, order), expected.of(r)), growth_cell(r, exact, order),
                              ""});
        }
    });
    return {make_table(columns(), counts), make_table(time_columns(), times)};
}

// One step after the other, whatever the number of jobs: concurrent runs would disturb the timings.
study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const auto orders = request.orders();
    orders_from(request, least_order, "leaves no recurrence to count");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:50"));
    study_table times = head_of("time", scalar, time_columns());
    times.timed = true;
    return plan_of_cells(
        {head_of("", scalar, columns()), std::move(times)}, {"energy", "gap", "order"},
        sweep->energies.size() * orders.size(),
        [sweep, orders](std::size_t i) {
            return with_input(inputs_of(sweep->energies[i / orders.size()]), "order",
                              std::to_string(orders[i % orders.size()]));
        },
        [sweep, orders, scalar](std::size_t i) {
            return tables_at(sweep->energies[i / orders.size()], orders[i % orders.size()], scalar);
        });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

constexpr int runs = 5;
constexpr int least_order = 2;
constexpr long digits_of_ratios = 4;

// The tape with and without the zeros of a symmetry.
enum class route { start, point };

std::string text_of(route which) { return which == route::start ? "start" : "point"; }

const std::string& meaning_of_routes() {
    static const std::string text =
        "start: about the start, where zeros of a symmetry are left out | point: the same as about any other point; "
        "only where the start is not singular";
    return text;
}

struct count_row {
    route which;
    int order;
    operation_count count;
    std::size_t steps;
};

const column_list<count_row>& columns() {
    using row = count_row;
    static const column_list<row> all{
        {"order", "N, last power of the series of all unknowns", [](const row& r) { return r.order; }},
        {"route", meaning_of_routes(), [](const row& r) { return text_of(r.which); }},
        {"multiplications", "of two numbers of the arithmetic", [](const row& r) { return r.count.multiplications; }},
        {"nonzero_multiplications", "those where neither factor is 0",
         [](const row& r) { return r.count.multiplications - r.count.by_zero; }},
        {"divisions", "of two numbers of the arithmetic", [](const row& r) { return r.count.divisions; }},
        {"additions", "and subtractions", [](const row& r) { return r.count.additions; }},
        {"by_integers", "operations of a number with a small integer",
         [](const row& r) { return r.count.by_integers; }},
        {"steps", "operations of the tape that the equations became", [](const row& r) { return r.steps; }},
        {"unknown", "all: the coefficients of one need those of the others", [](const row&) { return "all"; }},
    };
    return all;
}

struct time_row {
    route which;
    int order;
    std::string scalar;
    double seconds;
};

const column_list<time_row>& time_columns() {
    using row = time_row;
    static const column_list<row> all{
        {"order", "N, last power of the series of all unknowns", [](const row& r) { return r.order; }},
        {"route", meaning_of_routes(), [](const row& r) { return text_of(r.which); }},
        {"scalar", "arithmetic", [](const row& r) { return r.scalar; }},
        {"seconds", "median of five runs on this machine, one thread, s",
         [](const row& r) { return decimal_cell(r.seconds, digits_of_ratios); }},
        {"log10_seconds", "log10 of it", [](const row& r) { return log10_cell(r.seconds); }},
        {"unknown", "all: the coefficients of one need those of the others", [](const row&) { return "all"; }},
    };
    return all;
}

operation_count counted_run(const ode::tape& tape, int order) {
    ode::taylor_expansion<counted> expansion(tape, order);
    return count_operations([&] { expansion.about_start(); });
}

template <scalar T>
double seconds_of(const ode::tape& tape, int order) {
    using clock = std::chrono::steady_clock;
    ode::taylor_expansion<T> expansion(tape, order);
    const int repetitions = 1 + 20'000 / (order * order + 1);
    std::vector<double> times(runs);
    for (double& time : times) {
        const auto start = clock::now();
        for (int i = 0; i < repetitions; ++i) {
            expansion.about_start();
        }
        time = std::chrono::duration<double>(clock::now() - start).count() / repetitions;
    }
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[runs / 2];
}

std::vector<table> tables_at(const ode::explicit_system& system, int order, const std::vector<scalar_spec>& scalars) {
    std::map<route, ode::tape> tapes;
    tapes.emplace(route::start, ode::tape::about_start(system));
    if (!system.singular()) {
        tapes.emplace(route::point, ode::tape::about_points(system));
    }
    std::vector<count_row> counts;
    std::vector<time_row> times;
    for (const auto& [which, tape] : tapes) {
        counts.push_back({which, order, counted_run(tape, order), tape.steps().size()});
        for (const scalar_spec& scalar : scalars) {
            const double seconds =
                with_scalar(scalar, 0, [&t = tape, order]<class T>() { return seconds_of<T>(t, order); });
            times.push_back({which, order, scalar.name(), seconds});
        }
    }
    return {make_table(columns(), counts), make_table(time_columns(), times)};
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, least_order, "leaves no recurrence to count");
    const std::vector<scalar_spec> scalars =
        request.scalar ? std::vector<scalar_spec>{*request.scalar}
                       : std::vector<scalar_spec>{read_scalar("double"), read_scalar("mpfr:50")};
    study_table times = head_of(*sweep, "time", scalars.back(), time_columns());
    times.timed = true;
    return plan_of_cells(
        {head_of(*sweep, "", read_scalar("double"), columns()), std::move(times)}, sweep->axes({"order"}),
        sweep->size() * orders.size(),
        [sweep, orders](std::size_t i) {
            return with_input(sweep->inputs(i / orders.size()), "order", std::to_string(orders[i % orders.size()]));
        },
        [sweep, orders, scalars](std::size_t i) {
            const std::size_t at = i / orders.size();
            return sweep->framed(at, tables_at(sweep->system(at), orders[i % orders.size()], scalars));
        });
}

}  // namespace
}  // namespace of_equation

namespace {

study_plan plan(const study_request& request) {
    return request.equation ? of_equation::plan(request) : of_pendulum::plan(request);
}

}  // namespace
}  // namespace cost_study

const study& cost() {
    using namespace cost_study;
    static const study result{
        .name = "cost",
        .title = "What the coefficients cost",
        .label = "",
        .question =
            "How many multiplications and how much time do the coefficients of the series and of its resummation cost, "
            "by each way to them?",
        .reading =
            "Left: multiplications of two numbers for all coefficients up to N; thin lines are the theory, N^2 times a "
            "constant. Right: time relative to the recursion (pendseries) as printed. An arcsine of the Jacobi "
            "function costs 1.5 times the direct recursion, as the paper says it costs more; but it does not exist at "
            "the top of rotation, and it is unstable: the second figure shows how its rounding errors grow by R/K~' a "
            "power. What the paper does not say: omega is a Jacobi function itself, and needs no arcsine and 5.3 times "
            "fewer products than the direct recursion, as does the recurrence of symmetric squares (4 of that is "
            "parity, which the direct one multiplies out as zeros). From a_n to the resummation the convolution is the "
            "second quadratic step of the paper, with half as many products as the first; its appendix (alpha, beta) "
            "needs three. Running sums give the resummed coefficients themselves without any product.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "20,40,80,160,320,640",
                        "N, last power of the series; last index of the resummed series"},
                       {"--scalar", "mpfr:50", "arithmetic that is timed"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "10", ""}},
        .seconds = 1.5,
        .excluded =
            no_answer_at_limits("the series from the top is the constant 0", "the series from the top is not defined"),
        .plan = plan,
        .alone = true,
        .any_equation = equation_form{
            .question = "How many operations and how much time do the coefficients of all unknowns cost?",
            .reading =
                "Left: multiplications of two numbers for the coefficients of all unknowns up to N; every product and "
                "every function of the equations costs N^2/2 of them, and a symmetry of the start divides that by its "
                "square. Right: the time of it on the machine that made this page.",
            .parameters = {{"--orders", "10,20,40,80,160,320", "N, last power of the series"},
                           {"--scalar", "double and mpfr:50", "arithmetic of the times"}},
            .example = {"lorenz", {}},
            .quick = {{"--orders", "10,20"}},
            .seconds = 2}};
    return result;
}

}  // namespace libration::studies
