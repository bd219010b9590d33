#include "carried_connection.hpp"

#include <algorithm>
#include <array>

#include "../../algebra/dense_matrix.hpp"
#include "enclosed_decimal.hpp"
#include "layer_connection.hpp"
#include "layer_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/identities.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long more_digits_of_carrier = 8;
constexpr long bits_of_carrier_text = 192;
constexpr std::array parts_of_time{1.0, 1.25, 1.5, 2.0};

// g'' = -c f g' with a limit of g.
struct carried_quantity {
    std::string name;
    std::array<std::size_t, 2> places;  // of g and g' in the state
    expression c;
    std::size_t limit;  // its index in the question
};

struct carried_text {
    connection_question layer;
    std::size_t flow;  // the place of f
    std::vector<carried_quantity> quantities;
};

bool names_initial_value(const std::string& unknown, const std::string& of, int order) {
    return unknown.substr(0, unknown.find('(')) == primed(of, order) && unknown.find('(') != std::string::npos;
}

std::optional<carried_text> carried_in(const connection_question& question) {
    const auto& limits = question.limits;
    const auto slope =
        std::ranges::find_if(limits, [](const auto& each) { return each.of.derivative() == 1 && each.direction > 0; });
    if (limits.size() < 2 || slope == limits.end()) {
        return std::nullopt;
    }
    carried_text result{{question.system, {}, {*slope}, {}, question.digits}, 0, {}};
    const std::string& carrier = slope->of.name();
    for (int order = 0; order < 3; ++order) {
        for (const std::string& each : question.unknowns) {
            if (names_initial_value(each, carrier, order)) {
                result.layer.unknowns.push_back(each);
                if (std::ranges::find(question.open, each) != question.open.end()) {
                    result.layer.open.push_back(each);
                }
            }
        }
    }
    if (result.layer.unknowns.size() != 1 || !is_layer(result.layer)) {
        return std::nullopt;
    }
    const first_order_form form{opened(question.system, question.unknowns).system};
    const auto place_of = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(form.names, name) - form.names.begin());
    };
    result.flow = place_of(carrier);
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (&limits[i] == &*slope) {
            continue;
        }
        const std::string& name = limits[i].of.name();
        carried_quantity here{name, {place_of(name), place_of(primed(name, 1))}, {}, i};
        if (limits[i].of.derivative() != 0 || limits[i].direction < 0 || here.places[1] >= form.names.size() ||
            !same_form(form.slopes[here.places[0]], form.leaves[here.places[1]])) {
            return std::nullopt;
        }
        const expression& f = form.leaves[result.flow];
        const expression& g = form.leaves[here.places[1]];
        const expression& change = form.slopes[here.places[1]];
        here.c = -partial(partial(change, f), g);
        const precision_scope scope(decimal_digits(bits_of_carrier_text));
        if (!here.c.is_constant() || here.c.has_parameters() || !is_identically_zero(change + here.c * f * g) ||
            arb_is_positive(number_in(here.c).handle()) == 0) {
            return std::nullopt;
        }
        result.quantities.push_back(here);
    }
    return result;
}

std::vector<expression> limits_of(const connection_question& question) {
    std::vector<expression> values;
    for (const limit_condition& each : question.limits) {
        values.push_back(each.value);
    }
    return values;
}

class carried_search {
public:
    carried_search(const connection_question& question, carried_text text, const proof_route& route, march_watch watch)
        : question_(question),
          text_(std::move(text)),
          route_(route),
          watch_(std::move(watch)),
          open_(opened(question.system, question.unknowns, limits_of(question))) {
        require_unknowns();
    }

    connection result() {
        for (const long more :
             {more_digits_of_carrier, 3 * more_digits_of_carrier, question_.digits + 4 * more_digits_of_carrier}) {
            connection_question layer = text_.layer;
            layer.digits = question_.digits + more;
            connection found = proved_layer(layer, route_, watch_);
            for (const double part : parts_of_time) {
                const auto values = values_at(found, found.time * part);
                if (values) {
                    return described(*values, found);
                }
            }
        }
        throw error(error_kind::undecided, error_subject::solution, "",
                    "is not followed far enough for so many digits");
    }

private:
    std::size_t unknown_of(const carried_quantity& of, int order) const {
        return static_cast<std::size_t>(
            std::ranges::find_if(question_.unknowns,
                                 [&](const std::string& each) { return names_initial_value(each, of.name, order); }) -
            question_.unknowns.begin());
    }

    void require_unknowns() const {
        bool fits = question_.unknowns.size() == 1 + text_.quantities.size();
        for (const carried_quantity& each : text_.quantities) {
            const std::size_t count = question_.unknowns.size();
            const std::size_t value = unknown_of(each, 0);
            const std::size_t slope = unknown_of(each, 1);
            fits = fits && (value < count) != (slope < count);
            const std::size_t open = std::min(value, slope);
            const std::size_t given = each.places[value < count ? 1 : 0];
            fits = fits && open < count && is_identically_zero(partial(open_.starts[given], open_.leaves[open]));
        }
        if (!fits) {
            throw error(
                error_kind::argument, error_subject::unknowns, "",
                "has other names than these limits determine: give the open initial value of the layer and, for each "
                "quantity g that it carries, either g(0) or g'(0), on which the other does not depend");
        }
    }

    // The unknowns as enclosures; std::nullopt if they do not have the digits.
    std::optional<std::vector<proved_decimal>> values_at(const connection& layer, double time) const {
        const long bits = 64 + 4 * static_cast<long>(question_.digits + more_digits_of_carrier) + 64;
        const precision_scope scope(decimal_digits(bits));
        expression_values<ball> numbers(open_.leaves, ball(0));
        for (std::size_t i = 0; i < question_.unknowns.size(); ++i) {
            numbers.push_back(question_.unknowns[i] == text_.layer.unknowns.front()
                                  ? enclosed(layer.values.front())
                                  : constant_value<ball>::of(open_.values[i]));
        }
        std::vector<ball> given;
        for (const expression& each : open_.starts) {
            given.push_back(numbers.of(each));
        }
        auto start = given;
        for (const carried_quantity& each : text_.quantities) {
            start[each.places[0]] = ball(0);
            start[each.places[1]] = ball(1);
        }
        proved_march march(open_.system, start, bits, run_bits::usual_error_bits, watch_, route_);
        const auto state = march.at(constant_value<ball>::of(open_.system.point()) + exactly(time));
        if (!state) {
            return std::nullopt;
        }
        std::vector<proved_decimal> result(question_.unknowns.size());
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (question_.unknowns[i] == text_.layer.unknowns.front()) {
                const auto printed = to_proved_decimal(enclosed(layer.values.front()), question_.digits);
                if (!printed) {
                    return std::nullopt;
                }
                result[i] = *printed;
            }
        }
        for (const carried_quantity& each : text_.quantities) {
            const ball whole = (*state)[each.places[0]] + (*state)[each.places[1]] * rest_of_integral(*state, each);
            const ball limit = numbers.of(open_.others[each.limit]);
            const bool by_slope = unknown_of(each, 1) < result.size();
            const ball found =
                by_slope ? (limit - given[each.places[0]]) / whole : limit - given[each.places[1]] * whole;
            const auto printed = to_proved_decimal(found, question_.digits);
            if (!printed) {
                return std::nullopt;
            }
            result[unknown_of(each, by_slope ? 1 : 0)] = *printed;
        }
        return result;
    }

    // int_0^inf exp(-c (f x + l x^2/2)) dx for all l within |f' - L| of L.
    ball rest_of_integral(const std::vector<ball>& state, const carried_quantity& of) const {
        const ball limit = number_in(open_.others[slope_limit()]);
        const ball c = number_in(of.c);
        const ball l = widened(limit, magnitude(state[text_.flow + 1] - limit));
        const ball z = state[text_.flow] * sqrt(c / (l * 2));
        ball complement;
        arb_hypgeom_erfc(complement.handle(), z.handle(), ball::working_bits());
        return sqrt(pi<ball>() / (c * l * 2)) * exp(z * z) * complement;
    }

    std::size_t slope_limit() const {
        return static_cast<std::size_t>(
            std::ranges::find_if(question_.limits, [](const auto& each) { return each.of.derivative() == 1; }) -
            question_.limits.begin());
    }

    connection described(std::vector<proved_decimal> values, const connection& layer) const {
        connection result;
        result.values = std::move(values);
        result.proved = layer.proved + "; and exactly one value of each other unknown for it";
        result.not_claimed = layer.not_claimed;
        result.time = layer.time;
        return result;
    }

    const connection_question& question_;
    carried_text text_;
    proof_route route_;
    march_watch watch_;
    parametric_system open_;
};

}  // namespace

bool is_carried(const connection_question& question) { return carried_in(question).has_value(); }

connection proved_carried(const connection_question& question, const proof_route& route, const march_watch& watch) {
    auto text = carried_in(question);
    if (!text) {
        throw error(error_kind::argument, error_subject::conditions, "",
                    "are not those of quantities carried by a layer");
    }
    return carried_search(question, *std::move(text), route, watch).result();
}

}  // namespace libration::ode
