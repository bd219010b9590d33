// The polynomial form of a system, of first order with additional unknowns: the bounds of theorem T (expansion/tail_bound.hpp) apply to it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/equation/function_value.hpp"
#include "libration/equation/node_values.hpp"

namespace libration::ode {

/// The unknowns that an expression depends on, with its derivatives with respect to them.
using gradient = std::vector<std::pair<std::size_t, expression>>;

/// y' = f(t, y), f polynomial. The first unknowns are those of the given system with their lower derivatives, in order;
/// each of the others is a function of those before it: e = exp u has e' = e u', any function the derivative given in
/// its file; q = 1/u has q' = -q^2 u', l = log u has l' = q u', p = u^(-1/b) has p' = -(1/b) p^(b+1) u', any other
/// power p' = r p q u'. The solution of the given system is part of the solution of this one as long as the latter
/// exists: 1/u, log u and powers need u != 0.
struct polynomial_form {
    explicit_system system;
    /// Number of given unknowns.
    std::size_t given = 0;
    /// Definitions of the others, in the unknowns before them and the variable.
    std::vector<expression> added;
    /// Their derivatives with respect to those.
    std::vector<gradient> gradients;
    /// leaves[k] is the leaf of unknown k.
    std::vector<expression> leaves;
    /// The derivatives of `gradients` as polynomials in all unknowns; empty in a path_form.
    std::vector<gradient> polynomial_gradients = {};
    /// Whether relative functions occur in it (relative_functions::kept).
    bool has_functions = false;
};

/// What becomes of exprel, cosrel and sinc, which have no polynomial form about a zero of their argument: divisions by
/// the argument, or functions that remain in the right-hand sides, where theorem T bounds them (expansion/tail_bound.hpp).
enum class relative_functions { divided, kept };

/// Throws error if the initial point is singular: the system has no polynomial form about it.
polynomial_form lifted(const explicit_system& of, relative_functions as = relative_functions::divided);
/// The same for a system without initial values.
polynomial_form lifted_about_points(const explicit_system& of);

/// The polynomial form for paths in the complex t-plane: functions of several values (logarithms, roots, inverse
/// functions) count as given, after the given unknowns, and are continued along the path instead of being recomputed
/// from an argument that may have gone around a branch point. The others are recomputed: continued by q' = -q^2 u', 1/u
/// would keep a constant error, however small u becomes.
struct path_form {
    polynomial_form lifted;
    /// The index of each of its given unknowns among all those of lifted(of).
    std::vector<std::size_t> places;

    /// Its given unknowns from all those of lifted(of).
    template <class R>
    std::vector<R> given_of(const std::vector<R>& all) const {
        std::vector<R> result;
        for (const std::size_t place : places) {
            result.push_back(all[place]);
        }
        return result;
    }
};

path_form lifted_for_paths(const explicit_system& of);

/// Whether every solution is analytic in the whole plane by the form of the equations: the right-hand sides of each
/// strongly connected component are of degree 1 in its own unknowns, with coefficients that are polynomials,
/// exponentials, sines and cosines of the variable and of the unknowns of preceding components, which are themselves
/// entire functions of it.
bool has_entire_solutions(const explicit_system& of);

/// The polynomial form with the derivatives of its unknowns with respect to the given ones at some point, column by
/// column after the unknowns: v_ij' = sum_k df_i/dy_k v_kj.
explicit_system with_variations(const polynomial_form& of);

/// The value of an expression for values of its unknowns y_k = leaves[k] and of the variable, in any field; on balls an
/// enclosure. Throws error if a function is not available in R.
template <field R>
class expression_values {
public:
    expression_values(const std::vector<expression>& leaves, R variable) : variable_(std::move(variable)) {
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            indices_.emplace(leaves[k].name(), k);
        }
    }

    /// Appends the value of the next unknown.
    void push_back(const R& value) { values_.push_back(value); }
    const std::vector<R>& values() const { return values_; }

    R of(const expression& e) {
        return done_.of(e, [this](const expression& each) { return computed(each); });
    }

private:
    R computed(const expression& e) {
        switch (e.kind()) {
            case node_kind::constant: return constant_value<R>::of(e.constant());
            case node_kind::variable: return variable_;
            case node_kind::sum: return R(done_.at(e.left()) + done_.at(e.right()));
            case node_kind::product: return R(done_.at(e.left()) * done_.at(e.right()));
            case node_kind::quotient: return R(done_.at(e.left()) / done_.at(e.right()));
            case node_kind::power: return raised(e);
            case node_kind::function: return of_function(e);
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        return values_[indices_.at(e.name())];
    }

    R of_function(const expression& e) {
        const rational order = e.order();
        return function_value<R>(e.function(), done_.at(e.left()), &order);
    }

    // Integer powers by products, so that any base is possible.
    R raised(const expression& e) {
        const R& base = done_.at(e.left());
        const auto exponent = e.right().fraction();
        constexpr int largest = 1'000'000;
        if (!exponent || denominator(*exponent) != 1 || abs(numerator(*exponent)) > largest) {
            return power_value<R>(base, done_.at(e.right()));
        }
        const R result = whole_power(base, static_cast<int>(abs(numerator(*exponent))));
        return *exponent < 0 ? R(R(1) / result) : result;
    }

    // One factor after the other up to 64, by squares beyond.
    static R whole_power(const R& base, int n) {
        constexpr int few = 64;
        R result(1);
        if (n > few) {
            const R half = whole_power(base, n / 2);
            result = R(half * half);
            n %= 2;
        }
        for (; n > 0; --n) {
            result = R(result * base);
        }
        return result;
    }

    R variable_;
    std::map<std::string, std::size_t> indices_;
    std::vector<R> values_;
    node_values<R> done_;
};

/// All unknowns of the polynomial form from the given ones at a time, in any field; on balls enclosures.
template <field R>
std::vector<R> lifted_values(const polynomial_form& of, const R& time, const std::vector<R>& given) {
    expression_values<R> values(of.leaves, time);
    for (const R& each : given) {
        values.push_back(each);
    }
    for (const expression& each : of.added) {
        values.push_back(values.of(each));
    }
    return values.values();
}

/// lifted_values() and, column by column, their derivatives with respect to the given ones.
template <field R>
std::vector<R> varied_values(const polynomial_form& of, const R& time, const std::vector<R>& given) {
    std::vector<R> result = lifted_values(of, time, given);
    const std::size_t count = result.size();
    expression_values<R> values(of.leaves, time);
    for (const R& each : std::vector<R>(result)) {
        values.push_back(each);
    }
    for (std::size_t j = 0; j < of.given; ++j) {
        std::vector<R> derivatives;
        for (std::size_t i = 0; i < count; ++i) {
            if (i < of.given) {
                derivatives.emplace_back(i == j ? 1 : 0);
                continue;
            }
            R sum(0);
            for (const auto& [k, by] : of.gradients[i - of.given]) {
                sum += values.of(by) * derivatives[k];
            }
            derivatives.push_back(sum);
        }
        result.insert(result.end(), derivatives.begin(), derivatives.end());
    }
    return result;
}

}  // namespace libration::ode
