// libration asymptotics: the law of all Taylor coefficients of a solution, proved.
#include <fmt/format.h>

#include <memory>

#include "libration/number/grid.hpp"
#include "libration/problem/law_answer.hpp"
#include "libration/scalar/whole_number.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/answer_table.hpp"
#include "problem/problem_options.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr int most_terms_of_law = 200;
constexpr std::size_t most_orders = 10'000;
constexpr long most_digits_of_law = 10'000;

struct asymptotics_options {
    problem_options problem;
    output_options output;
    std::optional<std::string> show, within, digits, terms;
    std::vector<std::string> orders;
};

law_question question_of(const asymptotics_options& options) {
    law_question asked;
    asked.show = options.show.value_or("");
    if (options.within) {
        asked.within = positive_number_of("--within", *options.within);
    }
    if (options.terms) {
        asked.terms = reading("--terms", *options.terms, "write the last index of the expansions, 0 to 200",
                              [&] { return read_count(*options.terms, most_terms_of_law); });
    }
    return asked;
}

std::vector<long> orders_of(const asymptotics_options& options) {
    std::vector<long> orders;
    for (const std::string& each : options.orders) {
        orders.push_back(reading("--order", each, "write powers such as 100,10000,1000000",
                                 [&] { return read_whole_number(each, largest_power_of_series, "power"); }));
    }
    if (orders.size() > most_orders) {
        throw input_error("--order", std::to_string(orders.size()) + " powers", "are more than 10000", "write fewer");
    }
    return orders;
}

// Errors of the unknown and of what is not proved name the option.
law_report report_of(const asymptotics_options& options, long digits) {
    const auto asked = question_of(options);
    const auto orders = orders_of(options);
    progress shown("asymptotics", 1);
    try {
        return law_of(options.problem.choose(), asked, orders,
                      {.scalar = {scalar_kind::proved, digits}, .stage = [&](const std::string& done) {
                           shown.stage(done);
                           check_time();
                       }});
    } catch (const error& reason) {
        if (reason.is_about(error_subject::problem)) {
            throw error(reason.kind(), "--problem", *options.problem.problem(), reason.reason());
        }
        if (reason.is_about(error_subject::unknowns)) {
            throw input_error("--show", reason.value(), reason.reason(), "write an unknown of the problem");
        }
        throw;
    }
}

table table_of_orders(const answer& found) {
    table data({{"n", "the power of t - t0"},
                {"value", "a_n; empty if no digit is proved"},
                {"error", "a bound of |a_n - value|, or of |a_n| if value is empty"},
                {"by", "law, recurrence, or symmetry for an exact 0"}});
    for (const auto& row : found.rows) {
        data.add_row({std::stol(row[0].text), number_cell(row[1].text), number_cell(row[1].bound), row[2].text});
    }
    return data;
}

std::string number_or_bound(const answer_value& value) {
    return value.text.empty() ? "|.| <= " + value.bound : value.text;
}

std::string text_of_law(const answer& law, const std::optional<table>& orders) {
    std::string text;
    for (const auto& row : law.rows) {
        if (row[3].text == "none") {
            continue;
        }
        const std::string place = row[1].text == "0"
                                      ? number_or_bound(row[0])
                                      : fmt::format("({}) + ({})i", number_or_bound(row[0]), number_or_bound(row[1]));
        text += fmt::format("t* - t0 = {}  {}", place, row[3].text);
        if (!row[4].text.empty()) {
            text += fmt::format(", exponent {}, coefficient ", row[4].text);
            text += row[6].text == "0" ? number_or_bound(row[5])
                                       : fmt::format("({}) + ({})i", number_or_bound(row[5]), number_or_bound(row[6]));
        }
        text += "\n";
    }
    for (const answer_note& each : law.notes) {
        text += fmt::format("{:8}{}\n", each.name, each.text);
    }
    return orders ? text + "\n" + to_text(*orders) : text;
}

int run_asymptotics(const asymptotics_options& options) {
    options.output.check();
    const long digits = digits_of(options.digits, defaults::digits_of_law);
    if (digits > most_digits_of_law) {
        throw input_error("--digits", *options.digits, "is more than 10000", "write a smaller number");
    }
    const law_report found = report_of(options, digits);
    const auto orders = options.orders.empty() ? std::nullopt : std::optional(table_of_orders(found.coefficients));
    const auto text = text_of_law(found.singularities, orders);
    options.output.write(orders ? *orders : table_of(found.singularities), text);
    if (!found.complete) {
        throw error(error_kind::undecided, "coefficient", "",
                    "has less than the digits of --digits: its order is too small for the law, and too large for the "
                    "recurrence");
    }
    return 0;
}

}  // namespace

subcommand asymptotics_command(CLI::App& program) {
    const auto options = std::make_shared<asymptotics_options>();
    CLI::App* command = program.add_subcommand(
        "asymptotics",
        "the law of all Taylor coefficients of a problem, proved: singularities, error for every n, any a_n");
    options->problem.add_to(*command);
    command->remove_option(command->get_option("--show"));
    options->output.add_to(*command);
    command->add_option("--show", options->show, "the unknown, or x' for a derivative (default: the first)")
        ->type_name("NAME");
    command
        ->add_option("--order", options->orders, "powers n whose coefficients a_n are computed by the law, 100,1000000")
        ->delimiter(',')
        ->type_name("N");
    command->add_option("--digits", options->digits, fmt::format("digits of all numbers ({})", defaults::digits_of_law))
        ->type_name("D");
    command
        ->add_option("--within", options->within,
                     "the distance from the initial point up to which all singularities are proved (default: chosen "
                     "between the nearest)")
        ->type_name("RHO");
    command->add_option("--terms", options->terms, "last index J of the expansions at branch points (60)")
        ->type_name("J");
    return {command, [options] { return run_asymptotics(*options); }};
}

}  // namespace libration
