// libration elliptic: proved digits of am, sn, cn, dn, K and F.
#include <memory>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "table/elliptic_request.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct elliptic_options {
    output_options output;
    std::string function;
    option_words said;
    std::optional<std::string> digits;
};

int run_elliptic(const elliptic_options& options) {
    options.output.check();
    const std::string& function = options.function;
    if (!is_elliptic_function(function)) {
        throw input_error("elliptic", function, "is no function", "write am, sn, cn, dn, K or F");
    }
    const long digits = digits_of(options.digits);
    const elliptic_request request = read_elliptic({function}, options.said, elliptic_grid::one);
    const typed_parameter& parameter = request.parameters.front();
    table data({{"function", ""},
                {"argument", ""},
                {request.option.substr(2), ""},
                {"value", ""},
                {"digits", ""},
                {"rigour", ""}});
    for (const exact& argument : request.arguments) {
        data.add_row({function, read_cell(argument.text), read_cell(parameter.typed.text),
                      number_cell(function_text(function, argument, parameter.value(), digits)), digits, "proved"});
    }
    options.output.write(data);
    return 0;
}

}  // namespace

subcommand elliptic_command(CLI::App& program) {
    const auto options = std::make_shared<elliptic_options>();
    CLI::App* command =
        program.add_subcommand("elliptic", "proved digits of am, sn, cn, dn, K and F at any modulus from 0 to 1");
    command->add_option("function", options->function, "am, sn, cn, dn, K or F")->type_name("FUNCTION")->required();
    offer_elliptic(options->said, *command);
    command->add_option("--digits", options->digits, "significant digits, each proved to one unit in the last (50)")
        ->type_name("D");
    options->output.add_to(*command);
    return {command, [options] { return run_elliptic(*options); }};
}

}  // namespace libration
