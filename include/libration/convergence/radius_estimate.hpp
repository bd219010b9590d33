// The result of a radius test: a radius with its uncertainty, or the reason why it has none.
//
// Finitely many coefficients cannot determine a radius: any series agrees to x^N with a polynomial. Every estimate here
// is heuristic and has an uncertainty, which is also an estimate: it is intended to cover the error, but is not a bound
// on it.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "libration/scalar/complex_number.hpp"

namespace libration::convergence {

/// How f behaves at x0, with z = 1 - x/x0: z^-m; log z; z^nu with any other exponent; a boundary where f ends; a
/// logarithm or two powers, which the coefficients do not distinguish; or an irregular (essential) singularity.
enum class singularity_kind { unknown, pole, logarithm, algebraic, boundary, confluent, irregular };

/// unknown | pole | logarithm | algebraic | boundary | confluent | irregular.
inline std::string name_of(singularity_kind kind) {
    switch (kind) {
        case singularity_kind::pole: return "pole";
        case singularity_kind::logarithm: return "logarithm";
        case singularity_kind::algebraic: return "algebraic";
        case singularity_kind::boundary: return "boundary";
        case singularity_kind::confluent: return "confluent";
        case singularity_kind::irregular: return "irregular";
        case singularity_kind::unknown: break;
    }
    return "unknown";
}

/// The result of one test, in units of the variable. What a test does not determine is left out.
template <rounding_scalar T>
struct radius_estimate {
    std::string method;
    std::optional<T> radius;                    ///< std::nullopt if the test does not apply; `note` then has the reason
    T uncertainty = T(0);                       ///< of the radius, absolute
    T nearer = T(0);                            ///< a weaker singularity may be nearer by this; 0 if none was detected
    std::optional<complex_number<T>> position;  ///< of one nearest singularity, the one of smallest argument >= 0
    std::optional<T> exponent;                  ///< nu of (1 - x/x0)^nu there; 0 is a logarithm
    T exponent_uncertainty = T(0);
    bool exponent_assumed = false;  ///< the exponent is an assumption of the test
    singularity_kind kind = singularity_kind::unknown;
    int count = 0;     ///< singularities on the circle of convergence; 0 if the test does not determine it
    std::string note;  ///< the reason why there is no radius, or a remark
};

/// A list a_0 .. a_N, each known to `noise` relative to its size.
template <rounding_scalar T>
struct list_quality {
    int order;  ///< N
    T noise;
};

/// The result of a test that does not apply.
template <rounding_scalar T>
radius_estimate<T> no_estimate(const std::string& method, const std::string& reason) {
    radius_estimate<T> result;
    result.method = method;
    result.note = reason;
    return result;
}

/// The result of a test that needs more coefficients than are given.
template <rounding_scalar T>
radius_estimate<T> too_short(const std::string& method, int needed, int given) {
    return no_estimate<T>(
        method, "needs " + std::to_string(needed) + " non-zero coefficients, there are " + std::to_string(given));
}

/// The same result in the current working precision, exactly.
template <rounding_scalar T>
radius_estimate<mpfr> widened(const radius_estimate<T>& estimate) {
    const auto wide = [](const std::optional<T>& x) { return x ? std::optional<mpfr>(widen(*x)) : std::nullopt; };
    radius_estimate<mpfr> result;
    result.method = estimate.method;
    result.radius = wide(estimate.radius);
    result.uncertainty = widen(estimate.uncertainty);
    result.nearer = widen(estimate.nearer);
    if (estimate.position) {
        result.position = complex_number<mpfr>{widen(estimate.position->re), widen(estimate.position->im)};
    }
    result.exponent = wide(estimate.exponent);
    result.exponent_uncertainty = widen(estimate.exponent_uncertainty);
    result.exponent_assumed = estimate.exponent_assumed;
    result.kind = estimate.kind;
    result.count = estimate.count;
    result.note = estimate.note;
    return result;
}

}  // namespace libration::convergence
