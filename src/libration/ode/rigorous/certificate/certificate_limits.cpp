#include "certificate_limits.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "libration/scalar/error.hpp"

namespace libration::ode {

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
    throw error(error_kind::argument, "certificate", "", what + ": " + remedy);
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
