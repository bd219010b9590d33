#include "libration/equation/parametric_system.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "libration/equation/dependency.hpp"
#include "libration/scalar/near_word.hpp"
#include "smooth_equations.hpp"

namespace libration::ode {

namespace {

// The parameters and initial values, for messages about a name that is none of them.
std::string remedy_for(const std::string& name, const equation_system& of) {
    constexpr std::size_t most_shown = 8;
    std::vector<std::string> own;
    std::ranges::transform(of.parameters, std::back_inserter(own), &definition::name);
    for (const start& each : of.starts) {
        own.push_back(name_of_start(each.of, each.point));
    }
    std::string list;
    for (std::size_t i = 0; i < own.size() && i < most_shown; ++i) {
        list += (i == 0 ? "" : ", ") + own[i];
    }
    return suggestion(name, own) + ": choose one of them, " + list + (own.size() > most_shown ? ", ..." : "");
}

// Replaces f''(0) = value by f''(0) = a parameter of that value.
std::string parameter_for_start(equation_system& made, const std::string& name, std::size_t index) {
    for (start& each : made.starts) {
        if (name.starts_with(primed(each.of.name(), each.of.derivative()) + "(")) {
            std::string parameter_name = "open number " + std::to_string(index);
            made.parameters.push_back({parameter_name, each.value, {}});
            each.value = parameter(parameter_name);
            return parameter_name;
        }
    }
    refuse(name, {}, "is not an initial value of the problem" + remedy_for(name, made));
}

class opening {
public:
    opening(equation_system given, std::vector<std::string> names) : made_(std::move(given)), names_(std::move(names)) {
        require_smooth_equations(made_);
        require_numbers(made_);
        made_.exact.clear();
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i].find('(') != std::string::npos) {
                names_[i] = parameter_for_start(made_, names_[i], i);
            }
            leaves_.push_back(unknown("y" + std::to_string(i)));
        }
        for (const std::string& each : names_) {
            values_.push_back(number_with_values(given_parameter(made_, each).value, made_));
        }
    }

    parametric_system result(const std::vector<expression>& others) {
        equation_system open = made_;
        parameter_values in_equations = values_with([&](std::size_t i) { return unknown(names_[i]); });
        for (auto* const list : {&open.equations, &open.invariants}) {
            for (equation& each : *list) {
                each.left = in_equations.in(each.left);
                each.right = in_equations.in(each.right);
            }
        }
        for (std::size_t i = 0; i < names_.size(); ++i) {
            open.add(derivative(unknown(names_[i])));
            open.begin(unknown(names_[i]), expression(values_[i]), made_.starts.front().point);
        }
        parametric_system made{explicit_system(open), values_, {}, leaves_, {}};
        if (!made.system.algebraic().empty()) {
            refuse("algebraic equations", {},
                   "are not supported with free parameters and initial values, which would have to satisfy them: write "
                   "the differential equations to which they lead");
        }
        parameter_values in_starts = values_with([&](std::size_t i) { return leaves_[i]; });
        for (const expression& each : others) {
            made.others.push_back(in_starts.in(each));
        }
        for (const unknown_function& each : made.system.unknowns()) {
            for (int j = 0; j < each.order; ++j) {
                made.starts.push_back(start_of(in_starts, each.name, j));
            }
        }
        return made;
    }

private:
    expression start_of(parameter_values& in_starts, const std::string& name, int order) const {
        const auto number_of = std::ranges::find(names_, name);
        if (number_of != names_.end()) {
            return leaves_[static_cast<std::size_t>(number_of - names_.begin())];
        }
        const auto at = std::ranges::find_if(
            made_.starts, [&](const start& s) { return s.of.name() == name && s.of.derivative() == order; });
        return in_starts.in(at->value);
    }

    // Parameters by their values, the free ones by the expressions that represent them.
    template <class For>
    parameter_values values_with(const For& stands_for) const {
        std::map<std::string, expression> open;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            open.emplace(names_[i], stands_for(i));
        }
        return parameter_values(made_, std::move(open));
    }

    equation_system made_;
    std::vector<std::string> names_;
    std::vector<number> values_;
    std::vector<expression> leaves_;
};

}  // namespace

const definition& given_parameter(const equation_system& of, const std::string& name) {
    if (of.is_open(name)) {
        refuse(name, {}, "has no first guess: write " + name + " = number in the problem");
    }
    const definition* const found = of.parameter_of(name);
    if (found == nullptr) {
        refuse(name, {}, "is neither a parameter nor an initial value of the problem" + remedy_for(name, of));
    }
    parameter_values values(of, {{name, unknown(name)}});
    for (const start& each : of.starts) {
        if (!values.in(each.point).is_constant()) {
            refuse(name, {}, "determines the initial point, which must not vary: write the initial point as a number");
        }
    }
    return *found;
}

parametric_system opened(const equation_system& given, const std::vector<std::string>& names,
                         const std::vector<expression>& others) {
    if (!given.delays.empty()) {
        const delayed_value& first = given.delays.front();
        refuse(primed(first.of.name(), first.of.derivative()), first.at,
               "is delayed, which is not supported for free numbers: leave it out");
    }
    return opening(given, names).result(others);
}

parametric_system closed_part(const parametric_system& of, const std::vector<std::string>& unknowns) {
    const closed_subsystem part = subsystem_with(of.system, unknowns);
    parametric_system result{part.system, of.values, {}, of.leaves, of.others};
    for (const std::size_t leaf : part.leaves) {
        result.starts.push_back(of.starts[leaf]);
    }
    return result;
}

}  // namespace libration::ode
