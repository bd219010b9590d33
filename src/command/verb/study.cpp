// libration study NAME: runs one study with any parameters; to stdout, or to files with figures under --out.
#include "sweep/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

#include "libration/number/grid.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/problem_options.hpp"
#include "run/progress.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_run.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct study_options {
    std::string name;
    std::map<std::string, std::optional<std::string>> words;  // by option
    std::optional<std::string> columns, out, jobs, shard, problem;
    std::vector<std::string> sets;
    bool fresh = false;

    study_words said() const {
        study_words result;
        for (const auto& [option, value] : words) {
            if (value) {
                result[option] = *value;
            }
        }
        return result;
    }

    std::optional<equation_words> equation() const {
        return problem ? std::optional(equation_words{*problem, sets}) : std::nullopt;
    }
};

bool same_columns(const table& a, const table& b) {
    return std::equal(a.columns().begin(), a.columns().end(), b.columns().begin(), b.columns().end(),
                      [](const column& x, const column& y) { return x.name == y.name; });
}

// The tables written to stdout under one header: the first one and those with its columns. The others are listed.
table under_one_header(const std::vector<study_table>& parts, std::string& left_out) {
    table all(parts.front().data.columns());
    for (const study_table& part : parts) {
        if (same_columns(part.data, all)) {
            all.append(part.data);
        } else {
            left_out += (left_out.empty() ? "" : ", ") + part.suffix;
        }
    }
    return all;
}

failures_found print_tables(const study_order& order) {
    std::string left_out;
    auto answers = answers_of(order);
    if (answers.tables.empty()) {
        return {};  // a rank of MPI that computed for another
    }
    const table all = under_one_header(answers.tables, left_out);
    write_to_stdout(to_csv(order.columns ? with_named_columns(all, *order.columns) : all));
    if (order.what->remarks) {
        for (const std::string& each : order.what->remarks(answers.tables)) {
            say_line(each);
        }
    }
    if (!left_out.empty()) {
        fmt::print(stderr, "libration: {} makes more tables ({}): see them with --out DIR\n", order.what->name,
                   left_out);
    }
    return std::move(answers.failures);
}

// 2/3 is the second of three.
study_shard shard_of(const std::string& words) {
    const auto refuse = [&](const std::string& reason) {
        throw input_error("--shard", words, reason, "write I/N for the I-th of N shards, such as 2/3");
    };
    constexpr int most_shards = 1'000'000;
    const auto slash = words.find('/');
    if (slash == std::string::npos) {
        refuse("is not I/N");
    }
    const auto count_in = [&](const std::string& part) {
        return reading("--shard", words, "write I/N for the I-th of N shards, such as 2/3",
                       [&] { return read_count(part, most_shards); });
    };
    const int index = count_in(words.substr(0, slash));
    const int count = count_in(words.substr(slash + 1));
    if (index < 1 || index > count) {
        refuse("is not one of the shards 1 to " + std::to_string(count));
    }
    return {static_cast<std::size_t>(index - 1), static_cast<std::size_t>(count)};
}

study_run run_of(const study_options& options) {
    study_run how;
    if (options.fresh) {
        how.earlier = earlier_cells::replaced;
    }
    if (options.shard) {
        how.shard = shard_of(*options.shard);
    }
    return how;
}

int run_order(study_order order, const study_options& options) {
    if (!order.left_out.empty()) {
        fmt::print(stderr, "libration: left out {}\n", order.left_out);
    }
    order.columns = options.columns;
    const study_run how = run_of(options);
    const failures_found failures = options.out ? make_study(order, *options.out, how) : print_tables(order);
    if (options.out && !how.shard) {
        say_line(fmt::format("wrote {}/{}", *options.out, order.what->name));
    }
    if (failures.count > 0) {
        say_line(message_of(failures));
    }
    return failures.count > 0 ? 1 : 0;
}

// Rethrows an error of the library about a value as one about the study.
[[noreturn]] void refuse(const error& problem, const study_options& options) {
    if (problem.kind() == error_kind::undecided) {
        throw;
    }
    if (problem.kind() == error_kind::range) {
        throw input_error(
            "--scalar", options.words.at("--scalar").value_or("double"),
            fmt::format("cannot hold {} ({})", options.problem ? "a number of the study" : "an energy of the list",
                        problem.what()),
            "use --scalar mpfr:DIGITS");
    }
    const std::string reason = problem.value().empty() ? problem.reason() : std::string("finds: ") + problem.what();
    if (options.problem && problem.is_about(error_subject::problem)) {
        throw input_error("--problem", *options.problem, reason, "choose another problem or initial value");
    }
    const bool names_option = problem.is_about(error_subject::option);
    throw input_error("study", options.name, reason,
                      "leave that value out" + (names_option ? " of " + problem.subject() : ""));
}

int run_study(const study_options& options) {
    const int jobs = jobs_of(options.jobs);
    try {
        study_order order = order_asked("study", options.name, options.equation(), options.said(), jobs);
        if (options.problem) {
            warn_of_unused_parameters(problem_named(*options.problem).text);
        }
        return run_order(std::move(order), options);
    } catch (const error& problem) {
        refuse(problem, options);
    }
}

// The options that are not parameters of any study.
bool is_general(const std::string& option) {
    static const std::vector<std::string> all{"--columns", "--out", "--fresh", "--shard", "--jobs", "--timeout"};
    return std::ranges::find(all, option) != all.end();
}

// A parameter as --help describes it: its meaning with the default value, and what may be written for it.
struct parameter_text {
    std::string meaning, usual, forms;

    std::string with(const std::string& ending) const { return meaning + ending + usual; }
};

std::optional<parameter_text> text_in(const study& what, const std::string& option) {
    const auto found = std::ranges::find(what.parameters, option, &study_parameter::option);
    if (found == what.parameters.end()) {
        return std::nullopt;
    }
    const std::string usual = found->usual_text();
    return parameter_text{found->meaning,
                          found->required ? fmt::format(" ({})", usual) : fmt::format(" (default: {})", usual),
                          forms_of(what, option)};
}

// The description of an option of a study, whose form for any equation is `about`, if there is one; std::nullopt if
// neither has it. What both forms share is printed once.
std::optional<std::string> description_in(const study& what, const study* about, const std::string& option) {
    const auto own = text_in(what, option);
    const auto any = about != nullptr ? text_in(*about, option) : std::nullopt;
    if (!own && !any) {
        return std::nullopt;
    }
    const std::string condition = what.needs_equation() ? "" : ", with --problem";
    if (!own || !any) {
        return own ? own->with("") + ": " + own->forms : any->with(condition) + ": " + any->forms;
    }
    const bool same_forms = own->forms == any->forms;
    if (own->with("") == any->with("") && same_forms) {
        return own->with("") + ": " + own->forms;
    }
    return own->with("") + (same_forms ? "" : ": " + own->forms) + "; " + any->with(condition) + ": " + any->forms;
}

constexpr const char* forms_of_problem = "a name of the catalogue, a file, or \"y' = y; y(0) = 1\"";

// Only the options of the study, with its defaults.
void narrow_options(CLI::App& command, const study& what, const study* about) {
    for (CLI::Option* const each : command.get_options([](const CLI::Option* one) { return one->nonpositional(); })) {
        const std::string option = "--" + (each->get_lnames().empty() ? "" : each->get_lnames().front());
        const bool of_equations = option == "--problem" || option == "--set" || option == "--unknowns";
        if (of_equations && what.any_equation) {
            if (option == "--problem" && what.needs_equation()) {
                each->description(fmt::format("the equation (required): {}", forms_of_problem));
            }
        } else if (const auto meaning = description_in(what, about, option)) {
            each->description(*meaning);
        } else if (!is_general(option) && option != "--help") {
            each->group("");
        }
    }
}

// Only the options of the study that is named on the command line, with its defaults and its examples.
void narrow_help(CLI::App& command, const study& what) {
    std::optional<study_order> example;
    if (what.any_equation) {
        example = order_asked("study", what.name, what.any_equation->example, what.any_equation->quick, 1);
    }
    narrow_options(command, what, example ? example->what : nullptr);
    command.description(fmt::format("{}: {}", what.name, what.question));
    std::string quick;
    for (const study_parameter& parameter : what.quick) {
        quick += fmt::format(" {} {}", parameter.option, parameter.usual);
    }
    std::string examples;
    if (!what.needs_equation()) {
        examples += fmt::format("\n    libration study {}{}", what.name, quick);
    }
    if (example) {
        examples += "\n    " + example->command;
    }
    if (what.needs_equation() || !what.any_equation) {
        examples += fmt::format("\n    libration studies {}", what.name);
    }
    command.footer("Examples:" + examples);
}

}  // namespace

subcommand study_command(CLI::App& program) {
    const auto options = std::make_shared<study_options>();
    CLI::App* command = program.add_subcommand("study", "run one study; 'libration studies' lists them");
    command->add_option("NAME", options->name, "name of the study")
        ->required()
        ->each([command](const std::string& name) { narrow_help(*command, study_named("study", name)); });
    for (const study_option& each : options_of(all_studies())) {
        auto& words = options->words[each.option];
        if (each.type_name.empty()) {
            command->add_flag_callback(
                each.option, [&words] { words = "yes"; }, each.help);
        } else {
            command->add_option(each.option, words, each.help)->type_name(each.type_name);
        }
    }
    command
        ->add_option("--problem", options->problem,
                     fmt::format("any equation instead of the pendulum: {}", forms_of_problem))
        ->type_name("P");
    command
        ->add_option("--set", options->sets,
                     "values of a parameter or an initial value of --problem, as an axis of the study")
        ->type_name("X=LIST");
    command->add_option("--unknowns", options->words["--unknowns"], "unknowns of --problem (default: all)")
        ->type_name("NAMES");
    command
        ->add_option("--columns", options->columns,
                     "only these columns in the tables for LaTeX and in the CSV on stdout: NAME,NAME,...")
        ->type_name("NAMES");
    command->add_option("--out", options->out, "write DIR/NAME/: tables, figures, provenance (default: CSV to stdout)")
        ->type_name("DIR");
    command->add_flag("--fresh", options->fresh, "recompute all cells instead of using those in DIR/NAME/NAME.journal");
    command
        ->add_option("--shard", options->shard,
                     "only the I-th of N shares of the cells, into the journal of DIR: 'libration journal merge' "
                     "makes the tables of all")
        ->type_name("I/N");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options] { return run_study(*options); }};
}

}  // namespace libration
