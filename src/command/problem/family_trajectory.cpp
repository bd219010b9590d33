#include "family_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include "libration/expansion/invariant.hpp"
#include "libration/integration/taylor/batch_march.hpp"
#include "libration/integration/taylor/varied_problem.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/precision_scope.hpp"
#include "problem_trajectory.hpp"
#include "run/ending_signal.hpp"
#include "run/parallel.hpp"
#include "text/members.hpp"

namespace libration {

namespace {

constexpr long digits_of_double = 20;  // beyond those that are printed
constexpr std::size_t members_together = 256;

// The problem with the values of the lists as variables, if these may vary.
std::optional<ode::varied_problem> varied_problem_of(const family_member& first) {
    const ode::equation_system equations = first.problem.equations();
    std::vector<std::string> names;
    std::ranges::transform(first.values, std::back_inserter(names), [](const auto& each) { return each.first; });
    try {
        return ode::varied_problem(equations, names);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument) {
            throw;
        }
        return {};
    }
}

template <class R>
R value_of(const exact& value) {
    return ode::constant_value<R>::of(constants_of({value}).front());
}

template <class R>
std::vector<R> varied_values(const family_member& member) {
    std::vector<R> values;
    for (const auto& [name, text] : member.values) {
        values.push_back(value_of<R>(read_exact(text)));
    }
    return values;
}

// The changes of the invariants of members since their initial points, as the solution of each one alone has them.
class drifts_of_members {
public:
    explicit drifts_of_members(const ode::varied_problem& varied) : varied_(varied), constant_(varied.system()) {}

    /// values[time][component], in the order of names_of_state without the names.
    std::vector<std::string> of(const family_member& member, const std::vector<exact>& times,
                                std::span<const double> values) {
        std::vector<mpfr> state = varied_.state_of(varied_values<mpfr>(member));
        constant_.begin_at(ode::constant_value<mpfr>::of(varied_.system().point()), by_unknowns(state));
        std::vector<std::string> drifts;
        for (const exact& time : times) {
            for (std::size_t i = 0; i < state.size(); ++i) {
                if (!varied_.parameters()[i]) {
                    state[i] = widen(values.front());
                    values = values.subspan(1);
                }
            }
            drifts.push_back(to_decimal(constant_.drift(value_of<mpfr>(time), by_unknowns(state)), digits_of_drift));
        }
        return drifts;
    }

private:
    ode::solution_state<mpfr> by_unknowns(const std::vector<mpfr>& state) const {
        ode::solution_state<mpfr> grouped;
        auto next = state.begin();
        for (const auto& each : varied_.system().unknowns()) {
            grouped.emplace_back(next, next + each.order);
            next += each.order;
        }
        return grouped;
    }

    const ode::varied_problem& varied_;
    ode::invariants<mpfr> constant_;
};

// Some members of the family, and where they end in time.
class lock_step {
public:
    lock_step(const ode::varied_problem& varied, const std::vector<family_member>& family,
              const std::vector<exact>& times, std::vector<std::string> decimals, long digits)
        : varied_(varied), family_(family), times_(times), decimals_(std::move(decimals)), digits_(digits) {
        std::ranges::transform(times, std::back_inserter(at_), value_of<double>);
        const auto names = ode::names_of_state(varied.system());
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!varied.parameters()[i]) {
                names_.push_back(names[i]);
            }
        }
    }

    void run(std::size_t first, std::size_t last, std::span<std::optional<partial_table>> to) const {
        std::vector<double> states;
        for (std::size_t i = first; i < last; ++i) {
            varied_.append_state(varied_values<double>(family_[i]), states);
        }
        std::vector<double> found((last - first) * at_.size() * names_.size());
        ode::batch_march march(varied_.system(), varied_.parameters());
        const double begin = ode::constant_value<double>::of(varied_.system().point());
        march.run({begin, states, at_}, found, [](std::size_t) { check_time(); });
        const std::size_t size = at_.size() * names_.size();
        const precision_scope wide(digits_ + digits_of_double);
        std::optional<drifts_of_members> drifts;
        if (!varied_.system().invariants().empty()) {
            drifts.emplace(varied_);
        }
        for (std::size_t i = 0; i < last - first; ++i) {
            const auto values = std::span<const double>(found).subspan(i * size, size);
            if (std::ranges::none_of(values, [](double x) { return std::isnan(x); })) {
                to[i] = table_of(values,
                                 drifts ? drifts->of(family_[first + i], times_, values) : std::vector<std::string>());
            }
        }
    }

private:
    partial_table table_of(std::span<const double> values, std::vector<std::string> drifts) const {
        answer found{.names = names_, .rows = {}, .rigour = "heuristic"};
        found.drifts = std::move(drifts);
        for (std::size_t i = 0; i < at_.size(); ++i) {
            auto& row = found.rows.emplace_back();
            for (const double x : values.subspan(i * names_.size(), names_.size())) {
                row.push_back({to_decimal(widen(x), digits_), ""});
            }
        }
        return states_table(found, times_, decimals_, digits_);
    }

    const ode::varied_problem& varied_;
    const std::vector<family_member>& family_;
    const std::vector<exact>& times_;
    std::vector<std::string> decimals_;
    long digits_;
    std::vector<double> at_;
    std::vector<std::string> names_;
};

}  // namespace

std::vector<std::optional<partial_table>> family_in_lock_step(const std::vector<family_member>& family,
                                                              const std::vector<exact>& times, long digits, int jobs) {
    std::vector<std::optional<partial_table>> tables(family.size());
    const auto varied = varied_problem_of(family.front());
    if (!varied) {
        return tables;
    }
    const auto decimals = family.front().problem.general_solution()->times_in_decimals(times, digits);
    const lock_step members(*varied, family, times, decimals, digits);
    const std::size_t parts = (family.size() + members_together - 1) / members_together;
    progress shown("trajectories", parts);
    on_threads(parts, jobs, [&](std::size_t part) {
        const std::size_t first = part * members_together;
        const std::size_t last = std::min(first + members_together, family.size());
        members.run(first, last, std::span(tables).subspan(first, last - first));
        shown.step();
    });
    return tables;
}

}  // namespace libration
