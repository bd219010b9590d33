// The nodes at which polynomials are bounded.
#pragma once

#include <array>
#include <vector>

#include "ball_polynomial.hpp"

namespace libration::ode {

/// The zeros of T_M, M even, positive ones first: x_(M-1-k) = -x_k.
class chebyshev_zeros {
public:
    /// At least 3/2 as many as the degree, with powers of them up to x^(length - 1).
    chebyshev_zeros(int degree, std::size_t length, long bits);

    int count() const { return count_; }
    /// x_k for k < M/2.
    const ball& place(int k) const { return cosines_[2 * static_cast<std::size_t>(k) + 1]; }
    /// 1/cos(pi m/(2M)) for m = degree.
    magnitude factor(int degree) const;
    /// The values of polynomials in powers of x at place(k) and at -place(k), k < M/2, rounded to so many bits.
    std::array<std::vector<ball>, 2> values(const std::vector<ball_polynomial>& all, int k, long bits) const;
    /// Chebyshev coefficients of the polynomial of this degree, below M, with these values.
    std::vector<ball> coefficients(const std::vector<ball>& at, int degree) const;
    /// T_0, .. , T_degree at all nodes, by rows.
    std::vector<ball> chebyshev_values(int degree) const;

private:
    // cos(pi turns/(2M)).
    const ball& cosine(long turns) const { return cosines_[static_cast<std::size_t>(turns % (4L * count_))]; }

    int count_;
    std::vector<ball> cosines_;
    std::vector<std::vector<ball>> powers_;
};

}  // namespace libration::ode
