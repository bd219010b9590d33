// Whether the loaded FLINT multiplies integer polynomials correctly at the bound of its transform.
#pragma once

#include <string>

#include "libration/scalar/ball/product_guard.hpp"

namespace libration {

/// Whether the product of a_k = 2^s - 1 and b_k = -(2^t - 1), k < terms, is c_n = -(n+1) (2^s - 1)(2^t - 1) for all
/// n < terms.
bool multiplies_ones(integer_product by, slong terms, slong s, slong t);

/// The results of the self-test.
struct product_state {
    /// _fmpz_poly_mullow_SS multiplies 32 coefficients of 285 bits correctly (285 + 285 + 5 + 1 = 9 * 64).
    bool transform_is_right;
    /// guarded_product() multiplies them correctly, and some similar products.
    bool guarded_is_right;
};

/// For the FLINT in this process, tested at the first call of each thread: 0.1 ms.
const product_state& flint_products();

/// Throws product_mismatch if guarded_is_right is false. Called first by products and quotients of sequences of balls.
void require_flint_products();

/// "FLINT 2.9.0, Arb 2.23.0", the libraries at run time; before FLINT 3 with that of Arb.
std::string flint_versions();

/// One line on flint_products(): the result of the self-test of the transform, and that long products avoid it where it
/// may be wrong.
std::string describe_flint_products();

}  // namespace libration
