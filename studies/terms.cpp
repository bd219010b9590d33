// How many terms give D digits on [0, T*], and how does that number grow towards the separatrix?
#include <algorithm>
#include <functional>
#include <optional>

#include "libration/pendulum/least_order.hpp"
#include "shared/norms_on_interval.hpp"
#include "shared/radius_on_interval.hpp"
#include "shared/sweep_columns.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace terms_study {

namespace {

constexpr long printed_digits = 12;

// The least order of one method for a number of digits; std::nullopt if no order up to the highest suffices.
struct terms_row {
    int digits;
    std::string method;
    std::optional<int> order;
    std::optional<mpfr> norm, before, predicted;
    int terms, proved;  // for the pendulum, as `at`
    const sweep_energy* at;
    std::string unknown = {};  // for another equation
};

const column_list<terms_row>& columns() {
    using row = terms_row;
    static const column_list<row> all{
        energy_column<row>(),
        gap_column<row>(),
        {"digits", "D: the error norm is to be at most 10^-D, in the unit of the unknown",
         [](const row& r) { return r.digits; }},
        {"method", "series | endpoint: with value and slope of the far end of the times",
         [](const row& r) { return r.method; }},
        {"order",
         "least N whose norm, and that of every larger order looked at, is at most 10^-D; empty where there is none "
         "(heuristic: errors at sampled times)",
         [](const row& r) { return r.order ? cell(*r.order) : cell(); }},
        {"terms", "numbers that are not 0 in the polynomial: a_n up to N, and alpha and beta of the resummation",
         [](const row& r) { return r.terms; }},
        {"predicted",
         "D ln 10/ln(R/reach) of the rate of the series, reach the length of the interval; empty where that "
         "diverges",
         [](const row& r) { return decimal_cell(r.predicted, printed_digits); }},
        {"proved_order", "least N for which theorem A (series) or A2 (resummed) proves the same",
         [](const row& r) { return r.proved; }},
        {"norm", "max of |approximation - solution| over the times at N, in the unit of the unknown",
         [](const row& r) { return decimal_cell(r.norm, printed_digits); }},
        {"norm_before", "the same at N - 1, above 10^-D; empty for N = 0",
         [](const row& r) { return decimal_cell(r.before, printed_digits); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        log10_gap_column<row>(),
        unknown_column<row>(),
    };
    return all;
}

}  // namespace

namespace of_pendulum {

using namespace series;
using namespace pendulum;

namespace {

const column_list<terms_row>& own_columns() {
    static const auto all = with_typed_energy(columns_named(
        "energy,gap,digits,method,order,terms,predicted,proved_order,norm,norm_before,log10_norm,log10_gap",
        with_meanings(
            columns(),
            {{"digits", "D: the error norm is to be at most 10^-D radians"},
             {"method", "series | resummed"},
             {"order",
              "least N whose norm, and that of every larger order, is at most 10^-D (heuristic: errors at sampled "
              "times, true norms where they are near 10^-D)"},
             {"predicted", "D ln 10/ln(R/T*)"},
             {"norm", "max of |approximation - theta| over [0, T*] at N, radians"}})));
    return all;
}

// Nonzero coefficients: every second one, and pi in rotation.
int terms_of(const top_bounds<mpfr>& bounds, arc_method method, int order) {
    const int of_series = bounds.parity == 0 ? order / 2 + 1 : (order + 1) / 2 + 1;
    return of_series + (method == arc_method::resummed ? 2 : 0);
}

table rows_at(const sweep_energy& at, const std::vector<int>& falling) {
    const motion m = motion::of_energy(at.value);
    const precision_scope scope(working_digits_for(m, falling.front()) + printed_digits);
    const arc_orders search(m, falling.front());
    const auto& bounds = search.bounds();
    std::vector<terms_row> rows;
    rows.reserve(falling.size() * 2);
    for (const auto method : {arc_method::series, arc_method::resummed}) {
        const auto found = search.least(method, falling);
        for (std::size_t i = 0; i < falling.size(); ++i) {
            rows.push_back({falling[i], std::string(name_of(method)), found[i].order, found[i].norm, found[i].before,
                            predicted_order(bounds, falling[i]), terms_of(bounds, method, found[i].order),
                            proved_order(bounds, method, falling[i]), &at});
        }
    }
    return make_table(own_columns(), rows);
}

std::vector<int> falling_digits(std::vector<int> digits) {
    std::sort(digits.begin(), digits.end(), std::greater<>());
    digits.erase(std::unique(digits.begin(), digits.end()), digits.end());
    if (!digits.empty() && digits.front() > arc_orders::most_digits) {
        throw input_error("--digits", std::to_string(digits.front()), "is more than the search supports",
                          "write at most " + std::to_string(arc_orders::most_digits));
    }
    return digits;
}

study_plan plan(const study_request& request) {
    const std::vector<int> falling = falling_digits(request.digits());
    return plan_by_energy({head_of("", read_scalar("mpfr:" + std::to_string(falling.front())), own_columns())},
                          sweep_of(request),
                          [falling](const sweep_energy& at) { return std::vector<table>{rows_at(at, falling)}; });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

constexpr int highest_order = 600;
constexpr long guard_digits = 20;

const column_list<terms_row>& own_columns() {
    static const auto all =
        columns_named("digits,method,order,predicted,norm,norm_before,log10_norm,unknown", columns());
    return all;
}

// The norms of all orders of one method, in increasing order, until a quarter of them is below the bound.
std::vector<mpfr> norms_until(const unknown_on_interval<mpfr>& of, approximation method, const mpfr& bound) {
    std::vector<mpfr> norms;
    int below = 0;
    for (int order = 0; order <= highest_order && below < 16 + order / 4; ++order) {
        const auto error = of.error_of(method, order);
        if (!error) {
            return {};
        }
        norms.push_back(error->norm);
        below = error->norm <= bound ? below + 1 : 0;
    }
    return norms;
}

terms_row least_of(const std::vector<mpfr>& norms, int digits, approximation method) {
    terms_row row{digits, name_of(method), {}, {}, {}, {}, 0, 0, nullptr};
    const mpfr bound = pow(mpfr(10), -digits);
    std::size_t least = norms.size();
    while (least > 0 && norms[least - 1] <= bound) {
        --least;
    }
    if (least < norms.size()) {
        row.order = static_cast<int>(least);
        row.norm = norms[least];
        row.before = least > 0 ? std::optional(norms[least - 1]) : std::nullopt;
    }
    return row;
}

std::optional<mpfr> predicted_order(const radius_row& radius, int digits) {
    const auto& found = radius.of.found.radius;
    if (!found || radius.reach >= *found || radius.reach == 0) {
        return std::nullopt;
    }
    return mpfr(digits * log(mpfr(10)) / log(mpfr(*found / radius.reach)));
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<ode::number>& times,
                             const std::vector<int>& digits) {
    const auto system = sweep.system(i);
    const precision_scope scope(digits.back() + printed_digits + guard_digits);
    const auto radii = radii_about(system, sweep, times);
    const auto truth = solve_on(system, times);
    const series_about_start<mpfr> series(system, highest_order);
    const mpfr bound = pow(mpfr(10), -digits.back());
    std::vector<terms_row> rows;
    for (std::size_t u = 0; u < sweep.unknowns().size(); ++u) {
        const unknown_on_interval<mpfr> here(series, truth, sweep.unknowns()[u]);
        for (const approximation method : {approximation::series, approximation::endpoint}) {
            const auto norms = norms_until(here, method, bound);
            for (const int each : digits) {
                terms_row row = least_of(norms, each, method);
                row.predicted = predicted_order(radii[u], each);
                row.unknown = sweep.name_of(sweep.unknowns()[u]);
                rows.push_back(std::move(row));
            }
        }
    }
    return {make_table(own_columns(), rows), make_table(radius_columns(), radii)};
}

study_plan plan(const study_request& request) {
    constexpr int most_digits_searched = 300;
    const auto sweep = equation_sweep_of(request);
    const auto times = times_of(request, 2);
    const auto digits = request.digits();
    if (digits.back() > most_digits_searched) {
        throw input_error("--digits", std::to_string(digits.back()), "is more than the search supports",
                          "write at most " + std::to_string(most_digits_searched));
    }
    const scalar_spec scalar{scalar_kind::arbitrary, digits.back()};
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, own_columns()), head_of(*sweep, "radius", scalar, radius_columns())}, sweep,
        [sweep, times, digits](std::size_t i) { return tables_at(*sweep, i, times, digits); });
}

}  // namespace
}  // namespace of_equation
}  // namespace terms_study

const study& terms() {
    using namespace terms_study;
    static const study result{
        .name = "terms",
        .title = "Terms for a number of digits",
        .question = "How many terms give D digits on [0, T*], and how does that number grow towards E = 2?",
        .reading =
            "The least order N whose error norm stays below 10^-D, for libration (left) and rotation (right), against "
            "the distance of E from 2: dashed the series, solid its resummation, dotted the estimate D ln 10/ln(R/T*) "
            "of the rate alone, crosses what theorems A and A2 prove to be enough. R/T* tends to 1 like 1/ln^2 of the "
            "gap, so N grows with the square of its logarithm: ten digits at a gap of 1e-12 take "
            "{{the order of terms where gap=1e-12 digits=10 method=series to 4}} powers. The "
            "resummation has the same slope and a head start, which is the larger part of N where few digits are "
            "wanted. The measured N is heuristic, as the column says; the crosses are proved.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.1,0.5,1,1.5,3,4,8,20", "energies E, in m g l"},
                       {"--gaps", "1e-1:1e-12:12log,-1e-1:-1e-12:12log", "energies as 2 - E"},
                       {"--digits", "10,20,30", "D: the error norm is to be at most 10^-D radians"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--digits", "5,12", ""}},
        .seconds = 3.5,
        .excluded =
            no_answer_at_limits("the series is the constant 0", "the series is not defined: the period is infinite"),
        .plan = of_pendulum::plan,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .question = "How many terms give D digits on an interval?",
            .reading =
                "The least order N whose largest error at the times stays below 10^-D, of the partial sum and of the "
                "endpoint approximant, and thin what the rate of the series alone predicts, D ln 10/ln(R/reach). Where "
                "the interval ends near the circle of convergence every digit costs many terms, and beyond it no "
                "number is enough.",
            .parameters = {required_times("the interval, as times at which the error is taken"),
                           {"--digits", "5:50:10", "D, digits after the decimal point"}},
            .example = {"blasius", {"k=0.1,0.332,1"}},
            .example_words = {{"--times", "0:3:31"}},
            .quick = {{"--times", "0:1:3"}, {"--digits", "5,10"}},
            .seconds = 5}};
    return result;
}

}  // namespace libration::studies
