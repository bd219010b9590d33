// The option --derivatives of commands that print the states of a problem.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/error.hpp"
#include "text/input_error.hpp"

namespace libration {

/// --derivatives "x(0), x'(0), r": the numbers of a problem with respect to which its solution is differentiated.
class derivative_options {
public:
    void add_to(CLI::App& command);
    /// Whether derivatives are requested, which replaces closed forms by the equations.
    bool differentiate() const { return numbers_.has_value(); }
    /// request::derivatives. Throws input_error for an empty item.
    std::vector<std::string> numbers() const;

    /// work(); an error about a number is rethrown with the name of the option.
    template <class Work>
    static auto naming(const Work& work) {
        try {
            return work();
        } catch (const error& problem) {
            if (problem.kind() != error_kind::argument || !problem.is_about(error_subject::derivatives)) {
                throw;
            }
            throw input_error("--derivatives '" + problem.value() + "' " + problem.reason());
        }
    }

private:
    std::optional<std::string> numbers_;
};

}  // namespace libration
