// The Taylor coefficients of every unknown of any system, in an arithmetic that is chosen at run time.
#pragma once

#include <optional>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/proof_route.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// Which coefficients, first .. order, of which system.
struct coefficient_request {
    explicit_system system;
    long first = 0;
    long order = 0;
    /// The point of expansion; the start of the system where it is not given.
    std::optional<complex_constant> at = {};
    /// The corners of the way there through the complex plane; straight without them.
    std::vector<complex_constant> corners = {};

    /// Whether the point is the start, with no way to it.
    bool about_start() const;
    /// Whether the point and the way to it are complex.
    bool complex() const;
};

/// One degree after the other, in each the unknowns in order; of a complex point the real and the imaginary part of
/// each. Coefficient n is that of s^(n/root), s the distance from the point.
template <class Number>
struct coefficient_list {
    std::vector<Number> values;
    bool complex = false;
    int root = 1;
};

/// As a fixed scalar computes them; in mpfr right to the digits of the scalar, by two runs that agree, and 0 where
/// fractions or a symmetry show it. Throws error of the subject "time" or "point" where the point is not reached, of
/// the kind undecided where no precision within the limits does, of the kind range for a coefficient that the scalar
/// does not hold.
coefficient_list<mpfr> rounded_coefficients(const scalar_spec& scalar, const coefficient_request& request);

/// `digits` digits each, proved to one unit in the last. Throws error of the subject "point" for a complex point, to
/// which no way is proved, and as rounded_coefficients does.
coefficient_list<proved_decimal> proved_coefficients(const coefficient_request& request, long digits,
                                                     const proof_route& route = {});

/// Exact fractions. Throws error of the subject "point" for a point that is not the start, and of the subject "problem"
/// where the system has numbers that are none.
coefficient_list<rational> exact_coefficients(const coefficient_request& request);

}  // namespace libration::ode
