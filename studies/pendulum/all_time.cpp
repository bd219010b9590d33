// What does the accuracy of T* imply after many periods?
#include <algorithm>
#include <cstddef>
#include <optional>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "folded.hpp"
#include "libration/pendulum/folding_error.hpp"
#include "libration/pendulum/rounded_phase_map.hpp"
#include "periodic_rows.hpp"

namespace libration::studies {

namespace all_time_study {

using namespace pendulum;

namespace {

constexpr int points_in_period = 128;

mpfr as_mpfr(const integer& count) { return from_rational<mpfr>(rational(count)); }

// The error of a solution that is folded with an inexact T*.
struct folding_row {
    const sweep_energy& at;
    const std::string& period_by;
    const integer& periods;
    long digits;
    mpfr period_error, error, predicted;
};

const column_list<folding_row>& folding_columns() {
    using row = folding_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"period_by", "way to T*: agm (exact) | series:N (Kold) | resummed:N (Knew)",
         [](const row& r) { return r.period_by; }},
        {"periods", "p, whole periods before the one that is looked at", [](const row& r) { return cell(r.periods); }},
        {"period_error", "error of T, dimensionless",
         [](const row& r) { return decimal_cell(r.period_error, r.digits); }},
        {"error", "largest |theta - exact| at the 129 times (p + i/128) T, radians",
         [](const row& r) { return decimal_cell(r.error, r.digits); }},
        {"predicted", "sqrt(2E) (p + 1) times period_error, radians: first order in it",
         [](const row& r) { return decimal_cell(r.predicted, r.digits); }},
        {"log10_periods", "log10 of p", [](const row& r) { return log10_cell(as_mpfr(r.periods)); }},
        {"log10_error", "log10 of error", [](const row& r) { return log10_cell(r.error); }},
        {"log10_predicted", "log10 of predicted", [](const row& r) { return log10_cell(r.predicted); }},
    });
    return all;
}

// The error of a time in an arithmetic, for one reduction.
struct reduction_row {
    const sweep_energy& at;
    const scalar_spec& scalar;
    bool wide;
    const integer& periods;
    mpfr error;
    std::optional<mpfr> bound;
};

const column_list<reduction_row>& reduction_columns() {
    using row = reduction_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        {"scalar", "arithmetic of the time and of the solution", [](const row& r) { return r.scalar.name(); }},
        {"reduction", "exact: the typed time in wide arithmetic | fmod: remainder of the rounded time and period",
         [](const row& r) { return r.wide ? "exact" : "fmod"; }},
        {"periods", "p, whole periods before the one that is looked at", [](const row& r) { return cell(r.periods); }},
        {"error", "largest |theta - exact| at 65 times near (p + i/64) T, whole turns left aside, radians",
         [](const row& r) { return decimal_cell(r.error, r.scalar.digits); }},
        {"predicted", "fmod: sqrt(2E) (p + 1) T epsilon, the bound of what the rounding of t and T does; exact: empty",
         [](const row& r) { return decimal_cell(r.bound, r.scalar.digits); }},
        {"log10_periods", "log10 of p", [](const row& r) { return log10_cell(as_mpfr(r.periods)); }},
        {"log10_error", "log10 of error", [](const row& r) { return log10_cell(r.error); }},
        {"log10_predicted", "log10 of predicted", [](const row& r) { return log10_cell(r.bound); }},
    });
    return all;
}

// For T* by one rule alone, after each number of periods.
table folding_rows(const sweep_energy& at, const sweep_period_rule& by, const std::vector<integer>& periods) {
    const scalar_spec scalar = read_scalar("mpfr:40");
    const bool exact_period = by.rule.method == period_method::agm;
    const value_with_error period = period_by(motion::of_energy(at.value), by.rule, scalar);
    std::vector<folding_row> rows;
    const precision_scope of_rows(scalar.digits * 2 + guard_digits);
    for (const integer& count : periods) {
        const auto worst = resolved(scalar.digits, 0, [&] {
            const auto pair = folding_error<mpfr>(at.value, by.rule, count, points_in_period);
            // With an exact T* only rounding errors remain.
            return std::vector<value_with_error>{
                {pair.expected, pair.error, exact_period ? mpfr(0) : pair.error, exact_period}};
        });
        const precision_scope scope(scalar.digits * 2 + guard_digits);
        const mpfr& error = worst.front().error;
        const mpfr predicted = folding_error_estimate<mpfr>(at.value, period.error, count);
        rows.push_back({at, by.text, count, scalar.digits, period.error, error, predicted});
    }
    return make_table(folding_columns(), rows);
}

// For the phase map of one fixed scalar, with both reductions.
template <fixed_scalar T>
table reduction_rows(const sweep_energy& at, const scalar_spec& scalar, const std::vector<integer>& periods) {
    constexpr int points = 64;
    const motion m = motion::of_energy(at.value);
    const rounded_phase_map<T> rounded(m);
    const phase_map<T> typed(m);
    std::vector<reduction_row> rows;
    const precision_scope of_rows(scalar.digits * 2 + guard_digits);
    for (const bool wide : {true, false}) {
        for (const integer& count : periods) {
            const long before_point = static_cast<long>(count.str().size());
            const auto worst = resolved(scalar.digits, 2 * before_point + 40, [&] {
                const mpfr error = wide ? phase_map_error<T>(at.value, typed, count, points)
                                        : phase_map_error<T>(at.value, rounded, count, points);
                return std::vector<value_with_error>{{error, error, error, false}};
            });
            const precision_scope scope(scalar.digits * 2 + guard_digits);
            const mpfr& error = worst.front().error;
            const mpfr bound = rounded_phase_map_bound<T>(at.value, count);
            rows.push_back({at, scalar, wide, count, error, wide ? std::nullopt : std::optional(bound)});
        }
    }
    return make_table(reduction_columns(), rows);
}

// The rows of one energy for one method for T*, or in one scalar.
std::vector<table> rows_at(const sweep_energy& at, const sweep_period_rule* by, const scalar_spec& scalar,
                           const std::vector<integer>& periods) {
    if (by != nullptr) {
        return {folding_rows(at, *by, periods)};
    }
    const table no_folding = make_table(folding_columns(), std::vector<folding_row>());
    switch (scalar.kind) {
        case scalar_kind::binary64: return {no_folding, reduction_rows<double>(at, scalar, periods)};
        case scalar_kind::extended: return {no_folding, reduction_rows<long double>(at, scalar, periods)};
        default: return {no_folding, reduction_rows<quad>(at, scalar, periods)};
    }
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const std::vector<scalar_spec> scalars{read_scalar("double"), read_scalar("long-double"), read_scalar("quad")};
    const std::size_t rules = sweep->period_rules.size();
    const std::size_t each = rules + scalars.size();
    return plan_of_cells(
        {head_of("", read_scalar("mpfr:40"), folding_columns()),
         head_of("reduction", read_scalar("quad"), reduction_columns())},
        {"energy", "gap", "period_by"}, sweep->energies.size() * each,
        [sweep, scalars, rules, each](std::size_t i) {
            const auto at = inputs_of(sweep->energies[i / each]);
            const std::size_t way = i % each;
            return way < rules ? with_input(at, "period_by", sweep->period_rules[way].text)
                               : with_input(at, "scalar", scalars[way - rules].name());
        },
        [sweep, scalars, rules, each](std::size_t i) {
            const std::size_t way = i % each;
            const auto* const by = way < rules ? &sweep->period_rules[way] : nullptr;
            return rows_at(sweep->energies[i / each], by, scalars[by != nullptr ? 0 : way - rules], sweep->periods);
        });
}

}  // namespace
}  // namespace all_time_study

const study& all_time() {
    using namespace all_time_study;
    static const study result{
        .name = "all_time",
        .title = "The accuracy of the period at late times",
        .question = "What does the accuracy of T* cost after many periods?",
        .reading =
            "Each panel has one way to T*, each colour one energy; left over the number of periods p, both axes "
            "in powers of ten. Points and solid lines: the largest error within the period after p whole ones of "
            "a solution that is exact on [0, T*] but folded by that T*. Dotted: the first-order estimate, the "
            "error of the period times p + 1 times the greatest speed. Errors below 1e-32 are left out of the "
            "figure. The errors follow the estimate until the motion is out of step by a good part of a period; "
            "from there on libration can be off by twice its amplitude at most, and rotation loses whole turns. "
            "The second figure asks the same of the arithmetic: with the time as typed, reduced in as many digits"
            " as it needs, the error (dashed) stays at the rounding of the scalar for ever; with the remainder of"
            " a rounded time by a rounded period (solid) it grows like p.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1.71,1.9998,2.02,4", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--periods", "1,10,1e2,1e3,1e4,1e5,1e6,1e7,1e8,1e9",
                        "p, whole periods before the one looked at"},
                       {"--period-by", "series:40,resummed:10,resummed:40,resummed:200", "methods for T*"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--periods", "1,1e6", ""}, {"--period-by", "resummed:10", ""}},
        .seconds = 2,
        .excluded = without_period(),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
