#include "libration/scalar/ball/product_self_test.hpp"

#include <flint/flint.h>
#include <flint/fmpz_poly.h>

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include "libration/scalar/ball/product_check.hpp"

namespace libration {

namespace {

void by_transform(fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count) {
    _fmpz_poly_mullow_SS(c, a, a_terms, b, b_terms, count);
}

// sign (2^bits - 1).
void set_ones(fmpz& x, slong bits, int sign) {
    fmpz_one(&x);
    fmpz_mul_2exp(&x, &x, static_cast<ulong>(bits));
    fmpz_sub_ui(&x, &x, 1);
    fmpz_mul_si(&x, &x, sign);
}

struct thread_cleanup {
    thread_cleanup() = default;
    thread_cleanup(const thread_cleanup&) = delete;
    thread_cleanup& operator=(const thread_cleanup&) = delete;
    ~thread_cleanup() { flint_cleanup(); }
};

product_state self_tested() {
    constexpr slong terms = 32;
    constexpr slong bits = 285;
    bool guarded = true;
    for (const slong more : {0, 1, 32}) {
        guarded = guarded && multiplies_ones(guarded_product, terms, bits, bits + more);
    }
    return {multiplies_ones(by_transform, terms, bits, bits), guarded && multiplies_ones(guarded_product, 8, 30, 30)};
}

}  // namespace

bool multiplies_ones(integer_product by, slong terms, slong s, slong t) {
    const auto size = static_cast<std::size_t>(terms);
    integer_vector a(size);
    integer_vector b(size);
    integer_vector c(size);
    for (std::size_t k = 0; k < size; ++k) {
        set_ones(a[k], s, 1);
        set_ones(b[k], t, -1);
    }
    by(c.data(), a.data(), terms, b.data(), terms, terms);
    integer_vector step(1);
    integer_vector expected(1);
    fmpz_mul(step.data(), a.data(), b.data());
    bool right = true;
    for (std::size_t n = 0; n < size; ++n) {
        fmpz_add(expected.data(), expected.data(), step.data());
        right = right && fmpz_equal(&c[n], expected.data()) != 0;
    }
    return right;
}

const product_state& flint_products() {
    // A thread may call this without computing with balls, which free FLINT's memory with the thread.
    thread_local const thread_cleanup at_end;
    static_cast<void>(at_end);
    // Per thread: with a shared one, other threads would wait indefinitely for a thread that a failure of FLINT keeps
    // in here.
    thread_local const product_state state = self_tested();
    return state;
}

void require_flint_products() {
    if (!flint_products().guarded_is_right) {
        throw product_mismatch();
    }
}

std::string flint_versions() {
    const std::string flint = std::string("FLINT ") + flint_version;
#if __has_include(<flint/arb.h>)
    return flint;
#else
    return flint + ", Arb " + arb_version;
#endif
}

std::string describe_flint_products() {
    const product_state& state = flint_products();
    if (!state.guarded_is_right) {
        return "wrong (self-test failed): nothing that needs them is proved";
    }
    return state.transform_is_right
               ? "right (self-test passed)"
               : "guarded: _fmpz_poly_mullow_SS failed its self-test and is not used where it may be wrong";
}

}  // namespace libration
