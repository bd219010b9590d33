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
                  const std::vector<std::vector<proved_decimal>>& first) {
    const auto second =
        ode::proved_trajectory(system, constants_of(times), digits + digits_of_second, {}, ode::proof_route::second());
    const auto columns = columns_of_states(system);
    for (std::size_t i = 0; i < first.size(); ++i) {
        for (std::size_t j = 0; j < first[i].size(); ++j) {
            require_agreement(first[i][j], second[i][j], columns[j + 1].name + " at time " + times[i].text);
        }
    }
}

}  // namespace

table problem_reference(const ode::explicit_system& system, const std::vector<exact>& times, long digits, bool check) {
    const auto checked = checked_products(check);
    const auto at = constants_of(times);
    way_to_go way(system, at);
    const auto states = ode::proved_trajectory(system, at, digits, [&](const ball& time, long) { way.reached(time); });
    if (check) {
        check_states(system, times, digits, states);
    }
    table data(columns_of_states(system));
    for (std::size_t i = 0; i < times.size(); ++i) {
        table_row_cells row{number_cell(decimal_of(times[i], digits))};
        for (const proved_decimal& value : states[i]) {
            row.push_back(cell::number(value.text, digits));
        }
        row.emplace_back(digits);
        row.emplace_back("proved");
        row.emplace_back(times[i].text);
        data.add_row(std::move(row));
    }
    return data;
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
