#include "index_value.hpp"

namespace libration::ode {

bool is_name_of(const token& word, std::string_view name) {
    return word.kind == token_kind::name && word.primes == 0 && word.text == name;
}

bool is_mod(const statement& words, std::size_t at) {
    return at < words.size() && is_name_of(words[at], "mod") && !symbol_at(words, at + 1, '(');
}

namespace {

class index_reader {
public:
    index_reader(const statement& words, std::size_t first, std::size_t last, const index_values& values)
        : words_(words), first_(first), at_(first), last_(last), values_(values) {}

    long read() {
        if (first_ == last_) {
            refuse(words_[first_ - 1].text, words_[first_ - 1].at,
                   std::string("has no index behind it: ") + form_of_range);
        }
        const long value = sum();
        if (at_ != last_) {
            refuse_index("is not an index");
        }
        return value;
    }

private:
    [[noreturn]] void refuse_index(const std::string& reason) const {
        refuse(text_of(words_, first_, last_), words_[first_].at,
               reason + ": write whole numbers and indices with + - * / and mod, as in q[i mod 40 + 1]");
    }

    long checked(long value) const {
        if (value > largest_index || value < -largest_index) {
            refuse_index("is beyond " + std::to_string(largest_index));
        }
        return value;
    }

    bool takes(char symbol) {
        const bool is = at_ < last_ && is_symbol(words_[at_], symbol);
        at_ += is ? 1 : 0;
        return is;
    }

    long sum() {
        long value = product();
        for (;;) {
            if (takes('+')) {
                value = checked(value + product());
            } else if (takes('-')) {
                value = checked(value - product());
            } else {
                return value;
            }
        }
    }

    long product() {
        long value = factor();
        for (;;) {
            if (takes('*')) {
                value = checked(value * factor());
            } else if (takes('/')) {
                const long by = factor();
                if (by == 0 || value % by != 0) {
                    refuse_index("is not a whole number");
                }
                value /= by;
            } else if (at_ < last_ && is_mod(words_, at_)) {
                ++at_;
                value = remainder(value, factor());
            } else {
                return value;
            }
        }
    }

    long factor() {
        if (takes('-')) {
            return -factor();
        }
        if (takes('(')) {
            const long value = sum();
            require(')');
            return value;
        }
        if (at_ >= last_) {
            refuse_index("is not an index");
        }
        const token& word = words_[at_++];
        if (word.kind == token_kind::numeral) {
            if (denominator(word.value) != 1 || numerator(word.value) > largest_index) {
                refuse_index("is not a whole number up to " + std::to_string(largest_index));
            }
            return numerator(word.value).convert_to<long>();
        }
        if (is_name_of(word, "mod") && takes('(')) {
            const long value = sum();
            require(',');
            const long by = sum();
            require(')');
            return remainder(value, by);
        }
        const auto found = word.kind == token_kind::name && word.primes == 0 ? values_.find(word.text) : values_.end();
        if (found == values_.end()) {
            if (word.kind == token_kind::name) {
                refuse(std::string(word.source), word.at,
                       std::string("is not an index with a range: ") + form_of_range);
            }
            refuse_index("is not an index");
        }
        return found->second;
    }

    void require(char symbol) {
        if (!takes(symbol)) {
            refuse_index("is not an index");
        }
    }

    long remainder(long value, long by) const {
        if (by == 0) {
            refuse_index("has the modulus 0");
        }
        const long rest = value % by;
        return rest != 0 && (rest < 0) != (by < 0) ? rest + by : rest;
    }

    const statement& words_;
    std::size_t first_, at_, last_;
    const index_values& values_;
};

}  // namespace

long index_value(const statement& words, std::size_t first, std::size_t last, const index_values& values) {
    return index_reader(words, first, last, values).read();
}

}  // namespace libration::ode
