#include "equation/problem_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "equation/problem_trajectory.hpp"
#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/constant_value.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/problem/axis.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "run/progress.hpp"

namespace libration {

namespace {

constexpr std::size_t parts_of_progress = 1000;

// How far a run has come towards the last time; a run that begins again does not go back.
class way_to_go {
public:
    way_to_go(const ode::explicit_system& system, const std::vector<ode::number>& times)
        : shown_("reference", parts_of_progress) {
        const precision_scope scope(20);
        origin_ = ode::constant_value<mpfr>::of(system.point());
        for (const ode::number& each : times) {
            whole_ = std::max(whole_, mpfr(abs(ode::constant_value<mpfr>::of(each) - origin_)));
        }
    }

    void reached(const ball& time) {
        const precision_scope scope(20);
        const mpfr part = whole_ == 0 ? mpfr(0) : mpfr(abs(midpoint_of(time) - origin_) / whole_ * parts_of_progress);
        const auto now = std::min(part.convert_to<std::size_t>(), parts_of_progress);
        if (now > done_) {
            shown_.step(now - done_);
            done_ = now;
        }
    }

private:
    progress shown_;
    mpfr origin_;
    mpfr whole_ = mpfr(0);
    std::size_t done_ = 0;
};

constexpr long digits_of_second = ode::more_digits_of_second_proof;

void check_states(const ode::explicit_system& system, const std::vector<exact>& times, long digits,
                  const ode::partial_trajectory& first) {
    const auto second = ode::proved_part_of_trajectory(system, constants_of(times), digits + digits_of_second, {},
                                                       ode::proof_route::second());
    const auto columns = columns_of_states(system);
    for (std::size_t i = 0; i < first.states.size(); ++i) {
        const std::size_t compared = std::min(first.states[i].size(), second.states[i].size());
        for (std::size_t j = 0; j < compared; ++j) {
            const auto& a = first.states[i][j].decimal;
            const auto& b = second.states[i][j].decimal;
            if (a && b) {
                require_agreement(*a, *b, columns[j + 1].name + " at time " + times[i].text);
            }
        }
    }
}

// A time with its values, to the table and to the text.
void add_state(partial_table& result, const std::vector<column>& columns,
               const std::vector<ode::trajectory_value>& state, const exact& time, long digits) {
    table_row_cells row{number_cell(decimal_of(time, digits))};
    result.text += fmt::format("{}{:<10}{}\n", result.text.empty() ? "" : "\n", columns.front().name, row[0].text());
    std::string bounds;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const std::string& name = columns[i + 1].name;
        const std::string bound = state[i].decimal         ? ""
                                  : state[i].bound.empty() ? name + " is not reached"
                                                           : fmt::format("|{}| < {}", name, state[i].bound);
        row.push_back(state[i].decimal ? cell::number(state[i].decimal->text, digits) : cell());
        bounds += bound.empty() || bounds.empty() ? bound : "; " + bound;
        result.text += fmt::format("{:<10}{}\n", name, state[i].decimal ? row.back().text() : bound);
    }
    row.emplace_back(digits);
    row.emplace_back("proved");
    row.emplace_back(time.text);
    if (row.size() < columns.size()) {
        row.emplace_back(bounds);
    }
    result.rows.add_row(std::move(row));
}

}  // namespace

partial_table problem_reference(const ode::explicit_system& system, const std::vector<exact>& times, long digits,
                                bool check) {
    const auto checked = checked_products(check);
    const auto at = constants_of(times);
    way_to_go way(system, at);
    const auto part =
        ode::proved_part_of_trajectory(system, at, digits, [&](const ball& time, long) { way.reached(time); });
    if (check) {
        check_states(system, times, digits, part);
    }
    std::vector<column> columns = columns_of_states(system);
    const bool undecided = std::ranges::any_of(part.states, [](const auto& state) {
        return std::ranges::any_of(state, [](const ode::trajectory_value& each) { return !each.decimal; });
    });
    if (undecided) {
        columns.push_back({"undecided", ""});
    }
    partial_table result{table(columns), {}, part.missing};
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!part.states[i].empty()) {
            add_state(result, columns, part.states[i], times[i], digits);
        }
    }
    return result;
}

void require_complete(const partial_table& of) {
    if (of.missing) {
        throw error(*of.missing);
    }
}

std::string lines_of_states(const table& data) {
    std::string text;
    for (const auto& row : data.rows()) {
        text += text.empty() ? "" : "\n";
        for (std::size_t i = 0; i + 3 < row.size(); ++i) {
            text += fmt::format("{:<10}{}\n", data.columns()[i].name, row[i].text());
        }
    }
    return text;
}

}  // namespace libration
