#include "piecewise.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "libration/ode/hybrid/hybrid_system.hpp"

namespace libration::ode {

namespace {

struct piecewise_form {
    std::string_view name;
    piecewise_kind kind;
    std::size_t arguments;
    std::string_view form;
};

constexpr std::array<piecewise_form, 9> forms{{{"if", piecewise_kind::conditional, 3, "if(x > 0, a, b)"},
                                               {"abs", piecewise_kind::absolute, 1, "abs(x)"},
                                               {"sign", piecewise_kind::sign, 1, "sign(x)"},
                                               {"max", piecewise_kind::maximum, 2, "max(a, b)"},
                                               {"min", piecewise_kind::minimum, 2, "min(a, b)"},
                                               {"heaviside", piecewise_kind::heaviside, 1, "heaviside(x)"},
                                               {"floor", piecewise_kind::floor, 1, "floor(t)"},
                                               {"square", piecewise_kind::square, 1, "square(t)"},
                                               {"sawtooth", piecewise_kind::sawtooth, 1, "sawtooth(t)"}}};

const piecewise_form& form_at(piecewise_kind kind) { return *std::ranges::find(forms, kind, &piecewise_form::kind); }

expression heaviside_by(const expression& sign) { return expression(rational(1, 2)) * (1 + sign); }

expression chosen_by(const expression& heaviside, const expression& a, const expression& b) {
    return heaviside * a + (1 - heaviside) * b;
}

}  // namespace

std::optional<piecewise_kind> piecewise_named(std::string_view name) {
    const auto* const found = std::ranges::find(forms, name, &piecewise_form::name);
    return found == forms.end() ? std::nullopt : std::optional(found->kind);
}

std::size_t arguments_of(piecewise_kind kind) { return form_at(kind).arguments; }

std::string form_of(piecewise_kind kind) { return std::string(form_at(kind).form); }

expression step_collector::value_of(piecewise_kind kind, const std::vector<expression>& arguments,
                                    const std::string& text, const place& at) {
    const expression& u = arguments.front();
    const auto sign_of = [&](const expression& of) { return sign(of, text, at); };
    const auto floor_by = [&](int pis) {
        const number divisor = pis == 0 ? number(rational(1)) : number(rational(pis), unit::pi);
        return floor(u, divisor, text, at);
    };
    switch (kind) {
        case piecewise_kind::conditional: return chosen_by(heaviside_by(sign_of(u)), arguments[1], arguments[2]);
        case piecewise_kind::absolute: return sign_of(u) * u;
        case piecewise_kind::sign: return sign_of(u);
        case piecewise_kind::maximum: return chosen_by(heaviside_by(sign_of(u - arguments[1])), u, arguments[1]);
        case piecewise_kind::minimum: return chosen_by(heaviside_by(sign_of(u - arguments[1])), arguments[1], u);
        case piecewise_kind::heaviside: return heaviside_by(sign_of(u));
        case piecewise_kind::floor: return floor_by(0);
        case piecewise_kind::square: return 1 - 2 * (floor_by(1) - 2 * floor_by(2));
        case piecewise_kind::sawtooth: return u / expression(number(1, unit::pi)) - 1 - 2 * floor_by(2);
    }
    return {};
}

// One parameter for arguments that are equal up to a constant factor.
expression step_collector::sign(const expression& argument, const std::string& text, const place& at) {
    for (const step_function& each : steps_) {
        const int relative = each.kind == step_kind::sign ? relative_sign(each.argument, argument) : 0;
        if (relative != 0) {
            return relative * parameter(each.parameter);
        }
    }
    return added({.kind = step_kind::sign, .argument = argument, .text = text, .at = at});
}

expression step_collector::floor(const expression& argument, const number& divisor, const std::string& text,
                                 const place& at) {
    for (const step_function& each : steps_) {
        if (each.kind == step_kind::floor && same_form(each.argument, argument) && same_form(each.divisor, divisor)) {
            return parameter(each.parameter);
        }
    }
    return added({.kind = step_kind::floor, .argument = argument, .divisor = divisor, .text = text, .at = at});
}

expression step_collector::added(step_function made) {
    made.parameter = "step " + std::to_string(steps_.size() + 1);
    steps_.push_back(std::move(made));
    return parameter(steps_.back().parameter);
}

}  // namespace libration::ode
