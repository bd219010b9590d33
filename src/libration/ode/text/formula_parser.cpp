#include "formula_parser.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int deepest_formula = 100;
constexpr std::array<std::string_view, 4> names_of_columns{"n", "time", "digits", "rigour"};

// By recursive descent, of bounded depth: sum, product, signed factor, power, primary.
class formula_parser {
public:
    formula_parser(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                   formula_role role)
        : words_(words), next_(first), last_(last), names_(names), role_(role) {}

    expression read() {
        expression value = sum();
        if (next_ < last_) {
            refuse_next();
        }
        return value;
    }

private:
    bool at_symbol(char c) const {
        return next_ < last_ && words_[next_].kind == token_kind::symbol && words_[next_].symbol == c;
    }
    bool take(char c) {
        const bool found = at_symbol(c);
        next_ += found ? 1 : 0;
        return found;
    }
    bool at_operand() const {
        return next_ < last_ && (words_[next_].kind != token_kind::symbol || words_[next_].symbol == '(');
    }

    [[noreturn]] void refuse_end() const {
        const token& end = words_[std::min(last_, words_.size()) - 1];
        refuse(text_of(words_, 0, words_.size()), end.at, "ends where a number or a name is missing: write one");
    }

    // Reports a token that cannot follow an operand.
    [[noreturn]] void refuse_next() const {
        const token& word = words_[next_];
        if (at_operand() && next_ > 0) {
            const token& before = words_[next_ - 1];
            const std::string both = text_of(words_, next_ - 1, next_ + 1);
            const std::string left = beginning_of(text_of(words_, next_ - 1, next_));
            const std::string right = beginning_of(text_of(words_, next_, next_ + 1));
            refuse(both, before.at, "multiplies without *: write " + left + "*" + right);
        }
        if (word.symbol == ')') {
            refuse(")", word.at, "closes nothing: add a (");
        }
        if (word.symbol == ',') {
            refuse(",", word.at, "is not expected: write a decimal point, and ; between statements");
        }
        refuse(std::string(word.text), word.at, "is not expected here: write + - * / or ^ between numbers and names");
    }

    void enter() {
        if (++depth_ > deepest_formula) {
            refuse(text_of(words_, 0, words_.size()), words_[std::min(next_, last_ - 1)].at,
                   "is nested more than " + std::to_string(deepest_formula) + " deep: use fewer parentheses");
        }
    }

    // Operations on constants may have no value.
    template <class Operation>
    expression folded(const place& at, const Operation& operation) const {
        try {
            return operation();
        } catch (const error& problem) {
            if (problem.subject() == "problem") {
                throw;
            }
            const std::string subject = problem.subject() == "number" ? "" : problem.subject() + " ";
            throw error(problem.kind(), "problem", beginning_of(text_of(words_, 0, words_.size())),
                        "at line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + " " +
                            (subject.empty() ? "" : "has an " + subject + "that ") + problem.reason() +
                            (problem.subject() == "number" ? ": choose another number" : ""));
        }
    }

    expression sum() {
        enter();
        expression total = product();
        while (at_symbol('+') || at_symbol('-')) {
            const token& sign = words_[next_++];
            const expression more = product();
            total = folded(sign.at, [&] { return sign.symbol == '+' ? total + more : total - more; });
        }
        --depth_;
        return total;
    }

    expression product() {
        expression value = factor();
        while (at_symbol('*') || at_symbol('/')) {
            const token& sign = words_[next_++];
            const expression next = factor();
            if (sign.symbol == '/' && juxtaposed_) {
                refuse(text_of(words_, 0, words_.size()), sign.at,
                       "is ambiguous: write parentheses, as 1/(2*pi) or (1/2)*pi");
            }
            value = folded(sign.at, [&] { return sign.symbol == '*' ? value * next : value / next; });
        }
        return value;
    }

    // [sign] power. -x^2 is -(x^2).
    expression factor() {
        enter();
        const bool negative = at_symbol('-');
        expression value = negative || at_symbol('+') ? (++next_, factor()) : power();
        --depth_;
        return negative ? -value : value;
    }

    expression power() {
        juxtaposed_ = false;
        if (next_ >= last_) {
            refuse_end();
        }
        const token& first = words_[next_];
        if (first.kind == token_kind::numeral) {
            ++next_;
            const auto behind = unit_behind();
            expression raised = raised_by_exponent(behind.value_or(expression(first.value)), first.at);
            juxtaposed_ = behind.has_value();
            return behind ? expression(first.value) * raised : raised;
        }
        expression raised = raised_by_exponent(primary(), first.at);
        juxtaposed_ = false;
        return raised;
    }

    // pi or deg directly after a number, in values.
    std::optional<expression> unit_behind() {
        if (role_ == formula_role::equation || next_ >= last_ || words_[next_].kind != token_kind::name ||
            !words_[next_].touches) {
            return std::nullopt;
        }
        const std::string_view name = words_[next_].text;
        if (name == "pi" || name == "deg") {
            ++next_;
            return expression(number(1, name == "pi" ? unit::pi : unit::degree));
        }
        if (name == "i" && role_ == formula_role::point) {
            ++next_;
            return parameter("i");
        }
        if (name == "T" && !names_.parameters.contains(name)) {
            refuse("T", words_[next_].at, "is the period of a pendulum, of which a problem has none: write a number");
        }
        return std::nullopt;
    }

    expression raised_by_exponent(const expression& base, const place& at) {
        if (!take('^')) {
            return base;
        }
        const expression exponent = factor();
        return folded(at, [&] { return pow(base, exponent); });
    }

    expression primary() {
        const token& word = words_[next_];
        if (take('(')) {
            return in_parentheses(word.at);
        }
        if (word.kind != token_kind::name) {
            refuse(std::string(1, word.symbol), word.at, "is not a number or a name: write one");
        }
        ++next_;
        if (is_function_name(word.text)) {
            return function(word);
        }
        if (at_symbol('(') && words_[next_].touches) {
            refuse_argument(word);
        }
        return named(word);
    }

    expression function(const token& word) {
        if (word.primes > 0) {
            refuse(text_of(words_, next_ - 1, next_), word.at,
                   "is the derivative of a function: write primes only after unknowns");
        }
        if (!take('(')) {
            refuse(std::string(word.text), word.at,
                   "is a function without ( after it: write " + std::string(word.text) + "(...)");
        }
        const function_kind f = *function_named(word.text);
        const place opened = words_[next_ - 1].at;
        const expression first = before_end(opened);
        if (!has_order(f)) {
            refuse_comma(word, " has one argument: write " + std::string(word.text) + "(x)");
            close(opened);
            return folded(word.at, [&] { return apply(f, first); });
        }
        const std::string call = std::string(word.text) + "(0, x)";
        if (!take(',')) {
            refuse(std::string(word.text), word.at, "has two arguments, its order and its argument: write " + call);
        }
        const expression x = before_end(opened);
        refuse_comma(word, " has two arguments: write " + call);
        close(opened);
        return folded(word.at, [&] { return apply(f, first, x); });
    }

    void refuse_comma(const token& word, const std::string& reason) const {
        if (at_symbol(',')) {
            refuse(std::string(word.text), word.at, reason.substr(1));
        }
    }

    // f(t), f(0), g(x).
    [[noreturn]] void refuse_argument(const token& word) const {
        const std::string name = text_of(words_, next_ - 1, next_);
        const bool known = names_.unknowns.contains(word.text);
        if (known && next_ + 1 < last_ && words_[next_ + 1].text == names_.variable) {
            refuse(name + "(" + names_.variable + ")", word.at, "has an argument: write " + name);
        }
        if (known) {
            refuse(name + "(", word.at,
                   "is not part of an equation: an initial value is a statement, " + name +
                       "(0) = 1, and a product has *");
        }
        refuse(name, word.at, "is not a function: write * for a product, or one of " + function_names());
    }

    expression named(const token& word) const {
        const std::string name(word.text);
        if (name == "pi" && word.primes == 0) {
            return number(1, unit::pi);
        }
        if (names_.unknowns.contains(name)) {
            return unknown(name, word.primes);
        }
        if (word.primes > 0) {
            refuse(primed(name, word.primes), word.at, "is not the derivative of an unknown");
        }
        if (name == names_.variable) {
            return variable();
        }
        if (names_.parameters.contains(name)) {
            return parameter(name);
        }
        if (name == "i") {
            refuse(name, word.at, "has no value: use imaginary numbers only in points");
        }
        if (name == "inf") {
            refuse(name, word.at, "is not a number: write one");
        }
        refuse(name, word.at,
               name == "t"
                   ? "has no value: use the variable, " + names_.variable
                   : "has no value: write " + name + " = number for a parameter, " + name + "' = ... for an unknown");
    }

    expression in_parentheses(const place& opened) {
        const expression value = before_end(opened);
        close(opened);
        return value;
    }

    // Up to a ) or a comma.
    expression before_end(const place& opened) {
        if (next_ >= last_) {
            refuse("(", opened, "is not closed: add a )");
        }
        const expression value = sum();
        if (next_ >= last_) {
            refuse("(", opened, "is not closed: add a )");
        }
        return value;
    }

    void close(const place& opened) {
        if (!take(')')) {
            if (next_ >= last_) {
                refuse("(", opened, "is not closed: add a )");
            }
            refuse_next();
        }
        juxtaposed_ = false;
    }

    const statement& words_;
    std::size_t next_, last_;
    const known_names& names_;
    formula_role role_;
    int depth_ = 0;
    bool juxtaposed_ = false;  // whether the last factor was a number directly before pi or deg
};

}  // namespace

bool is_function_name(std::string_view name) { return function_named(name).has_value(); }

void require_free_name(const token& name, const std::string& variable) {
    const std::string text(name.text);
    if (name.text == variable) {
        refuse(text, name.at, "is the independent variable: choose another name, or `variable x`");
    }
    if (is_function_name(name.text) || text == "pi" || text == "inf") {
        refuse(text, name.at, "is a reserved name: choose another");
    }
}

void require_free_column(const token& name, const std::string& variable) {
    require_free_name(name, variable);
    if (std::ranges::find(names_of_columns, name.text) != names_of_columns.end()) {
        refuse(std::string(name.text), name.at, "is the name of a column of tables: choose another");
    }
}

expression read_formula(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                        formula_role role) {
    return formula_parser(words, first, last, names, role).read();
}

}  // namespace libration::ode
