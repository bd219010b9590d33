#include "condition.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "formula_parser.hpp"
#include "formula_refusals.hpp"
#include "libration/equation/defined_zero.hpp"

namespace libration::ode {

namespace {

constexpr const char* form_of_conditional = "if(x > 0, a, b)";

// The index of the parenthesis that closes the one at this index; `last` if none does.
std::size_t closing_of(const statement& words, std::size_t opened, std::size_t last) {
    int open = 0;
    for (std::size_t i = opened; i < last; ++i) {
        open += change_of_depth(words[i]);
        if (open == 0) {
            return i;
        }
    }
    return last;
}

// `true` or `false`, as all of a condition.
bool is_truth(const statement& words, std::size_t at, std::size_t last) {
    const token& word = words[at];
    const bool ends = at + 1 >= last || is_connective(words[at + 1]) || is_symbol(words[at + 1], ')') ||
                      is_symbol(words[at + 1], ',');
    return ends && word.kind == token_kind::name && word.primes == 0 &&
           (word.text == "true" || word.text == "false" || word.text == "True" || word.text == "False");
}

// Disjunction, conjunction, negation and comparison, a function for each.
class condition_parser {
public:
    explicit condition_parser(const formula_cursor& at)
        : words_(at.words), next_(at.next), last_(at.last), depth_(at.depth), side_(at.sum) {}

    condition read() { return joined(or_sign, condition_kind::any, &condition_parser::conjunction); }

private:
    bool at_symbol(char c) const { return next_ < last_ && is_symbol(words_[next_], c); }
    bool take(char c) {
        const bool found = at_symbol(c);
        next_ += found ? 1 : 0;
        return found;
    }

    condition conjunction() { return joined(and_sign, condition_kind::all, &condition_parser::negation); }

    condition joined(char sign, condition_kind kind, condition (condition_parser::*part)()) {
        condition first = (this->*part)();
        if (!at_symbol(sign)) {
            return first;
        }
        condition all{.kind = kind};
        all.parts.push_back(std::move(first));
        while (take(sign)) {
            all.parts.push_back((this->*part)());
        }
        return all;
    }

    condition negation() {
        if (next_ >= last_) {
            refuse_end();
        }
        const token& word = words_[next_];
        if (take(not_sign)) {
            if (word.source == "!" && !at_symbol('(')) {
                refuse(word.text, word.at, "is not followed by a parenthesis: write !(x > 1)");
            }
            condition all{.kind = condition_kind::negation};
            all.parts.push_back(deeper(&condition_parser::negation));
            return all;
        }
        if (is_symbol(word, and_sign) || is_symbol(word, or_sign)) {
            return call();
        }
        if (at_symbol('(') && is_group(next_)) {
            ++next_;
            condition inside = deeper(&condition_parser::read);
            close(word);
            refuse_behind();
            return inside;
        }
        return comparison();
    }

    // and(a, b), or(a, b).
    condition call() {
        const token& word = words_[next_++];
        const bool all = word.symbol == and_sign;
        const token opened = next_ < last_ ? words_[next_] : word;
        if (!take('(')) {
            refuse(word.text, word.at, "has no condition before it: write x > 1 " + word.text + " y > 1");
        }
        condition made{.kind = all ? condition_kind::all : condition_kind::any};
        do {
            made.parts.push_back(deeper(&condition_parser::read));
        } while (take(','));
        close(opened);
        return made;
    }

    // a > b, and 0 <= x < 1.
    condition comparison() {
        if (is_truth(words_, next_, last_)) {
            const char first = words_[next_++].text.front();
            return {.kind = condition_kind::constant, .holds = first == 't' || first == 'T'};
        }
        condition all{.kind = condition_kind::all};
        const std::size_t begin = next_;
        expression left = side_();
        do {
            const token& sign = next_ < last_ ? words_[next_] : words_[begin];
            if (!is_comparison(sign)) {
                refuse_comparison(begin);
            }
            ++next_;
            const expression right = side_();
            all.parts.push_back(compared(left, sign, right));
            left = right;
        } while (next_ < last_ && is_comparison(words_[next_]));
        return all.parts.size() == 1 ? all.parts.front() : all;
    }

    // a > b and a >= b by a - b, a < b and a <= b by b - a.
    static condition compared(const expression& left, const token& sign, const expression& right) {
        const bool less = sign.symbol == '<';
        condition made{.difference = less ? written_sum(right, -left) : written_sum(left, -right)};
        const bool ordered = less || sign.symbol == '>';
        made.kind = ordered ? condition_kind::positive : condition_kind::equal;
        made.or_equal = sign.or_equal;
        if (sign.symbol != unequal_sign) {
            return made;
        }
        condition opposite{.kind = condition_kind::negation};
        opposite.parts.push_back(std::move(made));
        return opposite;
    }

    // Whether the parenthesis at this index contains a condition, and not a part of a side.
    bool is_group(std::size_t opened) const {
        const std::size_t end = closing_of(words_, opened, last_);
        return end < last_ && is_condition(words_, opened + 1, end);
    }

    condition deeper(condition (condition_parser::*part)()) {
        if (++depth_ > deepest_formula) {
            refuse_depth(words_, std::min(next_, last_ - 1));
        }
        condition value = (this->*part)();
        --depth_;
        return value;
    }

    void close(const token& opened) {
        if (next_ < last_ && !at_symbol(')')) {
            refuse_behind();
            refuse_comparison(next_++);
        }
        if (!take(')')) {
            refuse("(", opened.at, "is not closed: add a )");
        }
    }

    // Behind a condition.
    void refuse_behind() const {
        if (next_ >= last_ || words_[next_].kind != token_kind::symbol || is_symbol(words_[next_], ')') ||
            is_symbol(words_[next_], ',') || is_symbol(words_[next_], and_sign) || is_symbol(words_[next_], or_sign)) {
            return;
        }
        refuse(words_[next_].text, words_[next_].at,
               "follows a condition, which is not a number: write `and` or `or` between conditions, or if(x > 1, 1, 0) "
               "for a number");
    }

    // The side that begins with this token is not followed by a comparison.
    [[noreturn]] void refuse_comparison(std::size_t begin) const {
        if (at_symbol('=')) {
            refuse("=", words_[next_].at, "is not a comparison: write == in a condition");
        }
        refuse(text_of(words_, begin, next_), words_[begin].at,
               std::string("is not a comparison: write ") + form_of_conditional);
    }

    [[noreturn]] void refuse_end() const {
        refuse(whole(words_), words_[std::min(last_, words_.size()) - 1].at,
               std::string("ends where a condition is missing: write ") + form_of_conditional);
    }

    const statement& words_;
    std::size_t& next_;
    std::size_t last_;
    int& depth_;
    const std::function<expression()>& side_;
};

}  // namespace

condition read_condition(const formula_cursor& at) { return condition_parser(at).read(); }

bool is_condition(const statement& words, std::size_t first, std::size_t last) {
    for (std::size_t begin = first; begin < last; ++begin) {
        int open = 0;
        for (std::size_t i = begin; i < last; ++i) {
            open += change_of_depth(words[i]);
            if (open < 0 || (open == 0 && is_symbol(words[i], ','))) {
                last = i;
            } else if (open == 0 && (is_comparison(words[i]) || is_connective(words[i]))) {
                return true;
            }
        }
        // One parenthesis around all of it.
        const bool grouped = is_symbol(words[begin], '(') && closing_of(words, begin, last) + 1 == last;
        if (!grouped) {
            return last == begin + 1 && is_truth(words, begin, last);
        }
        --last;
    }
    return false;
}

bool is_pair(const statement& words, std::size_t first, std::size_t last) {
    if (!symbol_at(words, first, '(')) {
        return false;
    }
    const std::size_t end = closing_of(words, first, last);
    int open = 0;
    for (std::size_t i = first; i < end; ++i) {
        open += change_of_depth(words[i]);
        if (open == 1 && is_symbol(words[i], ',')) {
            return true;
        }
    }
    return false;
}

}  // namespace libration::ode
