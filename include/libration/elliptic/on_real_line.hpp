// Complex balls for the functions of Arb without a real version: elliptic integrals and theta functions.
#pragma once

#include "libration/scalar/ball/value.hpp"

#if __has_include(<flint/acb_elliptic.h>)
#include <flint/acb.h>
#include <flint/acb_elliptic.h>
#else
#include <acb.h>
#include <acb_elliptic.h>
#endif

namespace libration::elliptic {

/// A complex ball of Arb initialised on the real line, for calls whose results are read from their real parts. It owns
/// its memory, so nothing has to be cleared explicitly.
class on_real_line {
public:
    /// 0.
    on_real_line() { acb_init(value_); }
    /// x + 0i, exactly.
    explicit on_real_line(const ball& x) : on_real_line() { acb_set_arb(value_, x.handle()); }
    on_real_line(const on_real_line&) = delete;
    on_real_line& operator=(const on_real_line&) = delete;
    ~on_real_line() { acb_clear(value_); }

    /// The underlying Arb handle, which its functions read and write.
    acb_srcptr handle() const { return value_; }
    acb_ptr handle() { return value_; }

    /// The real part, exactly: it encloses a function that is real there.
    ball real() const {
        ball result;
        arb_set(result.handle(), acb_realref(value_));
        return result;
    }

private:
    acb_t value_;
};

}  // namespace libration::elliptic
