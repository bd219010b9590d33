// Functions computed by FLINT: including this header makes them available to formulas in every scalar.
#pragma once

namespace libration::function {

/// Makes the library use FLINT; returns true.
bool use_flint();

inline const bool flint_in_use = use_flint();

}  // namespace libration::function
