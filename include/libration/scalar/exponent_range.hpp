// The exponent range of MPFR: initially 31 bits, about 10^(+-323 million).
#pragma once

#include <mpfr.h>

namespace libration {

/// Extends the exponents of mpfr to their full range, about 62 bits, in this thread until the end of the scope; numbers
/// beyond the previous range must not leave it.
class whole_exponent_range {
public:
    whole_exponent_range() : least_(mpfr_get_emin()), greatest_(mpfr_get_emax()) {
        mpfr_set_emin(mpfr_get_emin_min());
        mpfr_set_emax(mpfr_get_emax_max());
    }
    whole_exponent_range(const whole_exponent_range&) = delete;
    whole_exponent_range& operator=(const whole_exponent_range&) = delete;
    ~whole_exponent_range() {
        mpfr_set_emin(least_);
        mpfr_set_emax(greatest_);
    }

private:
    mpfr_exp_t least_;
    mpfr_exp_t greatest_;
};

}  // namespace libration
