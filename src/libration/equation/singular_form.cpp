#include "singular_form.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int largest_root = 64;

expression distance() { return parameter(distance_name); }

bool is_distance(const expression& e) { return e.kind() == node_kind::parameter; }

expression in_distance(const expression& e, const number& point) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        return leaf.kind() == node_kind::variable ? std::optional(distance() + expression(point)) : std::nullopt;
    });
}

expression distance_power(const rational& r) { return pow(distance(), expression(r)); }

/// s^exponent rest.
struct factored_form {
    rational exponent;
    expression rest;
};

// Factors the powers of s out of an expression.
class factoring {
public:
    explicit factoring(start_values& values) : values_(values) {}

    factored_form of(const expression& e) {
        return done_.of(e, [this](const expression& each) { return made(each); });
    }

    /// The least root for which all powers of s are integer powers of s^(1/root).
    int root() const { return root_; }
    /// Whether s occurred at all: an expression that cannot be evaluated may be a quotient of its powers.
    bool has_met_powers() const { return met_; }

    void note(const rational& exponent) {
        const integer whole = lcm(integer(root_), denominator(exponent));
        if (whole > largest_root) {
            throw error(error_kind::argument, error_subject::problem, "",
                        "has powers of the distance from the initial point with denominators above " +
                            std::to_string(largest_root));
        }
        root_ = whole.convert_to<int>();
    }

private:
    factored_form made(const expression& e) {
        switch (e.kind()) {
            case node_kind::parameter: met_ = true; return {1, 1};
            case node_kind::sum: return of_sum(e);
            case node_kind::product: {
                const auto& a = done_.at(e.left());
                const auto& b = done_.at(e.right());
                if (e.is_unfolded_zero()) {
                    const expression zero = zero_where_defined(b.rest);
                    return {zero.is(0) ? rational(0) : b.exponent, zero};
                }
                return {a.exponent + b.exponent, a.rest * b.rest};
            }
            case node_kind::quotient: {
                const auto& a = done_.at(e.left());
                const auto& b = done_.at(e.right());
                return {a.exponent - b.exponent, a.rest / b.rest};
            }
            case node_kind::power: return of_power(e);
            case node_kind::function: return of_function(e);
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::unknown: break;
        }
        return {0, e};
    }

    expression joined(const factored_form& f) {
        note(f.exponent);
        return f.exponent == 0 ? f.rest : distance_power(f.exponent) * f.rest;
    }

    factored_form of_sum(const expression& e) {
        if (!e.has_unknowns() && e.has_parameters()) {
            const expression slope = partial(e, distance());
            const auto at_start = [&] { return values_.refusal_of(e) ? number(rational(1)) : values_.value_of(e); };
            if (slope.kind() == node_kind::constant && !slope.is(0) && at_start().sign() == 0) {
                met_ = true;
                return {1, slope};
            }
        }
        const auto& a = done_.at(e.left());
        const auto& b = done_.at(e.right());
        const rational least = std::min(a.exponent, b.exponent);
        return {least, joined({a.exponent - least, a.rest}) + joined({b.exponent - least, b.rest})};
    }

    factored_form of_power(const expression& e) {
        const auto& base = done_.at(e.left());
        const auto exponent = e.right().fraction();
        if (!exponent) {
            return {0, pow(joined(base), e.right())};
        }
        return {base.exponent * *exponent, pow(base.rest, e.right())};
    }

    factored_form of_function(const expression& e) {
        const auto& inner = done_.at(e.left());
        if (e.function() == function_kind::sqrt) {
            return {inner.exponent / 2, sqrt(inner.rest)};
        }
        if (e.function() == function_kind::cbrt) {
            return {inner.exponent / 3, cbrt(inner.rest)};
        }
        if (inner.exponent < 0) {
            throw error(
                error_kind::argument, error_subject::problem, "",
                "has a function whose argument may be infinite at the initial point: choose another initial point");
        }
        return {0, with_argument(e, joined(inner))};
    }

    start_values& values_;
    node_values<factored_form> done_;
    int root_ = 1;
    bool met_ = false;
};

// The lag behind n of the newest coefficient that can be computed before y_n.
long lag_of(const expression& whole, int root) {
    node_values<long> done;
    return done.of(whole, [&](const expression& e) {
        switch (e.kind()) {
            case node_kind::unknown: return static_cast<long>(e.derivative()) * root;
            case node_kind::function:
            case node_kind::power: return done.at(e.left());
            case node_kind::product: {
                const expression& left = e.left();
                if (left.kind() == node_kind::power && is_distance(left.left())) {
                    const rational shift = *left.right().fraction() * root;
                    return std::max(0L, done.at(e.right()) - numerator(shift).convert_to<long>());
                }
                if (is_distance(left)) {
                    return std::max(0L, done.at(e.right()) - root);
                }
                return std::max(done.at(left), done.at(e.right()));
            }
            case node_kind::sum:
            case node_kind::quotient: return std::max(done.at(e.left()), done.at(e.right()));
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::parameter: break;
        }
        return 0L;
    });
}

// Finds the weights of one right-hand side, f in terms of s.
std::vector<std::vector<number>> weights_of(const expression& f, int order,
                                            const std::vector<unknown_function>& unknowns, factoring& factors,
                                            start_values& values) {
    std::vector<std::vector<number>> weights;
    for (const unknown_function& each : unknowns) {
        auto& of_unknown = weights.emplace_back(static_cast<std::size_t>(each.order));
        for (int l = 0; l < each.order; ++l) {
            const auto slope = factors.of(partial(f, unknown(each.name, l)));
            if (!slope.rest.is(0) && slope.exponent + order - l == 0) {
                of_unknown[static_cast<std::size_t>(l)] = values.value_of(slope.rest);
            }
        }
    }
    return weights;
}

}  // namespace

std::optional<singular_start> singular_form(const std::vector<unknown_function>& unknowns,
                                            const std::vector<expression>& right, const number& point,
                                            start_values& values) {
    factoring factors(values);
    std::vector<expression> shifted;
    std::vector<factored_form> forms;
    for (const expression& f : right) {
        shifted.push_back(in_distance(f, point));
        forms.push_back(factors.of(shifted.back()));
        factors.note(forms.back().exponent);
    }
    if (!factors.has_met_powers()) {
        return std::nullopt;
    }
    singular_start result{factors.root(), {}};
    for (std::size_t i = 0; i < right.size(); ++i) {
        const rational power = forms[i].exponent + unknowns[i].order;
        const std::string highest = primed(unknowns[i].name, unknowns[i].order);
        const expression scaled = power == 0 ? forms[i].rest : distance_power(power) * forms[i].rest;
        if (power < 0 || lag_of(scaled, result.root) > 0) {
            refuse(highest, {},
                   "is irregular singular at the initial point, where a factor of the highest derivative vanishes too "
                   "fast for a power series: choose another initial point");
        }
        if (const auto reason = values.refusal_of(scaled)) {
            refuse(highest, {},
                   "cannot be expanded about the initial point, because its right-hand side " + *reason +
                       ": choose another initial point");
        }
        result.right.push_back({scaled, weights_of(shifted[i], unknowns[i].order, unknowns, factors, values)});
    }
    return result;
}

bool has_isolated_zero(const expression& e, const number& point, start_values& values) {
    constexpr int most_derivatives = 16;
    factoring factors(values);
    expression rest = factors.of(in_distance(e, point)).rest;
    for (int k = 0; k < most_derivatives && !values.refusal_of(rest); ++k) {
        if (values.value_of(rest).sign() != 0) {
            return true;
        }
        const expression at_start = replaced(rest, [](const expression& leaf) {
            return is_distance(leaf) ? std::optional(expression(0)) : std::nullopt;
        });
        if (!at_start.is(0) || factors.root() > 1) {
            return false;
        }
        rest = partial(rest, distance());
    }
    return false;
}

}  // namespace libration::ode
