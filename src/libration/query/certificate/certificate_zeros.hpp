// The zeros of a condition along the steps of a certificate, decided as by the program that checks it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../../integration/collocation/ball_polynomial.hpp"
#include "certificate.hpp"
#include "libration/integration/collocation/tube.hpp"
#include "lifted_functions.hpp"

namespace libration::ode {

/// Of a function of the solution on a step: the polynomial on the curve of the tube, in x, a bound of its derivative,
/// and one of the distance from it in the tube.
struct function_on_step {
    ball_polynomial on_curve;
    magnitude slope, reach;
};

/// Intervals of the zeros of a condition g, so narrow that the values there are known as well as at one time, and the
/// signs from which the zeros follow: between the intervals that of g, which alternates, and on each interval that of
/// the derivative of g.
class zeros_on_steps {
public:
    /// The printed times in the order of the steps; the condition and its derivative in the unknowns of the form.
    /// `vanishes` if the condition holds exactly at the initial point, which is not a zero after it. Bounds have so many
    /// bits behind the point.
    zeros_on_steps(const certified_zeros& of, const lifted_functions& form, bool vanishes, long bits);

    /// The next step, which begins at this time: the number of bits that are missing for its part of the proof, 0 if
    /// there are none.
    long lacking_bits_in(const solution_tube& tube, const rational& begin);
    /// The unknowns in the tube of that step at the times of interval k in it; std::nullopt if there are none.
    std::optional<std::vector<ball>> values_at(std::size_t k, const solution_tube& tube);
    /// Whether the step contains the end of the last interval.
    bool complete() const;
    /// The lines of the certificate.
    std::string text() const;

private:
    struct span {
        rational from, to;
    };

    rational place_of(const rational& time) const { return 2 * (time - begin_) / length_ - 1; }
    span places_of(std::size_t k) const;
    span gap_before(std::size_t k) const;
    void follow(const solution_tube& tube);
    long lacking_bits_of_next();
    int sure(const function_on_step& of, const span& in) const;
    int sign(const span& in) const;

    const certified_zeros& of_;
    bool vanishes_;
    long bits_;
    polynomial_map map_;
    std::vector<ball> constants_;
    std::vector<magnitude> constant_bounds_;
    chebyshev_form forms_;
    rational start_, begin_, length_;
    function_on_step function_, derivative_;
    std::vector<decimal_interval> intervals_;  // of the zeros up to the end of the step
    int sign_ = 0;                             // of the condition before the first zero
};

}  // namespace libration::ode
