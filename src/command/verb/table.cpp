// libration table: reference tables with proved digits, of motions at times or of elliptic functions, in the formats
// of those who test programs with them.
#include <filesystem>
#include <memory>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/problem_options.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_order.hpp"
#include "table/elliptic_request.hpp"
#include "table/motion_grid.hpp"
#include "table/table_formats.hpp"
#include "table/table_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct table_options {
    std::string what;
    problem_options problem;
    table_order order;
    output_options output{defaults::format_of_table, {"cpp", "ipp", "numpy", "c", "fortran", "julia", "pari"}};
    std::optional<std::string> digits, name, jobs;
};

// The file with the provenance of a format without comments: x.provenance.json next to x.csv.
std::filesystem::path provenance_beside(const std::string& file) {
    return std::filesystem::path(file).replace_extension("provenance.json");
}

std::string name_in_program(const table_options& options) {
    const std::string& format = options.output.format();
    if (!options.name) {
        return defaults::name_of_array;
    }
    if (!has_comments(format) || format == "numpy") {
        throw input_error("--name", *options.name, "has no meaning for " + format, "leave it out");
    }
    require_identifier(*options.name);
    return *options.name;
}

int run_table(const table_options& options) {
    options.output.check();
    const std::string name = name_in_program(options);
    const std::string& format = options.output.format();
    table_order order = options.order;
    order.digits = digits_of(options.digits);
    order.subject = table_subject_of(options.what, options.problem);
    const table data = table_for(order, format, jobs_of(options.jobs));
    const std::string command = order.command() + " --format " + format + (options.name ? " --name " + name : "");
    options.output.write_content(table_file(order, data, format, name, command));
    const auto& file = options.output.file();
    if (file && !has_comments(format) && std::filesystem::is_regular_file(*file)) {
        write_into(provenance_beside(*file).string(), provenance_json(order, data, command));
    }
    return 0;
}

}  // namespace

subcommand table_command(CLI::App& program) {
    const auto options = std::make_shared<table_options>();
    CLI::App* command =
        program.add_subcommand("table",
                               "reference tables with proved digits: motions and any problem at times, or elliptic "
                               "functions");
    command->add_option("what", options->what, "pendulum, or functions as in am,sn: " + elliptic_names())
        ->type_name("pendulum|FUNCTION");
    options->problem.add_to(*command, problem_options::closed_forms::used);
    offer_motions(options->order.said, *command);
    offer_elliptic(options->order.said, *command);
    options->order.said.offer(
        *command, "--points", "FILE",
        "a file with a point in each row instead: a motion and a time, or u (phi, x) and m (m1, k)");
    options->order.said.offer(*command, "--columns", "THEIRS=OURS,...",
                              "the names of its columns: t=time,E=energy; NAME=- ignores a column");
    add_digits(*command, options->digits);
    options->output.add_to(*command);
    command->add_option("--name", options->name, "name of the array in cpp, ipp, c, fortran, julia and pari")
        ->type_name("NAME");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options] { return run_table(*options); }};
}

}  // namespace libration
