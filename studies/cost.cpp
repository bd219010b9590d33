// What do the coefficients of the series and of its resummation cost, by each method? [paper sec:A1, sec:series]
#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>

#include "coefficient_routes.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/counted.hpp"
#include "shared/equation_plan.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace cost_study {

namespace {

constexpr int least_order = 2;
constexpr long digits_of_ratios = 4;

const std::string& meaning_of_routes() {
    static const std::string text =
        "of a_n: direct (pendseries), direct_parity (the same without half of the zeros), symmetric_squares (of cos "
        "theta and omega), speed (omega alone), arcsine (Jacobi function under the arcsine), arcsine_parity; from a_n "
        "to the resummation: convolution (approxcoeffs), running_sums, alpha_beta (efficient)";
    return text;
}

// The processor time of this thread, on which other work of the machine has least influence.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The least processor time of several runs, each of enough repetitions to take longer than the clock's resolution.
template <class Work>
double seconds_of(int runs, int order, const Work& work) {
    const int repetitions = 1 + 20'000 / (order * order + 1);
    double least = 0;
    for (int run = 0; run < runs; ++run) {
        const double start = processor_seconds();
        for (int i = 0; i < repetitions; ++i) {
            work();
        }
        const double time = (processor_seconds() - start) / repetitions;
        least = run == 0 ? time : std::min(least, time);
    }
    return least;
}

template <class Number>
cell ratio_cell(const Number& value, const Number& unit) {
    return decimal_cell(mpfr(mpfr(value) / mpfr(unit)), digits_of_ratios);
}

template <class Row>
column_list<Row> columns_of_routes() {
    return {energy_column<Row>(),
            {"route", meaning_of_routes(), [](const Row& r) { return r.route; }},
            {"order", "N, last power of the series; last index of the resummed series",
             [](const Row& r) { return r.order; }},
            {"unknown", "all: the coefficients of one need those of the others", [](const Row&) { return "all"; }}};
}

// The operation counts of a route, for the pendulum with its accuracy; the reason if it does not exist.
struct count_row {
    std::string route;
    int order;
    std::optional<operation_count> count = {};
    std::size_t steps = 0;  // of an equation
    bool structural_zeros = true;
    const sweep_energy* at = nullptr;  // of the pendulum
    long direct_products = 0;
    cell difference = {};
    cell growth = {};
    std::string note = {};
};

const column_list<count_row>& columns() {
    using row = count_row;
    const auto counted_cell = [](auto of) {
        return [of](const row& r) { return r.count ? cell(of(*r.count)) : cell(); };
    };
    static const auto all = with_typed_energy(joined<row>(
        columns_of_routes<row>(),
        {{"multiplications", "of two numbers of the arithmetic",
          counted_cell([](const operation_count& c) { return c.multiplications; })},
         {"nonzero_multiplications", "those where neither factor is 0; empty where rounding decides that",
          [](const row& r) {
              return r.count && r.structural_zeros ? cell(r.count->multiplications - r.count->by_zero) : cell();
          }},
         {"divisions", "of two numbers of the arithmetic",
          counted_cell([](const operation_count& c) { return c.divisions; })},
         {"additions", "and subtractions", counted_cell([](const operation_count& c) { return c.additions; })},
         {"by_integers", "operations of a number with a small integer",
          counted_cell([](const operation_count& c) { return c.by_integers; })},
         {"steps", "operations of the tape that the equations became", [](const row& r) { return r.steps; }},
         {"ratio", "multiplications in units of those of the route direct",
          [](const row& r) { return r.count ? ratio_cell(r.count->multiplications, r.direct_products) : cell(); }},
         {"log10_difference",
          "log10 of the largest difference from the same coefficients by symmetric squares and running "
          "sums with 30 digits more: of a_n R^n, or of the resummation relative to its largest coefficient",
          [](const row& r) { return r.difference; }},
         {"expected_growth", "log10 of (R/K~')^N, by which the arcsine's quotient 0/0 at i K~' makes rounding grow",
          [](const row& r) { return r.growth; }},
         {"note", "why a route does not exist", [](const row& r) { return r.note; }}}));
    return all;
}

struct time_row {
    std::string route;
    int order;
    double seconds;
    std::string scalar = {};           // of an equation
    const sweep_energy* at = nullptr;  // of the pendulum
    double direct_seconds = 0;
};

const column_list<time_row>& time_columns() {
    using row = time_row;
    static const auto all = with_typed_energy(joined<row>(
        columns_of_routes<row>(), {{"scalar", "arithmetic", [](const row& r) { return r.scalar; }},
                                   {"seconds", "least processor time of nine runs on this machine, one thread, s",
                                    [](const row& r) { return decimal_cell(r.seconds, digits_of_ratios); }},
                                   {"log10_seconds", "log10 of it", [](const row& r) { return log10_cell(r.seconds); }},
                                   {"ratio", "in units of the route direct",
                                    [](const row& r) { return ratio_cell(r.seconds, r.direct_seconds); }}}));
    return all;
}

}  // namespace

namespace of_pendulum {

using namespace coefficient_routes;

namespace {

constexpr long guard_digits = 15;
constexpr int runs = 9;

const column_list<count_row>& count_columns() {
    static const auto all = columns_named(
        "route,order,energy,multiplications,nonzero_multiplications,divisions,additions,by_integers,ratio,"
        "log10_difference,expected_growth,note,energy_typed,gap_typed",
        columns());
    return all;
}

const column_list<time_row>& own_time_columns() {
    static const auto all = columns_named("route,order,energy,seconds,ratio,energy_typed,gap_typed", time_columns());
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
        const auto time_of = [&](route which) { return seconds_of(runs, order, [&] { by(which, own, order); }); };
        const double direct_seconds = time_of(route::direct);
        for (const named_route& r : routes()) {
            if (const auto reason = refusal(r.which, exact)) {
                counts.push_back({.route = r.name, .order = order, .at = &at, .note = *reason});
                continue;
            }
            const double seconds = r.which == route::direct ? direct_seconds : time_of(r.which);
            times.push_back({r.name, order, seconds, "", &at, direct_seconds});
            counts.push_back({.route = r.name,
                              .order = order,
                              .count = operations(r.which),
                              .structural_zeros = r.which != route::alpha_beta,
                              .at = &at,
                              .direct_products = direct_products,
                              .difference = difference_cell(r, by(r.which, own, order), expected.of(r)),
                              .growth = growth_cell(r, exact, order)});
        }
    });
    return {make_table(count_columns(), counts), make_table(own_time_columns(), times)};
}

// One step after the other, whatever the number of jobs: concurrent runs would disturb the timings.
study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const auto orders = request.orders();
    orders_from(request, least_order, "leaves no recurrence to count");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:50"));
    study_table times = head_of("time", scalar, own_time_columns());
    times.timed = true;
    return plan_of_cells(
        {head_of("", scalar, count_columns()), std::move(times)}, {"energy", "gap", "order"},
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
const char* const meaning_of_order = "N, last power of the series of all unknowns";
const char* const meaning_of_tapes =
    "start: about the start, where zeros of a symmetry are left out | point: the same as about any other point; only "
    "where the start is not singular";

const column_list<count_row>& count_columns() {
    static const auto all = columns_named(
        "order,route,multiplications,nonzero_multiplications,divisions,additions,by_integers,steps,unknown",
        with_meanings(columns(), {{"order", meaning_of_order},
                                  {"route", meaning_of_tapes},
                                  {"nonzero_multiplications", "those where neither factor is 0"}}));
    return all;
}

const column_list<time_row>& own_time_columns() {
    static const auto all =
        columns_named("order,route,scalar,seconds,log10_seconds,unknown",
                      with_meanings(time_columns(),
                                    {{"order", meaning_of_order},
                                     {"route", meaning_of_tapes},
                                     {"seconds", "least processor time of five runs on this machine, one thread, s"}}));
    return all;
}

std::vector<table> tables_at(const ode::explicit_system& system, int order, const std::vector<scalar_spec>& scalars) {
    std::vector<std::pair<std::string, ode::tape>> tapes{{"start", ode::tape::about_start(system)}};
    if (!system.singular()) {
        tapes.emplace_back("point", ode::tape::about_points(system));
    }
    std::vector<count_row> counts;
    std::vector<time_row> times;
    for (const auto& [route, tape] : tapes) {
        ode::taylor_expansion<counted> tally(tape, order);
        counts.push_back({route, order, count_operations([&] { tally.about_start(); }), tape.steps().size()});
        for (const scalar_spec& scalar : scalars) {
            const double seconds = with_scalar(scalar, 0, [&t = tape, order]<class T>() {
                ode::taylor_expansion<T> expansion(t, order);
                return seconds_of(runs, order, [&] { expansion.about_start(); });
            });
            times.push_back({route, order, seconds, scalar.name()});
        }
    }
    return {make_table(count_columns(), counts), make_table(own_time_columns(), times)};
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, least_order, "leaves no recurrence to count");
    const std::vector<scalar_spec> scalars =
        request.scalar ? std::vector<scalar_spec>{*request.scalar}
                       : std::vector<scalar_spec>{read_scalar("double"), read_scalar("mpfr:50")};
    study_table times = head_of(*sweep, "time", scalars.back(), own_time_columns());
    times.timed = true;
    return plan_of_cells(
        {head_of(*sweep, "", read_scalar("double"), count_columns()), std::move(times)}, sweep->axes({"order"}),
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
}  // namespace cost_study

const study& cost() {
    using namespace cost_study;
    static const study result{
        .name = "cost",
        .title = "What the coefficients cost",
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
        .plan = of_pendulum::plan,
        .alone = true,
        .any_equation = equation_form{
            .plan = of_equation::plan,
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
