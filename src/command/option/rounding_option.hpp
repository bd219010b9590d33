// --exact and --rounded D: how the decimals of a list of coefficients are read.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace libration {

/// The two options, of `radius` and `series`.
struct rounding_option {
    bool exact = false;
    std::optional<std::string> rounded = std::nullopt;

    /// `otherwise`: how they are read without an option.
    void add_to(CLI::App& command, const std::string& otherwise);
    /// 0: exact; D: correct to D significant digits; std::nullopt if that follows from how they are written. Throws
    /// input_error.
    std::optional<long> digits() const;
};

}  // namespace libration
