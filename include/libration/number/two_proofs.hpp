// Two proofs of the same number, compared in exact fractions.
#pragma once

#include <memory>
#include <string>

#include "libration/scalar/ball/product_check.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration {

/// If `check` is set, products of long series are checked modulo a prime while the returned object exists: for the
/// first of two proofs, whereas the second one has no check.
inline std::unique_ptr<product_check_scope> checked_products(bool check) {
    return check ? std::make_unique<product_check_scope>() : nullptr;
}

/// Whether the enclosures [text - uncertainty, text + uncertainty] of two decimals meet.
bool enclosures_meet(const proved_decimal& first, const proved_decimal& second);

/// Throws std::runtime_error with both enclosures if they do not meet; `what` names the number: "y at time 2".
void require_agreement(const proved_decimal& first, const proved_decimal& second, const std::string& what);

/// Whether the intervals of two pairs of decimals meet; inf is above every number.
bool intervals_meet(const std::string& lower, const std::string& upper, const std::string& other_lower,
                    const std::string& other_upper);

}  // namespace libration
