// Proved error norms from the top to the bottom: of the series and of its resummation, max |theta - p| on [0, T*], p a
// polynomial in x = t/T*.
//
// [0, 1] is cut into K panels, K > 2 T*/K~'. On each, theta is its Taylor polynomial about the middle of the panel with
// the tail of theorem A1 (singularity_view.hpp): no pole is nearer to it than R, so |a_j| <= (2/j) R^(4-j) S4 for
// j >= 4. The half width d = T*/(2K) of a panel has d/R <= d/K~' < 1/4, whatever the energy, and
//     |a_j| d^j <= scale (d/R)^j for every j > J >= 3, scale = 2 S4 R^4/(J+1).
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "libration/approximant/pade_error.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/singularity_view.hpp"

namespace libration::pendulum {

/// theta of a canonical motion on [0, T*] in panels, for any number of norms, at the current working precision: it must
/// cover the wanted digits of a norm below theta, digits_below() and some more.
class proved_arc_errors {
public:
    /// The motion of energy E from the top (clockwise rotation: its mirror image, which has the same norms), with
    /// polynomials of the order J >= 3, half of the bits unless given. O(K J^2). Throws error for E = 0 and 2 and for
    /// a lower order, precision_exhausted.
    explicit proved_arc_errors(const exact& energy, std::optional<int> order = {})
        : motion_(motion::of_energy(energy)), arc_(arc_of<ball>(motion_)) {
        const singularity_lattice<ball> lattice{arc_.effective_period(), singularity_height(arc_.level())};
        const ball panels = lattice.effective_period * 2 / lattice.height;
        count_ = static_cast<int>(nearest_integer(upper_bound(panels)) + 1);
        order_ = order.value_or(digits<ball>() / 2 + 8);
        if (order_ < 3) {
            throw error(error_kind::argument, "order", std::to_string(order_),
                        "is below 3, the lowest order for theorem A1");
        }
        add_truth(lattice);
    }

    /// T*.
    const ball& effective_period() const { return arc_.effective_period(); }

    /// The norm of order N, and the fraction of T* where it is attained. O(K N^2) and the search. Throws
    /// precision_exhausted if the working precision is too low, error for N < 0.
    proved_maximum norm(arc_method method, int order) const {
        const series::power_series<ball> a = arc_series(arc_, order);
        return norm_of(method == arc_method::series ? a : endpoint_corrected(a, arc_endpoint(arc_)));
    }

    /// The norm of any polynomial in x = t/T*.
    proved_maximum norm_of(const series::power_series<ball>& polynomial) const {
        std::vector<enclosed_panel> panels;
        panels.reserve(truth_.size());
        const ball half = ball(1) / (2 * count_);
        for (int i = 0; i < count_; ++i) {
            const auto own = rescale(about(polynomial, from_rational<ball>(middle_of(i))), half);
            panels.push_back(difference(i, own));
        }
        return largest_magnitude(panels);
    }

private:
    // theta about the middle of a panel, in units of its half width, and the bound of the powers from order + 1 on.
    struct truth_panel {
        series::power_series<ball> theta;
        ball ratio;  ///< d/R
        ball scale;
    };

    rational middle_of(int panel) const { return {2 * panel + 1, 2 * count_}; }

    void add_truth(const singularity_lattice<ball>& lattice) {
        const exact_solution<ball> solution(motion_);
        const ball half = lattice.effective_period / (2 * count_);
        truth_.reserve(static_cast<std::size_t>(count_));
        for (int i = 0; i < count_; ++i) {
            const phase<ball> place = phase_from_top<ball>(motion_, middle_of(i), lattice.effective_period);
            const singularity_view<ball> view(motion_, lattice, place);
            truth_.push_back({taylor_coefficients(start_at(solution, place), order_, half), half / view.radius(),
                              view.fourth_powers() * pow(view.radius(), 4) * 2 / (order_ + 1)});
        }
    }

    // theta - p on a panel; beyond the order of theta's polynomial the terms of p are added to the tail bound.
    enclosed_panel difference(int panel, const series::power_series<ball>& p) const {
        const auto& [theta, ratio, scale] = truth_[static_cast<std::size_t>(panel)];
        series::power_series<ball> kept = theta;
        for (int n = kept.order() + 1; n <= p.order(); ++n) {
            kept.push_back(enclose(ball(0), ball(scale * pow(ratio, n))));
        }
        for (int n = 0; n <= p.order(); ++n) {
            kept[n] -= p[n];
        }
        return {std::move(kept), scale, ratio, rational(panel, count_), rational(panel + 1, count_)};
    }

    motion motion_;
    fundamental_arc<ball> arc_;
    int count_ = 0;  ///< K
    int order_ = 0;  ///< of theta's polynomials, J
    std::vector<truth_panel> truth_;
};

}  // namespace libration::pendulum
