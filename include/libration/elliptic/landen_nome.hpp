// Reduction to a small nome in balls: the few steps of the arithmetic-geometric mean after which three terms of the
// theta series are exact to the precision. Quantities that depend on the modulus only are computed here, rigorously,
// for any number of arguments.
//
// With a_0 > b_0 > 0 (only b_0/a_0 = k' matters) and c_{n+1} = (a_n - b_n)/2 the modulus of level n is k_n, with
// k_{n+1} = c_{n+1}/a_{n+1}, and its nome is q^(2^n) [DLMF 22.7(i), 20.9(i)]. At the last level r the nome P follows
// from e = k_{r+1}/4 = (a_r - b_r)/(4 (a_r + b_r)), a_r = M theta_3(0)^2 and b_r = M theta_4(0)^2, M = agm(a_0, b_0).
//
// (1) P = e sum_j p_j e^(2j) = e (1 + 4 e^2 + 34 e^4 + ...), and after J terms the remainder is at most
//     4 k^(2J)/(1 - k^2), k = k_{r+1} = 4e. Proof: at nome P^2, k = 4P (sum P^(2n(n+1)))^2/(sum P^(2n^2))^2, the first
//     sum over n >= 0, the second over all n [DLMF 20.9.1]. The nome exp(-pi K'/K) as a function of k^2 is analytic for
//     |k| < 1, of modulus below 1, with its only zero at k = 0, simple: so P, its square root, is an odd analytic
//     function of k there, of modulus below 1, and Cauchy's estimate on |k| = s -> 1 gives |p_j| <= 4^(2j+1).
// (2) theta_3(z) = 1 + 2 sum P^(n^2) cos 2nz has a remainder after n = N of at most 4 P^((N+1)^2). With
//     x_n = cos((2n+1)z)/cos z, or the same of sines, |x_n| <= 2n+1, and sum P^(n(n+1)) x_n has a remainder of at most
//     2 (2N+3) P^((N+1)(N+2)), if P <= 1/8.
//     Proof: every bound is at most half of the previous one: P^(2n+1) <= 1/8, (2n+3)/(2n+1) P^(2n+2) <= 1/2.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/error.hpp"

namespace libration::elliptic {

/// Upper limits on the reduction and on the series of a nome: normally the precision ends them earlier. The remainder
/// is enclosed in any case.
struct nome_steps {
    int levels = std::numeric_limits<int>::max();  ///< r, but at least as many as bring P below 2^-4
    int terms = 4;                                 ///< N of the theta series, 1 .. 4, if the reduction is ended by r
    int series = 18;                               ///< J of the series of P, 1 .. 18
};

/// Chain, nome and mean. Cost: one square root, two products and three sums per level, log2 log2(1/k') levels until b/a
/// is above 1/2, then about log2(bits) - 4; two square roots and 7 levels suffice for 1000 digits. Absolute errors
/// relative to a: a few units of the working precision in M and in the sums. The precision is that of the scope.
class landen_nome {
public:
    /// quarter_square is c_0^2/4 = (a_0^2 - b_0^2)/4. Throws error unless a_0 and b_0 are positive, and
    /// precision_exhausted if they are too wide for a nome.
    landen_nome(const ball& a, const ball& b, const ball& quarter_square, const nome_steps& most = {})
        : bits_(ball::working_bits()), a_(a), b_(b) {
        if (arb_is_positive(a.handle()) == 0 || arb_is_positive(b.handle()) == 0) {
            throw error(error_kind::argument, "mean", "", "has arguments that are not proved positive");
        }
        steps_.reserve(16);
        steps_.push_back(quarter_square);
        descend(most);
        solve_nome(most.series);
        raise_powers();
        measure();
    }

    long bits() const { return bits_; }
    /// The last level r >= 1; the modulus of level n < r enters as step(n) = c_n^2/4.
    int levels() const { return static_cast<int>(steps_.size()); }
    const ball& step(int n) const { return steps_[static_cast<std::size_t>(n)]; }
    const ball& mean() const { return mean_; }
    /// a_r theta_2(0)/(2 P^(1/4) theta_3(0)): cd(u_r, k_r)/a_r = second/(third scale).
    const ball& scale() const { return scale_; }
    const ball& last_b() const { return b_; }

    /// The last n of the sums of (2), and P^(n^2), P^(n(n+1)) for n = 1 .. terms().
    int terms() const { return terms_; }
    const ball& square_power(int n) const { return square_powers_[static_cast<std::size_t>(n)]; }
    const ball& between_power(int n) const { return between_powers_[static_cast<std::size_t>(n)]; }
    /// The number of bits needed in P^n times a number of size 1 when it is added to 1.
    long deserved(long n) const { return std::max(8L, bits_ - n * small_ + 8); }
    /// Widens a sum by the remainder in (2): 4 P^((N+1)^2), or 2 (2N+3) P^((N+1)(N+2)) < 32 P^((N+1)(N+2)).
    void widen_third(ball& x) const { arb_add_error_2exp_si(x.handle(), 2 - power_of_third() * small_); }
    void widen_second(ball& x) const { arb_add_error_2exp_si(x.handle(), 5 - power_of_second() * small_); }

    // x y to this number of bits, from operands truncated to them if that saves time.
    static ball product(const ball& x, const ball& y, long bits) {
        ball result;
        if (bits > 640) {
            ball cut;
            arb_set_round(cut.handle(), x.handle(), bits);
            if (&x == &y) {
                arb_mul(result.handle(), cut.handle(), cut.handle(), bits);
                return result;
            }
            arb_set_round(result.handle(), y.handle(), bits);
            arb_mul(result.handle(), cut.handle(), result.handle(), bits);
        } else {
            arb_mul(result.handle(), x.handle(), y.handle(), bits);
        }
        return result;
    }

    // x/y for adding to a number of the size of y with this number of bits: fewer bits if x is small compared with y^2.
    static ball quotient(const ball& x, const ball& y, long bits) {
        const long few = std::min(bits, std::max(8L, bits + exponent(x) - 2 * exponent(y) + 8));
        ball result;
        if (bits > 640 && few < bits - 100) {
            arb_set_round(result.handle(), y.handle(), few);
            arb_div(result.handle(), x.handle(), result.handle(), few);
        } else {
            arb_div(result.handle(), x.handle(), y.handle(), bits);
        }
        return result;
    }

private:
    static constexpr int most_terms = 4;
    static constexpr std::array<ulong, 18> series{1,
                                                  4,
                                                  34,
                                                  360,
                                                  4239,
                                                  53148,
                                                  694582,
                                                  9348664,
                                                  128625067,
                                                  1800131564,
                                                  25538105486,
                                                  366348201176,
                                                  5304067812296,
                                                  77394671803040,
                                                  1136872705730600,
                                                  16796605751564320,
                                                  249415741237963837,
                                                  3720135370117399924};

    static long exponent(const ball& x) { return fmpz_get_si(ARF_EXPREF(arb_midref(x.handle()))); }
    // The largest s for which |x| <= 2^-s is proved, at most slightly above the precision.
    long smallness(const ball& x) const {
        mag_t size;
        mag_init(size);
        arb_get_mag(size, x.handle());
        const bool zero = mag_is_zero(size) != 0;
        const bool bounded = zero || (mag_is_finite(size) != 0 && fmpz_fits_si(MAG_EXPREF(size)) != 0);
        const long exponent = zero || !bounded ? -bits_ : fmpz_get_si(MAG_EXPREF(size));
        mag_clear(size);
        return bounded ? std::min(-exponent, bits_ + 8) : 0;
    }
    long power_of_third() const { return long{terms_ + 1} * (terms_ + 1); }
    long power_of_second() const { return long{terms_ + 1} * (terms_ + 2); }

    void descend(const nome_steps& most);
    void solve_nome(int most_terms_of_series);
    void raise_powers();
    void measure();

    long bits_;
    long small_ = 0;  ///< P <= 2^-small
    int terms_ = 1;
    ball a_;
    ball b_;
    ball mean_;
    ball scale_;
    std::vector<ball> steps_;
    std::array<ball, most_terms + 1> square_powers_;   ///< P^(n^2)
    std::array<ball, most_terms + 1> between_powers_;  ///< P^(n(n+1))
};

// Until this number of terms suffices: one up to 2000 bits, then two and three; the time hardly depends on it.
inline void landen_nome::descend(const nome_steps& most) {
    const int affordable = bits_ < 2000 ? 1 : bits_ < 20'000 ? 2 : 3;
    ball sum = a_ + b_;
    ball difference = a_ - b_;
    const long longest = doublings(2 + std::max(0L, exponent(a_) - exponent(b_))) + doublings(bits_) + 8;
    for (long level = 1; level <= longest; ++level) {
        arb_mul(b_.handle(), a_.handle(), b_.handle(), bits_);
        arb_sqrt(b_.handle(), b_.handle(), bits_);
        arb_mul_2exp_si(a_.handle(), sum.handle(), -1);
        std::swap(sum, difference);  // sum is now 2 c_n
        arb_sub(difference.handle(), a_.handle(), b_.handle(), bits_);
        if (arb_is_finite(difference.handle()) == 0) {
            throw precision_exhausted("a nome");  // an input so wide that a mean of it may be 0
        }
        small_ = smallness(difference) + exponent(a_) + 1;  // e is about difference/(8a)
        terms_ = 1;
        while (terms_ <= affordable && power_of_third() * small_ < bits_ + 4) {
            ++terms_;
        }
        if (small_ >= 5 && terms_ <= affordable) {
            return;
        }
        if (small_ >= 5 && level >= most.levels) {
            terms_ = most.terms;
            return;
        }
        steps_.emplace_back();
        ball& step = steps_.back();
        const long bits = std::min(bits_, std::max(64L, bits_ + 2 * (exponent(sum) - exponent(a_)) + 8));
        step = product(sum, sum, bits);
        arb_mul_2exp_si(step.handle(), step.handle(), -4);
        arb_add(sum.handle(), a_.handle(), b_.handle(), bits_);
    }
    throw precision_exhausted("a nome");
}

inline void landen_nome::solve_nome(int most_terms_of_series) {
    const long bits = std::max(8L, bits_ - small_ + 8);
    ball e;
    ball sum;
    arb_add(sum.handle(), a_.handle(), b_.handle(), bits);
    arb_sub(e.handle(), a_.handle(), b_.handle(), bits_);
    arb_div(e.handle(), e.handle(), sum.handle(), bits);
    arb_mul_2exp_si(e.handle(), e.handle(), -2);
    const long least = smallness(e);
    if (least < 3) {
        throw precision_exhausted("a nome");
    }
    long count = 1;
    while (2 * count * (least - 2) + least < bits_ && count < most_terms_of_series) {
        ++count;
    }
    const ball square = product(e, e, std::max(8L, bits - 2 * least + 8));
    ball factor;
    arb_set_ui(factor.handle(), series[static_cast<std::size_t>(count - 1)]);
    for (long j = count - 2; j >= 0; --j) {
        const long enough = std::max(8L, bits - 2 * j * (least - 4));
        arb_mul(factor.handle(), factor.handle(), square.handle(), enough);
        arb_add_ui(factor.handle(), factor.handle(), series[static_cast<std::size_t>(j)], enough);
    }
    // 4e <= 2^(2 - least) <= 1/2, and 4/(1 - 1/4) < 2^3.
    arb_add_error_2exp_si(factor.handle(), 3 - 2 * count * (least - 2));
    ball& nome = square_powers_[1];
    arb_mul(nome.handle(), factor.handle(), e.handle(), bits);
    small_ = smallness(nome);
    if (small_ < 3) {
        throw precision_exhausted("a nome");
    }
}

inline void landen_nome::raise_powers() {
    const ball& nome = square_powers_[1];
    ball power = nome;
    between_powers_[1] = product(nome, nome, deserved(2));
    for (int n = 2; n <= terms_; ++n) {
        const auto i = static_cast<std::size_t>(n);
        power = product(power, nome, deserved(n * n));
        square_powers_[i] = product(between_powers_[i - 1], power, deserved(n * n));
        between_powers_[i] = product(square_powers_[i], power, deserved(n * (n + 1)));
    }
}

inline void landen_nome::measure() {
    ball second = between_powers_[1];
    ball third = square_powers_[1];
    for (int n = 2; n <= terms_; ++n) {
        const auto i = static_cast<std::size_t>(n);
        arb_add(second.handle(), second.handle(), between_powers_[i].handle(), bits_);
        arb_add(third.handle(), third.handle(), square_powers_[i].handle(), bits_);
    }
    arb_mul_2exp_si(third.handle(), third.handle(), 1);
    arb_add_ui(second.handle(), second.handle(), 1, bits_);
    arb_add_ui(third.handle(), third.handle(), 1, bits_);
    widen_second(second);
    widen_third(third);
    arb_div(scale_.handle(), a_.handle(), third.handle(), bits_);
    arb_div(mean_.handle(), scale_.handle(), third.handle(), bits_);
    arb_mul(scale_.handle(), scale_.handle(), second.handle(), bits_);
}

}  // namespace libration::elliptic
