// The errors of sigma_N and theta_N on [0, T*] from their omitted terms, for all N downwards from a high order: there
// is no cancellation against theta, so a fixed scalar resolves errors far below its epsilon.
//
// With x = t/T* and a_n scaled likewise, T_N(x) = sum_{n>N} a_n x^(n-N-1) obeys T_{N-1} = a_N + x T_N, and
//     theta - sigma_N = x^(N+1) T_N(x),
//     theta - theta_N = x^(N+1) [T_N(x) - T_N(1) - (x-1) T_N'(1)],
// because theta_N subtracts the polynomial that has the value and the slope of the rest at x = 1. From N + 1 to N
//     theta - sigma_N = theta - sigma_{N+1} + a_{N+1} x^(N+1),
//     theta - theta_N = theta - theta_{N+1} + x^(N+1) (1-x)^2 T_{N+1}'(1),
// which bounds the growth of the largest error.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "libration/pendulum/error_norm.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The errors at points 0 < x <= 1. Starts at the order of the series, where no term is omitted, and steps down.
template <fixed_scalar T>
class arc_tails {
public:
    /// a: a_n T*^n. Throws error for a point outside (0, 1].
    arc_tails(std::vector<T> a, const std::vector<double>& points)
        : a_(std::move(a)), order_(static_cast<int>(a_.size()) - 1) {
        for (const double x : points) {
            if (!(x > 0 && x <= 1)) {
                throw error(error_kind::argument, error_subject::point, "", "is outside (0, 1]");
            }
            places_.push_back({T(x), T(0)});
        }
        at_end_.resize(a_.size());
        for (auto n = a_.size() - 1; n > 0; --n) {
            at_end_[n - 1] = {at_end_[n].value + a_[n], at_end_[n].slope + at_end_[n].value};
        }
    }

    int order() const { return order_; }

    /// From N to a lower order. O(points) for each step.
    void step_down_to(int order) {
        for (place& p : places_) {
            T tail = p.tail;
            for (int n = order_; n > order; --n) {
                tail = tail * p.x + a_[static_cast<std::size_t>(n)];
            }
            p.tail = tail;
        }
        order_ = order;
    }

    /// |error| at each point, into a vector of their number. An underflow of x^N is harmless: the error there is as
    /// far below the norm. O(points).
    void errors(arc_method method, std::vector<T>& result) const {
        using std::abs;
        using std::pow;
        const bool resummed = method == arc_method::resummed;
        const value_and_slope& end = at_end_[static_cast<std::size_t>(order_)];
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const place& p = places_[i];
            const T part = resummed ? T(p.tail - end.value - (p.x - 1) * end.slope) : p.tail;
            result[i] = abs(pow(p.x, order_ + 1) * part);
        }
    }

    /// An upper bound of the growth of the largest |error| from N + 1 to N: |a_{N+1}|, and |T_{N+1}'(1)| times the
    /// largest x^(N+1) (1-x)^2, which is at x = (N+1)/(N+3). O(1).
    T growth(arc_method method, int order) const {
        using std::abs;
        using std::pow;
        const auto above = static_cast<std::size_t>(order) + 1;
        if (method == arc_method::series) {
            return abs(a_[above]);
        }
        const T apart = T(2) / (order + 3);
        return pow(1 - apart, order + 1) * apart * apart * abs(at_end_[above].slope);
    }

private:
    struct place {
        T x;
        T tail;  ///< T_N(x)
    };
    // T_N and T_N' at x = 1.
    struct value_and_slope {
        T value = T(0);
        T slope = T(0);
    };

    std::vector<T> a_;
    int order_;
    std::vector<place> places_;
    std::vector<value_and_slope> at_end_;  ///< by N
};

}  // namespace libration::pendulum
