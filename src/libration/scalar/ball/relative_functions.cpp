#include "libration/scalar/ball/relative_functions.hpp"

#include <algorithm>

#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration {

namespace {

// Coefficients of FLINT, freed with their owner.
class flint_coefficients {
public:
    explicit flint_coefficients(slong count) : values_(_acb_vec_init(count)), count_(count) {}
    flint_coefficients(const flint_coefficients&) = delete;
    flint_coefficients& operator=(const flint_coefficients&) = delete;
    ~flint_coefficients() { _acb_vec_clear(values_, count_); }

    acb_ptr operator[](slong j) { return values_ + j; }
    slong size() const { return count_; }

private:
    acb_ptr values_;
    slong count_;
};

// exp(max(Re z, 0)) and the radius of a ball z.
struct kernel_size {
    mag_t largest;
    mag_t radius;

    explicit kernel_size(acb_srcptr z) {
        mag_init(largest);
        mag_init(radius);
        mag_hypot(radius, arb_radref(acb_realref(z)), arb_radref(acb_imagref(z)));
        arb_t above;
        arb_init(above);
        arb_get_ubound_arf(arb_midref(above), acb_realref(z), 64);
        if (arf_sgn(arb_midref(above)) < 0) {
            arb_zero(above);
        }
        arb_exp(above, above, 64);
        arb_get_mag(largest, above);
        arb_clear(above);
    }
    kernel_size(const kernel_size&) = delete;
    kernel_size& operator=(const kernel_size&) = delete;
    ~kernel_size() {
        mag_clear(largest);
        mag_clear(radius);
    }
};

// F_j(z) by the function M of Kummer, z exact.
void set_directly(acb_ptr result, slong n, slong j, acb_srcptr z, slong bits) {
    flint_complex a;
    flint_complex b;
    acb_set_si(a.handle(), j + 1);
    acb_set_si(b.handle(), n + j + 1);
    acb_hypgeom_m(result, a.handle(), b.handle(), z, 0, bits);
    for (slong i = 1; i <= j; ++i) {
        acb_div_si(result, result, n + i, bits);
    }
}

// F_0 .. F_(count - 1) of exprel(n, .) about every point of z.
void set_series(flint_coefficients& f, slong n, acb_srcptr z, slong bits) {
    const slong count = f.size();
    flint_complex middle;
    acb_get_mid(middle.handle(), z);
    // What the recurrence loses to cancellation, which grows with |z|.
    constexpr double most_lost = 4096;
    const double size = std::abs(arf_get_d(arb_midref(acb_realref(z)), ARF_RND_UP)) +
                        std::abs(arf_get_d(arb_midref(acb_imagref(z)), ARF_RND_UP));
    const slong more = bits + 64 + 2 * count + (size < most_lost / 4 ? static_cast<slong>(4 * size) : 4096);
    set_directly(f[count - 1], n, count - 1, middle.handle(), more);
    if (count > 1) {
        set_directly(f[count - 2], n, count - 2, middle.handle(), more);
    }
    flint_complex factor;
    for (slong j = count - 3; j >= 0; --j) {
        acb_mul_si(f[j], f[j + 2], j + 2, more);
        acb_mul(f[j], f[j], middle.handle(), more);
        acb_sub_si(factor.handle(), middle.handle(), j + n + 1, more);
        acb_neg(factor.handle(), factor.handle());
        acb_addmul(f[j], factor.handle(), f[j + 1], more);
    }
    const kernel_size kernel(z);
    mag_t error;
    mag_init(error);
    mag_mul(error, kernel.largest, kernel.radius);
    for (slong j = 0; j < count; ++j) {
        mag_div_ui(error, error, static_cast<ulong>(n + j) + 1);  // r C n!/(n + j + 1)!
        acb_set_round(f[j], f[j], bits);
        mag_t of_this;
        mag_init(of_this);
        mag_mul_ui(of_this, error, static_cast<ulong>(j) + 1);
        acb_add_error_mag(f[j], of_this);
        mag_clear(of_this);
    }
    mag_clear(error);
}

// The same of cosrel(n, .): i^j (F_j(i x) + (-1)^j F_j(-i x))/2.
void set_cosine_series(flint_coefficients& f, slong n, acb_srcptr x, slong bits) {
    flint_coefficients other(f.size());
    flint_complex turned;
    acb_mul_onei(turned.handle(), x);
    set_series(f, n, turned.handle(), bits);
    acb_neg(turned.handle(), turned.handle());
    set_series(other, n, turned.handle(), bits);
    for (slong j = 0; j < f.size(); ++j) {
        if (j % 2 == 0) {
            acb_add(f[j], f[j], other[j], bits);
        } else {
            acb_sub(f[j], f[j], other[j], bits);
        }
        acb_mul_2exp_si(f[j], f[j], -1);
        for (slong turn = 0; turn < j % 4; ++turn) {
            acb_mul_onei(f[j], f[j]);
        }
    }
}

void set_series(relative_kind kind, flint_coefficients& f, slong n, acb_srcptr x, slong bits) {
    if (kind == relative_kind::exponential) {
        set_series(f, n, x, bits);
    } else {
        set_cosine_series(f, n, x, bits);
    }
}

slong whole_order(arb_srcptr order) { return arf_get_si(arb_midref(order), ARF_RND_NEAR); }

}  // namespace

std::vector<complex_number<ball>> relative_series(relative_kind kind, int n, const complex_number<ball>& x, int count) {
    flint_coefficients f(count);
    set_series(kind, f, n, flint_complex(x).handle(), ball::working_bits());
    std::vector<complex_number<ball>> result(static_cast<std::size_t>(count));
    for (int j = 0; j < count; ++j) {
        auto& each = result[static_cast<std::size_t>(j)];
        arb_set(each.re.handle(), acb_realref(f[j]));
        arb_set(each.im.handle(), acb_imagref(f[j]));
    }
    return result;
}

// About a real point the series is real.
std::vector<ball> relative_series(relative_kind kind, int n, const ball& x, int count) {
    std::vector<ball> result;
    for (complex_number<ball>& each : relative_series(kind, n, complex_number<ball>(x, ball(0)), count)) {
        result.push_back(std::move(each.re));
    }
    return result;
}

void relative_ball(acb_struct* y, relative_kind kind, const acb_struct* order, const acb_struct* x, long bits) {
    flint_coefficients f(1);
    set_series(kind, f, whole_order(acb_realref(order)), x, bits);
    acb_set(y, f[0]);
}

void relative_ball(arb_struct* y, relative_kind kind, const arb_struct* order, const arb_struct* x, long bits) {
    flint_coefficients f(1);
    flint_complex at;
    acb_set_arb(at.handle(), x);
    set_series(kind, f, whole_order(order), at.handle(), bits);
    arb_set(y, acb_realref(f[0]));
}

}  // namespace libration
