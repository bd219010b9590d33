// libration radius: the radius of convergence of a series from its coefficients alone, by every test.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

#include "libration/convergence/list/coefficient_list.hpp"
#include "libration/convergence/list/coefficient_noise.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/scalar/text/decimal.hpp"
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
    arithmetic_options arithmetic;
    output_options output;
    std::optional<std::string> order;
    std::optional<std::string> at;
    std::optional<std::string> file;
};

std::string content_of(const std::string& path) {
    const char* const remedy = "name a readable file, or - for stdin";
    if (path == "-") {
        return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    }
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw input_error("--coefficients", path, "is a folder", remedy);
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw input_error("--coefficients", path, fmt::format("cannot be read ({})", std::strerror(errno)), remedy);
    }
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<exact> coefficients_in_file(const std::string& path) {
    std::vector<exact> list;
    try {
        list = read_coefficients(content_of(path));
    } catch (const malformed_line& problem) {
        throw input_error("--coefficients", path,
                          fmt::format("line {}: {} {}", problem.number(), quotation(problem.text()), problem.reason()),
                          "write one number a line such as 0.25, 1/3 or 1e-30, or n,coefficient with growing n");
    }
    if (list.empty()) {
        throw input_error("--coefficients", path, "holds no coefficient", "write one number a line, or n,coefficient");
    }
    return list;
}

judged_list list_of_file(const radius_options& options, const arithmetic& numbers) {
    if (const auto motion = options.motion.first_given()) {
        throw input_error(fmt::format("--coefficients {} comes together with {}: give a list or a motion, not both",
                                      quotation(*options.file), *motion));
    }
    if (options.at) {
        throw input_error("--at", *options.at, "is a point of a motion, and --coefficients have none",
                          "leave --at out");
    }
    std::vector<exact> written = coefficients_in_file(*options.file);
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
    return {power_series<mpfr>(std::move(values)), std::move(written), "", std::nullopt};
}

judged_list list_of_motion(const radius_options& options, const arithmetic& numbers) {
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
    return {power_series<mpfr>(coefficient_values(request)), {}, std::move(text), std::move(radius)};
}

template <class T>
radius_answers answers_in(const judged_list& list) {
    const coefficient_unit unit = unit_of(list.coefficients);
    const T noise = list.written.empty() ? epsilon<T>() : noise_of<T>(list.written);
    const radius_report<T> report = report_on_radius(in_unit_of<T>(list.coefficients, unit), noise);
    radius_answers answers{report.pattern, {}};
    answers.rows.reserve(report.tests.size() + 1);
    // The radius may be beyond the range of T where the coefficients are.
    const precision_scope scope(decimal_digits(digits<T>()) + radius_guard_digits);
    answers.rows.push_back(in_unit(widened(report.verdict), unit.length));
    for (const auto& test : report.tests) {
        answers.rows.push_back(in_unit(widened(test), unit.length));
    }
    if (report.verdict.radius) {
        answers.rows.front().note = report.pattern.text() + "; " + report.verdict.note;
    }
    return answers;
}

int run_radius(const radius_options& options) {
    options.output.check();
    const arithmetic numbers = options.arithmetic.choose();
    const judged_list list = options.file ? list_of_file(options, numbers) : list_of_motion(options, numbers);
    const radius_answers answers = with_scalar(numbers.scalar, 0, [&]<class T>() { return answers_in<T>(list); });
    const table data = radius_table(answers, list, numbers.digits);
    options.output.write(data, radius_text(answers, list, data));
    return 0;
}

}  // namespace

subcommand radius_command(CLI::App& program) {
    const auto options = std::make_shared<radius_options>();
    CLI::App* command = program.add_subcommand(
        "radius", "the radius of convergence from coefficients alone: of a motion's series, or of a list in a file");
    options->motion.add_to(*command);
    options->arithmetic.add_to(*command);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N; of a file all that it has unless given")
        ->type_name("N");
    command->add_option("--at", options->at, "top, bottom, start or a time (T/8, 1.1)")->type_name("POINT");
    command
        ->add_option("--coefficients", options->file,
                     "a list instead of a motion: one number a line, or n,coefficient; - for stdin")
        ->type_name("FILE");
    return {command, [options] { return run_radius(*options); }};
}

}  // namespace libration
