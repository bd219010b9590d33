#include "layer_text.hpp"

#include <algorithm>

#include "libration/equation/first_order_form.hpp"
#include "libration/equation/identities.hpp"

namespace libration::ode {

namespace {

constexpr long bits_of_layer_text = 192;
constexpr std::size_t highest_power_of_slope = 8;

}  // namespace

ball number_in(const expression& e) { return expression_values<ball>({}, ball(0)).of(e); }

std::optional<layer_text> layer_in(const connection_question& question) {
    if (question.limits.size() != 1 || question.limits.front().of.derivative() != 1 ||
        question.limits.front().direction < 0) {
        return std::nullopt;
    }
    const std::string name = question.limits.front().of.name();
    layer_text text{closed_part(opened(question.system, question.unknowns, {question.limits.front().value}), {name}),
                    {},
                    {},
                    {},
                    {}};
    const first_order_form form(text.open.system);
    for (int order = 0; order < 3; ++order) {
        const auto place = std::ranges::find(form.names, primed(name, order));
        if (place == form.names.end()) {
            return std::nullopt;
        }
        text.places[static_cast<std::size_t>(order)] = static_cast<std::size_t>(place - form.names.begin());
    }
    const auto leaf = [&](std::size_t order) { return form.leaves[text.places[order]]; };
    const expression& slope = form.slopes[text.places[2]];
    if (!same_form(form.slopes[text.places[1]], leaf(2)) || slope.has_variable()) {
        return std::nullopt;
    }
    text.a = -partial(partial(slope, leaf(0)), leaf(2));
    text.limit = text.open.others.front();
    expression rest = slope + text.a * leaf(0) * leaf(2);
    const auto is_number = [&](const expression& e) { return e.is_constant() && !e.has_parameters(); };
    if (!is_number(text.a) || !is_number(text.limit) || !is_identically_zero(partial(rest, leaf(0))) ||
        !is_identically_zero(partial(rest, leaf(2)))) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(bits_of_layer_text));
    if (arb_is_positive(number_in(text.a).handle()) == 0 || arb_is_positive(number_in(text.limit).handle()) == 0) {
        return std::nullopt;
    }
    const auto at_limit = [&](const expression& e) {
        return replaced(e, [&](const expression& each) {
            return same_form(each, leaf(1))                               ? std::optional(text.limit)
                   : same_form(each, leaf(0)) || same_form(each, leaf(2)) ? std::optional(expression(0))
                                                                          : std::nullopt;
        });
    };
    if (!is_identically_zero(at_limit(rest))) {
        return std::nullopt;
    }
    rational factorial = 1;
    for (std::size_t order = 1; order <= highest_power_of_slope + 1; ++order) {
        rest = partial(rest, leaf(1));
        if (is_identically_zero(rest)) {
            return text;
        }
        factorial *= static_cast<long>(order);
        text.k.push_back(at_limit(rest) / expression(factorial));
        if (!is_number(text.k.back())) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
