#include "libration/scalar/ball/binary_parts.hpp"

namespace libration {

namespace {

long fitting(const integer& exponent) {
    if (mpz_fits_slong_p(exponent.backend().data()) == 0) {
        throw error(error_kind::range, "the exponent of a ball", "", "is beyond that of a long");
    }
    return mpz_get_si(exponent.backend().data());
}

integer integer_of(const fmpz_t x) {
    integer result;
    fmpz_get_mpz(result.backend().data(), x);
    return result;
}

}  // namespace

binary_parts parts_of(const ball& x) {
    if (!is_finite(x)) {
        throw error(error_kind::range, "a ball", "", "is infinite");
    }
    binary_parts parts{0, 0, 0, 0};
    fmpz_t mantissa;
    fmpz_t exponent;
    fmpz_init(mantissa);
    fmpz_init(exponent);
    arf_get_fmpz_2exp(mantissa, exponent, arb_midref(x.handle()));
    parts.mantissa = integer_of(mantissa);
    const integer scale = integer_of(exponent);
    fmpz_clear(mantissa);
    fmpz_clear(exponent);
    parts.exponent = fitting(scale);
    mag_srcptr radius = arb_radref(x.handle());
    if (mag_is_zero(radius) == 0) {
        parts.radius = MAG_MAN(radius);
        parts.radius_exponent = fitting(integer_of(MAG_EXPREF(radius))) - MAG_BITS;
    }
    return parts;
}

}  // namespace libration
