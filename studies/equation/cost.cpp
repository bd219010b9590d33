// What do the coefficients of any equation cost?
#include <algorithm>
#include <chrono>
#include <functional>
#include <map>

#include "equation_plan.hpp"
#include "libration/ode/taylor_expansion.hpp"
#include "libration/scalar/counted.hpp"

namespace libration::studies::of_equation {

namespace cost_of_equation {

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

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
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
            std::vector<table> all;
            for (const table& own : tables_at(sweep->system(at), orders[i % orders.size()], scalars)) {
                all.push_back(sweep->framed(at, own));
            }
            return all;
        });
}

}  // namespace
}  // namespace cost_of_equation

const equation_study& cost() {
    using namespace cost_of_equation;
    static const equation_study result{
        .name = "cost",
        .title = "What the coefficients cost",
        .question = "How many operations and how much time do the coefficients of all unknowns cost?",
        .reading =
            "Left: multiplications of two numbers for the coefficients of all unknowns up to N; every product and "
            "every function of the equations costs N^2/2 of them, and a symmetry of the start divides that by its "
            "square. Right: the time of it on the machine that made this page.",
        .parameters = {{"--orders", "10,20,40,80,160,320", "N, last power of the series"},
                       {"--scalar", "double and mpfr:50", "arithmetic of the times"}},
        .example = {"lorenz", {}},
        .example_words = {},
        .quick = {{"--orders", "10,20"}},
        .seconds = 2,
        .plan = plan,
        .alone = true};
    return result;
}

}  // namespace libration::studies::of_equation
