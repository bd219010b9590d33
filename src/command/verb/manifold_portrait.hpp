// The manifolds of an equilibrium as a table and a figure: `libration trajectory --manifold`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "option/options.hpp"
#include "plot/plot_options.hpp"
#include "problem/problem_options.hpp"

namespace libration {

/// --manifold and --equilibrium.
class manifold_options {
public:
    void add_to(CLI::App& command);
    bool given() const { return manifold_.has_value(); }
    /// Prints manifold,branch,time,<unknowns>...,digits,rigour, and draws it with --plot. The exit code. Throws input_error.
    int write(const problem_options& problem, const output_options& output, plot_axes plot) const;

private:
    std::optional<std::string> manifold_, equilibrium_;
};

}  // namespace libration
