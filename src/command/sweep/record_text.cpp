#include "record_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "counted_text.hpp"

namespace libration {

namespace {

constexpr double nanoseconds = 1e9;

}  // namespace

std::string to_record_text(const std::vector<journal_record>& records) {
    std::string text;
    add_number(text, static_cast<long>(records.size()));
    for (const journal_record& each : records) {
        add_string(text, std::string(each.key.begin(), each.key.end()));
        add_string(text, each.inputs);
        add_number(text, static_cast<long>(each.failed));
        add_number(text, each.attempts);
        add_number(text, static_cast<long>(each.seconds * nanoseconds));
        add_string(text, each.content);
    }
    return text;
}

std::vector<journal_record> records_from(std::string_view text) {
    counted_text rest(text);
    std::vector<journal_record> records(rest.count());
    for (journal_record& each : records) {
        const std::string key = rest.string();
        if (key.size() != each.key.size()) {
            counted_text::refuse();
        }
        std::copy(key.begin(), key.end(), each.key.begin());
        each.inputs = rest.string();
        each.failed = rest.number() != 0;
        each.attempts = static_cast<int>(rest.number());
        each.seconds = static_cast<double>(rest.number()) / nanoseconds;
        each.content = rest.string();
    }
    rest.require_end();
    return records;
}

}  // namespace libration
