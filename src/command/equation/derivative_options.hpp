// The option --derivatives of commands that print the states of a problem.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace libration {

/// --derivatives "x(0), x'(0), r": the numbers of a problem with respect to which its solution is differentiated.
class derivative_options {
public:
    void add_to(CLI::App& command);
    /// Whether derivatives are requested, which replaces closed forms by the equations.
    bool differentiate() const { return numbers_.has_value(); }
    /// request::derivatives. Throws input_error for an empty item.
    std::vector<std::string> numbers() const;

private:
    std::optional<std::string> numbers_;
};

}  // namespace libration
