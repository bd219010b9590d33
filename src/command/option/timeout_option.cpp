#include "option/timeout_option.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "libration/number/number_lexer.hpp"
#include "libration/scalar/mpfr.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* timeout_remedy = "write seconds above 0 such as 90, or 500ms, 90s, 5min, 2h";
constexpr long most_milliseconds = 1'000'000'000'000;

// Milliseconds in a unit; std::nullopt for an unknown one.
std::optional<rational> milliseconds_in(std::string_view unit) {
    using known = std::pair<std::string_view, long>;
    for (const auto& [name, size] :
         std::array<known, 6>{{{"", 1000}, {"s", 1000}, {"ms", 1}, {"min", 60'000}, {"m", 60'000}, {"h", 3'600'000}}}) {
        if (name == unit) {
            return rational(size);
        }
    }
    return std::nullopt;
}

}  // namespace

std::chrono::milliseconds duration_of(const std::string& value) {
    std::string_view rest = value;
    const auto number = reading("--timeout", value, timeout_remedy, [&] { return take_number(rest); });
    const auto unit = milliseconds_in(rest);
    if (!number || !unit) {
        throw input_error("--timeout", value, "is not a duration", timeout_remedy);
    }
    const rational length = number->value() * *unit;
    if (length < 1) {
        throw input_error("--timeout", value, "is less than a millisecond", timeout_remedy);
    }
    if (length > most_milliseconds) {
        throw input_error("--timeout", value, "is more than 30 years", timeout_remedy);
    }
    const integer whole = numerator(length) / denominator(length);
    return std::chrono::milliseconds(whole.convert_to<long>());
}

void timeout_option::add_to(CLI::App& command) {
    command
        .add_option(
            "--timeout", value_,
            "stop after this time (90, 90s or 5min), print what is finished and exit with status 1, like Ctrl-C")
        ->type_name("SECONDS");
}

std::unique_ptr<time_limit> timeout_option::begin(bool signals, bool prints_parts) const {
    const auto limit = value_ ? std::optional(duration_of(*value_)) : std::nullopt;
    return std::make_unique<time_limit>(limit, value_.value_or(""), signals, prints_parts);
}

}  // namespace libration
