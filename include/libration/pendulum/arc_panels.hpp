// theta between the top and the bottom at many points: short Taylor polynomials about the middles of panels, so that a
// value costs a few dozen products instead of a Jacobi function.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "libration/pendulum/period.hpp"
#include "libration/pendulum/resummation.hpp"

namespace libration::pendulum {

/// theta of the canonical motion and its slope d theta/dx at x = t/T*, at the current working precision.
///
/// [0, 1] is cut into K >= 16 T*/K~' panels. Every singularity is at least R >= K~' away from a middle, so that with
/// the half width d = T*/(2K) a power of theta decreases by d/R <= 1/32, 5 bits: |a_n| d^n is about (8/n) (d/R)^n, and
/// the number of powers is that of the bits over 5, plus 2 for the factor n of the slope. A panel is expanded if enough
/// points are requested in it; elsewhere Jacobi's functions are used. Not for several threads at once.
class arc_panels {
public:
    /// Cost of a panel: a Jacobi function and O(bits^2) products, once.
    explicit arc_panels(const fundamental_arc<mpfr>& arc)
        : arc_(arc), solution_(arc.of()), mirrored_(mirrors(arc.of())) {
        const mpfr panels = arc.effective_period() * 16 / singularity_height(arc.level());
        count_ = static_cast<long>(nearest_integer(panels)) + 1;
    }

    /// theta and its slope at increasing points of [0, 1]. Errors of a few epsilon in theta, relative to max(1,
    /// |theta|).
    std::vector<series::jet<mpfr>> jets(const std::vector<double>& points) {
        return each<series::jet<mpfr>>(points, [this](const mpfr& x) { return at(x); });
    }

    /// theta alone: that of jets() at half the cost.
    std::vector<mpfr> values(const std::vector<double>& points) {
        return each<mpfr>(points, [this](const mpfr& x) {
            const auto panel = expanded_.find(panel_of(x));
            return panel == expanded_.end() ? at(x).value : evaluate_value(panel->second, step_in(panel->first, x));
        });
    }

    /// jets() at one point, by its panel if that is expanded.
    series::jet<mpfr> at(const mpfr& x) const {
        const auto panel = expanded_.find(panel_of(x));
        if (panel == expanded_.end()) {
            const auto state = solution_.from_top(x);
            return {canonical(state.theta), state.omega * mirrored_ * arc_.effective_period()};
        }
        series::jet<mpfr> jet = evaluate(panel->second, step_in(panel->first, x));
        jet.slope *= 2 * count_;
        return jet;
    }

    /// theta of the canonical motion from that of a motion in any well and direction.
    mpfr canonical(const mpfr& theta) const {
        mpfr own = theta - whole_turns<mpfr>(solution_.of().turns());
        if (mirrored_ > 0) {
            return own;
        }
        return pi<mpfr>() * 2 - own;
    }

private:
    static constexpr long worth = 3;  ///< points that cost as much by Jacobi's functions as a panel

    static int mirrors(const motion& m) { return m.regime() == regime::rotation ? m.direction() : 1; }

    template <class X>
    long panel_of(const X& x) const {
        const auto panel = static_cast<long>(x * X(count_));
        return panel < count_ ? panel : count_ - 1;
    }

    // From the middle of a panel, in half widths.
    mpfr step_in(long panel, const mpfr& x) const { return x * (2 * count_) - (2 * panel + 1); }

    template <class Value, class F>
    std::vector<Value> each(const std::vector<double>& points, const F& value) {
        std::map<long, long> asked;
        for (const double x : points) {
            if (++asked[panel_of(x)] == worth) {
                expand(panel_of(x));
            }
        }
        std::vector<Value> values;
        values.reserve(points.size());
        for (const double x : points) {
            values.push_back(value(mpfr(x)));
        }
        return values;
    }

    // theta about the middle of a panel, in units of its half width.
    void expand(long panel) {
        if (expanded_.contains(panel)) {
            return;
        }
        const rational middle(2 * panel + 1, 2 * count_);
        const phase<mpfr> place = phase_from_top<mpfr>(solution_.of(), middle, arc_.effective_period());
        const mpfr half = arc_.effective_period() / (2 * count_);
        auto theta = taylor_coefficients(start_at(solution_, place), digits<mpfr>() / 5 + 2, half);
        theta[0] = canonical(theta[0]);
        for (int n = 1; mirrored_ < 0 && n <= theta.order(); ++n) {
            theta[n] = -theta[n];
        }
        expanded_.emplace(panel, std::move(theta));
    }

    fundamental_arc<mpfr> arc_;
    exact_solution<mpfr> solution_;
    int mirrored_;
    long count_ = 0;  ///< K
    std::map<long, series::power_series<mpfr>> expanded_;
};

}  // namespace libration::pendulum
