// The errors of sigma_N and theta_N on [0, T*] from the terms that they leave out, for all N on the way down from a
// high one: no cancellation against theta, so a fixed scalar sees errors far below its epsilon.
//
// With x = t/T* and a_n scaled likewise, T_N(x) = sum_{n>N} a_n x^(n-N-1) obeys T_{N-1} = a_N + x T_N, and
//     theta - sigma_N = x^(N+1) T_N(x),
//     theta - theta_N = x^(N+1) [T_N(x) - T_N(1) - (x-1) T_N'(1)],
// because theta_N takes off the polynomial that has the value and the slope of the rest at x = 1.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/pendulum/error/error_norm.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The errors at points 0 < x <= 1. Starts at the order of the series, where nothing is left out, and steps down.
template <fixed_scalar T>
class arc_tails {
public:
    /// a: a_n T*^n. Throws error for a point outside (0, 1].
    arc_tails(std::vector<T> a, const std::vector<double>& points)
        : a_(std::move(a)), order_(static_cast<int>(a_.size()) - 1) {
        using std::pow;
        places_.reserve(points.size());
        for (const double x : points) {
            if (!(x > 0 && x <= 1)) {
                throw error(error_kind::argument, "point", "", "is outside (0, 1]");
            }
            places_.push_back({T(x), 1 / T(x), pow(T(x), order_ + 1), T(0)});
        }
    }

    int order() const { return order_; }

    /// From N to N - 1. O(points). An underflow of x^N is of no account: the error there is as far below the norm.
    void step_down() {
        const T& next = a_[static_cast<std::size_t>(order_)];
        slope_at_end_ += value_at_end_;
        value_at_end_ += next;
        for (place& p : places_) {
            p.tail = p.tail * p.x + next;
            p.power *= p.inverse;
        }
        --order_;
    }

    /// |error| at each point, into a vector of their number.
    void errors(arc_method method, std::vector<T>& result) const {
        using std::abs;
        const bool resummed = method == arc_method::resummed;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const place& p = places_[i];
            const T part = resummed ? T(p.tail - value_at_end_ - (p.x - 1) * slope_at_end_) : p.tail;
            result[i] = abs(p.power * part);
        }
    }

private:
    struct place {
        T x;
        T inverse;
        T power;  ///< x^(N+1)
        T tail;   ///< T_N(x)
    };

    std::vector<T> a_;
    int order_;
    std::vector<place> places_;
    T value_at_end_ = T(0);  ///< T_N(1)
    T slope_at_end_ = T(0);  ///< T_N'(1)
};

}  // namespace libration::pendulum
