#include "certificate_text.hpp"

#include <algorithm>
#include <cstdlib>

#include "../ball_polynomial.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

std::pair<ball, long> mantissa_of(const ball& exact) {
    fmpz_t m;
    fmpz_t e;
    fmpz_init(m);
    fmpz_init(e);
    arf_get_fmpz_2exp(m, e, arb_midref(exact.handle()));
    std::pair<ball, long> result{ball(0), -fmpz_get_si(e)};
    arb_set_fmpz(result.first.handle(), m);
    fmpz_clear(m);
    fmpz_clear(e);
    return result;
}

rational fraction_of(const ball& exact) {
    const auto [whole, exponent] = mantissa_of(exact);
    const integer power = integer(1) << static_cast<unsigned>(std::abs(exponent));
    const integer numerator = nearest_integer(whole);
    return exponent < 0 ? rational(integer(numerator * power)) : rational(numerator, power);
}

std::string decimal_fraction(const rational& q) {
    integer rest = denominator(q);
    long twos = 0;
    long fives = 0;
    for (; rest % 2 == 0; rest /= 2) {
        ++twos;
    }
    for (; rest % 5 == 0; rest /= 5) {
        ++fives;
    }
    const integer power = pow(integer(10), static_cast<unsigned>(std::max(twos, fives)));
    if (rest != 1 || power == 1) {
        return q.str();
    }
    return integer(numerator(q) * (power / denominator(q))).str() + "/" + power.str();
}

namespace {

std::string hexadecimal(const ball& whole) {
    fmpz_t n;
    fmpz_init(n);
    arf_get_fmpz(n, arb_midref(whole.handle()), ARF_RND_DOWN);
    char* raw = fmpz_get_str(nullptr, 16, n);
    std::string text = raw;
    flint_free(raw);
    fmpz_clear(n);
    return text;
}

template <class Whole>
std::string decimal(Whole k) {
    return std::to_string(k);
}

template <class List, class Text>
std::string joined(const List& of, const Text& text) {
    std::string result;
    for (const auto& each : of) {
        result += (result.empty() ? "" : " ") + text(each);
    }
    return result;
}

std::string lists_text(const std::vector<integer_list>& lists) {
    std::string text;
    for (const integer_list& each : lists) {
        text += joined(each, hexadecimal) + "\n";
    }
    return text;
}

std::string radii_text(const certificate_step& step) {
    std::vector<long> exponents;
    std::vector<ball> first;
    std::vector<ball> last;
    for (std::size_t b = 0; b < step.first.size(); ++b) {
        auto [m, k] = mantissa_of(step.first[b].exact());
        auto [n, l] = mantissa_of(step.last[b].exact());
        exponents.push_back(std::max(k, l));
        first.push_back(shifted(m, exponents.back() - k));
        last.push_back(shifted(n, exponents.back() - l));
    }
    return "radii " + joined(exponents, decimal<long>) + "\n" + lists_text({first, last});
}

}  // namespace

std::string text_of(const certificate_step& step) {
    const auto [length, exponent] = mantissa_of(step.length);
    return "step " + std::to_string(exponent) + "\n" + hexadecimal(length) + "\nscale " +
           joined(step.scales, decimal<long>) + "\nblocks " + joined(step.blocks, decimal<std::size_t>) + "\np " +
           std::to_string(step.curve_bits) + "\n" + lists_text(step.curve) + "V " +
           joined(step.frame_bits, decimal<long>) + "\n" + lists_text(step.frame) + "U " +
           joined(step.inverse_bits, decimal<long>) + "\n" + lists_text(step.inverse) + radii_text(step);
}

}  // namespace libration::ode
