#include "called_function.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "condition.hpp"
#include "formula_refusals.hpp"
#include "piecewise.hpp"
#include "written_function.hpp"

namespace libration::ode {

namespace {

class call_parser {
public:
    call_parser(const formula_cursor& at, equation_system* into) : at_(at), into_(into) {}

    std::optional<expression> read(std::size_t name) {
        const token& word = at_.words[name];
        const std::string_view known = name_without_synonym(word.text);
        if (known == "if") {
            return conditional(name);
        }
        if (known == "piecewise") {
            return piecewise(name);
        }
        if (const auto* const made = written_function_named(known)) {
            return written(*made, name);
        }
        const auto kind = function_named(known);
        return kind ? std::optional(function(name, *kind)) : std::nullopt;
    }

    expression function(std::size_t name, function_kind f) {
        const token& word = at_.words[name];
        if (word.primes > 0) {
            refuse(text_of(at_.words, at_.next - 1, at_.next), word.at,
                   "is the derivative of a function: write primes only after unknowns, and choose another name for an "
                   "unknown, as " +
                       word.text + "_");
        }
        if (!at_.take('(')) {
            refuse_without_argument(at_.words, at_.next - 1);
        }
        const place opened = at_.words[at_.next - 1].at;
        const expression first = at_.before_end(opened);
        if (!has_order(f)) {
            refuse_comma(word, " has one argument: write " + word.text + "(x)");
            at_.close(opened);
            return folded(at_.words, word.at, [&] { return apply(f, first); });
        }
        const std::string call = word.text + "(0, x)";
        if (!at_.take(',')) {
            refuse(word.text, word.at, "has two arguments, its order and its argument: write " + call);
        }
        const expression x = at_.before_end(opened);
        refuse_comma(word, " has two arguments: write " + call);
        at_.close(opened);
        return folded(at_.words, word.at, [&] { return apply(f, first, x); });
    }

private:
    // cot(x), abs(x), max(a, b, c), the name at this index.
    expression written(const written_function& f, std::size_t name) {
        const token& word = at_.words[name];
        if (f.piecewise) {
            require_equation(word);
        }
        const place opened = at_.words[at_.next++].at;
        std::vector<expression> arguments;
        do {
            arguments.push_back(at_.before_end(opened));
        } while (at_.take(','));
        at_.close(opened);
        if (arguments.size() < f.fewest || arguments.size() > f.most) {
            refuse_count(name, f.fewest, f.most, f.form);
        }
        return folded(at_.words, word.at, [&] {
            if (into_ == nullptr) {
                return f.value(arguments, nullptr);
            }
            step_collector steps = steps_of(name);
            return f.value(arguments, &steps);
        });
    }

    // if(x > 0, a, b).
    expression conditional(std::size_t name) {
        require_equation(at_.words[name]);
        const place opened = at_.words[at_.next++].at;
        const condition holds = condition_before_end(opened);
        std::vector<expression> arguments;
        while (at_.take(',')) {
            arguments.push_back(at_.before_end(opened));
        }
        at_.close(opened);
        if (arguments.size() != 2) {
            refuse_count(name, 3, 3, "if(x > 0, a, b)");
        }
        return folded(at_.words, at_.words[name].at,
                      [&] { return steps_of(name).chosen(holds, arguments[0], arguments[1]); });
    }

    // piecewise(a, x > 0, b, x > 1, c), piecewise(x > 0, a, x > 1, b, c), piecewise((a, x > 0), (b, x > 1)): the value of
    // the first condition that holds, else the last value, or 0 without one.
    expression piecewise(std::size_t name) {
        require_equation(at_.words[name]);
        const place opened = at_.words[at_.next++].at;
        const std::size_t first = at_.next;
        std::vector<condition> conditions;
        std::vector<expression> values;
        do {
            read_piece(opened, conditions, values);
        } while (at_.take(','));
        at_.close(opened);
        if (conditions.empty() || values.size() < conditions.size() || values.size() > conditions.size() + 1) {
            refuse(text_of(at_.words, name, at_.next), at_.words[name].at,
                   std::string("has no condition for each value but the last: write piecewise(a, x > 0, b)") +
                       (is_condition(at_.words, first, at_.last) ? ", or piecewise(x > 0, a, b)" : ""));
        }
        return folded(at_.words, at_.words[name].at, [&] {
            step_collector steps = steps_of(name);
            expression value = values.size() > conditions.size() ? values.back() : expression();
            for (std::size_t i = conditions.size(); i-- > 0;) {
                value = steps.chosen(conditions[i], values[i], value);
            }
            return value;
        });
    }

    // A value, a condition, or both in parentheses.
    void read_piece(const place& opened, std::vector<condition>& conditions, std::vector<expression>& values) {
        if (is_condition(at_.words, at_.next, at_.last)) {
            conditions.push_back(condition_before_end(opened));
        } else if (is_pair(at_.words, at_.next, at_.last)) {
            const place pair = at_.words[at_.next++].at;
            values.push_back(at_.before_end(pair));
            at_.take(',');
            conditions.push_back(condition_before_end(pair));
            at_.close(pair);
        } else {
            values.push_back(at_.before_end(opened));
        }
    }

    condition condition_before_end(const place& opened) {
        formula_cursor sides = at_;
        sides.sum = [&] { return at_.before_end(opened); };
        return read_condition(sides);
    }

    step_collector steps_of(std::size_t name) {
        return {into_->steps, text_of(at_.words, name, at_.next), at_.words[name].at};
    }

    void require_equation(const token& word) const {
        if (into_ == nullptr) {
            refuse(word.text, word.at, "is piecewise, which is supported only in equations: write one of its branches");
        }
    }

    void refuse_comma(const token& word, const std::string& reason) const {
        if (at_.at_symbol(',')) {
            refuse(word.text, word.at, reason.substr(1));
        }
    }

    [[noreturn]] void refuse_count(std::size_t name, std::size_t fewest, std::size_t most,
                                   std::string_view form) const {
        const std::string range = fewest == most       ? std::to_string(fewest)
                                  : most == fewest + 1 ? std::to_string(fewest) + " or " + std::to_string(most)
                                                       : std::to_string(fewest) + " or more";
        refuse(text_of(at_.words, name, at_.next), at_.words[name].at,
               "has another number of arguments than " + range + ": write " + std::string(form));
    }

    const formula_cursor& at_;
    equation_system* into_;
};

}  // namespace

expression read_function(const formula_cursor& at, std::size_t name, function_kind f) {
    return call_parser(at, nullptr).function(name, f);
}

std::optional<expression> read_call(const formula_cursor& at, std::size_t name, equation_system* into) {
    return call_parser(at, into).read(name);
}

}  // namespace libration::ode
