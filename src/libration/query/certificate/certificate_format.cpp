#include "certificate_format.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "../../integration/collocation/ball_polynomial.hpp"
#include "certificate_limits.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

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

namespace {

constexpr std::size_t most_digits = 4'000;
constexpr std::size_t deepest_formula = 150;

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }

// How deep factors, signs, exponents and parentheses are in one another, counted as the programs that check do.
std::size_t depth_of(const std::string& text) {
    std::vector<std::size_t> open;
    std::size_t depth = 1;
    std::size_t deepest = 1;
    bool operand = true;  // is expected
    for (const char c : text) {
        const std::size_t around = open.empty() ? 0 : open.back();
        if (c == '(') {
            open.push_back(depth);
            ++depth;
        } else if (c == ')') {
            depth = around;
            open.pop_back();
        } else if (c == '^' || (c == '-' && operand)) {
            ++depth;
        } else if (c == '+' || c == '-' || c == '*' || c == '/') {
            depth = around + 1;
        }
        operand = c == ' ' ? operand : std::string_view("(+-*/^").find(c) != std::string_view::npos;
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

std::size_t longest_integer(const std::string& text) {
    std::size_t longest = 0;
    std::size_t length = 0;
    for (const char c : text) {
        length = is_digit(c) ? length + 1 : 0;
        longest = std::max(longest, length);
    }
    return longest;
}

}  // namespace

void refuse_certificate(const std::string& what, const std::string& remedy) {
    throw error(error_kind::argument, error_subject::certificate, "", what + ": " + remedy);
}

void require_at_most(std::size_t count, std::size_t most, const std::string& what) {
    if (count > most) {
        refuse_certificate(
            "contains at most " + std::to_string(most) + " " + what + ", and here are " + std::to_string(count),
            "ask for fewer, or leave it out");
    }
}

void require_certified_name(const std::string& name) {
    constexpr std::array<std::string_view, 6> reserved{"exp", "log", "sin", "cos", "sqrt", "pi"};
    const bool spelt = !name.empty() && is_letter(name.front()) &&
                       std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); });
    const bool defined = name.size() > 1 && name.front() == '_' && std::all_of(name.begin() + 1, name.end(), is_digit);
    if (!spelt || defined || std::ranges::find(reserved, name) != reserved.end()) {
        refuse_certificate("does not contain '" + name + "' as a name", "choose a name of letters, digits and _");
    }
}

void require_certified_formula(const std::string& text) {
    if (text.size() > longest_certified_formula) {
        refuse_certificate("does not contain formulas as long as those of these equations", "leave it out");
    }
    if (const std::size_t digits = longest_integer(text); digits > most_digits) {
        refuse_certificate("contains integers of at most " + std::to_string(most_digits) + " digits, and one has " +
                               std::to_string(digits),
                           "write fewer digits, or leave it out");
    }
    if (const std::size_t depth = depth_of(text); depth > deepest_formula) {
        refuse_certificate("contains formulas that are nested at most " + std::to_string(deepest_formula) +
                               " deep, and one is " + std::to_string(depth) + " deep",
                           "write it with fewer parentheses, or leave it out");
    }
}

}  // namespace libration::ode
