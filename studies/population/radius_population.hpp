// Series of many families, drawn at random, whose radius of convergence and exponents are known: the population that
// the coverage of the stated uncertainties is measured on.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/special_series.hpp"
#include "libration/convergence/strided_series.hpp"
#include "libration/series/exponential.hpp"

namespace libration::tests {

using namespace series;
using namespace convergence;

/// Numbers by chance, the same ones from the same seed on every machine.
class dice {
public:
    explicit dice(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}

    /// 0 .. count - 1.
    int below(int count) {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(count));
    }
    /// A fraction between two thousandths, ends included.
    mpfr thousandths(int from, int to) { return mpfr(from + below(to - from + 1)) / 1000; }
    int sign() { return below(2) == 0 ? 1 : -1; }
    template <class T>
    T one_of(const std::vector<T>& of) {
        return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
    }
    /// An exponent that is not an integer of 0 or more: a simple fraction, or anything between -2.9 and 2.9.
    mpfr exponent() {
        const auto simple = one_of<rational>({{-5, 2}, {-3, 2}, {-1, 2}, {-1, 3}, {1, 3}, {1, 2}, {2, 3}, {3, 2}, {0}});
        if (simple != 0) {
            return from_rational<mpfr>(simple);
        }
        return mpfr(below(6) - 3) + thousandths(100, 900);
    }
    /// A place between 0.4 and 4 on either side.
    mpfr place() { return thousandths(400, 4000) * sign(); }
    /// A weight between 1/4 and 4 of either sign.
    mpfr weight() { return thousandths(250, 4000) * sign(); }

private:
    std::uint64_t state_;
};

/// One of the nearest singularities: the position (im >= 0) and the exponent nu there, the one that the size of the
/// coefficients follows.
struct drawn_singularity {
    complex_number<mpfr> at;
    mpfr exponent;
};

/// A drawn series.
struct drawn_series {
    power_series<mpfr> a;
    mpfr radius;
    std::vector<drawn_singularity> nearest = {};  ///< with im >= 0; empty without an exponent
    mpfr radius_error = mpfr(0);                  ///< of `radius`; 0 as a radius is one that is not known
};

/// A family: how it is called, and how one of it is drawn, a_0 .. a_N in the working precision.
struct series_family {
    std::string name;
    drawn_series (*draw)(dice&, int order);
};

namespace population {

/// The polynomial with these coefficients, as a series.
inline power_series<mpfr> polynomial(const std::vector<mpfr>& c, int order) {
    auto a = power_series<mpfr>::zero(order);
    for (int n = 0; n <= order && n < static_cast<int>(c.size()); ++n) {
        a[n] = c[static_cast<std::size_t>(n)];
    }
    return a;
}

inline power_series<mpfr> operator*(const mpfr& factor, power_series<mpfr> a) {
    for (int n = 0; n <= a.order(); ++n) {
        a[n] *= factor;
    }
    return a;
}

/// (1 - x/x0)^nu.
inline power_series<mpfr> power_at(const mpfr& x0, const mpfr& nu, int order) {
    return rescale(convergence::binomial_series(nu, order), mpfr(1 / x0));
}

/// log(1 - x/x0).
inline power_series<mpfr> logarithm_at(const mpfr& x0, int order) {
    return logarithm_series(std::vector<weighted_singularity<mpfr>>{{mpfr(1), x0}}, order);
}

/// (1 - 2 c x/r + x^2/r^2)^nu.
inline power_series<mpfr> power_of_pair(const mpfr& r, const mpfr& c, const mpfr& nu, int order) {
    return rescale(quadratic_power_series(c, nu, order), mpfr(1 / r));
}

/// e^(b x), b up to 2/r either way: analytic, and no larger than it must be to count.
inline power_series<mpfr> entire_factor(dice& random, const mpfr& r, int order) {
    const mpfr b = random.thousandths(-2000, 2000) / abs(r);
    return rescale(convergence::exponential_series<mpfr>(order), b);
}

/// w e^(b x), or a polynomial of degree 3.
inline power_series<mpfr> entire_term(dice& random, const mpfr& r, int order) {
    if (random.below(2) == 0) {
        return random.weight() * entire_factor(random, r, order);
    }
    std::vector<mpfr> c;
    c.reserve(4);
    for (int n = 0; n < 4; ++n) {
        c.push_back(random.weight());
    }
    return polynomial(c, order);
}

/// A series with the nearest singularity x0 on the real axis and the exponent nu there.
inline drawn_series at_point(power_series<mpfr> a, const mpfr& x0, const mpfr& nu) {
    return {std::move(a), abs(x0), {{{x0, mpfr(0)}, nu}}};
}

/// A series with the nearest singularities r e^(+-i phi), cos phi = c, and the exponent nu there.
inline drawn_series at_pair(power_series<mpfr> a, const mpfr& r, const mpfr& c, const mpfr& nu) {
    return {std::move(a), r, {{{mpfr(r * c), mpfr(r * sqrt(mpfr(1 - c * c)))}, nu}}};
}

/// A series with the nearest singularities x0 and -x0 and their exponents.
inline drawn_series opposite_points(power_series<mpfr> a, const mpfr& x0, const std::pair<mpfr, mpfr>& exponents) {
    return {std::move(a), abs(x0), {{{x0, mpfr(0)}, exponents.first}, {{mpfr(-x0), mpfr(0)}, exponents.second}}};
}

/// An angle's cosine that no few coefficients take for 1: 20 to 160 degrees.
inline mpfr cosine(dice& random) { return random.thousandths(-940, 940); }

}  // namespace population

}  // namespace libration::tests
