#include "table/elliptic_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "libration/number/grid.hpp"
#include "option/options.hpp"
#include "table/complex_argument.hpp"
#include "table/elliptic_columns.hpp"
#include "text/input_error.hpp"
#include "text/point_file.hpp"

namespace libration {

using namespace elliptic;

namespace {

constexpr const char* modulus_remedy =
    "write a number such as 0.8, 4/5, 1e-30 or, for --m and --m1, -3, for --alpha 30deg";
constexpr const char* argument_remedy = "write a number such as 1.5, 3/2 or pi/4, or several with commas between them";
constexpr std::array<const char*, 4> argument_options{"--u", "--phi", "--x", "--z"};
constexpr std::array<const char*, 5> modulus_options{"--k", "--m", "--m1", "--alpha", "--q"};
constexpr const char* alpha_option = "--alpha";

bool may_be(const std::string& option, const exact& modulus) {
    return modulus.is_number() || (option == alpha_option && modulus.is_angle());
}

std::vector<exact> read_moduli(const std::string& option, const std::string& typed, elliptic_grid grid) {
    if (grid == elliptic_grid::one && option != alpha_option) {
        return {number_of(option, typed)};
    }
    auto moduli = reading(option, typed, modulus_remedy, [&] {
        return grid == elliptic_grid::one ? std::vector{read_exact(typed)} : read_grid(typed);
    });
    for (const exact& modulus : moduli) {
        if (!may_be(option, modulus)) {
            throw input_error(option, typed, "has '" + modulus.text + "', which has a unit", modulus_remedy);
        }
    }
    return moduli;
}

void refuse(const char* option, const option_words& said, std::string_view function, const std::string& remedy) {
    if (said[option]) {
        throw input_error(option, *said[option], fmt::format("has no meaning for {}", function), remedy);
    }
}

std::vector<typed_parameter> read_parameters(elliptic_request& request, const option_words& said, elliptic_grid grid) {
    std::vector<typed_parameter> parameters;
    std::string chosen;
    const named_function& function = *request.functions.front();
    for (const std::string option : modulus_options) {
        const auto& typed = said[option];
        if (!typed) {
            continue;
        }
        if ((option == "--q") != function.of_nome) {
            refuse(option.c_str(), said, function.name, function.of_nome ? "write --q" : "write --m");
        }
        if (!chosen.empty()) {
            throw input_error(option, *typed, "comes together with " + chosen + " '" + *said[chosen] + "'",
                              "give one of --k, --m, --m1 and --alpha");
        }
        chosen = option;
        request.modulus = option.substr(2);
        for (const exact& modulus : read_moduli(option, *typed, grid)) {
            parameters.push_back(
                reading(option, *typed, modulus_remedy, [&] { return parameter_of(request.modulus, modulus); }));
        }
    }
    if (chosen.empty()) {
        throw input_error(function.of_nome ? "no nome is given: add --q Q"
                                           : "no modulus is given: add --k K, --m M (m = k^2), --m1 M1 (m1 = 1 - m) or "
                                             "--alpha A (k = sin A)");
    }
    return parameters;
}

using arguments_list = std::vector<std::pair<std::optional<exact>, std::optional<exact>>>;

bool has_complex_item(const std::string& words) {
    std::istringstream items(words);
    for (std::string item; std::getline(items, item, ',');) {
        if (is_complex_text(item)) {
            return true;
        }
    }
    return false;
}

// A list with complex numbers in it: no ranges.
arguments_list complex_arguments(const std::string& option, const std::string& words) {
    arguments_list arguments;
    std::istringstream items(words);
    for (std::string item; std::getline(items, item, ',');) {
        auto [real, imaginary] = reading(option, words, argument_remedy, [&] { return read_complex(item); });
        for (const auto& part : {std::optional(real), imaginary}) {
            reading(option, words, argument_remedy, [&] { return !part || (require_argument("u", *part), true); });
        }
        real.text = item;
        arguments.emplace_back(std::move(real), std::move(imaginary));
    }
    return arguments;
}

// The arguments with their imaginary parts; a single std::nullopt if the functions have no argument.
arguments_list read_arguments(elliptic_request& request, const option_words& said) {
    const named_function& function = *request.functions.front();
    const std::string wanted = function.argument.empty() ? "" : "--" + std::string(function.argument);
    for (const char* const option : argument_options) {
        if (option != wanted) {
            refuse(option, said, function.name, wanted.empty() ? "leave it out" : "write " + wanted);
        }
    }
    if (wanted.empty() || (function.may_be_complete && !said[wanted])) {
        return {{std::nullopt, std::nullopt}};
    }
    request.argument = std::string(function.argument);
    const auto& value = said[wanted];
    if (!value) {
        throw input_error(fmt::format("{} has no argument: add {} {}", function.name, wanted,
                                      request.argument == "phi" ? "A"
                                      : request.argument == "u" ? "U"
                                                                : "X"));
    }
    if (request.argument == "u" && has_complex_item(*value)) {
        for (const named_function* const each : request.functions) {
            if (!takes_complex(*each)) {
                throw input_error(wanted, *value, fmt::format("is complex, which {} does not take", each->name),
                                  "write real numbers");
            }
        }
        return complex_arguments(wanted, *value);
    }
    arguments_list arguments;
    for (const exact& argument : reading(wanted, *value, argument_remedy, [&] { return read_grid(*value); })) {
        reading(wanted, *value, argument_remedy, [&] { return require_argument(request.argument, argument), 0; });
        arguments.emplace_back(argument, std::nullopt);
    }
    return arguments;
}

std::optional<exact> read_characteristic(const named_function& function, const option_words& said) {
    if (!function.has_characteristic) {
        refuse("--n", said, function.name, "leave it out");
        return std::nullopt;
    }
    if (!said["--n"]) {
        throw input_error(fmt::format("{} has no characteristic: add --n N", function.name));
    }
    return number_of("--n", *said["--n"]);
}

void read_grid_points(elliptic_request& request, const option_words& said, elliptic_grid grid) {
    const auto parameters = read_parameters(request, said, grid);
    const auto arguments = read_arguments(request, said);
    const auto characteristic = read_characteristic(*request.functions.front(), said);
    if (parameters.size() * arguments.size() > static_cast<std::size_t>(most_grid_values)) {
        throw input_error("--" + request.modulus, *said["--" + request.modulus],
                          fmt::format("makes more than {} rows", most_grid_values), "choose fewer values");
    }
    for (const typed_parameter& parameter : parameters) {
        for (const auto& [argument, imaginary] : arguments) {
            request.points.push_back({argument, parameter, characteristic, imaginary});
        }
    }
}

// Each row of the file is a point.
void read_points(elliptic_request& request, const option_words& said) {
    const std::string& path = *said["--points"];
    const point_file file("--points", path, said["--columns"], elliptic_columns::known());
    const named_function* asked = request.functions.front();
    for (const named_function* const each : request.functions) {
        asked = takes_complex(*each) ? asked : each;
    }
    const elliptic_columns columns(file.names(), *asked);
    request.modulus = columns.modulus();
    request.from_file = true;
    request.argument = columns.has_argument() ? std::string(request.functions.front()->argument) : "";
    for (const point_file::row& row : file.rows()) {
        request.points.push_back(file.reading(row, [&](const auto& cells) { return columns.read(cells); }));
    }
}

}  // namespace

void refuse_input(const elliptic_request& request, const elliptic_point& at, const error& complaint) {
    const bool of_modulus = complaint.is_about(error_subject::parameter) || complaint.is_about(error_subject::nome);
    const bool of_argument = !request.argument.empty() && complaint.is_about(error_subject::argument);
    const bool of_characteristic = complaint.is_about(error_subject::characteristic);
    if (complaint.kind() != error_kind::argument || !(of_modulus || of_argument || of_characteristic)) {
        throw;
    }
    const std::string name = of_modulus ? request.modulus : complaint.subject();
    const auto& typed = of_modulus ? std::optional(at.parameter.typed) : of_argument ? at.argument : at.characteristic;
    const std::string remedy = of_modulus    ? "write another one, such as 0.8"
                               : of_argument ? "write an argument nearer to 0"
                                             : "write a smaller one";
    throw input_error((request.from_file ? "column " : "--") + name, typed ? typed->text : complaint.value(),
                      complaint.reason(), remedy);
}

void require_argument(const std::string& name, const exact& argument) {
    const bool angle = argument.measure == unit::degree && name != "phi";
    if (argument.has_periods() || angle || (name == "x" && !argument.is_number())) {
        throw error(error_kind::argument, name, argument.text, "has '" + argument.text + "', which is not a number");
    }
}

typed_parameter parameter_of(const std::string& quantity, const exact& typed) {
    typed_parameter parameter{typed, quantity == "k"                      ? &real_parameter::from_modulus
                                     : quantity == "m" || quantity == "q" ? &real_parameter::from_parameter
                                     : quantity == "m1"                   ? &real_parameter::from_complement
                                     : quantity.starts_with("alpha")
                                         ? &real_parameter::from_modular_angle
                                         : throw std::logic_error("no modulus: " + quantity)};
    static_cast<void>(parameter.value());
    return parameter;
}

std::string elliptic_names() {
    std::string names;
    for (const named_function& each : named_functions()) {
        names += (names.empty() ? "" : ", ") + std::string(each.name);
    }
    return names;
}

void offer_elliptic(option_words& said, CLI::App& command) {
    said.offer(command,
               {{"--u", "U",
                 "argument of am, sn, cn, dn, cd, ...: 1.5, 3/2, pi/4, or a list; also complex, 1+2i, except for am"},
                {"--phi", "A", "amplitude of F, E, D, Pi, Zeta: 1.5, 3pi/4, 60deg, or a list"},
                {"--x", "X", "argument of the inverses arcsn, arccn, ...: 0.5, 1/3, or a list"},
                {"--z", "Z", "argument of theta1 .. theta4: 0.5, pi/4, or a list"},
                {"--n", "N", "the characteristic of Pi"},
                {"--k", "K", "the modulus k"},
                {"--m", "M", "the parameter m = k^2, any real number"},
                {"--m1", "M1", "the complementary parameter m1 = 1 - m, for m close to 1: 1e-30 loses no digits"},
                {"--alpha", "A", "the modular angle, m = sin^2 alpha: 0.5, pi/6, 30deg"},
                {"--q", "Q", "the nome of theta1 .. theta4"}});
}

elliptic_request read_elliptic(const std::vector<const named_function*>& functions, const option_words& said,
                               elliptic_grid grid) {
    elliptic_request request{functions, "", "", {}};
    if (grid == elliptic_grid::lists && said["--points"]) {
        read_points(request, said);
    } else {
        read_grid_points(request, said, grid);
    }
    return request;
}

}  // namespace libration
