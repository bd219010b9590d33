#include "closed_equation.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/dependency.hpp"
#include "libration/equation/identities.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/plane/regular_coordinates.hpp"
#include "libration/plane/uniformizing_chart.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

using rational_row = std::array<rational, 3>;

// The polynomial form z' = g(z) with exact initial values.
class polynomial_flow {
public:
    explicit polynomial_flow(const explicit_system& of) : form_(lifted(of)) {
        for (const auto& of_unknown : of.starts()) {
            for (const number& each : of_unknown) {
                starts_.emplace_back(each);
            }
        }
        for (const expression& each : form_.added) {
            starts_.push_back(at_values(each, starts_));
        }
    }

    bool is_autonomous() const {
        for (const expression& each : form_.system.right()) {
            if (each.has_variable()) {
                return false;
            }
        }
        return true;
    }

    expression unknown_at(std::size_t leaf) const { return form_.leaves[leaf]; }
    expression slope_of(const expression& f) const { return derivative_along(f, form_.leaves, form_.system.right()); }
    std::optional<number> at_start(const expression& f) const {
        const expression value = at_values(f, starts_);
        return value.kind() == node_kind::constant ? std::optional(value.constant()) : std::nullopt;
    }
    // At the k-th of the points that the rational coefficients are found from.
    std::optional<rational> at_sample(const expression& f, int k) const {
        std::vector<expression> values;
        for (std::size_t i = 0; i < form_.leaves.size(); ++i) {
            values.emplace_back(rational(static_cast<int>(3 * i + 2) + k * (k + 2), static_cast<int>(2 * i + 3)));
        }
        const expression value = at_values(f, values);
        return value.kind() == node_kind::constant ? value.constant().fraction() : std::nullopt;
    }

private:
    expression at_values(const expression& f, const std::vector<expression>& values) const {
        return replaced(f, [&](const expression& leaf) -> std::optional<expression> {
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (same_form(leaf, form_.leaves[i])) {
                    return values[i];
                }
            }
            return std::nullopt;
        });
    }

    polynomial_form form_;
    std::vector<expression> starts_;
};

rational determinant_of(const std::array<rational_row, 3>& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

// Rational x with sum x_k columns[k] = value identically, by three samples and a proof of the identity.
std::optional<rational_row> combination(const polynomial_flow& flow, const std::array<expression, 3>& columns,
                                        const expression& value) {
    std::array<rational_row, 3> a;
    rational_row right;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = flow.at_sample(columns[k], static_cast<int>(i));
            if (!at) {
                return std::nullopt;
            }
            a[i][k] = *at;
        }
        const auto at = flow.at_sample(value, static_cast<int>(i));
        if (!at) {
            return std::nullopt;
        }
        right[i] = *at;
    }
    const rational determinant = determinant_of(a);
    if (determinant == 0) {
        return std::nullopt;
    }
    rational_row x;
    expression rest = value;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<rational_row, 3> with = a;
        for (std::size_t i = 0; i < 3; ++i) {
            with[i][k] = right[i];
        }
        x[k] = determinant_of(with) / determinant;
        rest = rest - expression(x[k]) * columns[k];
    }
    return is_identically_zero(rest) ? std::optional(x) : std::nullopt;
}

const char* const name_of_function = "f";

explicit_system equation_of_function(const explicit_system& like, const expression& right,
                                     const std::vector<number>& starts) {
    const auto order = static_cast<int>(starts.size());
    equation_system made;
    made.equations.push_back({unknown(name_of_function, order), right});
    for (int k = 0; k < order; ++k) {
        made.starts.push_back(
            {unknown(name_of_function, k), expression(like.point()), expression(starts[static_cast<std::size_t>(k)])});
    }
    return explicit_system(made);
}

std::optional<explicit_system> equation_for(const explicit_system& like, const polynomial_flow& flow,
                                            const expression& f) {
    const expression f1 = flow.slope_of(f);
    const expression f2 = flow.slope_of(f1);
    const expression f3 = flow.slope_of(f2);
    const auto at = flow.at_start(f);
    const auto slope = flow.at_start(f1);
    if (!at || !slope) {
        return std::nullopt;
    }
    const expression y = unknown(name_of_function);
    if (const auto x = combination(flow, {expression(1), f, f * f}, f1); x && (*x)[2] != 0) {
        return equation_of_function(like, expression((*x)[0]) + expression((*x)[1]) * y + expression((*x)[2]) * y * y,
                                    {*at});
    }
    const auto x = combination(flow, {2 * f * f * f * f1, f * f * f1, -f1}, f * f3 - f1 * f2);
    if (!x || ((*x)[0] == 0 && (*x)[1] == 0)) {
        return std::nullopt;
    }
    const expression a3((*x)[0]);
    const expression a2((*x)[1]);
    const expression c((*x)[2]);
    // b from f'' or, where f = 0, from f'''.
    const bool from_slope = at->sign() == 0;
    if (from_slope && slope->sign() == 0) {
        return std::nullopt;
    }
    const auto b = from_slope ? flow.at_start(f3 / f1) : flow.at_start((f2 - a3 * f * f * f - a2 * f * f - c) / f);
    if (!b) {
        return std::nullopt;
    }
    return equation_of_function(like, a3 * y * y * y + a2 * y * y + expression(*b) * y + c, {*at, *slope});
}

bool has_charts(const explicit_system& system) {
    return system.unknowns().size() == 1 &&
           (has_entire_solutions(system) || regular_coordinates::of(system) || uniformizing_chart::of(system));
}

}  // namespace

closed_equation closed_equation_of(const explicit_system& system, std::size_t unknown, int derivative) {
    const closed_subsystem part = subsystem_of(system, dependency_graph(system).closure(unknown));
    if (has_charts(part.system)) {
        return {part.system, derivative, 0};
    }
    std::size_t leaf = 0;
    for (std::size_t k = 0; part.unknowns[k] != unknown; ++k) {
        leaf += static_cast<std::size_t>(part.system.unknowns()[k].order);
    }
    try {
        const polynomial_flow flow(part.system);
        if (flow.is_autonomous()) {
            const expression y = flow.unknown_at(leaf);
            if (auto found = equation_for(part.system, flow, y)) {
                return {*std::move(found), derivative, 0};
            }
            if (auto found = equation_for(part.system, flow, flow.slope_of(y))) {
                return {*std::move(found), derivative - 1, 0};
            }
        }
    } catch (const error&) {
        // without a polynomial form about the initial point, or an exact value there
    }
    if (part.system.unknowns().size() == 1) {
        return {part.system, derivative, 0};
    }
    // Lower derivatives are unknowns of the system.
    const auto k = static_cast<std::size_t>(std::ranges::find(part.unknowns, unknown) - part.unknowns.begin());
    const int lower = std::min(derivative, part.system.unknowns()[k].order - 1);
    return {part.system, derivative - lower, leaf + static_cast<std::size_t>(lower)};
}

}  // namespace libration::ode
