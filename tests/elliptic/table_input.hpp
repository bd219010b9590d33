// The reference tables are made for the decimals in them, and most scalars hold only neighbours of these.
#pragma once

#include <string>

#include "libration/elliptic/modulus.hpp"
#include "scalars.hpp"

namespace libration::tests {

/// The number typed in a table, rounded to T.
template <class T>
T typed(const std::string& text) {
    return from_exact<T>(read_exact(text));
}

/// A table's value moved from the inputs as typed to the inputs as T holds them: `held` and `exact` are the function at
/// both with many digits, for which the library serves. The move is of the size of the inputs' rounding, so whatever
/// might be wrong in it is of second order: it is the table that judges.
inline expected_value moved(const std::string& table_value, const mpfr& held, const mpfr& exact) {
    expected_value result = decimal(table_value);
    const precision_scope scope(250);
    result.value += held - exact;
    return result;
}

}  // namespace libration::tests
