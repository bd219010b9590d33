// The control of Newton's method and of the lengths of steps of collocation, in balls and in rounded arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace libration::ode {

/// Decimal logarithms are of corrections relative to the scales of the unknowns.
struct newton_control {
    static constexpr int most_iterations = 40;
    static constexpr int most_factorisations = 6;
    /// Of the gain of an iteration: above this the matrix is factored again, and above `none` it no longer gains.
    static constexpr double gain = -4;
    static constexpr double none = -0.3;
    /// Of a correction that is too large.
    static constexpr double diverged = 6;
};

/// The last Chebyshev coefficients and the decay of the unknowns within a step, as decimal logarithms.
struct step_measure {
    double tail;          ///< of the last coefficients, relative to the scales of their unknowns
    std::size_t reached;  ///< the highest degree of a coefficient above the aim
    double decay = 0;     ///< the largest, of an unknown from beginning to end

    /// A larger decay within a step costs digits of the value at its end.
    static constexpr double largest_decay = 2.4;

    /// Of an unknown with these sizes at the beginning, in the middle and at the end.
    void note_decay(double begin, double middle, double end) {
        if (middle < begin && end < middle) {
            decay = std::max(decay, std::min(begin - end, 3 * (begin - middle)));
        }
    }
    /// The factor by which the length is to change such that coefficients reach 10^-aimed at the degree.
    double factor(double aimed, int degree) const {
        const double by_tail = tail > -aimed ? std::pow(10., (-aimed - tail) / degree)
                                             : std::pow(10., aimed * (1. / static_cast<double>(reached) - 1. / degree));
        return decay > 0 ? std::min(by_tail, largest_decay / decay) : by_tail;
    }
    bool is_acceptable(double accepted) const { return tail <= -accepted && decay <= 2 * largest_decay; }
};

/// The change of the length from step to step.
class length_growth {
public:
    static constexpr int most_rejections = 60;

    void restart() { factor_ = 1; }
    /// After a step whose measure has this factor; the growth of the previous steps continues.
    void accept(double factor) {
        const double safe = safety * factor;
        const double memory = safe > 0.8 ? std::clamp(std::sqrt(factor_), 1., 1.6) : 1.;
        factor_ = std::clamp(safe * memory, 0.3, 3.);
    }
    /// For the next step.
    double factor() const { return factor_; }
    /// For a repetition of a step that was too long.
    static double reduction(double factor) { return std::clamp(safety * factor, 0.15, safety); }

private:
    static constexpr double safety = 0.9;
    double factor_ = 1;
};

}  // namespace libration::ode
