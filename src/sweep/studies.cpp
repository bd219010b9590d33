// libration studies: each study with its question, its parameters and its cost.
#include <fmt/format.h>

#include "option/subcommand.hpp"
#include "sweep/study.hpp"

namespace libration {

namespace {

int list_studies() {
    for (const study* each : all_studies()) {
        fmt::print("{}{}\n    {}\n", each->name, each->label.empty() ? "" : "  [paper " + each->label + "]",
                   each->question);
        for (const study_parameter& parameter : each->parameters) {
            fmt::print("    {:<12} {}\n    {:<12}   {}\n", parameter.option,
                       parameter.usual.empty() ? "none" : parameter.usual, "", parameter.meaning);
        }
        fmt::print("    {:<12} {:.1f} s on two cores\n", "cost", each->seconds);
    }
    return 0;
}

}  // namespace

subcommand studies_command(CLI::App& program) {
    return {program.add_subcommand("studies", "list the studies: question, parameters, cost"), list_studies};
}

}  // namespace libration
