#include "attack/judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "libration/number/exact.hpp"

namespace libration::attack {

namespace {

constexpr long most_digits_of_truth = 40'000;
constexpr long first_guard_digits = 60;
constexpr long digits_that_agree = 20;
// If two precisions agree on 0, constants near 1 may cancel in both: use more digits than any of them has.
constexpr long digits_of_a_zero = 3'000;

// 10^n, exactly.
rational power_of_ten(long n) {
    const integer power = pow(integer(10), static_cast<unsigned>(std::abs(n)));
    return n < 0 ? rational(1, power) : rational(power);
}

// The exponent of the first digit of a nonzero decimal.
long first_exponent(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const long exponent = e == std::string_view::npos ? 0 : std::stol(std::string(text.substr(e + 1)));
    const std::string_view mantissa = text.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    const auto at = static_cast<long>(first);
    const auto dot = static_cast<long>(point);
    return exponent + (at < dot ? dot - at - 1 : dot - at);
}

// The true value in twice as many digits as the one with which it agrees; a 0 in many.
template <class Use>
std::optional<verdict> settled(const truth& exact, long digits, const Use& use) {
    for (long precision = digits + first_guard_digits; precision <= most_digits_of_truth; precision *= 2) {
        mpfr rough;
        {
            const precision_scope scope(precision);
            rough = exact();
        }
        const precision_scope scope(2 * precision);
        const mpfr fine = exact();
        if (!isfinite(rough) || !isfinite(fine)) {
            return std::nullopt;
        }
        const mpfr small = abs(fine) * real(power_of_ten(-(digits + digits_that_agree)));
        const bool may_cancel = fine == 0 && precision < digits_of_a_zero;
        if (!may_cancel && abs(mpfr(fine - rough)) <= small) {
            return use(fine, small);
        }
    }
    return std::nullopt;
}

}  // namespace

mpfr real(const rational& q) {
    mpfr result;
    mpfr_set_q(handle(result), q.backend().data(), MPFR_RNDN);
    return result;
}

rational typed_fraction(const std::string& decimal) { return read_exact(decimal).coefficient; }

mpfr pi_value() { return 4 * atan(mpfr(1)); }

double rough(const truth& exact) {
    const precision_scope scope(700);
    return exact().convert_to<double>();
}

void outcome::add(verdict v, const std::string& statement) {
    ++counts[static_cast<std::size_t>(v)];
    statements.emplace_back(v, statement);
}

verdict judged(const proved_decimal& printed, long digits, const truth& exact) {
    const rational value = typed_fraction(printed.text);
    const auto judge = [&](const mpfr& fine, const mpfr& small) {
        if (value == 0 || fine == 0) {
            return value == 0 && fine == 0 ? verdict::right : verdict::wrong;
        }
        const mpfr off = abs(mpfr(fine - real(value)));
        const mpfr unit = real(power_of_ten(first_exponent(printed.text) - digits + 1)) + small;
        const mpfr bound = printed.uncertainty.empty() ? unit : mpfr(real(typed_fraction(printed.uncertainty)) + small);
        return off <= unit && off <= bound ? verdict::right : verdict::wrong;
    };
    return settled(exact, digits, judge).value_or(verdict::undecided);
}

verdict judged_bounds(const std::string& lower, const std::string& upper, const truth& exact) {
    const auto judge = [&](const mpfr& fine, const mpfr& small) {
        const bool above = lower.empty() || real(typed_fraction(lower)) <= fine + small;
        const bool below = upper.empty() || fine <= real(typed_fraction(upper)) + small;
        return above && below ? verdict::right : verdict::wrong;
    };
    return settled(exact, static_cast<long>(lower.size() + upper.size()), judge).value_or(verdict::undecided);
}

verdict judged_distance(const std::string& from, const std::vector<std::string>& bounds, const truth& exact) {
    rational most = 0;
    long digits = static_cast<long>(from.size());
    for (const std::string& each : bounds) {
        if (const rational bound = typed_fraction(each); bound != 0) {
            most += bound;
            digits = std::max(digits, -first_exponent(each));
        }
    }
    const auto judge = [&](const mpfr& fine, const mpfr& small) {
        return abs(mpfr(fine - real(typed_fraction(from)))) <= real(most) + small ? verdict::right : verdict::wrong;
    };
    return settled(exact, digits, judge).value_or(verdict::undecided);
}

verdict judged_ball(const ball& enclosure, const truth& exact) {
    constexpr double digits_of_bit = 0.302;
    constexpr long bits_of_ends = 10'000;  // whose rounding, outwards, is far below a radius
    const slong accurate = std::clamp<slong>(arb_rel_accuracy_bits(enclosure.handle()), 0, bits_of_ends / 2);
    const auto judge = [&](const mpfr& fine, const mpfr& small) {
        mpfr lower;
        mpfr upper;
        mpfr_set_prec(handle(lower), bits_of_ends);
        mpfr_set_prec(handle(upper), bits_of_ends);
        arb_get_interval_mpfr(handle(lower), handle(upper), enclosure.handle());
        return lower <= fine + small && fine - small <= upper ? verdict::right : verdict::wrong;
    };
    const auto digits = static_cast<long>(static_cast<double>(accurate) * digits_of_bit) + 1;
    return settled(exact, digits, judge).value_or(verdict::undecided);
}

int sign_of(const truth& exact, long most) {
    for (long precision = 60; precision <= most; precision *= 2) {
        const precision_scope scope(precision);
        const mpfr value = exact();
        if (abs(value) > real(power_of_ten(-precision / 2))) {
            return value < 0 ? -1 : 1;
        }
    }
    return 0;
}

}  // namespace libration::attack
