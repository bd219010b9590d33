// One Taylor expansion for the entire arc from the top to the bottom: which expansion point is best?
//
// About the time x T* after the top the nearest singularity is ((1-x) T*, K~') away, and the far end of [0, T*] is
// max(x, 1-x) T* away, so that the error there decreases at the rate per power
//     rate(x) = max(x, 1-x) T*/R(x),   R(x)^2 = (1-x)^2 T*^2 + K~'^2.
// R decreases from the top (x = 0) to the bottom (x = 1); but the rate decreases with x up to 1/2, where 1/rate^2 =
// 1 + (K~'/((1-x) T*))^2, and increases after it: at every energy the midpoint is the best expansion point, and the top
// is the best only in its radius.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "libration/approximant/difference_norm.hpp"
#include "libration/approximant/truncated_series.hpp"
#include "libration/pendulum/expansion.hpp"

namespace libration::pendulum {

/// The expansion about x T* after the top compared with [0, T*].
template <scalar T>
struct expansion_coverage {
    T effective_period;  ///< T*
    T height;            ///< K~'
    phase<T> place;      ///< of the expansion point
    T radius;            ///< R(x)
    T reach;             ///< max(x, 1-x) T*
    T convergence_rate;  ///< reach/R(x)
    int covers;          ///< sign of R(x) - reach: 1 if the disc of convergence contains [0, T*], 0 if it ends there
};

/// The sign of R(x) - max(x, 1-x) T*, that is of K~'^2 - (2x-1) T*^2. At the bottom it is that of 1 - E or E - 4,
/// exactly; up to x = 1/2 it is 1; between them the values of T are taken as exact.
template <rounding_scalar T>
int coverage_sign(const motion& m, const rational& x, const singularity_lattice<T>& lattice) {
    const rational beyond_half = x * 2 - 1;
    if (beyond_half <= 0) {
        return 1;
    }
    if (x == 1 && m.energy()) {
        const rational difference = m.regime() == regime::rotation ? *m.energy() - 4 : 1 - *m.energy();
        return difference.sign();
    }
    const T along = from_rational<T>(beyond_half) * lattice.effective_period * lattice.effective_period;
    return decided_sign(widen(T(lattice.height * lattice.height - along)));
}

/// The coverage about a fraction x of T*, 0 <= x <= 1. A few units in the last place. Throws error at
/// E = 0 and 2.
template <rounding_scalar T>
expansion_coverage<T> coverage_from(const motion& m, const rational& x) {
    const energy_level<T> o = energy_level_of<T>(m);
    const singularity_lattice<T> lattice{effective_period(o), singularity_height(o)};
    const phase<T> place = phase_from_top<T>(m, x, lattice.effective_period);
    const T radius = lattice.radius(place);
    const T reach = from_rational<T>(std::max(x, rational(1 - x))) * lattice.effective_period;
    return {lattice.effective_period,    lattice.height, place, radius, reach, reach / radius,
            coverage_sign(m, x, lattice)};
}

/// Decimal digits by which the error of order N is below theta, from its rate, and a few for the constants: the digits
/// that a computation must carry in addition to those wanted in a norm.
inline long coverage_digits_below(const motion& m, const rational& x, int order) {
    const precision_scope scope(20);
    const mpfr gained = -log10(coverage_from<mpfr>(m, x).convergence_rate) * (order + 2) + log10(mpfr(order + 1));
    return 8 + std::max(0L, static_cast<long>(nearest_integer(gained)));
}

/// The norms on [0, T*] of |sigma_N - theta|, sigma_N about any point of it, for one motion. The current working
/// precision must cover the wanted digits below theta: add coverage_digits_below().
class coverage_errors {
public:
    explicit coverage_errors(const motion& m) : truth_(m) {}

    /// As a true maximum, and the fraction of T* where it is attained.
    norm_at<mpfr> norm(const rational& x, int order) {
        const auto points = chebyshev_points(std::max(65, 2 * order + 11));
        const auto cover = coverage_from<mpfr>(truth_.of(), x);
        const auto sigma = series_about<mpfr>(truth_, cover, order);
        const mpfr middle = from_rational<mpfr>(x);
        const auto approximation = [&](const mpfr& u) {
            const series::jet<mpfr> at = sigma(mpfr((u - middle) * cover.effective_period));
            return series::jet<mpfr>{at.value, at.slope * cover.effective_period};
        };
        const auto exactly = [&](const mpfr& u) { return exact(u, cover.effective_period); };
        const auto& truth = truth_at(points, cover.effective_period);
        std::vector<series::jet<mpfr>> differences;
        differences.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const series::jet<mpfr> at = approximation(mpfr(points[i]));
            differences.push_back({at.value - truth[i].value, at.slope - truth[i].slope});
        }
        return difference_norm<mpfr>(difference(approximation, exactly), points, differences);
    }

    /// The largest error of the same polynomial computed and evaluated in T, over 1001 Chebyshev points.
    template <fixed_scalar T>
    mpfr norm_in(const rational& x, int order) {
        const auto points = chebyshev_points(1001);
        const motion& m = truth_.of();
        const auto cover = coverage_from<T>(m, x);
        const auto sigma = series_about<T>(exact_solution<T>(m), cover, order);
        const auto& truth = truth_at(points, effective_period(energy_level_of<mpfr>(m)));
        mpfr largest(0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const T t = (T(points[i]) - from_rational<T>(x)) * cover.effective_period;
            largest = std::max(largest, mpfr(abs(widen(sigma(t).value) - truth[i].value)));
        }
        return largest;
    }

private:
    template <rounding_scalar T>
    static truncated_series<T> series_about(const exact_solution<T>& solution, const expansion_coverage<T>& cover,
                                            int order) {
        return {taylor_coefficients(start_at(solution, cover.place), order, cover.radius), cover.radius};
    }

    series::jet<mpfr> exact(const mpfr& u, const mpfr& duration) const {
        const auto state = truth_.from_top(u);
        return {state.theta, state.omega * duration};
    }

    const std::vector<series::jet<mpfr>>& truth_at(const std::vector<double>& points, const mpfr& duration) {
        auto& sampled = sampled_[points.size()];
        for (std::size_t i = sampled.size(); i < points.size(); ++i) {
            sampled.push_back(exact(mpfr(points[i]), duration));
        }
        return sampled;
    }

    exact_solution<mpfr> truth_;
    std::map<std::size_t, std::vector<series::jet<mpfr>>> sampled_;
};

}  // namespace libration::pendulum
