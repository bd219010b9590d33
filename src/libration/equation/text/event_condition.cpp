#include "event_condition.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "../still_value.hpp"
#include "libration/equation/identities.hpp"
#include "piecewise.hpp"

namespace libration::ode {

namespace {

const step_function* step_in(const equation_system& in, const std::string& parameter) {
    for (const step_function& each : in.steps) {
        const auto own = parameters_of(each, number());
        if (std::ranges::any_of(own, [&](const definition& of) { return of.name == parameter; })) {
            return &each;
        }
    }
    return nullptr;
}

// What an expression consists of, without names for expressions.
struct contents {
    bool variable = false;
    bool changing = false;  ///< an unknown with a nonzero slope
    bool kept = false;      ///< an unknown with the slope 0
    std::vector<const step_function*> steps = {};

    void add(const expression& e, const equation_system& in) {
        each_leaf(e, [&](const expression& leaf) {
            if (leaf.kind() == node_kind::variable) {
                variable = true;
            } else if (leaf.kind() == node_kind::unknown) {
                (has_zero_slope(in, leaf) ? kept : changing) = true;
            } else if (leaf.kind() == node_kind::parameter) {
                const auto named = std::ranges::find(in.parameters, leaf.name(), &definition::name);
                if (const step_function* const step = step_in(in, leaf.name())) {
                    steps.push_back(step);
                } else if (named != in.parameters.end()) {
                    add(named->value, in);
                }
            }
        });
    }

    static contents of(const expression& e, const equation_system& in) {
        contents found;
        found.add(e, in);
        return found;
    }

    bool by_resets_alone() const { return kept && !changing && !variable && steps.empty(); }
    bool of_steps_alone() const { return !steps.empty() && !changing && !variable; }
    bool of_variable_alone() const { return variable && !changing && !kept && steps.empty(); }
};

condition positive(const expression& difference, bool or_equal = false) {
    return {.kind = condition_kind::positive, .difference = difference, .or_equal = or_equal};
}

condition both(condition a, condition b) {
    condition made{.kind = condition_kind::all};
    made.parts = {std::move(a), std::move(b)};
    return made;
}

class event_reader {
public:
    event_reader(const state_event& like, equation_system& into)
        : like_(like), into_(into), steps_(into.steps, like.text, like.at) {}

    std::vector<state_event> events(const condition& of) {
        std::vector<state_event> all;
        condition others{.kind = condition_kind::any};
        for (const condition& each : of.kind == condition_kind::any ? of.parts : std::vector{of}) {
            if (each.kind == condition_kind::equal) {
                all.push_back(of_equation(each));
            } else {
                others.parts.push_back(each);
            }
        }
        if (!others.parts.empty()) {
            all.push_back(of_condition(others.parts.size() == 1 ? others.parts.front() : others));
        }
        const bool plain = of.kind == condition_kind::equal && !all.front().holds;
        if (like_.way != crossing::any && !plain) {
            refuse(like_.text, like_.at, "has a direction and a condition: write when x > 1, or when x = 1 up");
        }
        return all;
    }

private:
    state_event of_equation(const condition& each) {
        state_event made = like_;
        const contents in = contents::of(each.difference, into_);
        if (in.by_resets_alone() || in.of_steps_alone()) {
            made.holds = steps_.chosen(each, 1, 0);
        } else if (!in.steps.empty()) {
            const auto begins = multiples(each.difference, in);
            if (!begins) {
                refuse(like_.text, like_.at,
                       "has a piecewise function in an equation, which is supported as mod(t, 8) = 1 with numbers: "
                       "write the condition that begins to hold, as when mod(x, 8) < 1");
            }
            made.holds = steps_.chosen(*begins, 1, 0);
        } else {
            made.condition = each.difference;
        }
        return made;
    }

    state_event of_condition(const condition& each) {
        require_no_moment(each);
        state_event made = like_;
        const contents in = contents::of(each.difference, into_);
        if (each.kind == condition_kind::positive && in.steps.empty() && !in.by_resets_alone()) {
            made.condition = each.difference;
            made.way = crossing::up;
        } else {
            made.holds = steps_.chosen(each, 1, 0);
        }
        return made;
    }

    // t == 8 and x > 1.
    void require_no_moment(const condition& of) const {
        for (const condition& each : of.parts) {
            if (of.kind == condition_kind::all && each.kind == condition_kind::equal &&
                contents::of(each.difference, into_).of_variable_alone()) {
                refuse(like_.text, like_.at,
                       "joins a moment by `and`, where nothing happens: write when " + into_.variable +
                           " = 8 alone, or a condition that holds for some time, as " + into_.variable + " > 8");
            }
            require_no_moment(each);
        }
    }

    // For g = a(t) - b p, p = floor(u/d), with g = b frac(u/d) - b rho, u linear: the condition that begins to hold where
    // frac(u/d) is rho.
    std::optional<condition> multiples(const expression& g, const contents& in) {
        const step_function step = *in.steps.front();  // others are added to them
        const expression& u = step.argument;
        const bool one =
            std::ranges::all_of(in.steps, [&](const step_function* each) { return each == in.steps.front(); });
        if (!one || step.kind != step_kind::floor || in.changing || in.kept || u.has_unknowns() ||
            !contents::of(u, into_).of_variable_alone()) {
            return std::nullopt;
        }
        const auto at = [](const expression& e, const expression& leaf) {
            return replaced(e, [&](const expression& each) {
                return same_form(each, leaf) ? std::optional(expression()) : std::nullopt;
            });
        };
        const expression d(step.divisor);
        const expression a = at(g, parameter(step.parameter));
        const expression b = -partial(g, parameter(step.parameter));
        const expression slope = partial(u, variable());
        // b u, also for u = w/b and u = -w/b with a parameter b.
        const auto is_divisor = [&](const expression& e) {
            return u.kind() == node_kind::quotient && is_identically_zero(u.right() - e);
        };
        const expression whole = is_divisor(b) ? u.left() : is_divisor(-b) ? -u.left() : b * u;
        if (slope.has_variable() || b.has_variable() || b.is(0) ||
            !is_identically_zero(partial(a - whole / d, variable()))) {
            return std::nullopt;
        }
        const expression rho = at(u, variable()) / d - at(a, variable()) / b;
        const expression from_multiple = u - rho * d;
        const auto begins = [&](const expression& v) {
            return positive(d / 2 - (v - d * steps_.floor(v, step.divisor)));
        };
        if (slope.kind() == node_kind::constant && rho.kind() == node_kind::constant) {
            if (rho.constant().sign() < 0 || (rho.constant() - number(rational(1))).sign() >= 0) {
                refuse(like_.text, like_.at,
                       "has a remainder that mod does not take: write one from 0 to below the divisor");
            }
            return begins(slope.constant().sign() > 0 ? from_multiple : -from_multiple);
        }
        condition either{.kind = condition_kind::any};
        either.parts = {both(positive(slope), begins(from_multiple)), both(positive(-slope), begins(-from_multiple))};
        return both(both(positive(rho, true), positive(1 - rho)), std::move(either));
    }

    const state_event& like_;
    equation_system& into_;
    step_collector steps_;
};

}  // namespace

std::vector<state_event> events_when(const condition& holds, const state_event& like, equation_system& into) {
    return event_reader(like, into).events(holds);
}

}  // namespace libration::ode
