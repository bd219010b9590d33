// libration elliptic: proved digits of elliptic functions and integrals.
#include <memory>
#include <utility>

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
    const elliptic::named_function* const function = elliptic::find_function(options.function);
    if (function == nullptr) {
        throw input_error("elliptic", options.function, "is not a function", "write " + elliptic_names());
    }
    const long digits = digits_of(options.digits);
    const elliptic_request request = read_elliptic({function}, options.said, elliptic_grid::one);
    std::vector<column> columns{{"function", ""}, {"argument", ""}, {request.modulus, ""},
                                {"value", ""},    {"digits", ""},   {"rigour", ""}};
    if (request.has_characteristic()) {
        columns.push_back({"n", ""});
    }
    if (request.is_complex()) {
        columns.insert(columns.end(), {{"imaginary", ""}, {"condition", ""}});
    }
    table data(std::move(columns));
    for (const elliptic_point& at : request.points) {
        const auto value = answer_at(request, at, [&] { return texts_of(*function, at, digits); });
        table_row_cells row{options.function,
                            at.argument ? read_cell(at.argument->text) : cell(),
                            read_cell(at.parameter.typed.text),
                            number_cell(value[0]),
                            digits,
                            "proved"};
        if (at.characteristic) {
            row.push_back(read_cell(at.characteristic->text));
        }
        if (request.is_complex()) {
            row.push_back(number_cell(value[1]));
            row.push_back(number_cell(condition_of(*function, at)));
        }
        data.add_row(std::move(row));
    }
    options.output.write(data);
    return 0;
}

}  // namespace

subcommand elliptic_command(CLI::App& program) {
    const auto options = std::make_shared<elliptic_options>();
    CLI::App* command =
        program.add_subcommand("elliptic", "proved digits of elliptic functions and integrals at any real parameter");
    command->add_option("function", options->function, elliptic_names())->type_name("FUNCTION")->required();
    offer_elliptic(options->said, *command);
    add_digits(*command, options->digits);
    options->output.add_to(*command);
    return {command, [options] { return run_elliptic(*options); }};
}

}  // namespace libration
