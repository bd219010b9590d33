// libration radius: the radius of convergence of a series from its coefficients alone, by every test, or with proved
// bounds.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "libration/number/grid.hpp"
#include "libration/problem/radius_answer.hpp"
#include "option/options.hpp"
#include "option/rounding_option.hpp"
#include "option/subcommand.hpp"
#include "plot/coefficient_plot.hpp"
#include "plot/plot_options.hpp"
#include "problem/answer_table.hpp"
#include "problem/coefficient_file.hpp"
#include "problem/list_audit.hpp"
#include "problem/point_options.hpp"
#include "problem/solution_options.hpp"
#include "problem/verdict_judgement.hpp"
#include "run/ending_signal.hpp"
#include "run/parallel.hpp"
#include "run/progress.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_order.hpp"
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
    std::optional<std::string> predict, biased;
    rounding_option rounding;
    bool prove = false, check = false, audit = false;
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
    convergence::listed_series list{series::power_series<mpfr>(std::move(values)), std::move(written)};
    list.rounded = options.rounding.digits();
    return list;
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

task_runner on_all_cores() {
    return [](std::size_t count, const std::function<void(std::size_t)>& work) {
        on_threads(count, jobs_of(std::nullopt), work);
    };
}

request heuristic_request(const radius_options& options, const arithmetic& numbers) {
    request how{.scalar = numbers.scalar, .digits = numbers.digits};
    how.run = on_all_cores();
    if (options.biased) {
        how.known_place = reading("--biased", *options.biased, "write a number such as 0.379 or sqrt(2)-1",
                                  [&] { return read_exact(*options.biased); });
    }
    return how;
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
        tested_series tested{chosen.of->radius(request, heuristic_request(options, numbers))};
        if (with_coefficients) {
            tested.drawn = chosen.of->coefficient_lists(request, numbers.scalar);
        }
        return tested;
    });
}

tested_series radius_of_file(const radius_options& options, const arithmetic& numbers) {
    auto lists = lists_of_file(options, numbers);
    auto found = radius_answer(lists, std::nullopt, heuristic_request(options, numbers));
    return {std::move(found), std::move(lists)};
}

// The columns that the text shows, below the verdict in words.
std::string text_of(const answer& found, const table& data) {
    constexpr std::size_t unknown = 13;
    const bool several = found.names[unknown] == "unknown";
    const table shown = data.with_columns(several ? std::vector<std::size_t>{unknown, 0, 1, 2, 9}
                                                  : std::vector<std::size_t>{0, 1, 2, 4, 9});
    const table tests(shown.columns(), {shown.rows().begin() + 1, shown.rows().end()});
    return lines_of_notes(found) + "\n" + to_text(tests) +
           "\nheuristic estimate: finitely many coefficients cannot prove a radius\n";
}

// The history and the ring of the verdict as further files: NAME_history.csv and NAME_ring.csv next to NAME.csv.
void write_lists(const table& data, const std::string& file) {
    namespace fs = std::filesystem;
    const fs::path path(file);
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        const cell& list = data.rows().front()[i];
        if (list.kind() == cell_kind::list) {
            const auto name = path.stem().string() + "_" + data.columns()[i].name + path.extension().string();
            write_into((path.parent_path() / name).string(), to_csv(table_of_list(list)));
        }
    }
}

void write_results(const output_options& output, const answer& found, const table& data) {
    const bool nested = output.format() == "json";
    output.write(nested ? data : data.without_lists(), text_of(found, data));
    if (output.file() && output.format() == "csv") {
        write_lists(data, *output.file());
    }
}

// Lower and upper bound, by discs and loops instead of coefficients, and what they say of the verdict on the coefficients.
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
    const std::string lower = found.at(0, "lower");
    const std::string upper = found.at(0, "upper");
    const auto judged =
        judge_verdict(*chosen.of, digits, lower, upper.empty() ? std::nullopt : std::optional(upper), on_all_cores());
    table data({{"lower", ""},
                {"upper", ""},
                {"digits", ""},
                {"rigour", ""},
                {"verdict", "heuristic radius, from the coefficients"},
                {"verdict_uncertainty", ""},
                {"judgement", "of the verdict by the bounds: holds | consistent | contradicted | none"}});
    data.add_row({number_cell(lower), number_cell(upper), digits, found.rigour, number_cell(judged.radius),
                  number_cell(judged.uncertainty), judged.judgement});
    std::string text;
    for (const answer_note& each : found.notes) {
        const std::string number = each.name == "nearest" ? "" : found.at(0, each.name == "upper" ? "upper" : "lower");
        text += fmt::format("{}  {}{}{}: {}\n", each.name, number, number.empty() ? "" : "  ", found.rigour, each.text);
    }
    options.output.write(data, text + judged.text() + "\n");
    if (found.missing) {
        throw error(*found.missing);
    }
    return 0;
}

convergence::series_list list_to_audit(const radius_options& options) {
    const auto order =
        options.order ? std::optional(static_cast<std::size_t>(order_of("--order", *options.order))) : std::nullopt;
    return real_list_in(*options.file, options.rounding.digits(), order);
}

// The coefficient that the others contradict.
int audit_list(const radius_options& options, const arithmetic& numbers) {
    const auto verdict = convergence::verdict_on(list_to_audit(options), on_all_cores());
    table data = table_of_suspect(verdict, numbers.digits);
    options.output.write(data, text_of_suspect(verdict, data));
    return verdict.suspect ? 1 : 0;
}

int predict_coefficients(const radius_options& options, const arithmetic& numbers) {
    constexpr int most = 1000;
    const int count = reading("--predict", *options.predict, "write how many further coefficients",
                              [&] { return read_count(*options.predict, most); });
    const auto list = list_to_audit(options);
    const auto found = convergence::predictions_for(list, count, on_all_cores());
    options.output.write(table_of_predictions(found, numbers.digits));
    if (static_cast<int>(found.size()) < count) {
        throw error(error_kind::undecided, "coefficient",
                    std::to_string(list.order() + 1 + static_cast<int>(found.size())),
                    "is not predicted: fewer than three differential approximants exist");
    }
    return 0;
}

int run_radius(const radius_options& options) {
    options.output.check();
    if (options.prove) {
        return prove_radius(options);
    }
    if (options.audit || options.predict) {
        const arithmetic numbers = options.arithmetic.choose();
        return options.audit ? audit_list(options, numbers) : predict_coefficients(options, numbers);
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
    write_results(table_output(options.output, figure), tested.found, data);
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
    command->add_option("--order", options->order, "last power N (default: for a file all of its coefficients)")
        ->type_name("N");
    options->rounding.add_to(*command, "rounded if all have the same number of digits, 17 or more; exact otherwise");
    command->add_option("--biased", options->biased, "also the exponent if the singularity is known to be at X")
        ->type_name("X");
    command->add_flag("--audit", options->audit,
                      "search --coefficients for one that the others contradict; exit 1 if there is one");
    command->add_option("--predict", options->predict, "print K further coefficients, each with an uncertainty")
        ->type_name("K");
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
