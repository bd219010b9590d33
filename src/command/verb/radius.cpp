// libration radius: the radius of convergence of a series from its coefficients alone, by every test, or with proved
// bounds.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "libration/problem/radius_answer.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "plot/coefficient_plot.hpp"
#include "plot/plot_options.hpp"
#include "problem/answer_table.hpp"
#include "problem/coefficient_file.hpp"
#include "problem/point_options.hpp"
#include "problem/solution_options.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

struct radius_options {
    solution_options of;
    arithmetic_options arithmetic;
    output_options output;
    plot_flag plot;
    point_options point;
    std::optional<std::string> order;
    std::optional<std::string> file;
    bool prove = false, check = false;
};

convergence::listed_series listed_part(const radius_options& options, const arithmetic& numbers,
                                       std::vector<exact> written) {
    if (options.order) {
        const auto order = static_cast<std::size_t>(order_of("--order", *options.order));
        if (order >= written.size()) {
            throw input_error("--order", *options.order,
                              fmt::format("is more than {} has, whose last power is {}", quotation(*options.file),
                                          written.size() - 1),
                              "write a smaller order or leave it out");
        }
        written.resize(order + 1);
    }
    const precision_scope scope(numbers.scalar.digits + convergence::radius_guard_digits);
    std::vector<mpfr> values;
    values.reserve(written.size());
    for (const exact& number : written) {
        values.push_back(from_exact<mpfr>(number));
    }
    return {series::power_series<mpfr>(std::move(values)), std::move(written)};
}

std::vector<unknown_series> lists_of_file(const radius_options& options, const arithmetic& numbers) {
    std::vector<unknown_series> lists;
    for (named_list& list : lists_in_file(*options.file)) {
        unknown_series unknown{list.name, {{listed_part(options, numbers, std::move(list.real))}, 1}};
        if (list.is_complex()) {
            unknown.lists.parts.push_back(listed_part(options, numbers, std::move(list.imaginary)));
        }
        lists.push_back(std::move(unknown));
    }
    return lists;
}

// The results of the tests, and the coefficients if they are drawn.
struct tested_series {
    answer found;
    std::vector<unknown_series> drawn = {};
};

tested_series radius_of_solution(const radius_options& options, const arithmetic& numbers, bool with_coefficients) {
    const chosen_solution chosen = options.of.choose(options.arithmetic);
    series_request request{.order = order_of("--order", options.order ? *options.order : *chosen.usual_order)};
    options.point.complete(request, chosen);
    return options.point.asking_about([&] {
        tested_series tested{chosen.of->radius(request, {.scalar = numbers.scalar, .digits = numbers.digits})};
        if (with_coefficients) {
            tested.drawn = chosen.of->coefficient_lists(request, numbers.scalar);
        }
        return tested;
    });
}

tested_series radius_of_file(const radius_options& options, const arithmetic& numbers) {
    auto lists = lists_of_file(options, numbers);
    auto found = radius_answer(lists, std::nullopt, {.scalar = numbers.scalar, .digits = numbers.digits});
    return {std::move(found), std::move(lists)};
}

// The columns that the text shows, below the verdict in words.
std::string text_of(const answer& found, const table& data) {
    const std::size_t last = data.columns().size() - 1;
    const bool several = found.names.back() == "unknown";
    const table shown = data.with_columns(several ? std::vector<std::size_t>{last, 0, 1, 2, 9}
                                                  : std::vector<std::size_t>{0, 1, 2, 4, 9});
    const table tests(shown.columns(), {shown.rows().begin() + 1, shown.rows().end()});
    return lines_of_notes(found) + "\n" + to_text(tests) +
           "\nheuristic estimate: finitely many coefficients cannot prove a radius\n";
}

// Lower and upper bound, by discs and loops instead of coefficients.
int prove_radius(const radius_options& options) {
    const long digits = options.arithmetic.choose().digits;
    const chosen_solution chosen = options.of.choose(options.arithmetic);
    progress shown("radius", 1);
    const request how{
        .scalar = {scalar_kind::proved, digits}, .check = options.check, .stage = [&](const std::string& done) {
            shown.stage(done);
            check_time();
        }};
    const answer found = chosen.of->radius(series_request{}, how);
    table data({{"lower", ""}, {"upper", ""}, {"digits", ""}, {"rigour", ""}});
    data.add_row({number_cell(found.at(0, "lower")), number_cell(found.at(0, "upper")), digits, found.rigour});
    std::string text;
    for (const answer_note& each : found.notes) {
        text += fmt::format("{}  {}  {}: {}\n", each.name, found.at(0, each.name == "upper" ? "upper" : "lower"),
                            found.rigour, each.text);
    }
    options.output.write(data, text);
    if (found.missing) {
        throw error(*found.missing);
    }
    return 0;
}

int run_radius(const radius_options& options) {
    options.output.check();
    if (options.prove) {
        return prove_radius(options);
    }
    const auto figure = options.plot.file(options.output);
    const arithmetic numbers = options.arithmetic.choose();
    const auto tested =
        options.file ? radius_of_file(options, numbers) : radius_of_solution(options, numbers, figure.has_value());
    const table data = table_of(tested.found);
    if (figure) {
        figure->draw(
            coefficient_plot(tested.drawn, tested.found, "Radius of convergence from coefficients", figure_digits));
    }
    table_output(options.output, figure).write(data, text_of(tested.found, data));
    return 0;
}

}  // namespace

subcommand radius_command(CLI::App& program) {
    const auto options = std::make_shared<radius_options>();
    CLI::App* command = program.add_subcommand(
        "radius",
        "the radius of convergence from coefficients alone: of a motion's series, of any problem, or of a list in a "
        "file");
    options->of.add_to(*command);
    options->arithmetic.add_to(*command);
    options->output.add_to(*command);
    options->plot.add_to(*command, "ratios, roots and Pade poles of the coefficients");
    command->add_option("--order", options->order, "last power N (default for a file: all of its coefficients)")
        ->type_name("N");
    command->add_flag("--prove", options->prove,
                      "proved lower and upper bounds that agree to --digits D (theorems L and C)");
    command->add_flag("--check", options->check,
                      "with --prove: compare with a second proof by another route, exit 1 if they disagree");
    options->point.add_to(*command);
    command
        ->add_option(
            "--coefficients", options->file,
            "lists instead of a motion: one number per line, n,coefficient, n,u,v, complex 1+2i or NAME_re,NAME_im, or "
            "JSON; - for stdin")
        ->type_name("FILE");
    return {command, [options] { return run_radius(*options); }};
}

}  // namespace libration
