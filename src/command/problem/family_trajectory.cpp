#include "family_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>

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

// The problem with the values of the lists as variables, if it has no invariants and these may vary.
std::optional<ode::varied_problem> varied_problem_of(const family_member& first) {
    const ode::equation_system equations = first.problem.equations();
    if (!equations.invariants.empty()) {
        return {};
    }
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

double in_double(const exact& value) { return ode::constant_value<double>::of(constants_of({value}).front()); }

// Some members of the family, and where they end in time.
class lock_step {
public:
    lock_step(const ode::varied_problem& varied, const std::vector<family_member>& family,
              const std::vector<exact>& times, std::vector<std::string> decimals, long digits)
        : varied_(varied), family_(family), times_(times), decimals_(std::move(decimals)), digits_(digits) {
        std::ranges::transform(times, std::back_inserter(at_), in_double);
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
            std::vector<double> values;
            for (const auto& [name, text] : family_[i].values) {
                values.push_back(in_double(read_exact(text)));
            }
            varied_.append_state(values, states);
        }
        std::vector<double> found((last - first) * at_.size() * names_.size());
        ode::batch_march march(varied_.system(), varied_.parameters());
        const double begin = ode::constant_value<double>::of(varied_.system().point());
        march.run({begin, states, at_}, found, [](std::size_t) { check_time(); });
        const std::size_t size = at_.size() * names_.size();
        for (std::size_t i = 0; i < last - first; ++i) {
            to[i] = table_of(std::span(found).subspan(i * size, size));
        }
    }

private:
    std::optional<partial_table> table_of(std::span<const double> values) const {
        if (std::ranges::any_of(values, [](double x) { return std::isnan(x); })) {
            return {};
        }
        const precision_scope wide(digits_ + digits_of_double);
        answer found{.names = names_, .rows = {}, .rigour = "heuristic"};
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
