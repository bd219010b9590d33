// Proved error norms on the way from the top to the bottom: of the series and of its resummation, max |theta - p| on
// [0, T*], p a polynomial in x = t/T*.
//
// [0, 1] is cut into K = ceil(2 T*/K~') panels. On each, theta is its Taylor polynomial about the middle s0 of the panel
// with the tail of theorem A, which holds about every point: |a_j| <= (2/j) r^(4-j) S4 for j >= 4 and any r <= R(s0). Here
// r = K~', the distance of the rows of poles, and with the half width d = T*/(2K) of a panel d/r <= 1/4, whatever the energy.
//
// S4 = sum |t_s - s0|^-4 over the poles. Those of one column at the distance a, t_s - s0 = a +- i (2q+1) K~', sum to
//     2 sum_q ((2q+1) K~')^-4 = pi^4/(48 K~'^4)                  at any a, and for a > 0, by a^2 + b^2 >= 2ab, to at most
//     2 sum_q (2 a (2q+1) K~')^-2 = pi^2/(16 a^2 K~'^2).
// For s0 in [0, T*] the nearest column is granted the first; the others are, on its side, at least 2p T* away and on the
// other side (2p+1) T*; sum_{p>=1} (2p)^-2 + sum_{p>=0} (2p+1)^-2 = pi^2/6. Hence
//     S4 <= pi^4/(48 K~'^4) + pi^4/(96 T*^2 K~'^2).
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "libration/approximant/proved_maximum.hpp"
#include "libration/pendulum/error_norm.hpp"

namespace libration {

/// The bound of S4 K~'^4 for every point of [0, T*], given T*/K~'.
template <scalar T>
T pole_sum_bound(const T& step) {
    const T half_turn_squared = pi<T>() * pi<T>();
    return half_turn_squared * half_turn_squared * (T(1) / 48 + 1 / (step * step * 96));
}

/// theta of a canonical motion on [0, T*] in panels, for any number of norms, at the working precision in force: it has to
/// hold the wanted digits of a norm below theta, digits_below() and some more.
class proved_descent_errors {
public:
    /// The motion of energy E from the top (clockwise rotation: its mirror image, which has the same norms). O(K bits^2).
    /// Throws std::domain_error for E = 0 and 2, precision_exhausted.
    explicit proved_descent_errors(const rational& energy)
        : motion_(motion::of_energy(energy)), descent_(descent_of<ball>(motion_)) {
        const ball height = singularity_height(descent_.o);
        const ball panels = descent_.effective_period * 2 / height;
        count_ = static_cast<int>(nearest_integer(upper_bound(panels)) + 1);
        const ball step = descent_.effective_period / height;
        order_ = digits<ball>() / 2 + 8;
        ratio_ = step / (2 * count_);
        scale_ = pole_sum_bound(step) * 2 / (order_ + 1);
        add_truth();
    }

    /// T*.
    const ball& effective_period() const { return descent_.effective_period; }

    /// The norm of order N, and the fraction of T* where it is attained. O(K N^2) and the search. Throws
    /// precision_exhausted where the working precision is too low, std::invalid_argument for N < 0.
    proved_maximum norm(descent_method method, int order) const {
        const power_series<ball> a = descent_series(descent_, order);
        return norm_of(method == descent_method::series ? a : endpoint_corrected(a, descent_endpoint(descent_)));
    }

    /// The norm of any polynomial in x = t/T*.
    proved_maximum norm_of(const power_series<ball>& polynomial) const {
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
    rational middle_of(int panel) const { return {2 * panel + 1, 2 * count_}; }

    void add_truth() {
        const exact_solution<ball> solution(motion_);
        const ball half = descent_.effective_period / (2 * count_);
        truth_.reserve(static_cast<std::size_t>(count_));
        for (int i = 0; i < count_; ++i) {
            const phase<ball> place = phase_from_top<ball>(motion_, middle_of(i), descent_.effective_period);
            truth_.push_back(taylor_coefficients(start_at(solution, place), order_, half));
        }
    }

    // theta - p on a panel; beyond the order of theta's polynomial p stands against the bound of theta's tail.
    enclosed_panel difference(int panel, const power_series<ball>& p) const {
        power_series<ball> kept = truth_[static_cast<std::size_t>(panel)];
        for (int n = kept.order() + 1; n <= p.order(); ++n) {
            kept.push_back(enclose(ball(0), ball(scale_ * pow(ratio_, n))));
        }
        for (int n = 0; n <= p.order(); ++n) {
            kept[n] -= p[n];
        }
        return {std::move(kept), scale_, ratio_, rational(panel, count_), rational(panel + 1, count_)};
    }

    motion motion_;
    descent<ball> descent_;
    int count_;   ///< K
    int order_;   ///< of theta's polynomials
    ball ratio_;  ///< d/K~'
    ball scale_;  ///< |a_j| d^j <= scale ratio^j from j = order + 1 on
    std::vector<power_series<ball>> truth_;
};

}  // namespace libration
