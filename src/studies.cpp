// libration studies: each study with its question, its parameters and its cost.
#include <fmt/format.h>

#include "subcommand.hpp"
#include "sweep/study.hpp"

namespace libration {

namespace {

int list_studies() {
    for (const study* each : all_studies()) {
        fmt::print("{}\n    {}\n", each->name, each->question);
        const auto line = [](const char* name, const std::string& value) {
            if (!value.empty()) {
                fmt::print("    {:<11}{}\n", name, value);
            }
        };
        line("--energies", each->defaults.energies);
        line("--gaps", each->defaults.gaps);
        line("--orders", each->defaults.orders);
        line("--scalar", each->defaults.scalars);
        line("cost", each->cost);
    }
    return 0;
}

}  // namespace

subcommand studies_command(CLI::App& program) {
    return {program.add_subcommand("studies", "list the studies: question, parameters, cost"), list_studies};
}

}  // namespace libration
