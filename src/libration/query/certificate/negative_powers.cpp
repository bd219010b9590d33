#include "negative_powers.hpp"

#include <optional>
#include <utility>

#include "libration/equation/node_values.hpp"

namespace libration::ode {

namespace {

bool is_whole(const rational& r) { return denominator(r) == 1; }

// The exponent of a power that is not whole, of which e consists.
std::optional<rational> root_exponent(const expression& e) {
    const auto exponent = e.kind() == node_kind::power ? e.right().fraction() : std::nullopt;
    return exponent && !is_whole(*exponent) ? exponent : std::nullopt;
}

// (u^r)^n as u^(r n), for whole n, if neither exponent is whole.
expression power_of_root(const expression& base, const expression& exponent) {
    const auto inner = root_exponent(base);
    const auto outer = exponent.fraction();
    const bool joins = inner && outer && is_whole(*outer) && !is_whole(*inner * *outer);
    return joins ? pow(base.left(), expression(rational(*inner * *outer))) : pow(base, exponent);
}

// 1/e without a quotient of roots; std::nullopt if e has none as a factor.
std::optional<expression> reciprocal(const expression& e) {
    if (const auto exponent = root_exponent(e)) {
        return pow(e.left(), expression(rational(-*exponent)));
    }
    if (e.kind() != node_kind::product) {
        return std::nullopt;
    }
    const auto left = reciprocal(e.left());
    const auto right = reciprocal(e.right());
    if (!left && !right) {
        return std::nullopt;
    }
    return left.value_or(1 / e.left()) * right.value_or(1 / e.right());
}

}  // namespace

expression with_negative_powers(const expression& whole) {
    node_values<expression> done;
    return done.of(whole, [&](const expression& e) {
        switch (e.kind()) {
            case node_kind::sum: return done.at(e.left()) + done.at(e.right());
            case node_kind::product: return done.at(e.left()) * done.at(e.right());
            case node_kind::quotient: {
                const expression& above = done.at(e.left());
                const expression& below = done.at(e.right());
                const auto factor = reciprocal(below);
                return factor ? above * *factor : above / below;
            }
            case node_kind::power: return power_of_root(done.at(e.left()), e.right());
            case node_kind::function: {
                const expression& argument = done.at(e.left());
                const bool is_root = e.function() == function_kind::sqrt && !argument.is_constant();
                return is_root ? pow(argument, expression(rational(1, 2))) : with_argument(e, argument);
            }
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        return e;
    });
}

explicit_system with_negative_powers(const explicit_system& of) {
    equation_system given;
    given.variable = of.variable();
    const expression at(of.point());
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const expression each = unknown(of.unknowns()[i].name);
        given.add(derivative(each, of.unknowns()[i].order), with_negative_powers(of.right()[i]));
        for (std::size_t j = 0; j < of.starts()[i].size(); ++j) {
            given.begin(derivative(each, static_cast<int>(j)), expression(of.starts()[i][j]), at);
        }
    }
    return explicit_system(given);
}

}  // namespace libration::ode
