// A function on a piece of an interval, enclosed with its first two derivatives: a polynomial with a bounded tail.
#pragma once

#include <algorithm>
#include <utility>

#include "libration/scalar/ball/ball.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration {

/// Enclosures of a function and of its first two derivatives.
struct enclosed_two_jet {
    ball value;
    ball slope;
    ball curvature;
};

/// A function of s in [-1, 1], which maps to the interval [from, to] of the caller's variable: a polynomial with a tail
/// whose coefficients satisfy |c_j| <= scale ratio^j for every j > J, the order of the polynomial.
class enclosed_panel {
public:
    /// Throws precision_exhausted if ratio < 1 cannot be proved.
    enclosed_panel(series::power_series<ball> kept, const ball& scale, const ball& ratio, rational from, rational to)
        : kept_(std::move(kept)), from_(std::move(from)), to_(std::move(to)) {
        require_below(ratio, ball(1), "the rate of a tail");
        // With n = J + 1: sum_{j>=n} q^j = q^n/(1-q), sum j q^j <= n q^n/(1-q)^2, sum j(j-1) q^j <= n(n-1) q^n/(1-q)^3,
        // because n + i <= n (1 + i) and (n+i)(n+i-1) <= n(n-1) (i+1)(i+2)/2 for n >= 2.
        const long n = std::max(2, kept_.order() + 1);
        const ball gap = 1 - ratio;
        tail_.value = scale * pow(ratio, kept_.order() + 1) / gap;
        tail_.slope = tail_.value * n / gap;
        tail_.curvature = tail_.slope * (n - 1) / gap;
    }

    int order() const { return kept_.order(); }

    /// On a ball of s, for those of its points that are in [-1, 1].
    enclosed_two_jet at(const ball& s) const {
        enclosed_two_jet sum{kept_[kept_.order()], ball(), ball()};
        for (int n = kept_.order() - 1; n >= 0; --n) {
            horner_step(sum.curvature, s, sum.slope);
            horner_step(sum.slope, s, sum.value);
            horner_step(sum.value, s, kept_[n]);
        }
        sum.curvature *= 2;
        return {with_tail(sum.value), slope_with_tail(sum.slope), enclose(sum.curvature, tail_.curvature)};
    }

    /// at() without the second derivative.
    series::jet<ball> jet_at(const ball& s) const {
        const series::jet<ball> sum = evaluate(kept_, s);
        return {with_tail(sum.value), slope_with_tail(sum.slope)};
    }

    /// The value alone.
    ball value_at(const ball& s) const { return with_tail(evaluate_value(kept_, s)); }

    /// The same function with its coefficients rounded to the working precision: wider enclosures at lower cost.
    enclosed_panel rounded() const {
        enclosed_panel result = *this;
        for (int n = 0; n <= kept_.order(); ++n) {
            result.kept_[n] = narrow<ball>(kept_[n]);
        }
        return result;
    }

    /// The caller's variable at s.
    ball place_of(const ball& s) const {
        return from_rational<ball>(rational((from_ + to_) / 2)) + s * from_rational<ball>(rational((to_ - from_) / 2));
    }

private:
    ball with_tail(const ball& sum) const { return enclose(sum, tail_.value); }
    ball slope_with_tail(const ball& sum) const { return enclose(sum, tail_.slope); }

    series::power_series<ball> kept_;
    rational from_;
    rational to_;
    enclosed_two_jet tail_;
};

}  // namespace libration
