#include "formula_refusals.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "libration/scalar/expression.hpp"

namespace libration::ode {

namespace {

// The function that another name denotes elsewhere; empty if it is not known.
std::string function_meant_by(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::pair<std::string_view, std::string_view>, 12> others{{{"ln", "log"},
                                                                                    {"tg", "tan"},
                                                                                    {"sh", "sinh"},
                                                                                    {"ch", "cosh"},
                                                                                    {"th", "tanh"},
                                                                                    {"arcsin", "asin"},
                                                                                    {"arccos", "acos"},
                                                                                    {"arctan", "atan"},
                                                                                    {"arctg", "atan"},
                                                                                    {"arcsinh", "asinh"},
                                                                                    {"arccosh", "acosh"},
                                                                                    {"arctanh", "atanh"}}};
    const auto found =
        std::ranges::find(others, std::string_view(name), &std::pair<std::string_view, std::string_view>::first);
    if (found != others.end()) {
        return std::string(found->second);
    }
    return is_function_name(name) ? name : "";
}

}  // namespace

void refuse_product(const statement& words, std::size_t second) {
    refuse(text_of(words, second - 1, second + 1), words[second - 1].at,
           "multiplies without *: write " + corrected(words, second, second, "*"));
}

void refuse_denominator(const statement& words, std::size_t begin, std::size_t slash, std::size_t numeral,
                        std::size_t end) {
    const std::string above = text_of(words, begin, slash);
    const std::string below = text_of(words, slash + 1, numeral + 1);
    const std::string behind = text_of(words, numeral + 1, end);
    refuse(text_of(words, begin, end), words[slash].at,
           "is ambiguous: write " + corrected(words, begin, end, above + "/(" + below + "*" + behind + ")") + ", or " +
               corrected(words, begin, end, "(" + above + "/" + below + ")*" + behind));
}

void refuse_exponent(const statement& words, std::size_t begin, std::size_t numeral, std::size_t end) {
    const std::string exponent = text_of(words, begin, numeral + 1);
    const std::string behind = text_of(words, numeral + 1, end);
    refuse(text_of(words, begin - 2, end), words[begin - 1].at,
           "is ambiguous: write " + corrected(words, begin, end, "(" + exponent + "*" + behind + ")") + ", or " +
               corrected(words, begin, end, exponent + "*" + behind));
}

void refuse_without_argument(const statement& words, std::size_t function) {
    const std::string& name = words[function].text;
    const bool operand = function + 1 < words.size() && words[function + 1].kind != token_kind::symbol;
    const std::string call = operand ? name + "(" + text_of(words, function + 1, function + 2) + ")" : name + "(...)";
    refuse(name, words[function].at,
           "is a function without ( after it: write " + corrected(words, function, function + (operand ? 2 : 1), call));
}

void refuse_argument(const statement& words, std::size_t name, const known_names& names) {
    const token& word = words[name];
    const std::string written = text_of(words, name, name + 1);
    const std::string product = corrected(words, name + 1, name + 1, "*") + " for a product";
    if (names.unknowns.contains(word.text)) {
        refuse(written + "(", word.at,
               "is ambiguous: write " + product + ", or " + written + "(0) = 1 as a statement for an initial value");
    }
    if (names.parameters.contains(word.text)) {
        refuse(written + "(", word.at,
               "is ambiguous: write " + product + ", or for a function one of " + function_names());
    }
    const std::string meant = function_meant_by(word.text);
    refuse(written, word.at,
           "is not a function: write " + (meant.empty() ? product : corrected(words, name, name + 1, meant)) +
               ", or one of " + function_names());
}

void refuse_name(const token& word, const known_names& names) {
    const std::string& name = word.text;
    if (name == "i") {
        refuse(name, word.at, "has no value: use imaginary numbers only in points");
    }
    if (name == "inf") {
        refuse(name, word.at, "is not a number: write one");
    }
    refuse(name, word.at,
           name == "t"
               ? "has no value: use the variable, " + names.variable
               : "has no value: write " + name + " = number for a parameter, " + name + "' = ... for an unknown");
}

}  // namespace libration::ode
