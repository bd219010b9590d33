#include "formula_refusals.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <utility>

#include "formula_parser.hpp"
#include "libration/number/exact_real.hpp"
#include "libration/number/number_lexer.hpp"
#include "written_function.hpp"

namespace libration::ode {

namespace {

// The function that another name denotes elsewhere; empty if it is not known.
std::string function_meant_by(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return is_called_function(name) ? std::string(name_without_synonym(name)) : "";
}

std::string all_function_names() { return function_names() + " " + written_function_names() + " if piecewise"; }

// Throws error for the name of an operator between conditions that other languages have, in any case of letters.
void refuse_foreign_connective(const token& word) {
    std::string name = word.text;
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    static const std::map<std::string, std::string> remedies{
        {"and", "x > 1 and y > 2"},
        {"or", "x > 1 or y > 2"},
        {"not", "not (x > 1)"},
        {"nand", "not (x > 1 and y > 2)"},
        {"nor", "not (x > 1 or y > 2)"},
        {"xor", "(x > 1 and not (y > 2)) or (y > 2 and not (x > 1)) for one of the two"}};
    const auto found = remedies.find(name);
    // The lower-case names of connectives are operators, unless the problem has a name of that kind.
    const bool own = name == word.text && (name == "and" || name == "or" || name == "not");
    if (word.kind == token_kind::name && word.primes == 0 && found != remedies.end() && !own) {
        refuse(word.text, word.at, "is not an operator between conditions: write " + found->second);
    }
}

// The end of the argument at this index, y or (y + 1); the index itself for other tokens.
std::size_t end_of_argument(const statement& words, std::size_t at) {
    if (!symbol_at(words, at, '(')) {
        return at < words.size() && words[at].kind == token_kind::name ? at + 1 : at;
    }
    int open = 0;
    for (std::size_t i = at; i < words.size(); ++i) {
        open += is_symbol(words[i], '(') ? 1 : is_symbol(words[i], ')') ? -1 : 0;
        if (open == 0) {
            return i + 1;
        }
    }
    return at;
}

// sin^2(y), sin²(y), sin^-1 y.
[[noreturn]] void refuse_raised_function(const statement& words, std::size_t function) {
    const std::string& name = words[function].text;
    const std::string reason = "is a function without ( after it: write ";
    const bool negative = symbol_at(words, function + 2, '-');
    const std::size_t numeral = function + (negative ? 3 : 2);
    const std::size_t end = end_of_argument(words, numeral + 1);
    if (end == numeral + 1 || words[numeral].kind != token_kind::numeral) {
        refuse(name, words[function].at, reason + "the exponent behind the argument, as in " + name + "(x)^2");
    }
    const std::string written = text_of(words, numeral + 1, end);
    const std::string argument = symbol_at(words, numeral + 1, '(') ? written : "(" + written + ")";
    const std::string digits = words[numeral].raised ? words[numeral].value.str() : words[numeral].text;
    const std::string power = name + argument + "^" + (negative ? "-" : "") + digits;
    const std::string inverse = "a" + name;
    refuse(name, words[function].at,
           reason + corrected(words, function, end, power) + " for a power" +
               (negative && is_function_name(inverse)
                    ? ", " + corrected(words, function, end, inverse + argument) + " for the inverse function"
                    : ""));
}

}  // namespace

void refuse_product(const statement& words, std::size_t second) {
    for (const token& word : {words[second - 1], words[second]}) {
        refuse_foreign_connective(word);
        if (word.kind == token_kind::name && (word.text == "if" || word.text == "else") && word.primes == 0) {
            refuse(word.text, word.at, "is not an operator between values: write if(t > 1, 1, 0)");
        }
    }
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
    if (symbol_at(words, function + 1, '^')) {
        refuse_raised_function(words, function);
    }
    const std::string& name = words[function].text;
    const auto is_operand = [&](std::size_t at) { return at < words.size() && words[at].kind != token_kind::symbol; };
    const bool numeral = is_operand(function + 1) && words[function + 1].kind == token_kind::numeral;
    const bool product = numeral && is_operand(function + 2);
    const std::size_t end = function + (product ? 3 : is_operand(function + 1) ? 2 : 1);
    const std::string argument = product ? words[function + 1].text + "*" + text_of(words, function + 2, end)
                                         : text_of(words, function + 1, end);
    refuse(name, words[function].at,
           "is a function without ( after it: write " +
               corrected(words, function, end, name + "(" + (argument.empty() ? "..." : argument) + ")"));
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
    refuse_foreign_connective(word);
    const std::string meant = function_meant_by(word.text);
    if (word.text == "DiracDelta" || word.text == "dirac") {
        refuse(written, word.at,
               "is not a function: write an impulse as a jump of what it changes, as when t = 2: y = y + 1");
    }
    refuse(written, word.at,
           meant.empty() ? "is not a function: write one of " + all_function_names() + ", or " + product
                         : "is not a function: write " + corrected(words, name, name + 1, meant) + ", or one of " +
                               function_names());
}

void refuse_token(const statement& words, std::size_t at, std::size_t last) {
    const token& word = words[at];
    const bool operand = at < last && (word.kind != token_kind::symbol || word.symbol == '(');
    if (operand && at > 0) {
        refuse_product(words, at);
    }
    if (word.symbol == ')') {
        refuse(")", word.at, "closes nothing: add a (");
    }
    if (word.symbol == ',') {
        refuse(",", word.at, "is not expected in parentheses: write a decimal point");
    }
    refuse_interval(word);
    if (is_comparison(word) || is_connective(word)) {
        refuse(word.text, word.at, "is not expected here: write conditions in if(x > 1 and y < 2, a, b)");
    }
    refuse(word.text, word.at, "is not expected here: write + - * / or ^ between numbers and names");
}

void refuse_end(const statement& words, std::size_t last) {
    const token& end = words[std::min(last, words.size()) - 1];
    refuse(whole(words), end.at, "ends where a number or a name is missing: write one");
}

void refuse_depth(const statement& words, std::size_t at) {
    refuse(whole(words), words[at].at,
           "is nested more than " + std::to_string(deepest_formula) + " deep: use fewer parentheses");
}

void require_time(const statement& words, std::size_t name, const known_names& names) {
    const std::string written = text_of(words, name, name + 1);
    if (words[name].text == names.variable) {
        refuse(written, words[name].at,
               "is the independent variable, which has no value in a condition: write " +
                   corrected(words, name, name + 1, "1") + " with the time instead of 1");
    }
    const bool at_variable = has_variable_behind(words, name, names.variable);
    if (symbol_at(words, name + 1, '(') && !at_variable) {
        return;
    }
    const std::size_t end = at_variable ? name + 4 : name + 1;
    refuse(text_of(words, name, end), words[name].at,
           "is not at a constant time: write " + corrected(words, name, end, written + "(1)") +
               " with the time instead of 1");
}

void require_constant_time(const expression& time, const statement& words, std::size_t name, std::size_t end) {
    if (time.is_constant()) {
        return;
    }
    const std::string written = text_of(words, name, name + 1);
    refuse(text_of(words, name, end), words[name].at,
           "has a time that is not constant: write " + corrected(words, name, end, written + "(1)") +
               " with the time, of numbers and parameters, instead of 1");
}

expression delay_of(const expression& argument, const statement& words, std::size_t name, std::size_t end,
                    const known_names& names) {
    const std::string written = text_of(words, name, name + 1);
    const std::string form = written + "(" + names.variable + " - delay)";
    const std::string product = corrected(words, name + 1, name + 1, "*") + " for a product";
    const expression delay = variable() - argument;
    const expression at_zero = replaced(delay, [](const expression& leaf) -> std::optional<expression> {
        return leaf.kind() == node_kind::variable ? std::optional(expression()) : std::nullopt;
    });
    if (delay.has_unknowns() || !partial(argument, variable()).is(1)) {
        refuse(text_of(words, name, end), words[name].at,
               "has a delay that is not constant: write " + form + " with a number or parameters, or " + product);
    }
    if (const auto fraction = at_zero.fraction(); fraction && *fraction <= 0) {
        refuse(text_of(words, name, end), words[name].at,
               "is not at an earlier time: write " + form + " with a positive delay, or " + product);
    }
    return at_zero;
}

void refuse_interval(const token& word) {
    if (is_symbol(word, interval_sign)) {
        refuse(word.text, word.at, interval_reason);
    }
    if (is_symbol(word, '[') || is_symbol(word, ']')) {
        refuse(word.text, word.at,
               "is not a parenthesis here: write (, or x(0) = [0, 1] for all initial values from 0 to 1");
    }
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
