// The summands of an expression.
#pragma once

#include <functional>
#include <string>

#include "libration/number/exact_real.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

enum class atom_kind { one, pi, degree, period, product, quotient, power, function };

struct exact_real::atom {
    atom_kind kind = atom_kind::one;
    function_kind f = function_kind::exp;  ///< of a function
    exact_real left;                       ///< the argument of a function
    exact_real right;                      ///< its order
    std::size_t hash = 0;
    long depth = 1;

    bool is_composed() const {
        switch (kind) {
            case atom_kind::one:
            case atom_kind::pi:
            case atom_kind::degree:
            case atom_kind::period: return false;
            case atom_kind::product:
            case atom_kind::quotient:
            case atom_kind::power:
            case atom_kind::function: break;
        }
        return true;
    }
};

}  // namespace libration
