#include "libration/equation/equation_system.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "libration/equation/choice.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/utf8.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_shown_names = 8;

std::vector<std::string> parameters_in(const expression& e) {
    std::vector<std::string> names;
    if (e.has_parameters()) {
        each_leaf(e, [&](const expression& leaf) {
            if (leaf.kind() == node_kind::parameter) {
                names.push_back(leaf.name());
            }
        });
    }
    return names;
}

[[noreturn]] void refuse_set(const number_set& set) {
    refuse(
        set.name, set.at,
        "is a set of values, which is supported for enclosures at times, over spans of time and at events (reference "
        "--time, --over, --until) alone: give it one number");
}

}  // namespace

std::string beginning_of(const std::string& text) {
    constexpr std::size_t shown = 60;
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size(); ++count) {
        if (count == shown) {
            return text.substr(0, end) + "...";
        }
        end += std::max<std::size_t>(bytes_of_character(std::string_view(text).substr(end)), 1);
    }
    return text;
}

void refuse(const std::string& what, const place& at, const std::string& reason) {
    const std::string where =
        at.line == 0 ? "" : "at line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + " ";
    throw error(error_kind::argument, error_subject::problem, beginning_of(what), where + reason);
}

std::vector<definition> parameters_of(const step_function& step, const number& value) {
    std::vector<definition> all{{step.parameter, expression(value), step.at}};
    if (step.kind == step_kind::sign) {
        const int sign = value.sign();
        all.push_back({name_of_positive(step.parameter), expression(sign > 0 ? 1 : 0), step.at});
        all.push_back({name_of_nonnegative(step.parameter), expression(sign >= 0 ? 1 : 0), step.at});
    }
    return all;
}

std::map<std::string, expression> kept_steps(const std::vector<step_function>& steps) {
    std::map<std::string, expression> kept;
    for (const step_function& each : steps) {
        for (const definition& of : parameters_of(each, number())) {
            kept.emplace(of.name, parameter(of.name));
        }
    }
    return kept;
}

equation_system& equation_system::add(const expression& left, const expression& right) {
    equations.push_back({left, right, {}});
    return *this;
}

equation_system& equation_system::begin(const expression& of, const expression& value, const expression& point) {
    starts.push_back({of, point, value, {}});
    return *this;
}

expression equation_system::delayed(const expression& of, const expression& delay, const place& at) {
    for (const delayed_value& each : delays) {
        if (same_form(each.of, of) && same_form(each.delay, delay)) {
            return parameter(each.parameter);
        }
    }
    delays.push_back({"delayed " + std::to_string(delays.size() + 1), of, delay, at});  // not a name that can be typed
    return parameter(delays.back().parameter);
}

equation_system& equation_system::before(const expression& of, const expression& value, const expression& point) {
    const auto found = std::ranges::find(histories, of.name(), &history::unknown);
    if (found != histories.end()) {
        *found = {of.name(), point, value, {}};
    } else {
        histories.push_back({of.name(), point, value, {}});
    }
    return *this;
}

equation_system& equation_system::set(const std::string& name, const expression& value) {
    const auto found = std::ranges::find(parameters, name, &definition::name);
    if (found != parameters.end()) {
        found->value = value;
    } else {
        parameters.push_back({name, value, {}});
        std::erase_if(open, [&](const open_parameter& each) { return each.name == name; });
        std::erase_if(sets, [&](const number_set& each) { return each.name == name; });
    }
    return *this;
}

equation_system& equation_system::set_to_text(const std::string& name, std::string_view value) {
    return set(name, expression(as_exact_real(read_exact(value))));
}

equation_system& equation_system::set_between(const std::string& name, const expression& lower,
                                              const expression& upper) {
    std::erase_if(parameters, [&](const definition& each) { return each.name == name; });
    std::erase_if(open, [&](const open_parameter& each) { return each.name == name; });
    std::erase_if(sets, [&](const number_set& each) { return each.name == name; });
    sets.push_back({name, lower, upper, {}});
    return *this;
}

equation_system& equation_system::begin_between(const expression& of, const expression& lower, const expression& upper,
                                                const expression& point) {
    const std::string name = name_of_start(of, point);
    return set_between(name, lower, upper).begin(of, parameter(name), point);
}

std::vector<std::string> equation_system::unknowns() const {
    std::vector<std::string> names;
    std::set<std::string> known;
    const auto add = [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown && known.insert(leaf.name()).second) {
            names.push_back(leaf.name());
        }
    };
    // A left-hand side that is an unknown or a derivative names the unknown of its equation.
    if (std::ranges::all_of(equations, [](const equation& each) { return each.left.kind() == node_kind::unknown; })) {
        std::ranges::for_each(equations, [&](const equation& each) { add(each.left); });
    }
    for (const equation& each : equations) {
        each_leaf(each.left, add);
        each_leaf(each.right, add);
    }
    return names;
}

const definition* equation_system::parameter_of(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &definition::name);
    return found == parameters.end() ? nullptr : &*found;
}

const number_set* equation_system::set_of(const std::string& name) const {
    const auto found = std::ranges::find(sets, name, &number_set::name);
    return found == sets.end() ? nullptr : &*found;
}

bool equation_system::is_open(const std::string& name) const {
    return std::ranges::find(open, name, &open_parameter::name) != open.end();
}

bool equation_system::has_parameter(const std::string& name) const {
    return parameter_of(name) != nullptr || set_of(name) != nullptr || is_open(name);
}

std::map<std::string, int> equation_system::highest_derivatives() const {
    std::map<std::string, int> highest;
    for (const equation& each : equations) {
        for (const expression* side : {&each.left, &each.right}) {
            each_leaf(*side, [&](const expression& leaf) {
                if (leaf.kind() == node_kind::unknown) {
                    int& of_unknown = highest[leaf.name()];
                    of_unknown = std::max(of_unknown, leaf.derivative());
                }
            });
        }
    }
    return highest;
}

int equation_system::order_of(const std::string& unknown) const {
    const auto highest = highest_derivatives();
    const auto found = highest.find(unknown);
    return found == highest.end() ? 0 : std::max(found->second, 1);
}

bool equation_system::is_algebraic(const std::string& unknown) const {
    const auto highest = highest_derivatives();
    const auto found = highest.find(unknown);
    return found != highest.end() && found->second == 0;
}

std::string name_of_start(const expression& of, const expression& point) {
    return primed(of.name(), of.derivative()) + "(" + (point.fraction() ? point.fraction()->str() : "...") + ")";
}

void require_numbers(const equation_system& system) {
    if (!system.sets.empty()) {
        refuse_set(system.sets.front());
    }
}

parameter_values::parameter_values(const equation_system& system, std::map<std::string, expression> open)
    : system_(system), values_(std::move(open)) {
    for (const definition& each : system.parameters) {
        definitions_.emplace(each.name, known_definition{&each});
    }
}

expression parameter_values::in(const expression& e) {
    for (const std::string& name : parameters_in(e)) {
        find(name);
    }
    return substituted(e);
}

number parameter_values::number_of(const expression& e) {
    const expression value = in(e);
    if (value.kind() != node_kind::constant) {
        const auto names = parameters_in(e);
        refuse(names.empty() ? "" : names.front(), {}, "depends on the solution or on time here: give a number");
    }
    return value.constant();
}

expression parameter_values::substituted(const expression& e) const {
    return with_parameters(e, [&](const std::string& name) { return std::optional(values_.at(name)); });
}

// Depth first without recursion: each definition in `open_` needs the one after it.
void parameter_values::find(const std::string& name) {
    for (const opened_definition& each : open_) {  // left by a call that threw
        definitions_.at(each.of->name).open = false;
    }
    open_.clear();
    open(name);
    while (!open_.empty()) {
        opened_definition& last = open_.back();
        if (last.next < last.needs.size()) {
            open(std::string(last.needs[last.next++]));
            continue;
        }
        values_.emplace(last.of->name, substituted(last.of->value));
        open_.pop_back();
    }
}

void parameter_values::open(const std::string& name) {
    if (values_.contains(name)) {
        return;
    }
    const auto found = definitions_.find(name);
    if (found == definitions_.end()) {
        if (const number_set* const set = system_.set_of(name)) {
            refuse_set(*set);
        }
        for (const step_function& each : system_.steps) {
            if (name.starts_with(each.parameter)) {
                refuse(each.text, each.at,
                       "is piecewise, which is supported only in equations: write one of its branches");
            }
        }
        const auto at = std::ranges::find(system_.open, name, &open_parameter::name);
        refuse(name, at != system_.open.end() ? at->at : place(),
               "has no value: write " + name + " = number for a parameter, " + name + "' = ... for an unknown");
    }
    if (!found->second.open) {
        found->second.open = true;
        open_.push_back({found->second.of, parameters_in(found->second.of->value)});
        return;
    }
    std::string circle;
    for (std::size_t i = 0; i < std::min(open_.size(), most_shown_names); ++i) {
        circle += open_[i].of->name + " -> ";
    }
    refuse(name, found->second.of->at,
           "needs itself: " + circle + (open_.size() > most_shown_names ? "... -> " : "") + name +
               ": give one of them a number");
}

expression with_values(const expression& e, const equation_system& system) { return parameter_values(system).in(e); }

number number_with_values(const expression& e, const equation_system& system) {
    return parameter_values(system).number_of(e);
}

}  // namespace libration::ode
