// theta(t) of the libration from the top, from decimal texts, by this library and by its best peers.
#pragma once

#if __has_include(<flint/acb_modular.h>)
#include <flint/acb.h>
#include <flint/acb_modular.h>
#else
#include <acb.h>
#include <acb_modular.h>
#endif

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <string>
#include <utility>

#include "libration/pendulum/proved_canonical.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::bench {

/// The input as it is typed.
struct question {
    std::string energy;
    std::string time;
};

/// The input as fractions: the same reader for both proved routes.
struct exact_question {
    explicit exact_question(const question& asked)
        : energy(read_exact(asked.energy).coefficient), gap(2 - energy), time(read_exact(asked.time).coefficient) {}

    rational energy;
    rational gap;
    rational time;
};

/// Libration: a few Landen steps, a short theta series, and back.
inline ball by_landen(const question& asked) {
    exact_question exact(asked);
    const pendulum::proved_canonical motion(std::move(exact.energy), std::move(exact.gap));
    return motion.theta_at(motion.phase_at(exact.time));
}

/// A complex number of Arb.
class complex_ball {
public:
    complex_ball() { acb_init(value_); }
    complex_ball(const complex_ball&) = delete;
    complex_ball& operator=(const complex_ball&) = delete;
    ~complex_ball() { acb_clear(value_); }

    acb_ptr handle() { return value_; }
    arb_ptr re() { return acb_realref(value_); }
    arb_ptr im() { return acb_imagref(value_); }

private:
    acb_t value_;
};

/// Arb: sqrt(k) theta_2/theta_3 by one call of acb_modular_theta at z = t/(2K), tau = i K'/K, K and K' by AGM.
inline ball by_arb_theta(const question& asked) {
    const exact_question exact(asked);
    const slong bits = ball::working_bits();
    const ball k = sqrt(from_rational<ball>(exact.energy) / 2);
    const ball complement = sqrt(from_rational<ball>(exact.gap) / 2);
    const ball one(1);
    ball mean;
    ball other_mean;
    arb_agm(mean.handle(), one.handle(), complement.handle(), bits);
    arb_agm(other_mean.handle(), one.handle(), k.handle(), bits);
    complex_ball z;
    complex_ball tau;
    const ball turns = from_rational<ball>(exact.time) * mean / pi<ball>();
    arb_set(z.re(), turns.handle());
    arb_div(tau.im(), mean.handle(), other_mean.handle(), bits);
    complex_ball first;
    complex_ball second;
    complex_ball third;
    complex_ball fourth;
    acb_modular_theta(first.handle(), second.handle(), third.handle(), fourth.handle(), z.handle(), tau.handle(), bits);
    ball quotient;
    arb_div(quotient.handle(), second.re(), third.re(), bits);
    return asin(sqrt(k) * quotient) * 2;
}

/// The most common alternative: 2 asin(k cd(t, k)) with Boost.Math on mpfr, without proved digits.
inline mpfr by_boost(const question& asked) {
    const mpfr k = sqrt(mpfr(mpfr(asked.energy) / 2));
    const mpfr cd = boost::math::jacobi_cd(k, mpfr(asked.time));
    return asin(mpfr(k * cd)) * 2;
}

}  // namespace libration::bench
