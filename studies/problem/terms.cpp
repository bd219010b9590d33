// How many terms give D digits on [0, T*], and how does that number grow towards the separatrix?
#include <algorithm>
#include <functional>

#include "libration/pendulum/error/least_order.hpp"
#include "sweep_columns.hpp"
#include "sweep_plan.hpp"

namespace libration::studies {

namespace terms_study {

using namespace series;
using namespace pendulum;

namespace {

constexpr long printed_digits = 12;

// The least order of one method for a number of digits.
struct terms_row {
    const sweep_energy& at;
    int digits;
    arc_method method;
    least_order least;
    int terms;
    mpfr predicted;
    int proved;
};

const column_list<terms_row>& columns() {
    using row = terms_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        gap_column<row>(),
        {"digits", "D: the error norm is to be at most 10^-D radians", [](const row& r) { return r.digits; }},
        {"method", "series | resummed", [](const row& r) { return name_of(r.method); }},
        {"order",
         "least N whose norm, and that of every larger order, is at most 10^-D (heuristic: errors at sampled times, "
         "true norms where they are near 10^-D)",
         [](const row& r) { return r.least.order; }},
        {"terms", "numbers that are not 0 in the polynomial: a_n up to N, and alpha and beta of the resummation",
         [](const row& r) { return r.terms; }},
        {"predicted", "D ln 10/ln(R/T*)", [](const row& r) { return decimal_cell(r.predicted, printed_digits); }},
        {"proved_order", "least N for which theorem A (series) or A2 (resummed) proves the same",
         [](const row& r) { return r.proved; }},
        {"norm", "max of |approximation - theta| over [0, T*] at N, radians",
         [](const row& r) { return decimal_cell(r.least.norm, printed_digits); }},
        {"norm_before", "the same at N - 1, above 10^-D; empty for N = 0",
         [](const row& r) { return decimal_cell(r.least.before, printed_digits); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.least.norm); }},
        log10_gap_column<row>(),
    });
    return all;
}

// Coefficients that are not 0: every second one, and pi in rotation.
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
            rows.push_back({at, falling[i], method, found[i], terms_of(bounds, method, found[i].order),
                            predicted_order(bounds, falling[i]), proved_order(bounds, method, falling[i])});
        }
    }
    return make_table(columns(), rows);
}

std::vector<int> falling_digits(std::vector<int> digits) {
    std::sort(digits.begin(), digits.end(), std::greater<>());
    digits.erase(std::unique(digits.begin(), digits.end()), digits.end());
    if (!digits.empty() && digits.front() > arc_orders::most_digits) {
        throw input_error("--digits", std::to_string(digits.front()), "is more than this search takes",
                          "write at most " + std::to_string(arc_orders::most_digits));
    }
    return digits;
}

study_plan plan(const study_request& request) {
    const std::vector<int> falling = falling_digits(request.digits());
    return plan_by_energy({head_of("", read_scalar("mpfr:" + std::to_string(falling.front())), columns())},
                          sweep_of(request),
                          [falling](const sweep_energy& at) { return std::vector<table>{rows_at(at, falling)}; });
}

}  // namespace
}  // namespace terms_study

const study& terms() {
    using namespace terms_study;
    static const study result{
        .name = "terms",
        .title = "Terms for a number of digits",
        .label = "",
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
        .plan = plan};
    return result;
}

}  // namespace libration::studies
