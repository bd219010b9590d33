// The summations of a list with their steps: how much they change with the last coefficients.
#pragma once

#include <vector>

#include "libration/convergence/sum_vote.hpp"
#include "reduced_list.hpp"
#include "summations.hpp"

namespace libration::convergence {

/// A method at one point.
struct candidate {
    sum_kind kind;
    stepped_value sum;
};

/// The candidates at all points of g (reduced_list), from a_0 .. a_n with n = N, N-1, N-2.
class sum_candidates {
public:
    /// Points sorted by modulus. At least five coefficients.
    sum_candidates(const reduced_list& list, const sum_shape& shape, std::vector<mpfr> points, const task_runner& run);

    /// By growing steps: the root mean square of the two changes, at least the error of a quadrature, 10^-51 of the
    /// value, and the change due to the noise of the coefficients. Methods without a value at one of the lengths are
    /// left out.
    std::vector<candidate> at(std::size_t point) const;

private:
    using method_values = std::vector<summation>;

    std::optional<mpfr> step_of(const summation& method, std::size_t point) const;
    mpfr least_step(const mpfr& value) const;
    mpfr last_terms(std::size_t point) const;

    const reduced_list& list_;
    std::vector<mpfr> points_;
    std::vector<method_values> by_length_, perturbed_;
};

}  // namespace libration::convergence
