// Numbers and strings one after the other in a text: a number ends with a colon, a string follows its length.
#pragma once

#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace libration {

inline void add_number(std::string& text, long number) {
    text += std::to_string(number);
    text += ':';
}

inline void add_string(std::string& text, std::string_view string) {
    add_number(text, static_cast<long>(string.size()));
    text += string;
}

/// Reads them back. Throws std::runtime_error for another text, also for one that is cut short.
class counted_text {
public:
    explicit counted_text(std::string_view text) : rest_(text) {}

    /// A number from 0 on.
    long number() {
        long value = 0;
        const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        const auto used = static_cast<std::size_t>(end - rest_.data());
        if (problem != std::errc() || used >= rest_.size() || rest_[used] != ':' || value < 0) {
            refuse();
        }
        rest_.remove_prefix(used + 1);
        return value;
    }

    /// A number of things that follow, of which each has a character at least.
    std::size_t count() {
        const auto value = static_cast<std::size_t>(number());
        if (value > rest_.size()) {
            refuse();
        }
        return value;
    }

    std::string string() {
        const std::size_t length = count();
        std::string result(rest_.substr(0, length));
        rest_.remove_prefix(length);
        return result;
    }

    void require_end() const {
        if (!rest_.empty()) {
            refuse();
        }
    }

    [[noreturn]] static void refuse() { throw std::runtime_error("the text of a cell cannot be read"); }

private:
    std::string_view rest_;
};

}  // namespace libration
