// How many terms give D digits on an interval, for any equation?
#include <algorithm>
#include <functional>
#include <optional>

#include "norms_on_interval.hpp"
#include "radius_on_interval.hpp"

namespace libration::studies::of_equation {

namespace terms_of_equation {

namespace {

constexpr int highest_order = 600;
constexpr long printed_digits = 12;
constexpr long guard_digits = 20;

// The least order of one method for a number of digits; nothing where no order up to the highest does.
struct terms_row {
    int digits;
    approximation method;
    std::optional<int> order;
    std::optional<mpfr> norm, before, predicted;
    std::string unknown;
};

const column_list<terms_row>& columns() {
    using row = terms_row;
    static const column_list<row> all{
        {"digits", "D: the error is to be at most 10^-D, in the unit of the unknown",
         [](const row& r) { return r.digits; }},
        {"method", "series | endpoint: with value and slope of the far end of the times",
         [](const row& r) { return name_of(r.method); }},
        {"order",
         "least N whose largest error at the times, and that of every larger order up to 600, is at most 10^-D; empty "
         "where there is none (heuristic: the orders beyond are not looked at)",
         [](const row& r) { return r.order ? cell(*r.order) : cell(); }},
        {"predicted", "D ln 10/ln(R/reach) of the rate of the series; empty where that diverges",
         [](const row& r) { return decimal_cell(r.predicted, printed_digits); }},
        {"norm", "max of |approximation - solution| over the times at N",
         [](const row& r) { return decimal_cell(r.norm, printed_digits); }},
        {"norm_before", "the same at N - 1, above 10^-D; empty for N = 0",
         [](const row& r) { return decimal_cell(r.before, printed_digits); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        unknown_column<row>(),
    };
    return all;
}

// The norms of all orders of one method, by growing ones, until a quarter of them is below the bound.
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
    terms_row row{digits, method, std::nullopt, std::nullopt, std::nullopt, std::nullopt, ""};
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
    if (!radius.found.radius || radius.reach >= *radius.found.radius || radius.reach == 0) {
        return std::nullopt;
    }
    return mpfr(digits * log(mpfr(10)) / log(mpfr(*radius.found.radius / radius.reach)));
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
    return {make_table(columns(), rows), make_table(radius_columns(), radii)};
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    constexpr int most_digits_searched = 300;
    const auto sweep = sweep_of(problem, request);
    const auto times = times_of(request, 2);
    const auto digits = request.digits();
    if (digits.back() > most_digits_searched) {
        throw input_error("--digits", std::to_string(digits.back()), "is more than this search takes",
                          "write at most " + std::to_string(most_digits_searched));
    }
    const scalar_spec scalar{scalar_kind::arbitrary, digits.back()};
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "radius", scalar, radius_columns())}, sweep,
        [sweep, times, digits](std::size_t i) { return tables_at(*sweep, i, times, digits); });
}

}  // namespace
}  // namespace terms_of_equation

const equation_study& terms() {
    using namespace terms_of_equation;
    static const equation_study result{
        .name = "terms",
        .title = "Terms for a number of digits",
        .question = "How many terms give D digits on an interval?",
        .reading =
            "The least order N whose largest error at the times stays below 10^-D, of the partial sum and of the "
            "endpoint approximant, and thin what the rate of the series alone predicts, D ln 10/ln(R/reach). Where the "
            "interval ends near the circle of convergence every digit costs many terms, and beyond it no number is "
            "enough.",
        .parameters = {{"--times", "", "the interval, as times at which the error is taken"},
                       {"--digits", "5:50:10", "D, digits behind the point"}},
        .example = {"blasius", {"k=0.1,0.332,1"}},
        .example_words = {{"--times", "0:3:31"}},
        .quick = {{"--times", "0:1:3"}, {"--digits", "5,10"}},
        .seconds = 5,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
