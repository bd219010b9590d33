// How many digits does the uniform resummation reach with 8, 16 and 32 coefficients, at energies from 1e-20 to 1e4?
#include <algorithm>
#include <string_view>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/uniform_convergence_rate.hpp"
#include "libration/pendulum/uniform_resummation.hpp"

namespace libration::studies {

namespace uniform_study {

using namespace series;
using namespace elliptic;
using namespace pendulum;

namespace {

constexpr long printed_digits = 12;
constexpr long digits_below_double = 17 + 2 * printed_digits;

// The norm for one number of coefficients.
struct uniform_row {
    const sweep_energy& at;
    int count;
    int order;
    mpfr norm, time;
    std::string_view scalar;
    bool two_method;
    mpfr bound, rate;
};

const column_list<uniform_row>& columns() {
    using row = uniform_row;
    const auto value = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(r.*which, printed_digits); };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        gap_column<row>(),
        {"count", "coefficients of powers of t that are not 0", [](const row& r) { return r.count; }},
        {"order", "N, last power", [](const row& r) { return r.order; }},
        {"norm", "max of |approximation - theta| over [0, T*], radians", value(&row::norm)},
        {"time_of_maximum", "dimensionless time since the top", value(&row::time)},
        {"scalar", "arithmetic of the approximation", [](const row& r) { return r.scalar; }},
        {"rigour", "two-method: confirmed by the sum over separatrix solutions | heuristic",
         [](const row& r) { return r.two_method ? "two-method" : "heuristic"; }},
        {"bound", "theorem U, radians: what exact arithmetic does not exceed", value(&row::bound)},
        {"rate", "T*/|3 T* + i K~'|, the exact factor of the error a power in the long run", value(&row::rate)},
        {"log10_norm", "log10 of norm", [](const row& r) { return log10_cell(r.norm); }},
        {"log10_bound", "log10 of bound", [](const row& r) { return log10_cell(r.bound); }},
        {"log10_energy", "log10 of E",
         [](const row& r) {
             const precision_scope scope(60);
             return log10_cell(from_exact<mpfr>(r.at.value));
         }},
        log10_gap_column<row>(),
    });
    return all;
}

// The tables of one energy, in mpfr and in double.
std::vector<table> rows_at(const sweep_energy& at, const std::vector<int>& counts) {
    const motion m = motion::of_energy(at.value);
    const int parity = parity_from_top(m.regime());
    std::vector<uniform_row> in_mpfr;
    std::vector<uniform_row> in_double;
    // The reference for double, once for all counts: accurate to twice the printed digits below its rounding error.
    const auto truth = [&] {
        const precision_scope scope(digits_below_double);
        return std::make_unique<arc_errors>(m);
    }();
    // One reference for all counts in mpfr, too, with the digits that the smallest error requires.
    long below = 0;
    for (const int count : counts) {
        below = std::max(below, uniform_digits_below(m, 2 * count - parity));
    }
    const precision_scope scope(below + 2 * printed_digits);
    arc_errors errors(m);
    for (const int count : counts) {
        const int order = 2 * count - parity;
        const auto f = uniform_from_top<mpfr>(m, order);
        const norm_at<mpfr> found = errors.norm_of(f, order);
        const mpfr other = errors.second_opinion_of(f, found.place);
        const bool agreed = abs(found.norm - other) <= found.norm * pow(mpfr(10), -static_cast<int>(printed_digits));
        const mpfr bound = f.bounds().norm(order);
        const mpfr rate = uniform_convergence_rate(errors.bounds(), 1);
        const mpfr& effective_period = errors.bounds().effective_period;
        in_mpfr.push_back(
            {at, count, order, found.norm, mpfr(found.place * effective_period), "mpfr", agreed, bound, rate});
        const auto rounded = uniform_from_top<double>(m, order);
        const auto value = [&](double x) { return widen(rounded.value(x)); };
        const precision_scope of_double(digits_below_double);
        const auto rough = truth->rounded_norm(value, narrow<double>(found.place));
        in_double.push_back(
            {at, count, order, rough.norm, mpfr(rough.place * effective_period), "double", false, bound, rate});
    }
    return {make_table(columns(), in_mpfr), make_table(columns(), in_double)};
}

study_plan plan(const study_request& request) {
    return plan_by_order({head_of("", read_scalar("mpfr:" + std::to_string(printed_digits)), columns()),
                          head_of("double", read_scalar("double"), columns())},
                         sweep_of(request), numbers_of_coefficients(request), &rows_at);
}

}  // namespace
}  // namespace uniform_study

const study& uniform() {
    using namespace uniform_study;
    static const study result{
        .name = "uniform",
        .title = "One resummation for every energy",
        .question =
            "How many digits does the uniform resummation reach with 8, 16 and 32 coefficients, from E = 1e-20 "
            "over |2-E| = 1e-100 to E = 1e4?",
        .reading =
            "The digits -log10 of the error norm on [0, T*], of theta minus its two nearest columns of singularities "
            "in closed form and a series for the rest, by the number of coefficients that are not 0. Solid in exact "
            "arithmetic, dotted what theorem U proves at every energy, circles the same with 16 coefficients in "
            "double, whose rounding is all that is left of its error. The digits are absolute: at tiny energies theta "
            "itself is sqrt(2E), so that the digits of theta are fewer by as many as that has zeros, and in double the "
            "rounding of the columns, which are not small, is left. Towards E = 2 the two columns become the whole "
            "motion, and the error falls with the gap itself.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "1e-20:1e-1:20log,0.5,1,1.5,10:1e4:7log", "energies E, in m g l"},
                       {"--gaps", "1e-1:1e-100:34log,-1e-1:-1e-100:34log,-0.5,-1,-2", "energies as 2 - E"},
                       {"--orders", "8,16,32", "numbers of nonzero coefficients"}},
        .quick = {{"--energies", "1.71,1e-20", ""}, {"--gaps", "1e-12,-1e-30", ""}, {"--orders", "4,16", ""}},
        .seconds = 5,
        .excluded = no_answer_at_limits("the columns of singularities are infinitely many", "the period is infinite"),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
