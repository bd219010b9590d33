// About which point of the way from the top to the bottom should the series be expanded? [paper sec:sing]
#include "sweep/study.hpp"

#include <algorithm>
#include <utility>

#include "libration/pendulum/error/descent_cover.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"

namespace libration::studies {

namespace expansion_point_study {
namespace {

using rows = std::vector<std::vector<std::string>>;

constexpr long guard_digits = 15;
constexpr long digits_of_norms = 12;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
        {"radius", "radius of convergence R about it, dimensionless time"},
        {"tstar", "T*, dimensionless"},
        {"covers", "whether the circle of convergence holds both ends of [0, T*]: yes | boundary | no"},
        {"rate", "max(x, 1-x) T*/R: factor of the error on [0, T*] a power, by theory"},
        {"measured_rate", "the same from the norms of the first and the last order; empty with one order"},
        {"height", "K~', imaginary part of the nearest singularity, dimensionless time"},
        {"scalar", "arithmetic of radius, rate and series"},
        {"gap", "2 - E"},
    };
    return all;
}

const std::vector<column>& norm_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
        {"order", "N, last power of the series about the point"},
        {"norm", "max of |series - theta| over [0, T*], radians"},
        {"log10_norm", "log10 of norm"},
    };
    return all;
}

std::string covers_text(int sign) { return sign > 0 ? "yes" : sign == 0 ? "boundary" : "no"; }

// (norm_b/norm_a)^(1/(b-a)) of the first and the last order.
std::string measured_rate(const std::vector<int>& orders, const std::vector<mpfr>& norms) {
    const int apart = orders.back() - orders.front();
    if (apart == 0 || norms.front() == 0 || norms.back() == 0) {
        return "";
    }
    return to_decimal(mpfr(pow(mpfr(norms.back() / norms.front()), mpfr(1) / apart)), digits_of_norms);
}

// Digits that the smallest norm of one energy lies below theta.
long digits_below(const motion& m, const std::vector<exact>& points, int order) {
    long below = 0;
    for (const exact& point : points) {
        below = std::max(below, cover_digits_below(m, point.coefficient, order));
    }
    return below;
}

// Both tables of one energy.
std::pair<rows, rows> rows_at(const sweep_energy& at, const std::vector<exact>& points, const std::vector<int>& orders,
                              const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const long below = digits_below(m, points, orders.back());
    const precision_scope scope(std::max(scalar.digits, digits_of_norms) + below + guard_digits);
    cover_errors errors(m);
    std::pair<rows, rows> all;
    for (const exact& point : points) {
        const rational& x = point.coefficient;
        with_scalar(scalar, below + guard_digits, [&]<class T>() {
            const auto cover = cover_from<T>(m, x);
            std::vector<mpfr> norms;
            norms.reserve(orders.size());
            for (const int order : orders) {
                if constexpr (fixed_scalar<T>) {
                    norms.push_back(errors.norm_in<T>(x, order));
                } else {
                    norms.push_back(errors.norm(x, order).norm);
                }
                all.second.push_back({at.energy, point.text, std::to_string(order),
                                      to_decimal(norms.back(), digits_of_norms), log10_text(norms.back())});
            }
            const auto text = [&](const T& value) { return to_decimal(value, scalar.digits); };
            all.first.push_back({at.energy, point.text, text(cover.radius), text(cover.effective_period),
                                 covers_text(cover.covers), text(cover.rate), measured_rate(orders, norms),
                                 text(cover.height), scalar.name(), at.gap});
        });
    }
    return all;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "theta is constant and every radius infinite", "T* is infinite");
    std::vector<int> orders = request.orders;
    std::sort(orders.begin(), orders.end());
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    progress shown("expansion_point, energies", request.energies.size(), request.shown);
    const auto found = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(request.energies[i], request.points, orders, scalar);
    });
    study_table covers{"", scalar, {columns(), {}}};
    study_table norms{"norms", scalar, {norm_columns(), {}}};
    for (const auto& [cover_rows, norm_rows] : found) {
        covers.data.rows.insert(covers.data.rows.end(), cover_rows.begin(), cover_rows.end());
        norms.data.rows.insert(norms.data.rows.end(), norm_rows.begin(), norm_rows.end());
    }
    return {std::move(covers), std::move(norms)};
}

}  // namespace
}  // namespace expansion_point_study

const study& expansion_point() {
    using namespace expansion_point_study;
    static const study result{
        .name = "expansion_point",
        .title = "Where to expand",
        .label = "",
        .question = "About which point of the way from the top to the bottom should the series be expanded?",
        .reading =
            "Left: the radius of convergence in units of T*. It is largest about the top, as the paper says, at every "
            "energy, and from there alone is it always above 1. Right: the factor by which one more power reduces the "
            "error on the whole way [0, T*]; lines are theory, max(x, 1-x) T*/R, and marks are measured from norms of "
            "two orders (the 1/N in the coefficients lowers them by two hundredths). A rate above 1 diverges: about "
            "the bottom for 1 < E < 4, and not for every E < 2. The second figure shows the same rate over the "
            "expansion point: the best is half way at every energy, so the top is optimal in its radius and not in "
            "what it costs to cover the way; what speaks for the top is that half of its coefficients vanish.",
        .parameters = {{"--energies", "0.05:1.95:39,2.02,2.1:3:10,3.25:8:20", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0,1/4,1/2,3/4,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "40,160", "N, last powers between which the rate is measured"},
                       {"--scalar", "mpfr:40", "arithmetic of radius, rate and series"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "6,12", ""}, {"--points", "0,1", ""}},
        .seconds = 3,
        .run = run};
    return result;
}

}  // namespace libration::studies
