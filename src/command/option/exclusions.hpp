// Which options of a command exclude or need others, as one table for each command.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace libration {

/// A combination of options that a command rejects, with the reason as a predicate and what to write instead.
struct option_rule {
    /// The options, separated by blanks, each of which is rejected if it is given; empty if something is missing.
    const char* options;
    /// When: terms, separated by blanks, all of which hold. `--out` is given; `--times=inf|0` has one of these values,
    /// `--scalar=ball:*` one that begins so; `--gap|--energy` means one of them, and `!` the contrary of a term. A term
    /// without dashes is a positional argument that is given, or a property of the arguments, which the command decides.
    const char* when;
    const char* reason;  ///< {} is replaced by the value of the first option of `when`
    const char* remedy = "leave it out";
};

/// Whether the arguments of a command have a property that a table names, such as "sets".
using argument_property = std::function<bool(std::string_view)>;

/// Throws input_error for the first rule of the command that its options break. Options that a command does not have
/// are not given.
void check_combinations(const CLI::App& command, const argument_property& has);

/// The options that the tables name, each of which some command has.
std::vector<std::string> options_in_tables();

}  // namespace libration
