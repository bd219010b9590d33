#include "interval_value.hpp"

#include "formula_parser.hpp"

namespace libration::ode {

namespace {

// The formulas of an interval: its ends in [a, b], or its centre and its radius in a +- b. Each is in the tokens from
// one index up to, but not including, another.
struct interval_places {
    bool by_radius = false;
    std::size_t first = 0, end_of_first = 0;
    std::size_t second = 0, end_of_second = 0;
};

// The index of the only token with this symbol outside of parentheses; `end` if there is none or another one.
std::size_t only_place_of(const statement& words, std::size_t begin, std::size_t end, char symbol) {
    std::size_t found = end;
    int depth = 0;
    for (std::size_t i = begin; i < end; ++i) {
        depth += change_of_depth(words[i]);
        if (depth == 0 && is_symbol(words[i], symbol)) {
            if (found != end) {
                return end;
            }
            found = i;
        }
    }
    return found;
}

interval_places parts_of(bool by_radius, std::size_t begin, std::size_t middle, std::size_t end) {
    return {by_radius, begin, middle, middle + 1, end};
}

bool has_two_parts(const interval_places& of) { return of.first < of.end_of_first && of.second < of.end_of_second; }

// In the tokens from this index to the end of the statement; std::nullopt if they are another value.
std::optional<interval_places> interval_in(const statement& words, std::size_t begin) {
    const std::size_t end = words.size();
    if (symbol_at(words, begin, '[')) {
        const bool closed = is_symbol(words.back(), ']');
        const std::size_t comma = closed ? only_place_of(words, begin + 1, end - 1, ',') : end;
        const auto parts = parts_of(false, begin + 1, comma, end - 1);
        if (!closed || comma == end - 1 || !has_two_parts(parts)) {
            refuse(text_of(words, begin, end), words[begin].at, "is not an interval: write both ends, as in [0, 1]");
        }
        return parts;
    }
    const std::size_t sign = only_place_of(words, begin, end, interval_sign);
    const auto parts = parts_of(true, begin, sign, end);
    return sign < end && has_two_parts(parts) ? std::optional(parts) : std::nullopt;
}

expression constant_in(const statement& words, std::size_t first, std::size_t last, const known_names& names) {
    expression value = read_formula(words, first, last, names, formula_role::value);
    if (!value.is_constant()) {
        refuse(whole(words), words[first].at,
               "has an end of an interval that is not constant: give a number or parameters");
    }
    return value;
}

}  // namespace

std::optional<number_set> set_in(const statement& words, std::size_t begin, const std::string& name,
                                 const known_names& names) {
    const auto places = interval_in(words, begin);
    if (!places) {
        return std::nullopt;
    }
    const expression first = constant_in(words, places->first, places->end_of_first, names);
    const expression second = constant_in(words, places->second, places->end_of_second, names);
    return places->by_radius ? number_set{name, first - second, first + second, words[0].at}
                             : number_set{name, first, second, words[0].at};
}

}  // namespace libration::ode
