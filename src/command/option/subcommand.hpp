// The subcommands: one file each, which adds its options to the program and returns the action to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "option/exclusions.hpp"

namespace libration {

/// A subcommand of the program and its action, which returns the exit code, once its options fit together; the
/// properties of its arguments that the table of its options names.
struct subcommand {
    CLI::App* options;
    std::function<int()> run;
    argument_property has = {};
};

subcommand find_command(CLI::App& program);
subcommand singularities_command(CLI::App& program);
subcommand asymptotics_command(CLI::App& program);
subcommand problems_command(CLI::App& program);
subcommand period_command(CLI::App& program);
subcommand coefficients_command(CLI::App& program);
subcommand trajectory_command(CLI::App& program);
subcommand radius_command(CLI::App& program);
subcommand series_command(CLI::App& program);
subcommand reference_command(CLI::App& program);
subcommand elliptic_command(CLI::App& program);
subcommand table_command(CLI::App& program);
subcommand study_command(CLI::App& program);
subcommand studies_command(CLI::App& program);
subcommand journal_command(CLI::App& program);
subcommand figure_command(CLI::App& program);
subcommand claims_command(CLI::App& program);
subcommand reproduce_command(CLI::App& program);
subcommand verify_command(CLI::App& program);
subcommand cite_command(CLI::App& program);
subcommand import_command(CLI::App& program);

}  // namespace libration
