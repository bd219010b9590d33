// Which equations are those of the two-body problem.
#include <cstddef>
#include <string>
#include <utility>

#include "libration/problem/known/kepler.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

using ode::node_kind;

bool is_coordinate(const ode::expression& e, const std::string& name) {
    return e.kind() == node_kind::unknown && e.name() == name && e.derivative() == 0;
}

// x^2 or x*x.
bool is_square(const ode::expression& e, const std::string& name) {
    return (e.kind() == node_kind::power && is_coordinate(e.left(), name) && e.right().is(2)) ||
           (e.kind() == node_kind::product && is_coordinate(e.left(), name) && is_coordinate(e.right(), name));
}

// factor * x^own * (x^2 + y^2)^squares.
struct monomial {
    ode::number factor = ode::number(rational(1));
    rational own = 0;
    rational squares = 0;
};

// Right-hand sides as monomials, with x the unknown of the equation.
class monomial_reader {
public:
    monomial_reader(std::string x, std::string y) : x_(std::move(x)), y_(std::move(y)) {}

    std::optional<monomial> operator()(const ode::expression& e) const {
        switch (e.kind()) {
            case node_kind::constant: return monomial{.factor = e.constant()};
            case node_kind::unknown: return is_coordinate(e, x_) ? std::optional(monomial{.own = 1}) : std::nullopt;
            case node_kind::sum: return is_distance_squared(e) ? std::optional(monomial{.squares = 1}) : std::nullopt;
            case node_kind::product: return product((*this)(e.left()), (*this)(e.right()));
            case node_kind::quotient: return product((*this)(e.left()), to_power((*this)(e.right()), -1));
            case node_kind::power:
                return e.right().fraction() ? to_power((*this)(e.left()), *e.right().fraction()) : std::nullopt;
            case node_kind::function:
                return e.function() == function_kind::sqrt ? to_power((*this)(e.left()), rational(1, 2)) : std::nullopt;
            case node_kind::variable:
            case node_kind::parameter: return std::nullopt;
        }
        return std::nullopt;
    }

private:
    bool is_distance_squared(const ode::expression& e) const {
        return (is_square(e.left(), x_) && is_square(e.right(), y_)) ||
               (is_square(e.left(), y_) && is_square(e.right(), x_));
    }

    static std::optional<monomial> product(const std::optional<monomial>& a, const std::optional<monomial>& b) {
        return a && b ? std::optional(monomial{a->factor * b->factor, a->own + b->own, a->squares + b->squares})
                      : std::nullopt;
    }

    // The distance is positive and has any power; the unknown, which may be 0, has only positive integers, and a number
    // none that is not an integer.
    static std::optional<monomial> to_power(const std::optional<monomial>& base, const rational& exponent) {
        const bool whole = denominator(exponent) == 1;
        if (!base || (base->own != 0 && !(whole && exponent > 0)) ||
            (!whole && base->factor.fraction() != rational(1))) {
            return std::nullopt;
        }
        return monomial{whole ? power(base->factor, ode::number(exponent)) : base->factor, base->own * exponent,
                        base->squares * exponent};
    }

    std::string x_, y_;
};

// The m of two equations x'' = -m x/r^3.
std::optional<ode::number> attraction_of(const ode::explicit_system& system) {
    const auto& unknowns = system.unknowns();
    if (system.singular() || unknowns.size() != 2 || unknowns[0].order != 2 || unknowns[1].order != 2) {
        return std::nullopt;
    }
    std::optional<ode::number> attraction;
    for (const std::size_t i : {0U, 1U}) {
        const auto right = monomial_reader(unknowns[i].name, unknowns[1 - i].name)(system.right()[i]);
        const bool central = right && right->own == 1 && right->squares == rational(-3, 2);
        if (!central || (attraction && !same_form(*attraction, -right->factor))) {
            return std::nullopt;
        }
        attraction = -right->factor;
    }
    return attraction;
}

// m > 0, nonzero angular momentum, and negative energy: v^2 r < 2 m.
bool is_elliptic(const recognised_kepler& orbit) {
    const auto& [x, y] = orbit.position;
    const auto& [vx, vy] = orbit.velocity;
    const ode::number distance = apply(function_kind::sqrt, x * x + y * y);
    return orbit.attraction.sign() > 0 && (x * vy - y * vx).sign() != 0 &&
           ((vx * vx + vy * vy) * distance - ode::number(rational(2)) * orbit.attraction).sign() < 0;
}

}  // namespace

std::optional<recognised_kepler> recognise_kepler(const ode::explicit_system& system) {
    try {
        const auto attraction = attraction_of(system);
        if (!attraction) {
            return std::nullopt;
        }
        const auto& starts = system.starts();
        const recognised_kepler found{*attraction, {starts[0][0], starts[1][0]}, {starts[0][1], starts[1][1]}};
        return is_elliptic(found) ? std::optional(found) : std::nullopt;
    } catch (const error&) {  // a sign that no precision decides
        return std::nullopt;
    }
}

}  // namespace libration
