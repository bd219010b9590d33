// Measures one claim of the table by its name.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "libration/scalar/precision.hpp"
#include "paper/claims/claim.hpp"

namespace libration {

/// The finding of the claim `name`, measured with 50 digits. Throws std::invalid_argument if there is none.
inline finding measured(const std::string& name) {
    const auto claims = all_claims();
    const auto found = std::find_if(claims.begin(), claims.end(), [&](const claim& c) { return c.name == name; });
    if (found == claims.end()) {
        throw std::invalid_argument("there is no claim " + name);
    }
    const precision_scope scope(50);
    return found->measure();
}

}  // namespace libration
