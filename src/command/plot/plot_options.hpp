// The option --plot of a command that draws its results.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "option/options.hpp"
#include "plot/figure_file.hpp"

namespace libration {

/// Digits of the numbers that are drawn.
inline constexpr long figure_digits = 17;

/// --plot: with it, --out is the file of a figure, and the table goes to stdout.
class plot_flag {
public:
    void add_to(CLI::App& command, const std::string& drawn);
    bool given() const { return given_; }
    /// The file of the figure, tested; std::nullopt without --plot. Throws input_error.
    std::optional<figure_file> file(const output_options& output) const;

private:
    bool given_ = false;
};

/// --plot X,Y,...: the same for a table of values, with the quantities on the axes.
class plot_axes {
public:
    void add_to(CLI::App& command);
    bool given() const { return words_.has_value(); }
    /// The names for --plot without names.
    void use_if_empty(const std::string& names);
    /// The file of the figure, tested; std::nullopt without --plot. Throws input_error.
    std::optional<figure_file> file(const output_options& output) const;
    /// The names as they are given, two at least; t is the time. Throws input_error.
    std::vector<std::string> names() const;
    /// Throws input_error, before anything is computed, for a name that no table of a solution with these columns has.
    void require_known(const std::vector<column>& columns) const;
    /// The places of the names among the columns of a table. Throws input_error for a name that it does not have.
    std::vector<std::size_t> places_in(const table& data) const;

private:
    std::optional<std::string> words_;
};

/// What a command with a figure writes its table with: stdout instead of --out.
output_options table_output(const output_options& output, const std::optional<figure_file>& figure);

}  // namespace libration
