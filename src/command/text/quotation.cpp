#include "text/quotation.hpp"

#include <algorithm>

#include "libration/scalar/utf8.hpp"

namespace libration {

namespace {

constexpr std::size_t longest_message = 2000;

// Of the character that a text begins with; 0 if there is none, or a control character.
std::size_t printable_bytes(std::string_view text) {
    const std::size_t bytes = bytes_of_character(text);
    return bytes > 0 && is_printable(text.substr(0, bytes)) ? bytes : 0;
}

std::string escaped(char c) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
        case '\n': return "\\n";
        case '\t': return "\\t";
        case '\r': return "\\r";
        case '\0': return "\\0";
        default: return {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    }
}

// Where a quoted part ends that begins behind `from`: at a quote with nothing of a word behind it.
std::size_t end_of_quotation(std::string_view message, std::size_t from) {
    constexpr std::string_view behind = " :;,.)";
    for (std::size_t at = message.find('\'', from); at != std::string_view::npos; at = message.find('\'', at + 1)) {
        if (at + 1 == message.size() || behind.find(message[at + 1]) != std::string_view::npos) {
            return at;
        }
    }
    return message.size();
}

}  // namespace

std::string without_controls(std::string_view text, std::size_t most) {
    std::string shown;
    for (std::size_t count = 0; !text.empty(); ++count) {
        if (count == most) {
            return shown + "...";
        }
        const std::size_t bytes = printable_bytes(text);
        shown += bytes > 0 ? std::string(text.substr(0, bytes)) : escaped(text.front());
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return shown;
}

std::string quotation(std::string_view input) { return "'" + without_controls(input, longest_quotation) + "'"; }

std::string shortened(std::string_view message) {
    std::string shown;
    for (std::size_t at = 0; at < message.size() && shown.size() <= longest_message;) {
        const bool opens = message[at] == '\'' && (at == 0 || message[at - 1] == ' ' || message[at - 1] == '(');
        const std::size_t begin = at + (opens ? 1 : 0);
        const std::size_t end =
            opens ? end_of_quotation(message, begin) : std::min(message.find('\'', at + 1), message.size());
        const std::string_view part = message.substr(begin, end - begin);
        shown += opens ? quotation(part) : without_controls(part, longest_message);
        at = end + (opens ? 1 : 0);
    }
    return without_controls(shown, longest_message);
}

std::string message_of(const error& problem) {
    return problem.subject() + (problem.value().empty() ? "" : " " + quotation(problem.value())) + " " +
           problem.reason();
}

}  // namespace libration
