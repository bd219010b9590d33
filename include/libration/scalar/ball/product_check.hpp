// A check of products of integer polynomials modulo a prime, which does not use FLINT's product of large integers.
#pragma once

#include <mpfr.h>  // before FLINT 3, which declares conversions to mpfr only if this is included first

#include <flint/fmpz.h>

#include <stdexcept>

namespace libration {

/// A wrong product of integer polynomials: FLINT, GMP or the machine cannot be relied on, and neither can any result of
/// this process. A std::logic_error, because no other input and no other precision helps.
class product_mismatch : public std::logic_error {
public:
    product_mismatch()
        : std::logic_error("a product of integer polynomials by FLINT is wrong modulo 2^61 - 1: nothing is proved") {}
};

/// In all threads, until the end of the scope, every product of integer polynomials used for products and quotients of
/// sequences of balls is checked by require_product(), which takes about a tenth of the time of the product. Scopes
/// nest.
class product_check_scope {
public:
    product_check_scope();
    product_check_scope(const product_check_scope&) = delete;
    product_check_scope& operator=(const product_check_scope&) = delete;
    ~product_check_scope();
};

/// Whether a product_check_scope is open.
bool products_are_checked();

/// 2^61 - 1, a prime; 2^31 - 1 where words have 32 bits.
constexpr ulong product_check_prime = (ulong{1} << (FLINT_BITS == 64 ? 61U : 31U)) - 1;

/// n modulo product_check_prime, in 0 .. product_check_prime - 1.
ulong residue(const fmpz& n);

/// Throws product_mismatch unless sum_{n < count} c_n x^n = sum_k a_k x^k sum_{j < min(b_terms, count-k)} b_j x^j
/// modulo p = 2^61 - 1 at one point x, which holds if c_n = sum_k a_k b_{n-k} for n < count.
///
/// The points are a hash of a counter of the process, so that a run can be repeated. If the c_n are wrong, their
/// differences from the correct ones are the coefficients of a polynomial d. If p divides all of them, the check
/// passes; otherwise d has at most count - 1 of the p points as zeros, so that the check passes for a fraction of at
/// most count / 2^61 of the points. A coefficient c with the wrong sign from a transform modulo 2^N + 1 differs from
/// the correct one by 2^N + 1, which p never divides: 2^N + 1 is 2^(N mod 61) + 1 modulo p, between 2 and p - 1.
/// O(count) operations modulo p, and one pass over the limbs of all coefficients.
void require_product(const fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count);

}  // namespace libration
