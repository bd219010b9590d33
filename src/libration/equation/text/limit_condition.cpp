#include "libration/equation/text/limit_condition.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

// The time for infinity while the rest of a condition is read.
constexpr std::string_view far_time = "1000000000000000000000007";
constexpr std::string_view exponentially_word = "exponentially";
constexpr std::string_view fast_word = "fast";
constexpr std::string_view amplitude_words = " with amplitude ";

bool is_infinity(const token& word) { return word.kind == token_kind::name && word.primes == 0 && word.text == "inf"; }

// Whether ( inf ) or ( -inf ) is at this place.
bool is_limit_at(const statement& words, std::size_t i) {
    const std::size_t sign = symbol_at(words, i + 1, '-') ? 1 : 0;
    return symbol_at(words, i, '(') && i + 1 + sign < words.size() && is_infinity(words[i + 1 + sign]) &&
           symbol_at(words, i + 2 + sign, ')');
}

bool has_limit(const statement& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (is_limit_at(words, i)) {
            return true;
        }
    }
    return false;
}

std::string replaced_in(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
    return text;
}

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    const auto last = text.find_last_not_of(" \t");
    return first == std::string_view::npos ? "" : std::string(text.substr(first, last + 1 - first));
}

// With a large number for infinity in ( inf ) and ( -inf ).
std::string with_far_times(const std::string& condition) {
    std::string result = condition;
    const auto statements = statements_of(condition);
    for (auto words = statements.rbegin(); words != statements.rend(); ++words) {
        for (std::size_t i = words->size(); i-- > 0;) {
            if (is_infinity((*words)[i]) && i > 0) {
                const std::size_t open = symbol_at(*words, i - 1, '-') ? i - 2 : i - 1;
                if (is_limit_at(*words, open)) {
                    const auto at = static_cast<std::size_t>((*words)[i].source.data() - condition.data());
                    result.replace(at, (*words)[i].source.size(), far_time);
                }
            }
        }
    }
    return result;
}

// f(time) = value; the leaf of the value is the only one.
limit_condition limit_in(const equation_system& of, const std::string& condition) {
    conditions_at_times read;
    add_condition(read, of, with_far_times(condition));
    if (read.values().size() != 1) {
        refuse(condition, {}, "is not a condition for one value at infinity: write one, as f'(inf) = 1");
    }
    const value_at_time& value = read.values().front();
    const expression& leaf = read.leaves().front();
    const expression& difference = read.differences().front();
    const auto factor = partial(difference, leaf).fraction();
    const auto time = value.time.fraction();
    if (!time || abs(*time) != rational(std::string(far_time))) {
        refuse(condition, {}, "is not at inf or -inf: give the conditions at times by themselves");
    }
    if (!factor || *factor == 0) {
        refuse(condition, {},
               "is not linear in its value at infinity: write " + primed(value.of.name(), value.of.derivative()) +
                   "(inf) = number");
    }
    const expression rest = replaced(difference, [&](const expression& each) {
        return same_form(each, leaf) ? std::optional<expression>(0) : std::nullopt;
    });
    return {value.of, -rest / expression(*factor), *time > 0 ? 1 : -1};
}

}  // namespace

separated_text with_limits_separated(const std::string& problem) {
    separated_text result{problem, {}};
    for (const statement& words : statements_of(problem)) {
        if (has_limit(words)) {
            const auto first = static_cast<std::size_t>(words.front().source.data() - problem.data());
            const auto last =
                static_cast<std::size_t>(words.back().source.data() - problem.data()) + words.back().source.size();
            result.limits.push_back(problem.substr(first, last - first));
            std::fill_n(result.problem.begin() + static_cast<std::ptrdiff_t>(first), last - first, ' ');
        }
    }
    return result;
}

bool has_limit(std::string_view condition) {
    try {
        const auto all = statements_of(condition);
        return std::ranges::any_of(all, [](const statement& words) { return has_limit(words); });
    } catch (const error&) {
        return false;  // reported where it is read
    }
}

limit_condition parse_limit(const equation_system& of, const std::string& condition) {
    std::string words = trimmed(condition);
    const auto ends_with = [&](std::string_view word) {
        const bool found = words.ends_with(" " + std::string(word));
        if (found) {
            words = trimmed(std::string_view(words).substr(0, words.size() - word.size()));
        }
        return found;
    };
    std::string amplitude;
    if (const auto at = words.find(amplitude_words); at != std::string::npos) {
        amplitude = trimmed(std::string_view(words).substr(at + amplitude_words.size()));
        words.resize(at);
    }
    const bool exponentially = ends_with(exponentially_word);
    const bool fast = ends_with(fast_word);
    try {
        limit_condition result = limit_in(of, words);
        if (!amplitude.empty()) {
            const std::string name = primed(result.of.name(), result.of.derivative());
            result.amplitude = limit_in(of, name + "(inf) = " + amplitude).value;
        }
        result.exponentially = exponentially;
        result.fast = fast;
        result.text = trimmed(condition);
        return result;
    } catch (const error& problem) {
        throw error(problem.kind(), subject_name(problem.about(), problem.subject()),
                    replaced_in(problem.value(), far_time, "inf"), replaced_in(problem.reason(), far_time, "inf"));
    }
}

}  // namespace libration::ode
