#include "table/elliptic_values.hpp"

#include <fmt/format.h>

#include <functional>

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/elliptic/function_condition.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration {

using namespace elliptic;

namespace {

constexpr long first_condition_digits = 40;

long digits_before_point_of(const exact& argument) { return elliptic::digits_before_point(argument); }

long digits_lost(const elliptic_point& at) { return at.argument ? digits_before_point_of(*at.argument) : 0; }

// Whether the value is infinite: decided by exact numbers, hence at any precision.
int infinite_at(const named_function& function, const elliptic_point& at) {
    return with_growing_precision(
        {0, 20, most_guard_digits}, std::string(function.name),
        [&](const precision_run& /*run*/) { return std::optional(value_at(function, at).infinite); });
}

long digits_lost_complex(const elliptic_point& at) { return digits_lost(at) + digits_before_point_of(*at.imaginary); }

bool is_complex_pole(const named_function& function, const elliptic_point& at) {
    return with_growing_precision(
        {0, 20, most_guard_digits}, std::string(function.name),
        [&](const precision_run& /*run*/) { return std::optional(!complex_value_at(function, at)); });
}

}  // namespace

true_value value_at(const named_function& function, const elliptic_point& at) {
    const precision_scope wider(working_digits() + digits_lost(at));
    return function(at.exactly());
}

std::optional<complex_parts> complex_value_at(const named_function& function, const elliptic_point& at) {
    const precision_scope wider(working_digits() + digits_lost_complex(at));
    return complex_quotient(function.name, *at.argument, *at.imaginary, at.parameter.value());
}

std::string function_text(const named_function& function, const elliptic_point& at, long digits) {
    if (const int infinite = infinite_at(function, at); infinite != 0) {
        return infinite < 0 ? "-inf" : "inf";
    }
    try {
        return proved_value(digits, [&] { return value_at(function, at).value(); }).text;
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range) {
            throw;
        }
        throw error(error_kind::argument, {error_subject::argument, std::string(function.argument)},
                    at.argument ? at.argument->text : "",
                    fmt::format("makes {} too large or too small to be printed", function.name));
    }
}

std::array<std::string, 2> complex_texts(const named_function& function, const elliptic_point& at, long digits) {
    if (is_complex_pole(function, at)) {
        return {"inf", "inf"};
    }
    const auto texts = proved_decimals(digits, [&] {
        const complex_parts value = *complex_value_at(function, at);
        return std::vector<ball>{value.real, value.imaginary};
    });
    return {texts[0].text, texts[1].text};
}

std::string condition_text(const named_function& function, const elliptic_point& at) {
    if (infinite_at(function, at) != 0) {
        return "inf";
    }
    std::vector<exact> inputs;
    for (const auto& input : {at.argument, at.characteristic, std::optional(at.parameter.typed)}) {
        if (input) {
            inputs.push_back(*input);
        }
    }
    const auto value = [&](const std::vector<exact>& moved) {
        elliptic_point there = at;
        auto next = moved.begin();
        for (std::optional<exact>* const input : {&there.argument, &there.characteristic}) {
            if (*input) {
                *input = *next++;
            }
        }
        there.parameter.typed = *next;
        return value_at(function, there).value();
    };
    const auto compute = [&](const precision_run& /*run*/) -> std::optional<std::string> {
        const auto condition = function_condition(value, inputs);
        return condition ? to_decimal(*condition, 3) : "inf";
    };
    const std::string at_text = at.argument ? at.argument->text : at.parameter.typed.text;
    return until_two_agree({0, first_condition_digits + digits_lost(at), most_agreement_digits},
                           fmt::format("the condition of {}({})", function.name, at_text), compute, std::equal_to<>());
}

std::string complex_condition_text(const named_function& function, const elliptic_point& at) {
    if (is_complex_pole(function, at)) {
        return "inf";
    }
    const auto value = [&](const std::vector<exact>& moved) {
        elliptic_point there = at;
        there.argument = moved[0];
        there.imaginary = moved[1];
        there.parameter.typed = moved[2];
        return *complex_value_at(function, there);
    };
    const auto compute = [&](const precision_run& /*run*/) -> std::optional<std::string> {
        const auto condition = complex_function_condition(value, {*at.argument, *at.imaginary, at.parameter.typed});
        return condition ? to_decimal(*condition, 3) : "inf";
    };
    return until_two_agree(
        {0, first_condition_digits + digits_lost_complex(at), most_agreement_digits},
        fmt::format("the condition of {}({} + {} i)", function.name, at.argument->text, at.imaginary->text), compute,
        std::equal_to<>());
}

std::array<std::string, 2> texts_of(const named_function& function, const elliptic_point& at, long digits) {
    if (at.imaginary) {
        return complex_texts(function, at, digits);
    }
    return {function_text(function, at, digits), "0"};
}

std::string condition_of(const named_function& function, const elliptic_point& at) {
    return at.imaginary ? complex_condition_text(function, at) : condition_text(function, at);
}

}  // namespace libration
