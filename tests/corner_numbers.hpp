// Operands with which carries, cancellations and bounds at their limit fail, where uniformly random ones do not: half
// of the operands of every test of proved arithmetic are drawn from here.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/fraction.hpp"

namespace libration::tests {

/// Corner cases from a fixed seed: integers of all ones, of a single one, of ones with a hole and of runs of ones and
/// zeros; exact balls of extreme exponents; radii 0, of a last place, of the midpoint and beyond; decimals next to 1.
class corner_numbers {
public:
    explicit corner_numbers(std::uint64_t seed) : bits_(seed) {}

    std::uint64_t below(std::uint64_t n) { return bits_() % n; }
    long between(long least, long most) {
        return least + static_cast<long>(below(static_cast<std::uint64_t>(most - least) + 1));
    }
    bool one_in(std::uint64_t n) { return below(n) == 0; }

    /// A corner case or the usual operand, each half of the time.
    template <class Corner, class Usual>
    auto half(const Corner& corner, const Usual& usual) -> decltype(usual()) {
        return one_in(2) ? corner() : usual();
    }

    /// 2^bits - 1.
    static integer ones(long bits) { return (integer(1) << static_cast<unsigned long>(bits)) - 1; }

    /// At most `bits` >= 1 bits and > 0: a corner case five times of six.
    integer positive(long bits) {
        switch (below(6)) {
            case 0: return ones(bits);
            case 1: return ones(bits) - (integer(1) << below(static_cast<std::uint64_t>(bits))) + (bits == 1 ? 1 : 0);
            case 2: return power_of_two(bits - 1);
            case 3: return power_of_two(bits - 1) + 1 - (bits == 1 ? 1 : 0);
            case 4: return runs(bits);
            default: return uniform(bits);
        }
    }
    /// The same of either sign.
    integer whole(long bits) { return one_in(2) ? positive(bits) : integer(-positive(bits)); }

    /// 2^64 times a number of words, give or take one, or any number of bits up to `most` >= 2.
    long length(long most) {
        const long limbs = std::max<long>(most / 64, 1);
        const long all = one_in(2) ? 64 * between(1, limbs) + between(-1, 1) : between(2, most);
        return std::clamp<long>(all, 2, most);
    }

    /// m 2^e exactly, |m| of at most `bits` bits, and 2^e so that the value lies within 2^-far .. 2^far; 0 sometimes.
    ball exact(long bits, long far) {
        ball result;
        if (one_in(25)) {
            return result;
        }
        const rational number(whole(bits));
        const fraction_parts parts(number);
        arf_set_fmpz(arb_midref(result.handle()), parts.above());
        arb_mul_2exp_si(result.handle(), result.handle(), between(-far, far) - bits);
        return result;
    }

    /// exact() with a radius: 0, near the last place, about |midpoint|, or anything within 2^-far .. 2^far, but no
    /// further than 2^10000 from the midpoint, so that its ends can be written exactly.
    ball wide(long bits, long far) {
        ball result = exact(bits, far);
        mag_ptr const radius = arb_radref(result.handle());
        if (arf_is_zero(arb_midref(result.handle())) != 0) {
            mag_set_ui_2exp_si(radius, below(1U << 30U), between(-far, far) - 30);
            return result;
        }
        const long reach = std::min<long>(far, 10'000);
        switch (below(6)) {
            case 0:
            case 1: return result;
            case 2:
            case 3:
                arf_get_mag(radius, arb_midref(result.handle()));
                mag_mul_2exp_si(radius, radius, between(-3, 3) - bits);
                return result;
            case 4:
                arf_get_mag(radius, arb_midref(result.handle()));
                mag_mul_2exp_si(radius, radius, between(-40, 3));
                return result;
            default:
                arf_get_mag(radius, arb_midref(result.handle()));
                mag_mul_2exp_si(radius, radius, between(-reach, reach));
                return result;
        }
    }

    /// A number of the ball, exactly: an end, the middle, or one between. Of a ball that is finite.
    ball member(const ball& x) {
        ball result = x;
        ball radius;
        arf_set_mag(arb_midref(radius.handle()), arb_radref(x.handle()));
        mag_zero(arb_radref(result.handle()));
        if (one_in(3)) {
            arb_mul_2exp_si(radius.handle(), radius.handle(), -between(1, 30));
        }
        const auto move = one_in(2) ? arf_add : arf_sub;
        if (!one_in(5)) {
            move(arb_midref(result.handle()), arb_midref(result.handle()), arb_midref(radius.handle()), ARF_PREC_EXACT,
                 ARF_RND_DOWN);
        }
        return result;
    }

    /// A decimal in (0, 2]: 20 to 40 nines, 1 -+ 10^-k, a power of two with all its digits, or 1.
    std::string decimal() {
        switch (below(5)) {
            case 0:
            case 1: return "0." + nines(between(20, 40));
            case 2: return "1." + std::string(static_cast<std::size_t>(between(1, 60)), '0') + "1";
            case 3: return power_of_half(between(1, 40));
            default: return one_in(2) ? "1" : "0." + nines(between(1, 60));
        }
    }

    /// The text of a constant in (0, 2): 1 -+ 2^-k and 1 -+ 10^-k as powers, tanh(25), or a decimal.
    std::string constant() {
        const std::string sign = one_in(4) ? "+" : "-";
        switch (below(5)) {
            case 0:
            case 1: return "1 " + sign + " 2^(-" + std::to_string(one_in(2) ? tight() : between(1, 600)) + ")";
            case 2: return "1 " + sign + " 10^(-" + std::to_string(between(1, 150)) + ")";
            case 3: return one_in(2) ? "tanh(25)" : "1 - exp(-" + std::to_string(between(20, 200)) + ")";
            default: return decimal();
        }
    }

private:
    static integer power_of_two(long exponent) { return integer(1) << static_cast<unsigned long>(exponent); }
    static std::string nines(long count) { return std::string(static_cast<std::size_t>(count), '9'); }
    // 2^-k = 5^k / 10^k.
    static std::string power_of_half(long k) {
        const std::string digits = integer(pow(integer(5), static_cast<unsigned>(k))).str();
        return "0." + std::string(static_cast<std::size_t>(k) - digits.size(), '0') + digits;
    }
    // Lengths of integers whose products with as long ones come near a whole number of words.
    long tight() { return 32 * between(1, 20) - between(1, 8); }

    integer runs(long bits) {
        integer result = 1;
        long left = bits - 1;
        for (bool one = one_in(2); left > 0; one = !one) {
            const long run = std::min<long>(left, one_in(3) ? 64 * between(1, 2) : between(1, 200));
            result <<= static_cast<unsigned long>(run);
            result += one ? ones(run) : integer(0);
            left -= run;
        }
        return result;
    }
    integer uniform(long bits) {
        integer result = 1;
        for (long left = bits - 1; left > 0; left -= 60) {
            const long part = std::min<long>(left, 60);
            result <<= static_cast<unsigned long>(part);
            result += bits_() >> static_cast<unsigned>(64 - part);
        }
        return result;
    }

    std::mt19937_64 bits_;
};

}  // namespace libration::tests
