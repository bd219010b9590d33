// What becomes of the series about the bottom of the trajectory over one period? [paper fig:series]
#include <algorithm>

#include "libration/pendulum/taylor/bottom_series.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace divergence_study {
namespace {

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of the series about the bottom"},
        {"time", "dimensionless time since the bottom"},
        {"periods", "time over the period T"},
        {"theta", "partial sum, radians"},
        {"theta_exact", "radians, unwrapped"},
        {"error", "|theta - theta_exact|, radians"},
        {"log10_error", "log10 of error; -inf where it is 0"},
        {"log10_abs_theta", "log10 of |theta|; -inf where it is 0"},
        {"gap", "2 - E"},
    };
    return all;
}

const std::vector<column>& radius_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"tstar", "T*, dimensionless time from the bottom to the top"},
        {"radius", "R, radius of convergence about the bottom, dimensionless time"},
        {"period", "T, dimensionless time"},
        {"radius_over_tstar", "R/T*: below 1 for 1 < E < 4 only"},
        {"gap", "2 - E"},
    };
    return all;
}

struct rows_of_energy {
    std::vector<std::vector<std::string>> sums;
    std::vector<std::string> radius;
};

rows_of_energy rows_at(const sweep_energy& at, const study_request& request, const scalar_spec& scalar) {
    const int highest = *std::max_element(request.orders.begin(), request.orders.end());
    const precision_scope scope(scalar.digits + bottom_digits_below(at.value, highest, request.times));
    const bottom_series<mpfr> bottom(at.value, highest);
    rows_of_energy rows;
    rows.radius = {at.energy,
                   to_decimal(bottom.effective_period(), scalar.digits),
                   to_decimal(bottom.radius(), scalar.digits),
                   to_decimal(bottom.period(), scalar.digits),
                   to_decimal(mpfr(bottom.radius() / bottom.effective_period()), scalar.digits),
                   at.gap};
    std::vector<mpfr> times;
    std::vector<mpfr> truth;
    times.reserve(request.times.size());
    truth.reserve(request.times.size());
    rows.sums.reserve(request.times.size() * request.orders.size());
    for (const exact& time : request.times) {
        times.push_back(bottom.dimensionless(time));
        truth.push_back(bottom.theta(time));
    }
    for (const int order : request.orders) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            const mpfr theta = bottom.partial_sum(order, times[i]);
            // At the bottom itself the sum is exact, and so is its error.
            const mpfr error = request.times[i].is_zero() ? mpfr(0) : mpfr(abs(theta - truth[i]));
            rows.sums.push_back({at.energy, std::to_string(order), to_decimal(times[i], scalar.digits),
                                 to_decimal(mpfr(times[i] / bottom.period()), scalar.digits),
                                 to_decimal(theta, scalar.digits), to_decimal(truth[i], scalar.digits),
                                 to_decimal(error, scalar.digits), log10_text(error), log10_text(theta), at.gap});
        }
    }
    return rows;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "the series is the constant 0", "the period is infinite");
    const scalar_spec scalar{scalar_kind::arbitrary, *std::max_element(request.digits.begin(), request.digits.end())};
    progress shown("divergence, energies", request.energies.size(), request.shown);
    const auto found = parallel_map(request.energies.size(), request.jobs, shown,
                                    [&](std::size_t i) { return rows_at(request.energies[i], request, scalar); });
    study_table sums{"", scalar, {columns(), {}}};
    study_table radius{"radius", scalar, {radius_columns(), {}}};
    for (const rows_of_energy& rows : found) {
        sums.data.rows.insert(sums.data.rows.end(), rows.sums.begin(), rows.sums.end());
        radius.data.rows.push_back(rows.radius);
    }
    return {std::move(sums), std::move(radius)};
}

}  // namespace
}  // namespace divergence_study

const study& divergence() {
    using namespace divergence_study;
    static const study result{
        .name = "divergence",
        .title = "Divergence of the series about the bottom",
        .label = "fig:series",
        .question = "How far does the series about the bottom of the trajectory reach before it diverges?",
        .reading =
            "Above: the exact angle (circles) over one period from the bottom and the partial sums of its Taylor "
            "series "
            "there (dashed); below: their error. The vertical lines mark the radius of convergence R and the effective "
            "period T*, when the pendulum is at the top. Left of R more terms are better, right of it they are worse, "
            "and at these energies R is less than T*: no number of terms reaches the top. Libration leaves the bottom "
            "with omega < 0, as the motion released at +theta_max does, rotation counterclockwise at theta = 2 pi. "
            "R is less than T* only for 1 < E < 4, not for all E < 2 as the paper says: at E = 1 and 4 they are equal.",
        .parameters = {{"--energies", "1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "10,100,1000", "N, last power of the series"},
                       {"--times", "0:T:401", "dimensionless times since the bottom"},
                       {"--digits", "40", "digits of every number; of a list the largest"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "10,40", ""}, {"--times", "0:T:9", ""}},
        .seconds = 2.5,
        .run = run};
    return result;
}

}  // namespace libration::studies
