// The Chebyshev-Radau nodes of collocation_points in a rounding scalar.
#pragma once

#include <cstddef>
#include <vector>

#include "collocation_points.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration::ode {

/// Matrices by rows, each entry rounded.
template <rounding_scalar T>
struct node_matrices {
    explicit node_matrices(int degree) : node_matrices(collocation_points(degree, bits_of_nodes())) {}

    std::size_t size() const { return places.size(); }
    int degree() const { return static_cast<int>(places.size()) - 1; }

    std::vector<T> places;        ///< ascending; the last is 1
    std::vector<T> integrals;     ///< row i maps values at the nodes to the integral from -1 to node i
    std::vector<T> coefficients;  ///< row l maps values at the nodes to Chebyshev coefficient l of the interpolant
    std::vector<long double> rounded_integrals;

private:
    static long bits_of_nodes() {
        constexpr long lost = 48;
        return static_cast<long>(digits<T>()) + lost;
    }

    explicit node_matrices(const collocation_points& nodes)
        : places(rounded(nodes.places())),
          integrals(rounded(nodes.integrals().entries)),
          coefficients(rounded(nodes.coefficients().entries)) {
        for (const ball& each : nodes.integrals().entries) {
            rounded_integrals.push_back(as_long_double(each));
        }
    }

    static std::vector<T> rounded(const std::vector<ball>& values) {
        const precision_scope scope(fixed_scalar<T> ? decimal_digits(bits_of_nodes()) : working_digits());
        std::vector<T> result;
        result.reserve(values.size());
        for (const ball& each : values) {
            result.push_back(convert<T>(midpoint_of(each)));
        }
        return result;
    }
};

}  // namespace libration::ode
