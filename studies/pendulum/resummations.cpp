// How do the resummations compare at the same number of coefficients, and which remain accurate near the separatrix?
#include <algorithm>
#include <optional>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/pendulum/arc_approximations.hpp"

namespace libration::studies {

namespace resummations_study {

using namespace series;
using namespace pendulum;
using pendulum::approximation;

namespace {

constexpr long printed_digits = 12;

// The norm of one approximation with one number of coefficients.
struct resummation_row {
    const sweep_energy& at;
    approximation by;
    int count;
    approximation_size size;
    std::optional<mpfr> norm;  // std::nullopt if there is a pole
    mpfr time;
    bool two_method;
    std::optional<mpfr> bound, rate;
};

const column_list<resummation_row>& columns() {
    using row = resummation_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        gap_column<row>(),
        {"method", "series | resummed | resummed_4 | resummed_8 | two_point | pade | uniform",
         [](const row& r) { return name_of(r.by); }},
        {"count",
         "numbers not 0 by symmetry that multiply powers of t: coefficients at the top, derivatives at the bottom",
         [](const row& r) { return r.count; }},
        {"order", "N, last power of the series at the top", [](const row& r) { return r.size.order; }},
        {"conditions", "m, value and derivatives taken at the bottom", [](const row& r) { return r.size.conditions; }},
        {"norm", "max of |approximation - theta| over [0, T*], radians; inf where a Pade approximant has a pole there",
         [](const row& r) { return r.norm ? decimal_cell(*r.norm, printed_digits) : number_cell("inf"); }},
        {"time_of_maximum", "dimensionless time since the top, of the first pole where there is one",
         [](const row& r) { return decimal_cell(r.time, printed_digits); }},
        {"rigour",
         "two-method: confirmed by the sum over separatrix solutions | heuristic, as the signs are that show a pole",
         [](const row& r) { return r.two_method ? "two-method" : "heuristic"; }},
        {"bound", "theorem A, A2 or its generalisation, or U, radians; empty where none is proved",
         [](const row& r) { return decimal_cell(r.bound, printed_digits); }},
        {"rate", "exact factor of the error a coefficient in the long run; empty where it has no closed form",
         [](const row& r) { return decimal_cell(r.rate, printed_digits); }},
        {"log10_norm", "log10 of norm; empty where it is inf", [](const row& r) { return log10_cell(r.norm); }},
        {"log10_bound", "log10 of bound", [](const row& r) { return log10_cell(r.bound); }},
        {"log10_rate", "log10 of rate", [](const row& r) { return log10_cell(r.rate); }},
        log10_gap_column<row>(),
    });
    return all;
}

// An approximation with this number of coefficients.
struct asked_norm {
    approximation method;
    int count;
};

// The rows of one energy, for each requested norm: one, or none if there is no such approximation. And the least of the
// norms, which determines whether the precision was sufficient.
struct energy_rows {
    std::vector<std::vector<resummation_row>> rows;
    mpfr least;
};

resummation_row row_of(const sweep_energy& at, approximation a, int count, const std::optional<mpfr>& norm,
                       const mpfr& place, bool two_method, const top_bounds<mpfr>& bounds) {
    const approximation_size size = *size_for(a, count, bounds.parity);
    return {at,
            a,
            count,
            size,
            norm,
            mpfr(place * bounds.effective_period),
            two_method,
            pendulum::proved_norm(a, size, bounds),
            convergence_rate(a, bounds)};
}

// The first pole in the interval, as a fraction of T*, for approximations that may have one.
template <class F>
std::optional<mpfr> pole_of(const F& approximation) {
    if constexpr (requires { approximation.first_pole(); }) {
        return approximation.first_pole();
    } else {
        return std::nullopt;
    }
}

energy_rows rows_in(const sweep_energy& at, const std::vector<asked_norm>& asked) {
    const motion m = motion::of_energy(at.value);
    arc_errors errors(m);
    energy_rows result{{}, mpfr(1)};
    for (const auto& [method, count] : asked) {
        auto& rows = result.rows.emplace_back();
        if (!size_for(method, count, errors.bounds().parity)) {
            continue;
        }
        with_approximation(method, m, errors.arc(), count, [&, a = method, n = count](const auto& f) {
            if (const auto pole = pole_of(f)) {
                rows.push_back(row_of(at, a, n, std::nullopt, *pole, false, errors.bounds()));
                return;
            }
            const norm_at<mpfr> found = errors.norm_of(f, 2 * n);
            const mpfr other = errors.second_opinion_of(f, found.place);
            const bool agreed =
                abs(found.norm - other) <= found.norm * pow(mpfr(10), -static_cast<int>(printed_digits));
            rows.push_back(row_of(at, a, n, found.norm, found.place, agreed, errors.bounds()));
            result.least = std::min(result.least, found.norm);
        });
    }
    return result;
}

// At a precision that leaves the least norm its digits, plus the 3/2 digits per degree that the linear system of Pade
// loses.
std::vector<cell_rows> cells_at(const sweep_energy& at, const std::vector<asked_norm>& asked) {
    int most = 0;
    for (const asked_norm& each : asked) {
        most = std::max(most, each.count);
    }
    constexpr long most_digits = 20'000;
    const auto attempt = [&](const precision_run& run) -> std::optional<std::vector<cell_rows>> {
        const auto found = rows_in(at, asked);
        if (!(found.least > pow(mpfr(10), static_cast<int>(2 * printed_digits - run.more)))) {
            return std::nullopt;
        }
        std::vector<cell_rows> cells;
        for (const auto& rows : found.rows) {
            cells.push_back(rows_of({make_table(columns(), rows)}));
        }
        return cells;
    };
    return with_growing_precision({0, 60 + most, most_digits}, "a norm at energy " + at.energy, attempt);
}

// The norms of one energy share its arc.
cell_group group_of(const shared_sweep& sweep, std::size_t i, const std::vector<int>& counts) {
    const sweep_energy& at = sweep->energies[i];
    cell_group group;
    std::vector<asked_norm> all;
    for (const approximation method : all_approximations) {
        for (const int count : counts) {
            all.push_back({method, count});
            group.cells.push_back(with_input(with_input(inputs_of(at), "method", std::string(name_of(method))), "order",
                                             std::to_string(count)));
        }
    }
    group.compute = [sweep, &at, all](const std::vector<std::size_t>& which) {
        std::vector<asked_norm> asked;
        asked.reserve(which.size());
        for (const std::size_t each : which) {
            asked.push_back(all[each]);
        }
        return cells_at(at, asked);
    };
    return group;
}

study_plan plan(const study_request& request) {
    const auto sweep = sweep_of(request);
    const auto counts = numbers_of_coefficients(request);
    return {{head_of("", read_scalar("mpfr:" + std::to_string(printed_digits)), columns())},
            {"energy", "gap", "order"},
            sweep->energies.size(),
            [sweep, counts](std::size_t i) { return group_of(sweep, i, counts); },
            {},
            {}};
}

}  // namespace
}  // namespace resummations_study

const study& resummations() {
    using namespace resummations_study;
    static const study result{
        .name = "resummations",
        .title = "Resummations at the same number of coefficients",
        .question = "How do the resummations compare at the same number of coefficients, and which survive E = 2?",
        .reading =
            "The error norm on [0, T*] against the number of coefficients that are not 0 and belong to powers of t (at "
            "the top, and at the bottom for those that take derivatives there), at an energy of each regime and next "
            "to E = 2; then, at one number of them, against the distance of E from 2. m = 2 is the paper's "
            "resummation, m = 4 and 8 take more derivatives at the bottom, the two-point expansion equally many from "
            "both ends. Dotted are the proved bounds of the series (A), of the paper's resummation (A2) and of the "
            "uniform one (U). Those with a fixed m have the rate (T*/R)^2 a coefficient of the series and gain a power "
            "of their number; all of them, and Pade, lose their rate towards E = 2, and the two-point expansion "
            "diverges where |2-E| < 7.7e-5. Pade approximants with a pole on [0, T*], as many have next to E = 2, have "
            "no norm and are not drawn. The uniform one alone keeps a rate below 1/9 a coefficient. It is not the best "
            "everywhere: for E < 0.23 and E > 17 the two-point expansion has the better rate.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.1,0.5,1.71,4,100", "energies E, in m g l"},
                       {"--gaps", "1e-1:1e-10:10log,-1e-1:-1e-10:10log", "energies as 2 - E"},
                       {"--orders", "2,4,6,8,10,12,16,20,24,28,32", "numbers of nonzero coefficients"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "4,6", ""}},
        .seconds = 6.5,
        .excluded = no_answer_at_limits("theta is constant", "the period is infinite"),
        .plan = plan};
    return result;
}

}  // namespace libration::studies
