// What does the accuracy of T* cost after many periods?
#include <algorithm>
#include <cstddef>

#include "folded.hpp"
#include "libration/pendulum/error/folding_error.hpp"
#include "libration/pendulum/solution/rounded_clock.hpp"
#include "periodic_rows.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

namespace all_time_study {
namespace {

constexpr int points_in_period = 128;

const std::vector<column>& folding_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"period_by", "way to T*: agm (exact) | series:N (Kold) | resummed:N (Knew)"},
        {"periods", "p, whole periods before the one that is looked at"},
        {"period_error", "error of T, dimensionless"},
        {"error", "largest |theta - exact| at the 129 times (p + i/128) T, radians"},
        {"predicted", "sqrt(2E) (p + 1) times period_error, radians: first order in it"},
        {"log10_periods", "log10 of p"},
        {"log10_error", "log10 of error"},
        {"log10_predicted", "log10 of predicted"},
    };
    return all;
}

const std::vector<column>& reduction_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"scalar", "arithmetic of the time and of the solution"},
        {"reduction", "exact: the typed time in wide arithmetic | fmod: remainder of the rounded time and period"},
        {"periods", "p, whole periods before the one that is looked at"},
        {"error", "largest |theta - exact| at 65 times near (p + i/64) T, whole turns left aside, radians"},
        {"predicted", "fmod: sqrt(2E) (p + 1) T epsilon, the bound of what the rounding of t and T does; exact: empty"},
        {"log10_periods", "log10 of p"},
        {"log10_error", "log10 of error"},
        {"log10_predicted", "log10 of predicted"},
    };
    return all;
}

// Of T* by one rule alone, after each number of periods.
table_rows folding_rows(const sweep_energy& at, const sweep_period_rule& by, const std::vector<integer>& periods) {
    const scalar_spec scalar = read_scalar("mpfr:40");
    const bool exact_period = by.rule.method == period_method::agm;
    const judged period = period_by(motion::of_energy(at.value), by.rule, scalar);
    table_rows rows;
    for (const integer& count : periods) {
        const auto worst = resolved(scalar.digits, 0, [&] {
            const auto pair = folding_error<mpfr>(at.value, by.rule, count, points_in_period);
            // An exact T* leaves rounding alone.
            return std::vector<judged>{{pair.expected, pair.error, exact_period ? mpfr(0) : pair.error, exact_period}};
        });
        const precision_scope scope(scalar.digits * 2 + guard_digits);
        const mpfr& error = worst.front().error;
        const mpfr predicted = folding_error_estimate<mpfr>(at.value, period.error, count);
        rows.push_back({at.energy, by.text, count.str(), to_decimal(period.error, scalar.digits),
                        to_decimal(error, scalar.digits), to_decimal(predicted, scalar.digits),
                        log10_text(from_rational<mpfr>(rational(count))), log10_text(error), log10_text(predicted)});
    }
    return rows;
}

// Of the clock of one fixed scalar, both ways.
template <fixed_scalar T>
table_rows reduction_rows(const sweep_energy& at, const scalar_spec& scalar, const std::vector<integer>& periods) {
    constexpr int points = 64;
    const motion m = motion::of_energy(at.value);
    const rounded_clock<T> rounded(m);
    const timeline<T> typed(m);
    table_rows rows;
    for (const bool wide : {true, false}) {
        for (const integer& count : periods) {
            const long before_point = static_cast<long>(count.str().size());
            const auto worst = resolved(scalar.digits, 2 * before_point + 40, [&] {
                const mpfr error = wide ? clock_error<T>(at.value, typed, count, points)
                                        : clock_error<T>(at.value, rounded, count, points);
                return std::vector<judged>{{error, error, error, false}};
            });
            const precision_scope scope(scalar.digits * 2 + guard_digits);
            const mpfr& error = worst.front().error;
            const mpfr bound = rounded_clock_bound<T>(at.value, count);
            rows.push_back({at.energy, scalar.name(), wide ? "exact" : "fmod", count.str(),
                            to_decimal(error, scalar.digits), wide ? "" : to_decimal(bound, scalar.digits),
                            log10_text(from_rational<mpfr>(rational(count))), log10_text(error),
                            wide ? "" : log10_text(bound)});
        }
    }
    return rows;
}

std::vector<study_table> run(const study_request& request) {
    require_period(request.energies);
    const std::vector<scalar_spec> scalars{read_scalar("double"), read_scalar("long-double"), read_scalar("quad")};
    const std::size_t rules = request.period_rules.size();
    const std::size_t each = rules + scalars.size();
    progress shown("all_time, ways at energies", request.energies.size() * each, request.shown);
    const auto parts = parallel_map(request.energies.size() * each, request.jobs, shown, [&](std::size_t i) {
        const sweep_energy& at = request.energies[i / each];
        if (i % each < rules) {
            return folding_rows(at, request.period_rules[i % each], request.periods);
        }
        switch (scalars[i % each - rules].kind) {
            case scalar_kind::binary64: return reduction_rows<double>(at, scalars[0], request.periods);
            case scalar_kind::extended: return reduction_rows<long double>(at, scalars[1], request.periods);
            default: return reduction_rows<quad>(at, scalars[2], request.periods);
        }
    });
    std::vector<study_table> tables{{"", read_scalar("mpfr:40"), {folding_columns(), {}}},
                                    {"reduction", read_scalar("quad"), {reduction_columns(), {}}}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto& rows = tables[i % each < rules ? 0 : 1].data.rows;
        rows.insert(rows.end(), parts[i].begin(), parts[i].end());
    }
    return tables;
}

}  // namespace
}  // namespace all_time_study

const study& all_time() {
    using namespace all_time_study;
    static const study result{
        .name = "all_time",
        .title = "The accuracy of the period at late times",
        .label = "",
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
        .parameters = {{"--energies", "0.5,1.71,1.9998,2.02,4", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--periods", "1,10,1e2,1e3,1e4,1e5,1e6,1e7,1e8,1e9",
                        "p, whole periods before the one looked at"},
                       {"--period-by", "series:40,resummed:10,resummed:40,resummed:200", "ways to T*"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--periods", "1,1e6", ""}, {"--period-by", "resummed:10", ""}},
        .seconds = 2.5,
        .run = run};
    return result;
}

}  // namespace libration::studies
