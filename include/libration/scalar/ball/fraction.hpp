// Balls times exact fractions.
#pragma once

#include "libration/scalar/ball/value.hpp"

namespace libration {

/// A fraction as two FLINT integers.
class fraction_parts {
public:
    explicit fraction_parts(const rational& q) {
        fmpz_init(above_);
        fmpz_init(below_);
        fmpz_set_mpz(above_, mpq_numref(q.backend().data()));
        fmpz_set_mpz(below_, mpq_denref(q.backend().data()));
    }
    fraction_parts(const fraction_parts&) = delete;
    fraction_parts& operator=(const fraction_parts&) = delete;
    ~fraction_parts() {
        fmpz_clear(above_);
        fmpz_clear(below_);
    }
    const fmpz* above() const { return above_; }
    const fmpz* below() const { return below_; }

private:
    fmpz_t above_;
    fmpz_t below_;
};

/// x q, by the numerator and then the denominator, so within two roundings to this number of bits.
inline ball times(const ball& x, const rational& q, slong bits) {
    ball result;
    const fraction_parts parts(q);
    arb_mul_fmpz(result.handle(), x.handle(), parts.above(), bits);
    if (fmpz_is_one(parts.below()) == 0) {
        arb_div_fmpz(result.handle(), result.handle(), parts.below(), bits);
    }
    return result;
}

}  // namespace libration
