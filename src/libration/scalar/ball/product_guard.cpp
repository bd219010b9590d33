#include "libration/scalar/ball/product_guard.hpp"

#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <cstdlib>

#include "libration/scalar/ball/product_check.hpp"

namespace libration {

bool near_transform_bound(const fmpz* a, slong a_terms, const fmpz* b, slong b_terms) {
    const slong s = _fmpz_vec_max_bits(a, a_terms);  // below 0 if a coefficient is
    const slong t = _fmpz_vec_max_bits(b, b_terms);
    const auto shorter = static_cast<ulong>(std::min(a_terms, b_terms));
    return (s < 0 || t < 0) &&
           (std::labs(s) + std::labs(t) + static_cast<slong>(FLINT_CLOG2(shorter)) + 1) % FLINT_BITS == 0;
}

void checked_product(integer_product by, fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms,
                     slong count) {
    a_terms = std::min(a_terms, count);
    b_terms = std::min(b_terms, count);
    if (a_terms < b_terms) {
        std::swap(a, b);
        std::swap(a_terms, b_terms);
    }
    // FLINT takes operands at one address to be equal even if their lengths differ: in that case the shorter one is
    // passed through a copy of its words, which owns nothing.
    std::vector<fmpz> shorter;
    if (a == b && a_terms != b_terms) {
        shorter.assign(b, b + b_terms);
        b = shorter.data();
    }
    const slong all = std::min(count, a_terms + b_terms - 1);
    by(c, a, a_terms, b, b_terms, all);
    _fmpz_vec_zero(c + all, count - all);
    if (products_are_checked()) {
        require_product(c, a, a_terms, b, b_terms, count);
    }
}

void guarded_product(fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count) {
    const bool near = near_transform_bound(a, std::min(a_terms, count), b, std::min(b_terms, count));
    checked_product(near ? _fmpz_poly_mullow_KS : _fmpz_poly_mullow, c, a, a_terms, b, b_terms, count);
}

}  // namespace libration
