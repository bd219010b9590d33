// --timeout, of every command that may take long.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "run/ending_signal.hpp"

namespace libration {

/// A duration above 0 in seconds, or with a unit: 90, 1.5, 90s, 500ms, 5min, 2h. Throws input_error of --timeout.
std::chrono::milliseconds duration_of(const std::string& value);

class timeout_option {
public:
    void add_to(CLI::App& command);
    /// The limit of the command that runs now, at signals, too, if the command leaves them to it; and whether it prints
    /// what is finished.
    std::unique_ptr<time_limit> begin(bool signals, bool prints_parts) const;

private:
    std::optional<std::string> value_;
};

}  // namespace libration
