// A list in a unit that makes its coefficients level, without the zeros that a symmetry causes.
#pragma once

#include <span>
#include <vector>

#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/convergence/list.hpp"

namespace libration::convergence {

/// f(x) = e(y) + y^first g(y^stride), y = x/unit, with a polynomial e of the coefficients outside the class.
class reduced_list {
public:
    /// `noise` holds absolute errors of the coefficients, or nothing for exact ones.
    reduced_list(const series_list& list, std::span<const mpfr> noise, long bits);

    const coefficient_pattern& pattern() const { return pattern_; }
    /// The coefficients of g, and their errors; none for a polynomial, which is e.
    const std::vector<mpfr>& values() const { return b_; }
    const std::vector<mpfr>& noise() const { return noise_; }
    bool is_exact() const;

    /// y^stride.
    mpfr point(const mpfr& x) const;
    /// The real x with the sign of `towards` at which |y^stride| = |z|.
    mpfr place_of(const mpfr& z, const mpfr& towards) const;
    /// f(x) and its error from g(y^stride) and its error.
    struct value_with_error {
        mpfr value, error;
    };
    value_with_error complete(const value_with_error& g, const mpfr& x) const;

private:
    mpfr unit_;
    coefficient_pattern pattern_;
    std::vector<mpfr> b_, noise_;
    std::vector<mpfr> outside_, noise_outside_;  ///< e and its errors
};

}  // namespace libration::convergence
