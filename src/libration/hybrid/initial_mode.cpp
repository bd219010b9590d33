#include "libration/hybrid/initial_mode.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "../equation/emptied_store.hpp"
#include "../equation/varied_value.hpp"
#include "branch_beginning.hpp"
#include "libration/equation/identities.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Of lists of values that are possible at one beginning.
constexpr std::size_t most_lists = 243;

number sign_number(int sign) { return number(rational(sign)); }

// Of values of step functions, which are integers.
bool is_same(const std::optional<number>& a, const number& b) { return a && *a->fraction() == *b.fraction(); }

// A list of values with the slopes of its branch.
struct possible_list {
    step_values values;
    std::vector<expression> slopes;
};

// The derivative along the branch of one list.
struct derivative_on {
    const possible_list* list;
    expression value;
    std::optional<int> sign;
};

class mode_search {
public:
    mode_search(const branch_beginning& at, const std::optional<step_values>& before,
                const std::vector<std::size_t>& crossed)
        : at_(at), system_(at.system()), before_(before), crossed_(crossed), found_(system_.steps().size()) {}

    initial_mode result() {
        step_values values(found_.size());
        for (bool more = true; more;) {
            more = false;
            for (std::size_t i = 0; i < found_.size(); ++i) {
                if (!found_[i] && has_arguments(i)) {
                    found_[i] = value_of(i);
                    more = more || found_[i];
                }
            }
        }
        decide_beside_surfaces();
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (!found_[i]) {
                return failed_at(i);
            }
            values[i] = *found_[i];
        }
        return verified(std::move(values));
    }

private:
    // Whether the steps in the argument are found.
    bool has_arguments(std::size_t i) const {
        bool known = true;
        each_leaf(system_.steps()[i].argument, [&](const expression& leaf) {
            if (leaf.kind() == node_kind::parameter) {
                known = known && found_[system_.step_of(leaf.name())];
            }
        });
        return known;
    }

    step_values found_values() const {
        step_values values(found_.size());
        for (std::size_t i = 0; i < found_.size(); ++i) {
            values[i] = found_[i].value_or(number());
        }
        return values;
    }

    // (1) for an argument that nothing changes on a branch.
    std::optional<number> kept_value(std::size_t i, const expression& u) const {
        if (!system_.is_kept(u) || is_varied(system_, u)) {
            return std::nullopt;
        }
        const auto exact = at_.exact_value(u);
        try {
            return exact ? std::optional(system_.step_value(i, *exact)) : std::nullopt;
        } catch (const error&) {  // a number that may be 0
            return std::nullopt;
        }
    }

    // (1) and (2) for an argument with these values of the steps in it.
    std::optional<number> plain_value(std::size_t i, const step_values& values) const {
        if (auto constant = system_.constant_step(i, values)) {
            return constant;
        }
        const expression u = system_.argument(i, values);
        if (const auto kept = kept_value(i, u)) {
            return kept;
        }
        if (system_.steps()[i].kind == step_kind::sign) {
            if (const auto sign = at_.sign(u); sign && *sign != 0) {
                return sign_number(*sign);
            }
        } else if (const auto near = at_.integers_of(u, system_.steps()[i].divisor); near && !near->at) {
            return near->below;
        }
        const bool crossed = std::ranges::find(crossed_, i) != crossed_.end();
        if (before_ && is_emptied((*before_)[i]) && !at_.is_reset(u) && !is_influenced_by_change(i, u)) {
            return (*before_)[i];  // no step that may change here influences it
        }
        if (before_ && !crossed && !system_.is_at_rest(i, *before_) && same_form(u, system_.argument(i, *before_)) &&
            !at_.is_reset(u)) {
            return (*before_)[i];
        }
        return std::nullopt;
    }

    // Whether another step that influences u is crossed, or its argument is reset.
    bool is_influenced_by_change(std::size_t i, const expression& u) const {
        const auto influences = system_.influences_on(u);
        for (std::size_t j = 0; j < influences.size(); ++j) {
            const bool crossed = std::ranges::find(crossed_, j) != crossed_.end();
            if (influences[j] && j != i && (crossed || at_.is_reset(system_.argument(j, *before_)))) {
                return true;
            }
        }
        return false;
    }

    // The function of which the sign decides between the value n and n - 1, or the sign, and n.
    struct zero_function {
        expression u;
        std::optional<number> level;
    };

    std::optional<zero_function> zero_function_of(std::size_t i, const step_values& values) const {
        const expression u = system_.argument(i, values);
        const step_function& of = system_.steps()[i];
        if (of.kind == step_kind::sign) {
            return zero_function{u, std::nullopt};
        }
        const auto near = at_.integers_of(u, of.divisor);
        return near ? std::optional(zero_function{u - expression(near->below * of.divisor), near->below})
                    : std::nullopt;
    }

    static number value_by(int sign, const zero_function& of) {
        return !of.level ? sign_number(sign) : sign < 0 ? *of.level - sign_number(1) : *of.level;
    }

    std::optional<number> value_of(std::size_t i) {
        const step_values values = found_values();
        if (auto plain = plain_value(i, values)) {
            return plain;
        }
        const auto zero = zero_function_of(i, values);
        if (!zero || at_.sign(zero->u) != 0) {
            return std::nullopt;
        }
        if (!zero->u.has_unknowns()) {
            const auto sign = at_.sign_after(zero->u);
            return sign ? std::optional(value_by(*sign, *zero)) : std::nullopt;
        }
        return value_by_derivatives(i, *zero);
    }

    // (3) and (4).
    std::optional<number> value_by_derivatives(std::size_t i, const zero_function& zero) {
        if (!find_lists(i, zero.u)) {
            if (std::ranges::any_of(slopes_, [](const auto& each) { return !each.second; })) {
                failures_[i] = mode_failure::not_continuous;
            }
            return std::nullopt;
        }
        expression now = zero.u;
        bool exactly = true;  // the functions are the same everywhere, not only where u is 0
        for (int order = 1; order <= branch_beginning::most_orders; ++order) {
            const auto derivatives = derivatives_of(now, exactly);
            if (!derivatives) {
                return std::nullopt;
            }
            const auto first_sign = derivatives->front().sign;
            const bool strict =
                first_sign && *first_sign != 0 &&
                std::ranges::all_of(*derivatives, [&](const derivative_on& each) { return each.sign == first_sign; });
            if (strict) {
                return value_by(*first_sign, zero);
            }
            const bool at_rest = std::ranges::all_of(
                *derivatives, [&](const derivative_on& each) { return vanishes_with(each.value, zero.u); });
            if (at_rest) {
                if (zero.level || is_in_another_argument(i)) {
                    return std::nullopt;
                }
                note_jump(i, zero.u);
                return sign_number(0);
            }
            note_failure(i, order, *derivatives);
            now = derivatives->front().value;
            const bool same = std::ranges::all_of(
                *derivatives, [&](const derivative_on& each) { return vanishes_with(each.value - now, zero.u); });
            exactly = exactly && std::ranges::all_of(*derivatives, [&](const derivative_on& each) {
                          return is_identically_zero(each.value - now);
                      });
            if (!same || at_.sign(now) != 0) {
                return std::nullopt;
            }
        }
        return std::nullopt;
    }

    // (5) and (6), for the steps that are not found, one after the other.
    void decide_beside_surfaces() {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (!found_[i]) {
                open.push_back(i);
            }
        }
        const step_values values = found_values();
        for (std::size_t j = 0; j < values.size(); ++j) {
            const expression u = system_.argument(j, values);
            if (found_[j] ? system_.is_at_rest(j, values)
                          : system_.steps()[j].kind != step_kind::sign || is_in_another_argument(j) ||
                                !u.has_unknowns() || at_.sign(u) != 0) {
                return;
            }
        }
        influences_.assign(found_.size(), true);
        while (!open.empty() && find_all_lists()) {
            if (!are_separate(open)) {
                const expression first = system_.argument(open.front(), values);
                const bool one_surface = std::ranges::all_of(
                    open, [&](std::size_t i) { return vanishes_with(system_.argument(i, values), first); });
                if (!one_surface) {
                    std::ranges::for_each(open, [&](std::size_t i) { failures_[i] = mode_failure::together; });
                }
                return;
            }
            const auto next = std::ranges::find_if(open, [&](std::size_t i) {
                found_[i] = value_beside_surface(i, open);
                return found_[i].has_value();
            });
            if (next == open.end()) {
                return;
            }
            open.erase(next);
        }
    }

    // The list in which one of the open steps has a value, the others 0.
    const possible_list& list_beside(const std::vector<std::size_t>& open, std::size_t i, const number& value) const {
        return *std::ranges::find_if(lists_, [&](const possible_list& each) {
            return std::ranges::all_of(
                open, [&](std::size_t j) { return is_same(each.values[j], j == i ? value : number()); });
        });
    }

    // Whether the slopes are sums of what each of these steps decides, the part of each with the value 0 being that on
    // one side, or the mean of both, identically.
    bool are_separate(const std::vector<std::size_t>& open) const {
        const auto& on = list_beside(open, open.front(), number()).slopes;
        for (const possible_list& each : lists_) {
            for (std::size_t k = 0; k < on.size(); ++k) {
                expression rest = each.slopes[k] - on[k];
                for (const std::size_t i : open) {
                    rest = rest - (list_beside(open, i, each.values[i]).slopes[k] - on[k]);
                }
                if (!is_identically_zero(rest)) {
                    return false;
                }
            }
        }
        return std::ranges::all_of(open, [&](std::size_t i) {
            return is_between(list_beside(open, i, sign_number(-1)).slopes, on,
                              list_beside(open, i, sign_number(1)).slopes);
        });
    }

    static bool is_between(const std::vector<expression>& below, const std::vector<expression>& on,
                           const std::vector<expression>& above) {
        return std::ranges::any_of(std::array{rational(0), rational(1), rational(1, 2)}, [&](const rational& share) {
            for (std::size_t k = 0; k < on.size(); ++k) {
                const expression mixed = below[k] + expression(share) * (above[k] - below[k]);
                if (!is_identically_zero(on[k] - mixed)) {
                    return false;
                }
            }
            return true;
        });
    }

    // Whether the derivative of u is the same for all values of the other steps.
    bool is_alone(std::size_t i, const expression& u, const std::vector<std::size_t>& open) const {
        const expression on = at_.derivative(u, list_beside(open, i, number()).slopes);
        return std::ranges::all_of(open, [&](std::size_t j) {
            return j == i || std::ranges::all_of(std::array{-1, 1}, [&](int side) {
                       const auto& slopes = list_beside(open, j, sign_number(side)).slopes;
                       return is_identically_zero(at_.derivative(u, slopes) - on);
                   });
        });
    }

    std::optional<number> value_beside_surface(std::size_t i, const std::vector<std::size_t>& open) {
        const expression u = system_.argument(i, found_values());
        const auto below = derivative_beside(u, list_beside(open, i, sign_number(-1)));
        const auto on = derivative_beside(u, list_beside(open, i, number()));
        const auto above = derivative_beside(u, list_beside(open, i, sign_number(1)));
        if (!below || !on || !above || !is_alone(i, u, open)) {
            return std::nullopt;
        }
        if (above->sign == below->sign && above->sign.value_or(0) != 0) {
            return sign_number(*above->sign);
        }
        const bool back_down = at_.sign_after(above->value) == -1 || vanishes_with(above->value, u);
        const bool back_up = at_.sign_after(below->value) == 1 || vanishes_with(below->value, u);
        if (back_down && back_up && (above->sign == -1 || below->sign == 1)) {
            return sliding_value();
        }
        for (const auto& [side, other] : {std::pair(&*above, &*below), std::pair(&*below, &*above)}) {
            const int sign = side == &*above ? 1 : -1;
            const bool leaves = side->sign == sign ||
                                (side->sign == 0 && at_.sign(at_.derivative(side->value, side->list->slopes)) == sign);
            if (leaves && side->sign == 0 && other->sign == sign) {
                return sign_number(sign);
            }
            if (leaves && open.size() == 1 && (vanishes_with(on->value, u) || vanishes_with(other->value, u))) {
                failures_[i] = mode_failure::several;
                return std::nullopt;
            }
        }
        failures_.emplace(i, mode_failure::undecided);
        return std::nullopt;
    }

    std::optional<derivative_on> derivative_beside(const expression& u, const possible_list& list) const {
        const expression value = at_.derivative(u, list.slopes);
        return at_.is_finite_near(value) ? std::optional(derivative_on{&list, value, at_.sign(value)}) : std::nullopt;
    }

    // Along the branches of all lists; std::nullopt if one is not finite near the beginning. With `beyond` the signs of
    // functions of the variable alone are those directly after it.
    std::optional<std::vector<derivative_on>> derivatives_of(const expression& of, bool beyond) const {
        std::vector<derivative_on> all;
        for (const possible_list& each : lists_) {
            const expression value = at_.derivative(of, each.slopes);
            if (!at_.is_finite_near(value)) {
                return std::nullopt;
            }
            all.push_back({&each, value, beyond ? at_.sign_after(value) : at_.sign(value)});
        }
        return all;
    }

    // What the signs of the derivatives on both sides of the surface of a sign mean.
    void note_failure(std::size_t i, int order, const std::vector<derivative_on>& derivatives) {
        if (system_.steps()[i].kind != step_kind::sign) {
            failures_[i] = mode_failure::undecided;
            return;
        }
        std::vector<side_of_surface> sides;
        for (const derivative_on& each : derivatives) {
            sides.push_back({each.list->values[i].sign(), each.sign});
        }
        failures_[i] = failure_at_surface(sides, order, derivatives.size() == 3);  // no other step function is open
    }

    // Whether the slopes of the state depend on the value of the sign, although its argument remains 0.
    void note_jump(std::size_t i, const expression& u) {
        influences_.assign(found_.size(), true);
        if (!find_all_lists()) {
            by_relation_.push_back(i);
            return;
        }
        const std::vector<expression>& first = lists_.front().slopes;
        const bool jumps = std::ranges::any_of(lists_, [&](const possible_list& each) {
            for (std::size_t k = 0; k < first.size(); ++k) {
                if (!vanishes_with(each.slopes[k] - first[k], u)) {
                    return true;
                }
            }
            return false;
        });
        if (jumps) {
            by_relation_.push_back(i);
        }
    }

    // The lists that are possible while the argument remains 0 have to be those at the beginning.
    bool is_in_another_argument(std::size_t i) const {
        return std::ranges::any_of(system_.steps(), [&](const step_function& each) {
            bool found = false;
            each_leaf(each.argument, [&](const expression& leaf) {
                found = found || (leaf.kind() == node_kind::parameter && system_.step_of(leaf.name()) == i);
            });
            return found;
        });
    }

    // All lists that are possible, with the slopes of their branches, as far as they influence the function, the argument
    // of the step i; other steps have one of their values.
    bool find_lists(std::size_t i, const expression& of) {
        influences_ = system_.influences_on(of);
        influences_[i] = true;
        return find_all_lists();
    }

    bool find_all_lists() {
        lists_.clear();
        step_values values(found_.size());
        if (!add_lists(0, values)) {
            lists_.clear();
        }
        return !lists_.empty();
    }

    bool add_lists(std::size_t j, step_values& values) {
        if (j == values.size()) {
            const auto& slopes = slopes_on(values);
            if (!slopes || lists_.size() >= most_lists) {
                return false;
            }
            lists_.push_back({values, *slopes});
            return true;
        }
        std::vector<number> candidates;
        if (found_[j]) {
            candidates.push_back(*found_[j]);
        } else if (const auto plain = plain_value(j, values)) {
            candidates.push_back(*plain);
        } else if (system_.steps()[j].kind == step_kind::sign) {
            candidates = {sign_number(-1), sign_number(0), sign_number(1)};
        } else if (const auto zero = zero_function_of(j, values)) {
            candidates = {*zero->level - sign_number(1), *zero->level};
        }
        if (candidates.empty() || !at_.is_finite_near(system_.argument(j, values))) {
            return false;
        }
        if (!influences_[j]) {
            candidates.resize(1);
        }
        return std::ranges::all_of(candidates, [&](const number& each) {
            values[j] = each;
            return add_lists(j + 1, values);
        });
    }

    const std::optional<std::vector<expression>>& slopes_on(const step_values& values) {
        std::vector<rational> key;
        std::ranges::transform(values, std::back_inserter(key), [](const number& each) { return *each.fraction(); });
        const auto known = slopes_.find(key);
        return known != slopes_.end() ? known->second
                                      : slopes_.emplace(std::move(key), at_.slopes_on(values)).first->second;
    }

    initial_mode failed_at(std::size_t i) const {
        const auto failure = failures_.find(i);
        return {std::nullopt, {}, failure == failures_.end() ? mode_failure::undecided : failure->second, i};
    }

    // Each step has the value of its argument on the branch that is entered.
    initial_mode verified(step_values values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (system_.is_sliding(i, values)) {
                continue;  // its argument is 0 along the branch by its equations
            }
            if (!is_same(plain_value(i, values), values[i]) && !is_same(value_on(i, values), values[i])) {
                return failed_at(i);
            }
        }
        return {std::move(values), std::move(by_relation_)};
    }

    // By the sign directly after the beginning of a function that is 0 there.
    std::optional<number> value_on(std::size_t i, const step_values& values) {
        const auto zero = zero_function_of(i, values);
        if (!zero) {
            return std::nullopt;
        }
        std::optional<int> sign;
        if (!zero->u.has_unknowns()) {
            sign = at_.sign_after(zero->u);
        } else if (const auto& slopes = slopes_on(values)) {
            const auto leading = at_.leading(zero->u, *slopes);
            sign = leading ? std::optional(leading->sign) : std::nullopt;
        }
        return sign ? std::optional(value_by(*sign, *zero)) : std::nullopt;
    }

    const branch_beginning& at_;
    const hybrid_system& system_;
    const std::optional<step_values>& before_;
    const std::vector<std::size_t>& crossed_;
    std::vector<std::optional<number>> found_;
    std::vector<possible_list> lists_;
    std::vector<bool> influences_;  // of each step on the argument that is decided
    std::map<std::vector<rational>, std::optional<std::vector<expression>>> slopes_;
    std::vector<std::size_t> by_relation_;
    std::map<std::size_t, mode_failure> failures_;
};

}  // namespace

initial_mode mode_after(const branch_beginning& beginning, const std::optional<step_values>& before,
                        const std::vector<std::size_t>& crossed) {
    return mode_search(beginning, before, crossed).result();
}

initial_mode mode_at_start(const hybrid_system& system) {
    const branch_beginning start(system);
    initial_mode found = mode_after(start);
    if (!found.values) {
        const std::string& text = system.steps()[found.step].text;
        if (const auto reason = start.reason_without_value(system.steps()[found.step].argument)) {
            throw error(error_kind::argument, error_subject::start, text,
                        "has no value at the initial point, where it " + *reason + ": choose another initial point");
        }
        throw error(error_kind::undecided, error_subject::start, text,
                    "begins on a switching surface: " + reason_of(found.failure, "") +
                        ": choose another initial point" +
                        (found.failure == mode_failure::undecided ? ", or write the condition in another form" : ""));
    }
    return found;
}

}  // namespace libration::ode
