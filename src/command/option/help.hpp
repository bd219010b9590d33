// The output of --help: lines of at most 100 columns, and examples at the end.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

namespace libration {

/// The program in one sentence, as in README.md, CITATION.cff and the packages.
inline constexpr const char* program_description =
    "Power-series solutions of ordinary differential equations to arbitrary precision, with rigorous error bounds; "
    "the pendulum is built in.";

/// Wraps the lines of `text` at 100 columns, at blanks, and words that do not fit in a line after commas; continued
/// lines start with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent);

/// Sets the layout of --help for the program and its subcommands. Call it before adding these, which inherit it.
void set_help_layout(CLI::App& program);

/// Appends the examples of every subcommand to its --help, and two of the program. Throws std::logic_error for a
/// subcommand without examples.
void add_examples(CLI::App& program);

}  // namespace libration
