// libration series: evaluates the function defined by a list of coefficients: the value with an uncertainty by the methods
// that agree, values by partial sums, Pade and endpoint approximants, errors against a reference, poles and zeros, and the
// plots of its ratios and roots.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "option/options.hpp"
#include "option/rounding_option.hpp"
#include "option/subcommand.hpp"
#include "problem/list_tables.hpp"
#include "run/working_folder.hpp"
#include "sweep/study_figures.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

struct series_options {
    list_words list;
    rounding_option rounding;
    std::optional<std::string> digits, out;
    std::string format = defaults::format;
};

// The tables and figures are written to a temporary directory and moved when all of them are complete.
void write_list(const list_request& request, const table& values, const std::string& folder) {
    output_folder into("--out", folder);
    const working_folder working(into.path());
    const auto write = [&](const char* name, const table& data) {
        write_into((fs::path(working.path()) / name).string(), to_csv(data));
    };
    write("values.csv", values);
    write("errors.csv", list_errors(request));
    write("poles.csv", list_poles(request));
    write("ratios.csv", list_ratios(request));
    write("radius.csv", list_radius(request));
    study script;
    script.name = "series";
    draw_figures(script, working.path());
    for (const auto& made : fs::directory_iterator(working.path())) {
        fs::rename(made.path(), fs::path(into.path()) / made.path().filename());
    }
    into.keep();
}

int run_series(const series_options& options) {
    const long digits = digits_of(options.digits, defaults::digits_of_list);
    if (options.format != "text" && options.format != "csv" && options.format != "json" && options.format != "latex") {
        throw input_error("--format", options.format, "is not a format", "write text, csv, json or latex");
    }
    list_request request = list_request_of(options.list, digits);
    request.rounded = options.rounding.digits();
    const bool evaluated = !request.times.empty();
    const table values = evaluated ? list_values(request) : table(std::vector<column>{{"time", ""}});
    if (options.out) {
        write_list(request, values, *options.out);
    }
    write_to_stdout(in_format(options.format, evaluated ? values : list_poles(request)));
    return 0;
}

}  // namespace

subcommand series_command(CLI::App& program) {
    const auto options = std::make_shared<series_options>();
    CLI::App* command = program.add_subcommand(
        "series", "your own list of coefficients: values, approximants, errors, poles and zeros, plots");
    list_words& list = options->list;
    command->add_option("--coefficients", list.file, "the list: one number per line, or n,coefficient; - for stdin")
        ->type_name("FILE")
        ->required();
    command->add_option("--order", list.order, "last power N (default: that of the list)")->type_name("N");
    options->rounding.add_to(*command, "rounded if they have fewer than 60 digits");
    command
        ->add_option("--times,--time", list.times,
                     "where to evaluate it: 0,1/2,1 or a range 0:1:11; without it the poles and zeros are printed")
        ->type_name("LIST");
    command
        ->add_option("--method", list.method,
                     "verdict, series, pade ([L/M] with M = N/2) or endpoint (default: all that apply)")
        ->type_name("METHOD");
    command->add_option("--endpoint", list.end, "another point where the function is known")->type_name("X");
    command->add_option("--endpoint-values", list.at_end, "f,f',f'',... there, for endpoint approximants")
        ->type_name("LIST");
    command
        ->add_option("--reference", list.reference,
                     "what values are compared with: a value, a formula in t, or a file with columns time,value")
        ->type_name("R");
    command
        ->add_option("--digits", options->digits,
                     fmt::format("significant digits of the values (default: {})", defaults::digits_of_list))
        ->type_name("D");
    command->add_option("--format", options->format, "text, csv, json or latex")
        ->type_name("FORMAT")
        ->capture_default_str();
    command
        ->add_option("--out", options->out,
                     "a folder for values, errors, poles and zeros, ratios and roots as CSV and as figures")
        ->type_name("DIR");
    return {command, [options] { return run_series(*options); }};
}

}  // namespace libration
