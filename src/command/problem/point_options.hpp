// The expansion point of a series, and the path to it.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "complex_times.hpp"
#include "libration/problem/series_request.hpp"
#include "libration/scalar/error.hpp"
#include "solution_options.hpp"

namespace libration {

/// --at POINT and --via LIST.
class point_options {
public:
    void add_to(CLI::App& command);
    const std::optional<std::string>& at() const { return at_; }
    /// Whether the point is complex.
    bool is_complex() const { return at_ && has_imaginary_unit(*at_); }
    /// Adds the point and the path to a request. Throws input_error for a text that is not a point of this solution.
    void complete(series_request& request, const chosen_solution& chosen) const;
    /// ask(); an error about the path to the point names the option.
    template <class Ask>
    auto asking_about(const Ask& ask) const {
        try {
            return ask();
        } catch (const error& problem) {
            if (!at_ || (!problem.is_about(error_subject::time) && !problem.is_about(error_subject::point))) {
                throw;
            }
            refuse_path(problem);
        }
    }

private:
    [[noreturn]] void refuse_path(const error& problem) const;

    std::optional<std::string> at_, via_;
};

}  // namespace libration
