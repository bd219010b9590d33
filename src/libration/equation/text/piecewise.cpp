#include "piecewise.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libration/equation/choice.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/equation/hybrid_system.hpp"

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
    const auto sign_of_u = [&] {
        const oriented_sign found = sign(u, text, at);
        return found.orientation * parameter(found.parameter);
    };
    const auto if_positive = [&](const expression& difference, const expression& a, const expression& b) {
        return chosen({difference}, a, b, text, at);
    };
    const auto floor_by = [&](int pis) {
        const number divisor = pis == 0 ? number(rational(1)) : number(rational(pis), unit::pi);
        return floor(u, divisor, text, at);
    };
    switch (kind) {
        case piecewise_kind::conditional: break;
        case piecewise_kind::absolute: return if_positive(u, u, -u);
        case piecewise_kind::sign: return sign_of_u();
        case piecewise_kind::maximum: return if_positive(written_sum(u, -arguments[1]), u, arguments[1]);
        case piecewise_kind::minimum: return if_positive(written_sum(u, -arguments[1]), arguments[1], u);
        case piecewise_kind::heaviside: return expression(rational(1, 2)) * (1 + sign_of_u());
        case piecewise_kind::floor: return floor_by(0);
        case piecewise_kind::square: return 1 - 2 * (floor_by(1) - 2 * floor_by(2));
        case piecewise_kind::sawtooth: return u / expression(number(1, unit::pi)) - 1 - 2 * floor_by(2);
    }
    throw std::logic_error("a conditional without its comparison");
}

expression step_collector::chosen(const comparison& condition, const expression& a, const expression& b,
                                  const std::string& text, const place& at) {
    const oriented_sign found = sign(condition.difference, text, at);
    const auto indicator = [&](bool or_equal) {
        return parameter(or_equal ? name_of_nonnegative(found.parameter) : name_of_positive(found.parameter));
    };
    // [-u > 0] = 1 - [u >= 0].
    const expression holds = found.orientation > 0 ? indicator(condition.or_equal) : 1 - indicator(!condition.or_equal);
    return choice_between(holds, a, b);
}

// One parameter for arguments that are equal up to a constant factor.
step_collector::oriented_sign step_collector::sign(const expression& argument, const std::string& text,
                                                   const place& at) {
    for (const step_function& each : steps_) {
        const int relative = each.kind == step_kind::sign ? relative_sign(each.argument, argument) : 0;
        if (relative != 0) {
            return {each.parameter, relative};
        }
    }
    return {added({.kind = step_kind::sign, .argument = argument, .text = text, .at = at})};
}

expression step_collector::floor(const expression& argument, const number& divisor, const std::string& text,
                                 const place& at) {
    for (const step_function& each : steps_) {
        if (each.kind == step_kind::floor && same_form(each.argument, argument) && same_form(each.divisor, divisor)) {
            return parameter(each.parameter);
        }
    }
    return parameter(
        added({.kind = step_kind::floor, .argument = argument, .divisor = divisor, .text = text, .at = at}));
}

const std::string& step_collector::added(step_function made) {
    made.parameter = "step " + std::to_string(steps_.size() + 1);
    steps_.push_back(std::move(made));
    return steps_.back().parameter;
}

}  // namespace libration::ode
