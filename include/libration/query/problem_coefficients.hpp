// The Taylor coefficients of every unknown of any system, in an arithmetic chosen at run time.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

class kept_integrations;

/// The requested coefficients, first .. order, and the system.
struct coefficient_request {
    explicit_system system;
    long first = 0;
    long order = 0;
    /// The expansion point; by default the initial point of the system.
    std::optional<complex_constant> at = {};
    /// The corners of the path there through the complex plane; by default a straight line.
    std::vector<complex_constant> corners = {};

    /// Whether the point is the initial point, without a path to it.
    bool about_start() const;
    /// Whether the point and the path to it are complex.
    bool complex() const;
};

/// Ordered by degree, then by unknown; for a complex point the real and the imaginary part of each. Coefficient n is
/// that of s^(n/root), s the distance from the point.
template <class Number>
struct coefficient_list {
    std::vector<Number> values;
    bool complex = false;
    int root = 1;
};

/// As computed in a fixed scalar; in mpfr correct to the digits of the scalar, by two runs that agree, and 0 if
/// fractions or a symmetry prove it. Throws error of the subject "time" or "point" if the point is not reached, of the
/// kind undecided if no precision within the limits reaches it, of the kind range for a coefficient out of the range of
/// the scalar.
coefficient_list<mpfr> rounded_coefficients(const scalar_spec& scalar, const coefficient_request& request);

/// `digits` digits each, proved to one unit in the last. Throws error of the subject "point" for a complex point, to
/// which no path is proved, and like rounded_coefficients. With kept steps of the system they lead to the point.
coefficient_list<proved_decimal> proved_coefficients(const coefficient_request& request, long digits,
                                                     const proof_route& route = {}, kept_integrations* kept = nullptr);

/// Exact fractions. Throws error of the subject "point" for a point that is not the initial point, and of the subject
/// "problem" if the system has numbers that are not fractions.
coefficient_list<rational> exact_coefficients(const coefficient_request& request);

}  // namespace libration::ode
