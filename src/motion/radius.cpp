// libration radius: the radius of convergence of a series from its coefficients alone, by every test.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "equation/problem_options.hpp"
#include "equation/problem_radius.hpp"
#include "equation/problem_series.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "list/coefficient_file.hpp"
#include "motion/motion_options.hpp"
#include "motion/motion_series.hpp"
#include "motion/radius_rows.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

using namespace series;
using namespace convergence;
using namespace pendulum;

namespace {

struct radius_options {
    motion_options motion;
    problem_options problem;
    arithmetic_options arithmetic;
    output_options output;
    std::optional<std::string> order;
    std::optional<std::string> at;
    std::optional<std::string> via;
    std::optional<std::string> file;
    bool prove = false, check = false;
};

// An unknown of a file or of a problem.
struct lists_of_unknown {
    std::string name;
    listed_function lists;
};

listed_series judged_part(const radius_options& options, const arithmetic& numbers, std::vector<exact> written) {
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
    const precision_scope scope(numbers.scalar.digits + radius_guard_digits);
    std::vector<mpfr> values;
    values.reserve(written.size());
    for (const exact& number : written) {
        values.push_back(from_exact<mpfr>(number));
    }
    return {power_series<mpfr>(std::move(values)), std::move(written)};
}

std::vector<lists_of_unknown> lists_of_file(const radius_options& options, const arithmetic& numbers) {
    if (const auto motion = options.motion.first_given()) {
        throw input_error(fmt::format("--coefficients {} is given together with {}: give a list or a motion, not both",
                                      quotation(*options.file), *motion));
    }
    if (options.at) {
        throw input_error("--at", *options.at, "is a point of a motion, which --coefficients do not have",
                          "leave --at out");
    }
    std::vector<lists_of_unknown> lists;
    for (named_list& list : lists_in_file(*options.file)) {
        lists_of_unknown unknown{list.name, {{judged_part(options, numbers, std::move(list.real))}, 1}};
        if (list.is_complex()) {
            unknown.lists.parts.push_back(judged_part(options, numbers, std::move(list.imaginary)));
        }
        lists.push_back(std::move(unknown));
    }
    return lists;
}

constexpr const char* usual_order_of_problems = "300";

// The coefficients of every unknown, with all digits correct.
std::vector<lists_of_unknown> judged_lists_of_problem(const radius_options& options, const arithmetic& numbers) {
    if (const auto other = options.motion.first_given()) {
        throw input_error(*other + " applies to motions of the pendulum, not to a --problem: leave one of them out");
    }
    const long order = order_of("--order", options.order.value_or(usual_order_of_problems));
    const problem_series_request request{options.problem.choose(), 0, order, options.at, options.via};
    const long digits = numbers.scalar.digits + radius_guard_digits;
    problem_lists found = naming_option("--problem", [&] { return lists_of_problem(request, digits); });
    std::vector<lists_of_unknown> lists;
    for (problem_list& each : found.unknowns) {
        lists_of_unknown unknown{each.name, {{}, found.root}};
        for (auto& part : each.parts) {
            unknown.lists.parts.push_back({std::move(part)});
        }
        lists.push_back(std::move(unknown));
    }
    return lists;
}

// The radius of a motion is also known independently.
struct list_of_known_radius {
    listed_series list;
    known_radius known;
};

list_of_known_radius list_of_motion(const radius_options& options, const arithmetic& numbers) {
    if (!options.motion.first_given()) {
        throw input_error(
            "no coefficients are given: add a motion (--energy E, --gap G, or --theta0 A with --omega0 W) and --order "
            "N, or --coefficients FILE");
    }
    series_request request{options.motion.choose_for(numbers.scalar), numbers.scalar, {}, 0};
    if (!options.order) {
        throw input_error("no --order is given: add --order N, the last power of the series");
    }
    request.order = order_of("--order", *options.order);
    request.at = point_of(options.at, request.chosen);
    auto radius = exact_radius(request, numbers.digits + radius_guard_digits);
    std::string text = radius ? to_decimal(*radius, numbers.digits) : "inf";
    return {{power_series<mpfr>(coefficient_values(request))}, {std::move(text), std::move(radius)}};
}

// Lower and upper bound for a problem, by discs and loops instead of coefficients.
int prove_radius(const radius_options& options) {
    if (!options.problem.given()) {
        throw input_error("--prove is for differential equations: add --problem P");
    }
    for (const auto& [name, value] :
         {std::pair("--order", options.order), std::pair("--at", options.at), std::pair("--coefficients", options.file),
          std::pair("--scalar", options.arithmetic.scalar())}) {
        if (value) {
            throw input_error(name, *value, "has no meaning for a proof about the initial point", "leave it out");
        }
    }
    if (const auto other = options.motion.first_given()) {
        throw input_error(*other + " applies to motions of the pendulum, not to a --problem: leave one of them out");
    }
    const long digits = options.arithmetic.choose().digits;
    const auto answer =
        naming_option("--problem", [&] { return proved_radius_of(options.problem.choose(), digits, options.check); });
    options.output.write(answer.data, answer.text);
    return 0;
}

int run_radius(const radius_options& options) {
    options.output.check();
    if (options.prove) {
        return prove_radius(options);
    }
    if (options.check) {
        throw input_error("--check compares two proofs and requires --prove: add it, or leave --check out");
    }
    const arithmetic numbers = options.arithmetic.choose();
    std::vector<lists_of_unknown> unknowns;
    known_radius known;
    if (options.problem.given()) {
        if (options.file) {
            throw input_error("--coefficients", *options.file, "is given together with --problem", "give one of them");
        }
        unknowns = judged_lists_of_problem(options, numbers);
    } else if (options.file) {
        unknowns = lists_of_file(options, numbers);
    } else {
        options.problem.require_problem();
        if (options.via) {
            throw input_error("--via", *options.via, "is a path in the complex t-plane of a --problem", "leave it out");
        }
        auto of_motion = list_of_motion(options, numbers);
        unknowns.push_back({"", {{std::move(of_motion.list)}, 1}});
        known = std::move(of_motion.known);
    }
    std::vector<radius_answers> all;
    all.reserve(unknowns.size());
    for (const auto& unknown : unknowns) {
        all.push_back(answers_of(unknown.lists, numbers.scalar));
    }
    if (all.size() == 1) {
        const table data = radius_table(all.front(), known, numbers.digits);
        options.output.write(data, radius_text(all.front(), known, data));
        return 0;
    }
    std::vector<std::string> names;
    names.reserve(unknowns.size());
    for (const auto& unknown : unknowns) {
        names.push_back(unknown.name);
    }
    const std::size_t nearest = nearest_of(all);
    const table data = radius_table_of_unknowns(all, names, nearest, known, numbers.digits);
    options.output.write(data, radius_text_of_unknowns(all, names, nearest, known, data));
    return 0;
}

}  // namespace

subcommand radius_command(CLI::App& program) {
    const auto options = std::make_shared<radius_options>();
    CLI::App* command = program.add_subcommand(
        "radius",
        "the radius of convergence from coefficients alone: of a motion's series, of any problem, or of a list in a "
        "file");
    options->motion.add_to(*command);
    options->problem.add_to(*command);
    options->arithmetic.add_to(*command);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N (default for a file: all of its coefficients)")
        ->type_name("N");
    command->add_flag("--prove", options->prove,
                      "of a problem: proved lower and upper bounds that agree to --digits D (theorems L and C)");
    command->add_flag("--check", options->check,
                      "with --prove: compare with a second proof by another route, exit 1 if they disagree");
    command->add_option("--at", options->at, "top, bottom, start or a time (T/8, 1.1)")->type_name("POINT");
    command->add_option("--via", options->via, "corners of the path to --at of a problem in the complex plane: 1+i,2+i")
        ->type_name("LIST");
    command
        ->add_option(
            "--coefficients", options->file,
            "lists instead of a motion: one number per line, n,coefficient, n,u,v, complex 1+2i or NAME_re,NAME_im, or "
            "JSON; - for stdin")
        ->type_name("FILE");
    return {command, [options] { return run_radius(*options); }};
}

}  // namespace libration
