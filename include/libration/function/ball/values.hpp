// Functions by FLINT: where this header is included, formulas have them in every scalar.
#pragma once

namespace libration::function {

/// Makes the library use FLINT; true.
bool use_flint();

inline const bool flint_in_use = use_flint();

}  // namespace libration::function
