// libration figure NAME: redraws a study's figures from its CSV.
#include <memory>

#include "option/subcommand.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_files.hpp"

namespace libration {

subcommand figure_command(CLI::App& program) {
    struct figure_options {
        std::string name;
        std::string out = "results";
    };
    const auto options = std::make_shared<figure_options>();
    CLI::App* command = program.add_subcommand("figure", "redraw the figures of a study from its CSV");
    command->add_option("NAME", options->name, "name of the study")->required();
    command->add_option("--out", options->out, "the directory that contains NAME/NAME.csv")
        ->type_name("DIR")
        ->capture_default_str();
    return {command, [options] {
                draw_study(*study_in("figure", options->name, options->out), options->out);
                return 0;
            }};
}

}  // namespace libration
