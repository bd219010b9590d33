#include "table/elliptic_request.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "libration/digits/proved/proved_decimals.hpp"
#include "option/options.hpp"
#include "run/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

constexpr const char* modulus_remedy = "write a number from 0 to 1 such as 0.8, 4/5 or 1e-30";
constexpr const char* argument_remedy = "write a number such as 1.5, 3/2 or pi/4, or several with commas between them";

std::vector<exact> read_moduli(const std::string& option, const std::string& typed, elliptic_grid grid) {
    if (grid == elliptic_grid::one) {
        return {number_of(option, typed)};
    }
    auto moduli = reading(option, typed, modulus_remedy, [&] { return read_grid(typed); });
    for (const exact& modulus : moduli) {
        if (!modulus.is_number()) {
            throw input_error(option, typed, "has '" + modulus.text + "', which has a unit", modulus_remedy);
        }
    }
    return moduli;
}

void read_parameters(elliptic_request& request, const option_words& said, elliptic_grid grid) {
    using make = exact_parameter (*)(const exact&);
    constexpr std::array<std::pair<const char*, make>, 3> ways{{{"--k", &exact_parameter::from_modulus},
                                                                {"--m", &exact_parameter::from_parameter},
                                                                {"--m1", &exact_parameter::from_complement}}};
    for (const auto& [option, from] : ways) {
        const auto& typed = said[option];
        if (!typed) {
            continue;
        }
        if (!request.option.empty()) {
            throw input_error(option, *typed,
                              "comes together with " + request.option + " '" + *said[request.option] + "'",
                              "give one of --k, --m and --m1");
        }
        request.option = option;
        for (const exact& modulus : read_moduli(option, *typed, grid)) {
            const typed_parameter parameter{modulus, from};
            reading(option, *typed, modulus_remedy, [&] { return parameter.value(); });
            request.parameters.push_back(parameter);
        }
    }
    if (request.option.empty()) {
        throw input_error("no modulus is given: add --k K, --m M (m = k^2) or --m1 M1 (m1 = 1 - m)");
    }
}

void refuse_argument(const char* option, const option_words& said, const std::string& function, const char* remedy) {
    if (said[option]) {
        throw input_error(option, *said[option], "has no meaning for " + function, remedy);
    }
}

// The name of a function's argument; nothing for K.
std::string argument_name(const std::string& function) { return function == "K" ? "" : function == "F" ? "phi" : "u"; }

void read_arguments(elliptic_request& request, const option_words& said) {
    const std::string& function = request.functions.front();
    if (function == "K") {
        refuse_argument("--u", said, "K", "leave it out");
        refuse_argument("--phi", said, "K", "leave it out");
        request.arguments = {exact{0, unit::one, ""}};
        return;
    }
    const bool integral = function == "F";
    refuse_argument(integral ? "--u" : "--phi", said, function, integral ? "write --phi" : "write --u");
    const char* const option = integral ? "--phi" : "--u";
    const auto& value = said[option];
    if (!value) {
        throw input_error(fmt::format("{} has no argument: add {} {}", function, option, integral ? "A" : "U"));
    }
    request.arguments = reading(option, *value, argument_remedy, [&] { return read_grid(*value); });
    for (const exact& argument : request.arguments) {
        if (argument.has_periods() || (argument.measure == unit::degree && !integral)) {
            throw input_error(option, *value, "has '" + argument.text + "', which is no number", argument_remedy);
        }
    }
}

std::optional<jacobi_function> jacobi_of(const std::string& name) {
    if (name == "am" || name == "sn") {
        return name == "am" ? jacobi_function::am : jacobi_function::sn;
    }
    if (name == "cn" || name == "dn") {
        return name == "cn" ? jacobi_function::cn : jacobi_function::dn;
    }
    return std::nullopt;
}

}  // namespace

void offer_elliptic(option_words& said, CLI::App& command) {
    const auto offer = [&](const char* option, const char* type_name, const char* help) {
        said.offer(command, option, type_name, help);
    };
    offer("--u", "U", "argument of am, sn, cn, dn: 1.5, 3/2, pi/4, or a list");
    offer("--phi", "A", "amplitude of F: 1.5, 3pi/4, 60deg, or a list");
    offer("--k", "K", "the modulus k");
    offer("--m", "M", "the parameter m = k^2");
    offer("--m1", "M1", "the complementary parameter m1 = 1 - m: 1e-30 keeps its digits");
}

bool is_elliptic_function(const std::string& name) { return jacobi_of(name) || name == "K" || name == "F"; }

elliptic_request read_elliptic(const std::vector<std::string>& functions, const option_words& said,
                               elliptic_grid grid) {
    elliptic_request request{functions, "", {}, argument_name(functions.front()), {}};
    read_parameters(request, said, grid);
    read_arguments(request, said);
    return request;
}

bool is_infinite(const std::string& function, const exact& at, const exact_parameter& p) {
    return (function == "K" && p.complement().is_zero()) || (function == "F" && infinite_sign(at, p) != 0);
}

ball function_ball(const std::string& function, const exact& at, const exact_parameter& p) {
    const precision_scope wider(working_digits() + digits_before_point(at));
    const auto jacobi = jacobi_of(function);
    return jacobi            ? jacobi_value(*jacobi, at, p)
           : function == "K" ? complete_integral(p.shape<ball>())
                             : incomplete_value(at, p);
}

std::string function_text(const std::string& function, const exact& at, const exact_parameter& p, long digits) {
    if (is_infinite(function, at, p)) {
        return function == "F" && infinite_sign(at, p) < 0 ? "-inf" : "inf";
    }
    return proved_value(digits, [&] { return function_ball(function, at, p); }).text;
}

}  // namespace libration
