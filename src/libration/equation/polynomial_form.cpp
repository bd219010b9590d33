#include "libration/equation/polynomial_form.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "libration/equation/dependency.hpp"
#include "libration/function/list.hpp"
#include "signed_form.hpp"
#include "start_values.hpp"

namespace libration::ode {

namespace {

// Of a polynomial, and of a root.
constexpr int most_whole_power = 1'000'000;
constexpr int most_power_of_root = 64;

gradient gradient_of(const expression& e, const std::vector<expression>& leaves) {
    std::set<std::string> names;
    each_leaf(e, [&](const expression& leaf) { names.insert(leaf.name()); });
    gradient result;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        const expression by = names.contains(leaves[k].name()) ? partial(e, leaves[k]) : expression();
        if (!by.is(0)) {
            result.emplace_back(k, by);
        }
    }
    return result;
}

class lifting {
public:
    explicit lifting(const explicit_system& of, relative_functions as) : of_(of), as_(as) {}

    polynomial_form result() {
        std::vector<expression> right;
        for (const unknown_function& each : of_.unknowns()) {
            for (int j = 0; j < each.order; ++j) {
                given_.emplace(primed(each.name, j), add_leaf());
            }
        }
        for (std::size_t i = 0; i < of_.unknowns().size(); ++i) {
            const unknown_function& each = of_.unknowns()[i];
            for (int j = 1; j < each.order; ++j) {
                right.push_back(given_.at(primed(each.name, j)));
            }
            right.push_back(polynomial(of_.right()[i]));
        }
        slopes_.assign(right.begin(), right.end());
        const std::size_t given = right.size();
        for (std::size_t k = given; k < leaves_.size(); ++k) {  // a slope may add unknowns
            slope_of(k);
        }
        std::vector<expression> all;
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            all.push_back(slope_of(k));
        }
        std::vector<gradient> gradients;
        std::vector<gradient> polynomial_gradients;
        for (std::size_t k = 0; k < added_.size(); ++k) {
            gradients.push_back(gradient_of(added_[k], leaves_));
            auto& row = polynomial_gradients.emplace_back(gradient_of(argument_of(added_[k]), leaves_));
            for (auto& [place, by] : row) {
                by = rate(added_[k], leaves_[given + k]) * by;
            }
        }
        return {explicit_system::first_order(leaves_, std::move(all), of_.point()),
                given,
                std::move(added_),
                std::move(gradients),
                leaves_,
                std::move(polynomial_gradients),
                has_functions_};
    }

private:
    expression add_leaf() {
        leaves_.push_back(unknown("y" + std::to_string(leaves_.size())));
        return leaves_.back();
    }

    // The unknown that is this function of those before it.
    expression added(const expression& definition) {
        const std::size_t given = leaves_.size() - added_.size();
        for (std::size_t k = 0; k < added_.size(); ++k) {
            if (same_form(added_[k], definition)) {
                return leaves_[given + k];
            }
        }
        added_.push_back(definition);
        return add_leaf();
    }
    expression inverse(const expression& u) { return u.is_constant() ? 1 / u : added(expression(1) / u); }

    // The polynomial form of an expression in the given unknowns.
    expression polynomial(const expression& e) {
        return done_.of(e, [this](const expression& each) {
            return each.kind() == node_kind::unknown ? given_.at(primed(each.name(), each.derivative()))
                                                     : converted(each, done_);
        });
    }

    // The polynomial form of an expression in leaves.
    expression in_leaves(const expression& e) {
        node_values<expression> done;
        return done.of(e, [&](const expression& each) { return converted(each, done); });
    }

    expression converted(const expression& e, const node_values<expression>& done) {
        switch (e.kind()) {
            case node_kind::sum: return done.at(e.left()) + done.at(e.right());
            case node_kind::product: return signed_product(done.at(e.left()), done.at(e.right()));
            case node_kind::quotient: return signed_product(done.at(e.left()), inverse(done.at(e.right())));
            case node_kind::power: return power_of(done.at(e.left()), e.right());
            case node_kind::function: return function_of(e, done.at(e.left()));
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        return e;
    }

    // u^(a/b) with p = u^(-1/b) is u^k p^(b k - a), k the least integer >= max(0, a/b).
    expression power_of(const expression& u, const expression& exponent) {
        if (u.is_constant()) {
            return pow(u, exponent);
        }
        const auto r = exponent.fraction();
        const bool whole = r && denominator(*r) == 1;
        if (!r || abs(numerator(*r)) > (whole ? most_whole_power : most_power_of_root) || denominator(*r) > 6) {
            return added(pow(u, exponent));
        }
        const int a = static_cast<int>(numerator(*r));
        const int b = static_cast<int>(denominator(*r));
        if (b == 1) {
            return a >= 0 ? signed_power(u, exponent, a) : pow(inverse(u), expression(-a));
        }
        const expression p = added(pow(u, expression(rational(-1, b))));
        const int k = a < 0 ? 0 : (a + b - 1) / b;
        return pow(u, expression(k)) * pow(p, expression(b * k - a));
    }

    expression function_of(const expression& e, const expression& u) {
        if (u.is_constant()) {
            return with_argument(e, u);
        }
        return function::with_function(e.function(), [&](auto of) -> expression {
            using each = decltype(of);
            if constexpr (function::in_table<each>) {
                if (as_ == relative_functions::divided) {
                    return in_leaves(each::by_division(e.order(), u));
                }
                has_functions_ = true;
                return with_argument(e, u);
            } else if constexpr (requires { each::in_others(u); }) {
                return in_leaves(each::in_others(u));
            } else {
                return added(with_argument(e, u));
            }
        });
    }

    // The derivative of unknown k along the solution, in terms of the unknowns.
    expression slope_of(std::size_t k) {
        slopes_.resize(std::max(slopes_.size(), leaves_.size()));
        if (!slopes_[k]) {
            const std::size_t given = leaves_.size() - added_.size();
            // Copies, because a slope may add unknowns, which reallocates the lists.
            const expression definition = added_[k - given];
            const expression leaf = leaves_[k];
            const expression made = slope(definition, leaf);
            slopes_.resize(std::max(slopes_.size(), leaves_.size()));
            slopes_[k] = made;
        }
        return *slopes_[k];
    }

    expression slope_of(const expression& u) {
        expression sum = partial(u, variable());
        for (const auto& [k, by] : gradient_of(u, leaves_)) {
            sum = sum + by * slope_of(k);
        }
        return sum;
    }

    static const expression& argument_of(const expression& w) {
        return w.kind() == node_kind::quotient ? w.right() : w.left();
    }

    expression slope(const expression& w, const expression& leaf) {
        const expression du = slope_of(argument_of(w));
        return w.kind() == node_kind::quotient ? -(leaf * leaf * du) : rate(w, leaf) * du;
    }

    // The derivative of a function, whose leaf is given, with respect to its argument, in leaves.
    expression rate(const expression& w, const expression& leaf) {
        const expression& u = argument_of(w);
        if (w.kind() == node_kind::quotient) {
            return -(leaf * leaf);
        }
        if (w.kind() == node_kind::power) {
            const auto r = w.right().fraction();
            if (r && numerator(*r) == -1) {
                return w.right() * pow(leaf, expression(1 + static_cast<int>(denominator(*r))));
            }
            return w.right() * leaf * inverse(u);
        }
        const expression by_argument = function::with_function(w.function(), [&](auto of) -> expression {
            using each = decltype(of);
            if constexpr (function::ordered<each>) {
                return each::derivative(w.order(), u, leaf);
            } else {
                return each::derivative(u, leaf);
            }
        });
        return in_leaves(by_argument);
    }

    const explicit_system& of_;
    relative_functions as_;
    bool has_functions_ = false;
    std::map<std::string, expression> given_;
    std::vector<expression> leaves_, added_;
    std::vector<std::optional<expression>> slopes_;
    node_values<expression> done_;
};

function::analytic_form form_of(const expression& e) {
    return function::with_function(e.function(), [&](auto of) {
        using each = decltype(of);
        if constexpr (function::ordered<each>) {
            if (!function::is_whole(e.order())) {
                return function::analytic_form::several_values;
            }
        }
        return each::form;
    });
}

// Whether a function is single-valued; square roots are powers here.
bool has_one_value(const expression& e) {
    return e.kind() == node_kind::quotient ||
           (e.kind() == node_kind::function && form_of(e) != function::analytic_form::several_values);
}

// Whether it is entire in the variable, if its unknowns are.
bool is_entire(const expression& whole) {
    node_values<bool> done;
    return done.of(whole, [&](const expression& e) {
        switch (e.kind()) {
            case node_kind::sum:
            case node_kind::product: return done.at(e.left()) && done.at(e.right());
            case node_kind::quotient: return false;  // a division by a constant is a product
            case node_kind::power: {
                const auto exponent = e.right().fraction();
                return done.at(e.left()) && exponent && denominator(*exponent) == 1 && *exponent >= 0;
            }
            case node_kind::function: return form_of(e) == function::analytic_form::entire && done.at(e.left());
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        return true;
    });
}

// Linear in the leaves of the component itself; the others are entire functions of the variable by themselves.
template <class IsOwn>
bool is_linear_with_entire_coefficients(const expression& right, const IsOwn& is_own) {
    std::vector<expression> own;
    each_leaf(right, [&](const expression& leaf) {
        if (is_own(leaf)) {
            own.push_back(leaf);
        }
    });
    for (const expression& leaf : own) {
        const expression by = partial(right, leaf);
        bool holds_own = false;
        each_leaf(by, [&](const expression& other) { holds_own = holds_own || is_own(other); });
        if (holds_own || !is_entire(by)) {
            return false;
        }
    }
    return is_entire(replaced(
        right, [&](const expression& leaf) { return is_own(leaf) ? std::optional(expression(0)) : std::nullopt; }));
}

// The system with the unknowns at `given` first, which have no definitions, and then the others, which are
// functions of those before them.
polynomial_form with_given(const polynomial_form& all, const std::vector<std::size_t>& given,
                           const std::vector<std::size_t>& others) {
    std::vector<std::size_t> order = given;
    order.insert(order.end(), others.begin(), others.end());
    std::vector<std::size_t> new_places(order.size());
    std::vector<expression> leaves;
    std::vector<expression> right;
    for (std::size_t i = 0; i < order.size(); ++i) {
        new_places[order[i]] = i;
        leaves.push_back(all.leaves[order[i]]);
        right.push_back(all.system.right()[order[i]]);
    }
    std::vector<expression> added;
    std::vector<gradient> gradients;
    for (const std::size_t each : others) {
        added.push_back(all.added[each - all.given]);
        gradient by = all.gradients[each - all.given];
        for (auto& [k, derivative] : by) {
            k = new_places[k];
        }
        gradients.push_back(std::move(by));
    }
    return {explicit_system::first_order(leaves, std::move(right), all.system.point()), given.size(), std::move(added),
            std::move(gradients), leaves};
}

// Points where a function has a series but its derivative divides by its argument.
function::singular_points points_without_form(function_kind f) {
    return function::with_function(f, [](auto of) {
        if constexpr (requires { of.without_polynomial_form; }) {
            return function::singular_points(of.without_polynomial_form);
        } else {
            return function::no_points;
        }
    });
}

void require_polynomial_form(const explicit_system& of, relative_functions as) {
    start_values values(leaves_at_start(of));
    node_values<bool> done;
    const auto check = [&](const expression& e) {
        const bool divided = e.kind() == node_kind::function && as == relative_functions::divided;
        const auto points = divided ? points_without_form(e.function()) : function::no_points;
        for (int i = 0; i < points.count; ++i) {
            const auto x = values.refusal_of(e.left()) ? std::nullopt : values.value_of(e.left()).fraction();
            if (x && *x == points.points[static_cast<std::size_t>(i)]) {
                refuse("", {},
                       std::string("has an initial point where it ") + points.reason +
                           ", which proofs by polynomials, as certificates, require: choose another initial point");
            }
        }
        return true;
    };
    for (const expression& right : of.right()) {
        done.of(right, check);
    }
}

}  // namespace

path_form lifted_for_paths(const explicit_system& of) {
    polynomial_form all = lifted(of);
    std::vector<std::size_t> places(all.given);
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::vector<std::size_t> recomputed;
    for (std::size_t k = 0; k < all.added.size(); ++k) {
        (has_one_value(all.added[k]) ? recomputed : places).push_back(all.given + k);
    }
    if (places.size() == all.given) {
        return {std::move(all), std::move(places)};
    }
    return {with_given(all, places, recomputed), places};
}

bool has_entire_solutions(const explicit_system& of) {
    if (of.singular()) {
        return false;
    }
    const dependency_graph graph(of);
    return std::ranges::all_of(graph.strong_components(), [&](const std::vector<std::size_t>& component) {
        const auto is_own = [&](const expression& leaf) {
            return leaf.kind() == node_kind::unknown &&
                   std::ranges::any_of(component, [&](std::size_t i) { return of.unknowns()[i].name == leaf.name(); });
        };
        return std::ranges::all_of(
            component, [&](std::size_t i) { return is_linear_with_entire_coefficients(of.right()[i], is_own); });
    });
}

polynomial_form lifted(const explicit_system& of, relative_functions as) {
    if (of.singular()) {
        refuse("", {}, "has a singular initial point, which is not supported by proofs: choose another initial point");
    }
    require_polynomial_form(of, as);
    return lifting(of, as).result();
}

polynomial_form lifted_about_points(const explicit_system& of) {
    return lifting(of, relative_functions::divided).result();
}

explicit_system with_variations(const polynomial_form& of) {
    const std::size_t count = of.leaves.size();
    std::vector<expression> leaves = of.leaves;
    std::vector<expression> right = of.system.right();
    const auto variation = [&](std::size_t i, std::size_t j) {
        return unknown("v" + std::to_string(i) + "_" + std::to_string(j));
    };
    std::vector<gradient> gradients;
    for (const expression& each : of.system.right()) {
        gradients.push_back(gradient_of(each, of.leaves));
    }
    for (std::size_t j = 0; j < of.given; ++j) {
        for (std::size_t i = 0; i < count; ++i) {
            expression sum;
            for (const auto& [k, by] : gradients[i]) {
                sum = sum + by * variation(k, j);
            }
            leaves.push_back(variation(i, j));
            right.push_back(sum);
        }
    }
    return explicit_system::first_order(leaves, std::move(right), of.system.point());
}

}  // namespace libration::ode
