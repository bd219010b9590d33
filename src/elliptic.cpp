// libration elliptic: proved digits of am, sn, cn, dn, K and F.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "libration/elliptic/proved_functions.hpp"
#include "options.hpp"
#include "sweep/proofs.hpp"
#include "subcommand.hpp"
#include "sweep/grid.hpp"
#include "sweep/input_error.hpp"

namespace libration {

namespace {

struct elliptic_options {
    output_options output;
    std::string function;
    std::optional<std::string> u, phi, k, m, m1, digits;
};

// What was asked: the parameter with the option that gave it, and the arguments (one without a text for K).
struct elliptic_request {
    std::string option;
    std::string typed;
    exact_parameter parameter;
    std::vector<exact> arguments;
};

constexpr const char* modulus_remedy = "write a number from 0 to 1 such as 0.8, 4/5 or 1e-30";
constexpr const char* argument_remedy = "write a number such as 1.5, 3/2 or pi/4, or several with commas between them";

elliptic_request read_parameter(const elliptic_options& options) {
    using make = exact_parameter (*)(const rational&);
    struct way {
        const char* option;
        const std::optional<std::string>* typed;
        make from;
    };
    const std::array<way, 3> ways{way{"--k", &options.k, &exact_parameter::from_modulus},
                                  way{"--m", &options.m, &exact_parameter::from_parameter},
                                  way{"--m1", &options.m1, &exact_parameter::from_complement}};
    std::optional<elliptic_request> request;
    for (const auto& [option, typed, from] : ways) {
        if (!*typed) {
            continue;
        }
        if (request) {
            throw input_error(option, **typed, "comes together with " + request->option + " '" + request->typed + "'",
                              "give one of --k, --m and --m1");
        }
        const exact number = number_of(option, **typed);
        const exact_parameter parameter =
            reading(option, **typed, modulus_remedy, [&, make_from = from] { return make_from(number.coefficient); });
        request.emplace(elliptic_request{option, **typed, parameter, {}});
    }
    if (!request) {
        throw input_error("no modulus is given: add --k K, --m M (m = k^2) or --m1 M1 (m1 = 1 - m)");
    }
    return *request;
}

void refuse_argument(const char* option, const std::optional<std::string>& value, const std::string& function,
                     const char* remedy) {
    if (value) {
        throw input_error(option, *value, "has no meaning for " + function, remedy);
    }
}

std::vector<exact> arguments_of(const elliptic_options& options) {
    if (options.function == "K") {
        refuse_argument("--u", options.u, "K", "leave it out");
        refuse_argument("--phi", options.phi, "K", "leave it out");
        return {exact{}};
    }
    const bool integral = options.function == "F";
    refuse_argument(integral ? "--u" : "--phi", integral ? options.u : options.phi, options.function,
                    integral ? "write --phi" : "write --u");
    const char* const option = integral ? "--phi" : "--u";
    const auto& value = integral ? options.phi : options.u;
    if (!value) {
        throw input_error(fmt::format("{} has no argument: add {} {}", options.function, option, integral ? "A" : "U"));
    }
    auto arguments = reading(option, *value, argument_remedy, [&] { return read_grid(*value); });
    for (const exact& argument : arguments) {
        if (argument.measure == unit::period || (argument.measure == unit::degree && !integral)) {
            throw input_error(option, *value, "has '" + argument.text + "', which is no number", argument_remedy);
        }
    }
    return arguments;
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

// The digits that an argument loses before its point.
long digits_before_point(const exact& argument) {
    if (argument.is_zero()) {
        return 0;
    }
    const precision_scope rough(20);
    return decimal_digits(std::max(0L, binary_exponent(from_exact<mpfr>(argument))));
}

std::string value_text(const std::string& function, const exact& at, const exact_parameter& p, long digits) {
    const auto jacobi = jacobi_of(function);
    if (function == "K" && p.complement() == 0) {
        return "inf";
    }
    if (const int sign = function == "F" ? infinite_sign(at, p) : 0; sign != 0) {
        return sign < 0 ? "-inf" : "inf";
    }
    const long more = digits_before_point(at);
    return proved_decimals(digits,
                           [&] {
                               const precision_scope wider(working_digits() + more);
                               return std::vector<ball>{jacobi            ? jacobi_value(*jacobi, at, p)
                                                        : function == "K" ? complete_integral(p.shape())
                                                                          : incomplete_value(at, p)};
                           })
        .front()
        .text;
}

int run_elliptic(const elliptic_options& options) {
    options.output.check();
    if (!jacobi_of(options.function) && options.function != "K" && options.function != "F") {
        throw input_error("elliptic", options.function, "is no function", "write am, sn, cn, dn, K or F");
    }
    const long digits = digits_of(options.digits);
    elliptic_request request = read_parameter(options);
    request.arguments = arguments_of(options);
    table data{{{"function", ""},
                {"argument", ""},
                {request.option.substr(2), ""},
                {"value", ""},
                {"digits", ""},
                {"rigour", ""}},
               {}};
    for (const exact& argument : request.arguments) {
        data.rows.push_back({options.function, options.function == "K" ? "" : argument.text, request.typed,
                             value_text(options.function, argument, request.parameter, digits), std::to_string(digits),
                             "proved"});
    }
    options.output.write(data);
    return 0;
}

}  // namespace

subcommand elliptic_command(CLI::App& program) {
    const auto options = std::make_shared<elliptic_options>();
    CLI::App* command =
        program.add_subcommand("elliptic", "proved digits of am, sn, cn, dn, K and F at any modulus from 0 to 1");
    command->add_option("function", options->function, "am, sn, cn, dn, K or F")->type_name("FUNCTION")->required();
    command->add_option("--u", options->u, "argument of am, sn, cn, dn: 1.5, 3/2, pi/4, or a list")->type_name("U");
    command->add_option("--phi", options->phi, "amplitude of F: 1.5, 3pi/4, 60deg, or a list")->type_name("A");
    command->add_option("--k", options->k, "the modulus k")->type_name("K");
    command->add_option("--m", options->m, "the parameter m = k^2")->type_name("M");
    command->add_option("--m1", options->m1, "the complementary parameter m1 = 1 - m: 1e-30 keeps its digits")
        ->type_name("M1");
    command->add_option("--digits", options->digits, "significant digits, each proved to one unit in the last (50)")
        ->type_name("D");
    options->output.add_to(*command);
    return {command, [options] { return run_elliptic(*options); }};
}

}  // namespace libration
