#include "formula_parser.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "called_function.hpp"
#include "formula_cursor.hpp"
#include "formula_refusals.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// By recursive descent, of bounded depth: sum, product, signed factor, power, primary.
class formula_parser {
public:
    formula_parser(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                   formula_role role, conditions_at_times* values, equation_system* into)
        : words_(words), next_(first), last_(last), names_(names), role_(role), values_(values), into_(into) {}

    expression read() {
        expression value = sum();
        if (next_ < last_) {
            refuse_token(words_, next_, last_);
        }
        return value;
    }

    // A sum and the index of the token behind it.
    std::pair<expression, std::size_t> read_part() {
        if (next_ >= last_) {
            refuse_end(words_, last_);
        }
        expression value = sum();
        return {std::move(value), next_};
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

    // What is in a parenthesis, behind a sign or in an exponent, of which each is one level.
    expression deeper(expression (formula_parser::*part)()) {
        if (++depth_ > deepest_formula) {
            refuse_depth(words_, std::min(next_, last_ - 1));
        }
        expression value = (this->*part)();
        --depth_;
        return value;
    }

    expression sum() {
        expression total = product();
        while (at_symbol('+') || at_symbol('-')) {
            const token& sign = words_[next_++];
            const expression more = product();
            total = folded(words_, sign.at, [&] { return written_sum(total, sign.symbol == '+' ? more : -more); });
        }
        return total;
    }

    expression product() {
        const std::size_t begin = next_;
        expression value = factor();
        while (at_symbol('*') || at_symbol('/')) {
            const std::size_t at = next_++;
            const token& sign = words_[at];
            const expression next = factor();
            if (sign.symbol == '/' && joined_at_) {
                refuse_denominator(words_, begin, at, *joined_at_, next_);
            }
            value = folded(words_, sign.at, [&] {
                return sign.symbol == '*' ? written_product(value, next) : written_quotient(value, next);
            });
        }
        return value;
    }

    // [sign] power. -x^2 is -(x^2).
    expression factor() {
        const bool negative = at_symbol('-');
        if (!negative && !at_symbol('+')) {
            return power();
        }
        ++next_;
        expression value = deeper(&formula_parser::factor);
        return negative ? -value : value;
    }

    expression power() {
        joined_at_.reset();
        if (next_ >= last_) {
            refuse_end(words_, last_);
        }
        const std::size_t at = next_;
        const token& first = words_[at];
        if (first.kind == token_kind::numeral) {
            ++next_;
            const expression value(first.value);
            if (!at_factor()) {
                return raised_by_exponent(value, first.at);
            }
            const auto behind = unit_behind();
            const expression right = behind ? raised_by_exponent(*behind, first.at) : named_power();
            joined_at_ = at;
            return folded(words_, first.at, [&] { return written_product(value, right); });
        }
        expression raised = named_power();
        joined_at_.reset();
        return raised;
    }

    // A power of a name, a call or a parenthesis.
    expression named_power() {
        const token& first = words_[next_];
        const bool euler = is_euler(first);
        const expression base = primary();
        return euler && at_symbol('^') ? exponential(first.at) : raised_by_exponent(base, first.at);
    }

    // A name or a parenthesis, which a number directly before it multiplies.
    bool at_factor() const { return at_symbol('(') || (next_ < last_ && words_[next_].kind == token_kind::name); }

    // pi and deg after a number.
    std::optional<expression> unit_behind() {
        if (words_[next_].kind != token_kind::name || names_.parameters.contains(words_[next_].text) ||
            names_.unknowns.contains(words_[next_].text)) {
            return std::nullopt;
        }
        const std::string& name = words_[next_].text;
        if (name == "pi" || name == "deg") {
            ++next_;
            return expression(number(1, name == "pi" ? unit::pi : unit::degree));
        }
        if (name == "T" && role_ != formula_role::equation) {
            refuse("T", words_[next_].at, "is the period of a pendulum, of which a problem has none: write a number");
        }
        if (name == "e" && role_ == formula_role::point) {
            refuse("e", words_[next_].at, "is an incomplete exponent, as in other times: write 1e5, or exp(1)");
        }
        return std::nullopt;
    }

    bool is_euler(const token& word) const {
        return word.kind == token_kind::name && word.text == "e" && word.primes == 0 && names_.variable != "e" &&
               !names_.unknowns.contains("e") && !names_.parameters.contains("e");
    }

    // e^x.
    expression exponential(const place& at) {
        const expression exponent = exponent_behind();
        return folded(words_, at, [&] { return apply(function_kind::exp, exponent); });
    }

    expression raised_by_exponent(const expression& base, const place& at) {
        if (!at_symbol('^')) {
            return base;
        }
        const expression exponent = exponent_behind();
        return folded(words_, at, [&] { return written_power(base, exponent); });
    }

    // Of x^2y it is not known where the exponent ends; of x²y it is.
    expression exponent_behind() {
        std::size_t at = ++next_;
        while (at < last_ && (is_symbol(words_[at], '-') || is_symbol(words_[at], '+'))) {
            ++at;
        }
        const bool number = at < last_ && words_[at].kind == token_kind::numeral && at + 1 < last_;
        const bool joined = number && (words_[at + 1].kind == token_kind::name || is_symbol(words_[at + 1], '('));
        if (joined && words_[at].raised) {
            refuse_token(words_, at + 1, last_);
        }
        if (joined) {
            const std::size_t begin = next_;
            next_ = at;
            power();
            refuse_exponent(words_, begin, at, next_);
        }
        return deeper(&formula_parser::factor);
    }

    expression primary() {
        const token& word = words_[next_];
        if (take('(')) {
            return in_parentheses(word.at);
        }
        if (word.kind != token_kind::name) {
            refuse_interval(word);
            if (is_symbol(word, or_sign)) {
                refuse(word.text, word.at, "is not a number or a name: write abs(x) for |x|");
            }
            refuse(word.text, word.at, "is not a number or a name: write one");
        }
        ++next_;
        if (is_function_name(word.text)) {
            return read_function(cursor(), next_ - 1, *function_named(word.text));
        }
        if (word.primes == 0 && at_symbol('(') && !is_known(word.text)) {
            if (auto value = read_call(cursor(), next_ - 1, into_)) {
                return *std::move(value);
            }
        }
        if (values_ != nullptr && (names_.unknowns.contains(word.text) || word.text == names_.variable)) {
            return value_at_time(next_ - 1);
        }
        if (at_symbol('(') && words_[next_].touches) {
            if (!names_.unknowns.contains(word.text)) {
                refuse_argument(words_, next_ - 1, names_);
            }
            if (!has_variable_behind(words_, next_ - 1, names_.variable)) {
                return delayed(next_ - 1);
            }
            next_ += 3;  // y(t) is y
        }
        return named(word);
    }

    // y(t - 1), the name at this index.
    expression delayed(std::size_t name) {
        const token& word = words_[name];
        const expression argument = in_parentheses(words_[next_++].at);
        if (!argument.has_variable() && !argument.has_unknowns()) {
            refuse_argument(words_, name, names_);
        }
        const expression delay = delay_of(argument, words_, name, next_, names_);
        if (into_ == nullptr) {
            refuse(text_of(words_, name, next_), word.at,
                   "is a delayed unknown, which is supported only in equations: leave it out");
        }
        return into_->delayed(unknown(word.text, word.primes), delay, word.at);
    }

    // y'(1), in a condition.
    expression value_at_time(std::size_t name) {
        require_time(words_, name, names_);
        const expression time = in_parentheses(words_[next_++].at);
        require_constant_time(time, words_, name, next_);
        return values_->at(unknown(words_[name].text, words_[name].primes), time);
    }

    formula_cursor cursor() {
        return {.words = words_, .next = next_, .last = last_, .depth = depth_, .sum = [this] {
                    return deeper(&formula_parser::sum);
                }};
    }

    bool is_known(const std::string& name) const {
        return names_.unknowns.contains(name) || names_.parameters.contains(name) || name == names_.variable;
    }

    expression named(const token& word) const {
        const std::string& name = word.text;
        if (name == "pi" && word.primes == 0) {
            return number(1, unit::pi);
        }
        if (is_euler(word)) {
            return apply(function_kind::exp, expression(1));
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
        refuse_name(word, names_);
    }

    expression in_parentheses(const place& opened) {
        const formula_cursor at = cursor();
        expression value = at.before_end(opened);
        at.close(opened);
        joined_at_.reset();
        return value;
    }

    const statement& words_;
    std::size_t next_, last_;
    const known_names& names_;
    formula_role role_;
    conditions_at_times* values_;
    equation_system* into_;
    int depth_ = 0;
    std::optional<std::size_t> joined_at_;  // the index of the number, if the last factor was one before a name
};

}  // namespace

expression read_formula(const statement& words, std::size_t first, std::size_t last, const known_names& names,
                        formula_role role, conditions_at_times* values, equation_system* into) {
    return formula_parser(words, first, last, names, role, values, into).read();
}

expression read_sum(const statement& words, std::size_t& next, std::size_t last, const known_names& names,
                    equation_system* into) {
    auto [value, behind] = formula_parser(words, next, last, names, formula_role::equation, nullptr, into).read_part();
    next = behind;
    return value;
}

}  // namespace libration::ode
