#include "indexed_statement.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "index_value.hpp"

namespace libration::ode {

namespace {

// `for i =`
bool begins_range(const statement& words, std::size_t at) {
    return at > 0 && at + 2 < words.size() && is_name_of(words[at], "for") && words[at + 1].kind == token_kind::name &&
           words[at + 1].primes == 0 && is_symbol(words[at + 2], '=');
}

// The index after the parenthesis or bracket that closes the one at this index.
std::size_t behind_group(const statement& words, std::size_t at) {
    int depth = 0;
    for (std::size_t i = at; i < words.size(); ++i) {
        depth += change_of_depth(words[i]);
        if (depth == 0) {
            return i + 1;
        }
    }
    refuse(text_of(words, at, words.size()), words[at].at, "is not closed: write the closing one");
}

struct index_range {
    std::string name;
    std::size_t first = 0, dots = 0, last = 0;  // places in the statement
};

// One statement, written out.
class indexed_statement {
public:
    explicit indexed_statement(const statement& words) : words_(words), body_(words.size()) {
        for (std::size_t at = words.size(); at-- > 0;) {
            if (begins_range(words, at)) {
                body_ = at;
            }
        }
        for (std::size_t at = body_; at < words.size();) {
            at = add_range(at);
        }
    }

    void write(std::vector<statement>& to, std::size_t& symbols) { write_from(0, to, symbols); }

private:
    std::size_t add_range(std::size_t at) {
        if (!begins_range(words_, at)) {
            refuse(text_of(words_, at, words_.size()), words_[at].at, std::string("is not a range: ") + form_of_range);
        }
        index_range made{words_[at + 1].text, at + 3, 0, at + 3};
        while (made.last < words_.size() && !begins_range(words_, made.last)) {
            made.dots = is_symbol(words_[made.last], range_sign) && made.dots == 0 ? made.last : made.dots;
            ++made.last;
        }
        if (made.dots == 0 || made.dots == made.first || made.dots + 1 == made.last) {
            refuse(text_of(words_, at, made.last), words_[at].at, std::string("has no range: ") + form_of_range);
        }
        if (std::ranges::find(ranges_, made.name, &index_range::name) != ranges_.end()) {
            refuse(made.name, words_[at + 1].at, "has two ranges: choose another name for one of the indices");
        }
        ranges_.push_back(made);
        return made.last;
    }

    void write_from(std::size_t range, std::vector<statement>& to, std::size_t& symbols) {
        if (range == ranges_.size()) {
            to.push_back(written());
            symbols += to.back().size();
            if (symbols > most_written_symbols) {
                refuse(whole(words_), words_[0].at,
                       "gives more than " + std::to_string(most_written_symbols) +
                           " symbols with its indices: write smaller ranges");
            }
            return;
        }
        const index_range& of = ranges_[range];
        const long first = index_value(words_, of.first, of.dots, values_);
        const long last = index_value(words_, of.dots + 1, of.last, values_);
        if (last < first && range == 0) {
            refuse(text_of(words_, of.first, of.last), words_[of.first].at,
                   "is an empty range: write the smaller number first");
        }
        for (long value = first; value <= last; ++value) {
            values_[of.name] = value;
            write_from(range + 1, to, symbols);
        }
        values_.erase(of.name);
    }

    statement written() const {
        statement result;
        result.reserve(body_);
        for (std::size_t at = 0; at < body_;) {
            const token& word = words_[at];
            if (word.kind != token_kind::name) {
                result.push_back(word);
                ++at;
            } else if (symbol_at(words_, at + 1, '[') && words_[at + 1].touches) {
                at = add_indexed_name(result, at);
            } else if (is_remainder_of_indices(at)) {
                const std::size_t end = behind_group(words_, at + 1);
                add_number(result, word, index_value(words_, at, end, values_));
                at = end;
            } else if (is_mod(words_, at) && !values_.empty() && !result.empty()) {
                at = add_remainder(result, at);
            } else {
                add_name(result, word);
                ++at;
            }
        }
        return result;
    }

    // mod(i + 1, 3)
    bool is_remainder_of_indices(std::size_t at) const {
        if (!is_name_of(words_[at], "mod") || !symbol_at(words_, at + 1, '(') || values_.empty()) {
            return false;
        }
        const auto begin = words_.begin() + static_cast<std::ptrdiff_t>(at + 1);
        const auto end = words_.begin() + static_cast<std::ptrdiff_t>(behind_group(words_, at + 1));
        return std::all_of(begin, end, [&](const token& word) {
            return word.kind == token_kind::symbol ||
                   (word.kind == token_kind::numeral && denominator(word.value) == 1) || values_.contains(word.text);
        });
    }

    // q[i+1]'' as one name, in the source up to the last bracket.
    std::size_t add_indexed_name(statement& to, std::size_t at) const {
        token made = words_[at];
        std::size_t next = at + 1;
        while (next < body_ && symbol_at(words_, next, '[') && words_[next].touches) {
            const std::size_t end = behind_group(words_, next);
            std::size_t first = next + 1;
            for (std::size_t i = first; i < end; ++i) {
                const bool ends = i + 1 == end || (is_symbol(words_[i], ',') && depth_within(next, i) == 1);
                if (ends) {
                    made.text += "[" + std::to_string(index_value(words_, first, i, values_)) + "]";
                    first = i + 1;
                }
            }
            made.primes += words_[end - 1].primes;
            next = end;
        }
        const std::string_view last = words_[next - 1].source;
        made.source = {made.source.data(), static_cast<std::size_t>(last.data() + last.size() - made.source.data())};
        to.push_back(std::move(made));
        return next;
    }

    int depth_within(std::size_t first, std::size_t at) const {
        int depth = 0;
        for (std::size_t i = first; i <= at; ++i) {
            depth += change_of_depth(words_[i]);
        }
        return depth;
    }

    static token numeral(const token& at, long value) {
        token made = at;
        made.kind = token_kind::numeral;
        made.value = rational(value);
        made.text = std::to_string(value);
        made.primes = 0;
        return made;
    }

    static void add_number(statement& to, const token& at, long value) {
        if (value >= 0) {
            to.push_back(numeral(at, value));
            return;
        }
        token sign = at;
        sign.kind = token_kind::symbol;
        for (const char symbol : {'(', '-'}) {
            sign.symbol = symbol;
            to.push_back(sign);
        }
        to.push_back(numeral(at, -value));
        sign.symbol = ')';
        to.push_back(sign);
    }

    void add_name(statement& to, const token& word) const {
        const auto found = values_.find(word.text);
        if (found == values_.end()) {
            to.push_back(word);
            return;
        }
        if (word.primes > 0) {
            refuse(std::string(word.source), word.at,
                   "is an index, which has no derivative: choose another name for it");
        }
        if (!to.empty() && to.back().kind == token_kind::numeral) {
            refuse(std::string(to.back().source) + word.text, to.back().at,
                   "is a product with an index: write " + std::string(to.back().source) + "*" + word.text);
        }
        add_number(to, word, found->second);
    }

    // The number before `mod` and the one behind it, each a number, an index or in parentheses.
    std::size_t add_remainder(statement& to, std::size_t at) const {
        const auto refuse_sides = [&] {
            refuse(text_of(words_, at > 0 ? at - 1 : at, std::min(at + 2, body_)), words_[at].at,
                   "is not a remainder of whole numbers: write (i mod 3) or mod(x, 3)");
        };
        std::size_t begin = to.size() - 1;
        if (is_symbol(to.back(), ')')) {
            for (int depth = change_of_depth(to[begin]); depth < 0 && begin > 0;) {
                depth += change_of_depth(to[--begin]);
            }
        } else if (to.back().kind != token_kind::numeral) {
            refuse_sides();
        }
        const bool is_product = begin > 0 && (is_symbol(to[begin - 1], '*') || is_symbol(to[begin - 1], '/') ||
                                              is_symbol(to[begin - 1], '^') || to[begin - 1].kind == token_kind::name);
        if (is_product || at + 1 >= body_) {
            refuse_sides();
        }
        const bool grouped = symbol_at(words_, at + 1, '(');
        const std::size_t end = grouped ? behind_group(words_, at + 1) : at + 2;
        statement whole_remainder(to.begin() + static_cast<std::ptrdiff_t>(begin), to.end());
        whole_remainder.insert(whole_remainder.end(), words_.begin() + static_cast<std::ptrdiff_t>(at),
                               words_.begin() + static_cast<std::ptrdiff_t>(end));
        const long value = index_value(whole_remainder, 0, whole_remainder.size(), values_);
        const token place = to[begin];
        to.erase(to.begin() + static_cast<std::ptrdiff_t>(begin), to.end());
        add_number(to, place, value);
        return end;
    }

    const statement& words_;
    std::size_t body_;  // its end: the first range, or that of the statement
    std::vector<index_range> ranges_;
    index_values values_;
};

bool has_indices(const statement& words) {
    for (std::size_t at = 0; at < words.size(); ++at) {
        const bool bracket =
            at > 0 && is_symbol(words[at], '[') && words[at].touches && words[at - 1].kind == token_kind::name;
        if (bracket || begins_range(words, at)) {
            return true;
        }
    }
    return false;
}

void require_no_other_signs(const statement& words) {
    for (const token& word : words) {
        if (is_symbol(word, range_sign)) {
            refuse("..", word.at, std::string("is not in a range: ") + form_of_range);
        }
        if (is_symbol(word, ']') && word.primes > 0) {
            refuse("'", word.at, "does not follow a name: write primes directly after an unknown, as f''");
        }
    }
}

}  // namespace

void write_out_indices(std::vector<statement>& all) {
    if (std::ranges::none_of(all, has_indices)) {
        std::ranges::for_each(all, require_no_other_signs);
        return;
    }
    std::vector<statement> written;
    std::size_t symbols = 0;
    for (const statement& words : all) {
        has_indices(words) ? indexed_statement(words).write(written, symbols) : written.push_back(words);
    }
    std::ranges::for_each(written, require_no_other_signs);
    all = std::move(written);
}

}  // namespace libration::ode
