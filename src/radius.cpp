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

#include "libration/convergence/coefficient_list.hpp"
#include "libration/convergence/coefficient_noise.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/scalar/decimal.hpp"
#include "motion_series.hpp"
#include "options.hpp"
#include "subcommand.hpp"
#include "sweep/input_error.hpp"

namespace libration {

namespace {

struct radius_options {
    motion_options motion;
    arithmetic_options arithmetic;
    output_options output;
    std::optional<std::string> order;
    std::optional<std::string> at;
    std::optional<std::string> file;
};

// The coefficients to judge, and what is known of their radius otherwise.
struct judged_list {
    power_series<mpfr> coefficients;
    std::vector<exact> written;     // as in the file; empty for a motion
    std::string exact_text;         // the true radius as printed, empty where it is not known
    std::optional<mpfr> true_size;  // the same with more digits, nothing also where it is infinite
};

// What all tests said, the verdict first, in the unit of the list.
struct radius_answers {
    coefficient_pattern pattern;
    std::vector<radius_estimate<mpfr>> rows;
};

const std::vector<column> radius_columns{{"method", ""},      {"radius", ""},         {"uncertainty", ""},
                                         {"exact", ""},       {"relative_error", ""}, {"position_re", ""},
                                         {"position_im", ""}, {"kind", ""},           {"count", ""},
                                         {"note", ""},        {"exponent", ""},       {"exponent_uncertainty", ""},
                                         {"rigour", ""}};

constexpr long guard_digits = 20;
constexpr long uncertainty_digits = 3;

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

// What a complaint may quote of a line.
std::string quotable(std::string text) {
    constexpr std::size_t longest = 60;
    if (text.size() > longest) {
        text = text.substr(0, longest) + "...";
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
    return text;
}

std::vector<exact> coefficients_in_file(const std::string& path) {
    std::vector<exact> list;
    try {
        list = read_coefficients(content_of(path));
    } catch (const malformed_line& problem) {
        throw input_error("--coefficients", path,
                          fmt::format("line {}: '{}' {}", problem.number(), quotable(problem.text()), problem.what()),
                          "write one number a line such as 0.25, 1/3 or 1e-30, or n,coefficient with growing n");
    }
    if (list.empty()) {
        throw input_error("--coefficients", path, "holds no coefficient", "write one number a line, or n,coefficient");
    }
    return list;
}

judged_list list_of_file(const radius_options& options, const arithmetic& numbers) {
    if (const auto motion = options.motion.first_given()) {
        throw input_error(fmt::format("--coefficients '{}' comes together with {}: give a list or a motion, not both",
                                      *options.file, *motion));
    }
    if (options.at) {
        throw input_error("--at", *options.at, "is a point of a motion, and --coefficients have none",
                          "leave --at out");
    }
    std::vector<exact> written = coefficients_in_file(*options.file);
    if (options.order) {
        const auto order = static_cast<std::size_t>(order_of("--order", *options.order));
        if (order >= written.size()) {
            throw input_error(
                "--order", *options.order,
                fmt::format("is more than '{}' has, whose last power is {}", *options.file, written.size() - 1),
                "write a smaller order or leave it out");
        }
        written.resize(order + 1);
    }
    const precision_scope scope(numbers.scalar.digits + guard_digits);
    std::vector<mpfr> values;
    values.reserve(written.size());
    for (const exact& number : written) {
        values.push_back(from_rational<mpfr>(number.coefficient));
    }
    return {power_series<mpfr>(std::move(values)), std::move(written), "", std::nullopt};
}

judged_list list_of_motion(const radius_options& options, const arithmetic& numbers) {
    if (!options.motion.first_given()) {
        throw input_error(
            "no coefficients are given: add a motion (--energy E, --gap G, or --theta0 A with --omega0 W) and --order "
            "N, "
            "or --coefficients FILE");
    }
    series_request request{options.motion.choose_for(numbers.scalar), numbers.scalar, {}, 0};
    if (!options.order) {
        throw input_error("no --order is given: add --order N, the last power of the series");
    }
    request.order = order_of("--order", *options.order);
    request.at = point_of(options.at, request.chosen);
    auto radius = exact_radius(request, numbers.digits + guard_digits);
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
    const precision_scope scope(decimal_digits(digits<T>()) + guard_digits);
    answers.rows.push_back(in_unit(widened(report.verdict), unit.length));
    for (const auto& test : report.tests) {
        answers.rows.push_back(in_unit(widened(test), unit.length));
    }
    if (report.verdict.radius) {
        answers.rows.front().note = report.pattern.text() + "; " + report.verdict.note;
    }
    return answers;
}

// floor(log10 |x|).
long magnitude(const mpfr& x) { return mpfr_get_si(handle(mpfr(log10(mpfr(abs(x))))), MPFR_RNDD); }

// The digits of x down to the last place of its uncertainty as that is printed; 0 or less where x is below it.
long supported_digits(const mpfr& x, const mpfr& uncertainty) {
    return magnitude(x) - magnitude(uncertainty) + uncertainty_digits;
}

// x with the digits that its uncertainty supports, and no more than asked.
std::string supported(const mpfr& x, const mpfr& uncertainty, long digits) {
    if (uncertainty == 0) {
        const integer whole = nearest_integer(x);
        return x == whole ? whole.str() : to_decimal(x, digits);
    }
    const long count = x == 0 ? 0 : supported_digits(x, uncertainty);
    return count < 1 ? "0" : to_decimal(x, std::min(count, digits));
}

std::string relative_error(const std::string& radius, const judged_list& list, long digits) {
    if (radius.empty() || !list.true_size) {
        return "";
    }
    const precision_scope scope(digits + guard_digits);
    return to_decimal(mpfr(abs(from_exact<mpfr>(read_exact(radius)) / *list.true_size - 1)), uncertainty_digits);
}

// The uncertainty of the radius as printed: where the digits asked cut it off, with a unit of its last place.
mpfr printed_uncertainty(const radius_estimate<mpfr>& estimate, long digits) {
    if (supported_digits(*estimate.radius, estimate.uncertainty) <= digits) {
        return estimate.uncertainty;
    }
    const int last_place = static_cast<int>(magnitude(*estimate.radius) - digits + 1);
    return estimate.uncertainty + pow(mpfr(10), last_place);
}

// Without commas, so that a reader that knows no quotes is right too.
std::string note_of(const radius_estimate<mpfr>& estimate) {
    std::string note = estimate.note;
    std::replace(note.begin(), note.end(), ',', ';');
    return note;
}

std::vector<std::string> row_of(const radius_estimate<mpfr>& estimate, const judged_list& list, long digits) {
    const bool found = estimate.radius.has_value();
    const auto cell = [&](const mpfr& x) { return supported(x, estimate.uncertainty, digits); };
    std::string radius = found ? cell(*estimate.radius) : "";
    if (radius == "0") {  // a radius is more than 0, however uncertain
        radius = to_decimal(*estimate.radius, 1);
    }
    return {estimate.method,
            radius,
            found ? to_decimal(printed_uncertainty(estimate, digits), uncertainty_digits) : "",
            list.exact_text,
            relative_error(radius, list, digits),
            estimate.position ? cell(estimate.position->re) : "",
            estimate.position ? cell(estimate.position->im) : "",
            estimate.kind == singularity_kind::unknown ? "" : name_of(estimate.kind),
            estimate.count > 0 ? std::to_string(estimate.count) : "",
            note_of(estimate),
            estimate.exponent ? supported(*estimate.exponent, estimate.exponent_uncertainty, digits) : "",
            estimate.exponent ? to_decimal(estimate.exponent_uncertainty, uncertainty_digits) : "",
            "heuristic"};
}

// "2 simple poles", "1 pole of order 2", "4 logarithms", "3 algebraic branch points".
std::string what_in_words(const radius_estimate<mpfr>& estimate) {
    const bool one = estimate.count == 1;
    const char* const plural = one ? "" : "s";
    std::string what = one ? "singularity" : "singularities";
    if (estimate.kind == singularity_kind::pole) {
        const rational order = -simple_exponent(estimate).value_or(rational(-1));
        what =
            order == 1 ? fmt::format("simple pole{}", plural) : fmt::format("pole{} of order {}", plural, order.str());
    } else if (estimate.kind == singularity_kind::logarithm) {
        what = fmt::format("logarithm{}", plural);
    } else if (estimate.kind == singularity_kind::algebraic) {
        what = fmt::format("algebraic branch point{}", plural);
    }
    return estimate.count > 0 ? fmt::format("{} {}", estimate.count, what) : what;
}

// "2 simple poles at 1.57 and its image": number, kind and position of the nearest singularities.
std::string nearest_in_words(const radius_estimate<mpfr>& estimate, const std::vector<std::string>& row) {
    if (estimate.kind == singularity_kind::boundary) {
        return "the whole circle of convergence is a boundary";
    }
    std::string words = what_in_words(estimate);
    if (estimate.position) {
        const std::string& re = row[5];
        const std::string& im = row[6];
        words += " at " + (im == "0" ? re : re == "0" ? im + " i" : fmt::format("{} + {} i", re, im));
        words += estimate.count > 2 ? " and its images" : estimate.count == 2 ? " and its image" : "";
    }
    return words;
}

std::string verdict_in_words(const radius_answers& answers, const judged_list& list, const table& data) {
    const radius_estimate<mpfr>& verdict = answers.rows.front();
    const auto& row = data.rows.front();
    std::string text;
    const auto say = [&](const char* name, const std::string& what) { text += fmt::format("{:<14}{}\n", name, what); };
    say("coefficients", fmt::format("n = 0 .. {}; {}", answers.pattern.order, answers.pattern.text()));
    if (verdict.radius) {
        say("radius", fmt::format("{} +- {}", row[1], row[2]));
        say("nearest", nearest_in_words(verdict, row));
        if (verdict.exponent) {
            say("exponent", fmt::format("{} +- {}", row[10], row[11]));
        }
    } else {
        say("radius", "none");
    }
    if (!list.exact_text.empty()) {
        say("exact", row[4].empty() ? list.exact_text : fmt::format("{}, relative error {}", list.exact_text, row[4]));
    }
    say("why", row[9]);
    return text;
}

std::string text_of(const radius_answers& answers, const judged_list& list, const table& data) {
    table tests{{{"method", ""}, {"radius", ""}, {"uncertainty", ""}, {"relative_error", ""}, {"note", ""}}, {}};
    tests.rows.reserve(data.rows.size());
    for (auto row = data.rows.begin() + 1; row != data.rows.end(); ++row) {
        tests.rows.push_back({row->at(0), row->at(1), row->at(2), row->at(4), row->at(9)});
    }
    return verdict_in_words(answers, list, data) + "\n" + to_text(tests) +
           "\nheuristic: coefficients prove no radius\n";
}

int run_radius(const radius_options& options) {
    options.output.check();
    const arithmetic numbers = options.arithmetic.choose();
    const judged_list list = options.file ? list_of_file(options, numbers) : list_of_motion(options, numbers);
    const radius_answers answers = with_scalar(numbers.scalar, 0, [&]<class T>() { return answers_in<T>(list); });
    table data{radius_columns, {}};
    data.rows.reserve(answers.rows.size());
    for (const auto& answer : answers.rows) {
        data.rows.push_back(row_of(answer, list, numbers.digits));
    }
    options.output.write(data, text_of(answers, list, data));
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
