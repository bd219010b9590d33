// Functions of complex balls by FLINT.
#pragma once

#include "libration/scalar/ball/relative_functions.hpp"
#include "libration/scalar/ball/traits.hpp"
#include "libration/scalar/complex_number.hpp"

#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb.h>
#include <flint/acb_hypgeom.h>
#else
#include <acb.h>
#include <acb_hypgeom.h>
#endif

namespace libration {

/// A complex ball of FLINT for a call.
class flint_complex {
public:
    flint_complex() { acb_init(value_); }
    explicit flint_complex(const complex_number<ball>& z) : flint_complex() {
        acb_set_arb_arb(value_, z.re.handle(), z.im.handle());
    }
    flint_complex(const flint_complex&) = delete;
    flint_complex& operator=(const flint_complex&) = delete;
    ~flint_complex() { acb_clear(value_); }

    acb_srcptr handle() const { return value_; }
    acb_ptr handle() { return value_; }
    complex_number<ball> number() const {
        complex_number<ball> result;
        arb_set(result.re.handle(), acb_realref(value_));
        arb_set(result.im.handle(), acb_imagref(value_));
        return result;
    }

private:
    acb_t value_;
};

/// F(arguments) for a function of function/NAME.hpp that FLINT provides.
template <class F, class... Balls>
requires(std::same_as<Balls, complex_number<ball>>&&...) complex_number<ball> function_at(F /*of*/,
                                                                                          const Balls&... arguments) {
    flint_complex result;
    F::complex_ball(result.handle(), flint_complex(arguments).handle()..., ball::working_bits());
    return result.number();
}

/// As for real balls (relative_functions.hpp).
std::vector<complex_number<ball>> relative_series(relative_kind kind, int n, const complex_number<ball>& x, int count);

/// The number of accurate bits relative to the size of a complex ball.
inline long relative_bits(const complex_number<ball>& z) { return acb_rel_accuracy_bits(flint_complex(z).handle()); }

}  // namespace libration
