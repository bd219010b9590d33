// Leibniz's notation, dx/dt, in the tokens of a problem.
#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "character.hpp"
#include "names.hpp"

namespace libration::ode {

namespace {

// "x" and 2 of dx^2 or dx2.
struct differential {
    std::string name;
    int order = 1;
    int primes = 0;
    std::size_t end = 0;  ///< the index of the token after it
};

constexpr int largest_order = 100;
constexpr std::string_view digits_of_numbers = "0123456789";

bool begins_with_letter(const std::string& text) {
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0;
}

bool has_digits_alone(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

int order_of_digits(const std::string& digits) {
    return digits.size() > 2 ? largest_order : std::min(std::stoi(digits), largest_order);
}

// The order in tokens ^ 2; std::nullopt for other tokens.
std::optional<int> exponent_at(const statement& words, std::size_t index) {
    const bool there = symbol_at(words, index, '^') && index + 1 < words.size() &&
                       words[index + 1].kind == token_kind::numeral && has_digits_alone(words[index + 1].value.str());
    return there ? std::optional(order_of_digits(words[index + 1].value.str())) : std::nullopt;
}

// "s" of s1.
std::string without_number(const std::string& name) {
    return name.substr(0, name.find_last_not_of(digits_of_numbers) + 1);
}

// d2x/dt2, or d^2x/ds1^2.
std::string quotient_of(const std::string& unknown, const std::string& variable, int order) {
    const std::string power = without_number(variable) == variable ? "" : "^";
    const std::string digits = order > 1 ? power + std::to_string(order) : "";
    return "d" + digits + unknown + "/d" + variable + digits;
}

class derivative_quotients {
public:
    derivative_quotients(const std::vector<statement>& all, std::optional<std::string> variable, known_names known)
        : variable_(std::move(variable)), known_(std::move(known)) {
        for (const statement& words : all) {
            for (const token& word : words) {
                if (word.kind == token_kind::name && word.primes > 0) {
                    known_.unknowns.insert(word.text);
                }
            }
            if (words[0].kind == token_kind::name && words[0].primes == 0 && symbol_at(words, 1, '=')) {
                known_.parameters.insert(words[0].text);
            }
        }
    }

    statement replaced(const statement& words) {
        statement result;
        for (std::size_t i = 0; i < words.size();) {
            const auto above = numerator_at(words, i);
            const auto below = above ? denominator_at(words, above->end) : std::nullopt;
            if (!below) {
                require_no_operator(words, i);
                result.push_back(words[i++]);
                continue;
            }
            result.push_back(derivative(words, i, *above, *below));
            i = below->end;
        }
        return result;
    }

    const std::optional<std::string>& variable() const { return found_; }

private:
    bool is_free(const token& word) const {
        return word.kind == token_kind::name && word.text.starts_with("d") && !known_.unknowns.contains(word.text) &&
               !known_.parameters.contains(word.text);
    }

    // dx, d2x or d^2x, before a /.
    std::optional<differential> numerator_at(const statement& words, std::size_t at) const {
        if (!is_free(words[at])) {
            return std::nullopt;
        }
        differential found{words[at].text.substr(1), 1, 0, at + 1};
        const auto order = exponent_at(words, at + 1);
        if (found.name.empty() && order && at + 3 < words.size() && words[at + 3].kind == token_kind::name) {
            found = {words[at + 3].text, *order, words[at + 3].primes, at + 4};
        } else {
            const std::size_t digits = std::min(found.name.find_first_not_of(digits_of_numbers), found.name.size());
            found.order = digits > 0 ? order_of_digits(found.name.substr(0, digits)) : 1;
            found.name = found.name.substr(digits);
        }
        const bool whole = begins_with_letter(found.name) && symbol_at(words, found.end, '/');
        return whole ? std::optional(found) : std::nullopt;
    }

    // dt, dt2 or dt^2, after the /. The 1 of ds1 is not an order.
    std::optional<differential> denominator_at(const statement& words, std::size_t slash) const {
        const std::size_t at = slash + 1;
        if (at >= words.size() || !is_free(words[at]) || words[at].primes > 0) {
            return std::nullopt;
        }
        differential found{words[at].text.substr(1), 1, 0, at + 1};
        if (const auto power = exponent_at(words, at + 1)) {
            found.order = *power;
            found.end = at + 3;
        } else if (found.name != variable_) {
            const std::string letters = without_number(found.name);
            const std::string digits = found.name.substr(letters.size());
            if (!digits.empty() && order_of_digits(digits) > 1) {
                found.order = order_of_digits(digits);
                found.name = letters;
            }
        }
        return is_variable(found.name) ? std::optional(found) : std::nullopt;
    }

    // d/dt x and d^2/dt^2 (x), which are not quotients.
    void require_no_operator(const statement& words, std::size_t at) const {
        if (words[at].text != "d" || !is_free(words[at])) {
            return;
        }
        const int order = exponent_at(words, at + 1).value_or(1);
        const std::size_t slash = order > 1 ? at + 3 : at + 1;
        const auto below = symbol_at(words, slash, '/') ? denominator_at(words, slash) : std::nullopt;
        if (!below) {
            return;
        }
        const bool opened = symbol_at(words, below->end, '(');
        const std::size_t name = below->end + (opened ? 1 : 0);
        const bool named =
            name < words.size() && words[name].kind == token_kind::name && (!opened || symbol_at(words, name + 1, ')'));
        const std::string quotient = quotient_of(named ? words[name].text : "x", below->name, order);
        refuse(text_of(words, at, below->end), words[at].at,
               "is an operator: write " +
                   (named ? corrected(words, at, name + (opened ? 2 : 1), quotient) : "the derivative as " + quotient));
    }

    // A word such as density in damping/density is not the differential of a variable.
    bool is_variable(const std::string& name) const {
        const std::string letters = without_number(name);
        const bool free = known_.unknowns.contains(name) || !known_.parameters.contains(name);
        return name == variable_ || is_greek_name(letters) ||
               (letters.size() == 1 && begins_with_letter(letters) && free);
    }

    void require_variable(const std::string& written, const place& at, const differential& above,
                          const differential& below) const {
        if (above.name == below.name) {
            refuse(written, at, "differentiates " + below.name + " by itself: rename the unknown or the variable");
        }
        if (known_.unknowns.contains(below.name)) {
            refuse(written, at,
                   "differentiates by " + below.name + ", which is an unknown: give one of them another name");
        }
    }

    token derivative(const statement& words, std::size_t at, const differential& above, const differential& below) {
        const std::string written = text_of(words, at, below.end);
        const auto of_order = [&](int order) { return quotient_of(above.name, below.name, order); };
        require_variable(written, words[at].at, above, below);
        if (above.order != below.order) {
            const int other = std::max(above.order, below.order);
            refuse(written, words[at].at,
                   "is ambiguous: write " + corrected(words, at, below.end, of_order(other)) + " for a derivative, " +
                       corrected(words, at, below.end, "(" + of_order(1) + ")^" + std::to_string(other)) +
                       " for a power");
        }
        const std::optional<std::string>& known = variable_ ? variable_ : found_;
        if (known && *known != below.name) {
            refuse(written, words[at].at,
                   "differentiates by " + below.name + ", but the independent variable is " + *known + ": write " +
                       corrected(words, at, below.end, primed(above.name, above.order + above.primes)) +
                       ", or `variable " + below.name + "`");
        }
        found_ = below.name;
        token made = words[at];
        made.text = above.name;
        made.primes = above.primes + above.order;
        made.source = {words[at].source.data(), written.size()};
        return made;
    }

    std::optional<std::string> variable_, found_;
    known_names known_;
};

}  // namespace

std::optional<std::string> with_primes(std::vector<statement>& all, const std::optional<std::string>& variable,
                                       const known_names& known) {
    derivative_quotients quotients(all, variable, known);
    for (statement& words : all) {
        words = quotients.replaced(words);
    }
    return quotients.variable();
}

}  // namespace libration::ode
