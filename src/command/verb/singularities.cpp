// libration singularities: the map of the complex t-plane, for any problem.
#include <fmt/format.h>

#include <initializer_list>
#include <memory>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/decimal.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "plot/plot_options.hpp"
#include "plot/singularity_plot.hpp"
#include "problem/answer_table.hpp"
#include "problem/problem_options.hpp"
#include "problem/verdict_judgement.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr long most_digits = 1000;

struct singularities_options {
    problem_options problem;
    output_options output;
    plot_flag plot;
    std::optional<std::string> within, digits;
    bool prove = false, check = false;

    std::optional<double> radius() const {
        return within ? std::optional(from_exact<double>(positive_number_of("--within", *within))) : std::nullopt;
    }
};

// What the columns mean.
column_labels labels_of_map() {
    column_labels labels;
    for (const column& each : std::initializer_list<column>{
             {"position_re", "time of the singularity, real part"},
             {"position_im", "time of the singularity, imaginary part"},
             {"modulus", "distance from the initial point"},
             {"uncertainty", "error bound of the position as printed"},
             {"kind", "pole, with branches, algebraic, logarithm, complex power, or unclear if no power is found"},
             {"exponent_re", "exponent p of the leading behaviour, real part"},
             {"exponent_im", "imaginary part"},
             {"rigour",
              "proved: that this unknown is singular within the uncertainty, and a pole by a zero of its inverse; "
              "other kinds are heuristic"},
             {"unknown", "the unknown that is singular there, with that behaviour"},
             {"coefficient_re", "c in c (t - t*)^p, or c (1 - (t - t0)/(t* - t0))^p if p is not an integer"},
             {"coefficient_im", "imaginary part"},
             {"resonances", "r: perturbations grow like (t - t*)^(p + r)"},
             {"evidence", "what proves it, or why it is not proved"}}) {
        labels[each.name] = each;
    }
    return labels;
}

std::string number_words(const std::string& name, const cell& re, const cell& im) {
    if (re.is_empty() || im.is_empty()) {
        return "";
    }
    return fmt::format(", {} {}", name, complex_text(re.text(), im.text()));
}

std::string text_of(const table& data, const answer& found) {
    std::string text;
    for (const auto& row : data.rows()) {
        text += fmt::format("{}  +- {}  {}  {}: {}{}{}\n", complex_text(row[0].text(), row[1].text()), row[3].text(),
                            row[7].text(), row[8].text(), row[4].text(), number_words("exponent", row[5], row[6]),
                            number_words("coefficient", row[9], row[10]));
        if (!row[11].is_empty()) {
            text += fmt::format("    resonances {}\n", row[11].text());
        }
        if (!row[12].is_empty()) {
            text += fmt::format("    {}\n", row[12].text());
        }
    }
    for (const answer_note& each : found.notes) {
        text += each.text + "\n";
    }
    return text;
}

std::string initial_point_of(const problem_options& of) {
    const precision_scope scope(figure_digits);
    return to_decimal(ode::constant_value<mpfr>::of(of.choose().point()), figure_digits);
}

// An error about what is not found or not proved names the option.
answer singularities_of(const singularities_options& options, const solution& of, long digits) {
    const scalar_spec scalar{options.prove ? scalar_kind::proved : scalar_kind::arbitrary, digits};
    progress shown("singularities", progress_of_part::steps);
    progress_of_part to(shown);
    try {
        return of.singularities(options.radius(), {.scalar = scalar,
                                                   .check = options.check,
                                                   .progress = [&](double part) { to(part); },
                                                   .stage =
                                                       [&](const std::string& done) {
                                                           shown.stage(done);
                                                           check_time();
                                                       }});
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || !problem.is_about_solution()) {
            throw;
        }
        throw error(problem.kind(), "--problem", *options.problem.problem(),
                    problem.reason() + ": --within RHO searches a larger disc");
    }
}

// The verdict on the coefficients, compared with a proved radius.
std::string judgement_for(const solution& of, long digits) {
    try {
        const auto bounds = of.radius(series_request{}, {.scalar = {scalar_kind::proved, digits}});
        const std::string upper = bounds.at(0, "upper");
        return judge_verdict(of, digits, bounds.at(0, "lower"), upper.empty() ? std::nullopt : std::optional(upper))
                   .text() +
               "\n";
    } catch (const error& problem) {
        return std::string("heuristic verdict not compared: ") + problem.what() + "\n";
    }
}

int run_singularities(const singularities_options& options) {
    options.output.check();
    const auto figure = options.plot.file(options.output);
    const auto of = options.problem.general_solution();
    const long digits = digits_of(options.digits, defaults::digits_of_singularities);
    if (digits > most_digits) {
        throw input_error("--digits", *options.digits, "is more than 1000", "write a smaller number");
    }
    const answer found = singularities_of(options, *of, digits);
    const table data = table_of(found, labels_of_map());
    if (figure) {
        figure->draw(singularity_plot(data, initial_point_of(options.problem), options.problem.heading()));
    }
    const bool is_judged = options.prove && options.output.format() == "text";
    table_output(options.output, figure)
        .write(data, text_of(data, found) + (is_judged ? judgement_for(*of, digits) : ""));
    if (found.missing) {
        const std::string subject =
            found.missing->is_about(error_subject::proof) ? "--prove" : found.missing->subject();
        throw error(found.missing->kind(), subject, found.missing->value(), found.missing->reason());
    }
    return 0;
}

}  // namespace

subcommand singularities_command(CLI::App& program) {
    const auto options = std::make_shared<singularities_options>();
    CLI::App* command = program.add_subcommand(
        "singularities", "the singularities of any problem in the complex t-plane, proved on request");
    options->problem.add_to(*command);
    options->output.add_to(*command);
    options->plot.add_to(*command, "the map of the complex plane");
    command
        ->add_option("--within", options->within,
                     "the distance from the initial point (default: twice that of the nearest)")
        ->type_name("RHO");
    command->add_flag("--prove", options->prove, "encloses each in a disc, to D digits (theorem C)");
    command
        ->add_option("--digits", options->digits,
                     fmt::format("digits of the positions ({})", defaults::digits_of_singularities))
        ->type_name("D");
    command->add_flag("--check", options->check,
                      "with --prove: compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_singularities(*options); }};
}

}  // namespace libration
