// libration import: a model in SBML as a problem.
#include <memory>
#include <string>

#include "option/subcommand.hpp"
#include "run/child_program.hpp"
#include "run/program_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr int not_found = 127;

int import_model(const std::string& file) {
    const int code = run_program({peer_program("libration-import"), file});
    if (code == not_found) {
        throw input_error(
            "import requires libsbml, without which this program was built: install libsbml5-dev and build it again");
    }
    return code;
}

}  // namespace

subcommand import_command(CLI::App& program) {
    CLI::App* const command =
        program.add_subcommand("import", "print a model in SBML as a problem, for a file with the ending .ode");
    auto file = std::make_shared<std::string>();
    command->add_option("FILE", *file, "the model: reactions, rules, events and delays")->required();
    return {command, [file] { return import_model(*file); }};
}

}  // namespace libration
