// The solution of the two-body problem on an elliptic orbit: states in closed form, everything else by Taylor series.
#include "libration/problem/known/kepler.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "../taylor_solution.hpp"
#include "closed_form_states.hpp"
#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/known/kepler_orbit.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration {

namespace {

// The values at a time as they are printed, and the numbers that they round.
struct kepler_row {
    closed_form_row printed;
    ode::solution_state<mpfr> state;
};

class kepler_solution : public taylor_solution {
public:
    kepler_solution(const ode::equation_system& equations, recognised_kepler found)
        : taylor_solution(equations), of_(std::move(found)) {}

    std::string closed_form() const override { return "an elliptic orbit of the two-body problem"; }
    answer states(const std::vector<exact>& times, const request& how) const override;

private:
    // In the order of the quantities, in the working precision.
    std::array<ball, 4> enclosed_at(const ode::number& elapsed) const;
    kepler_row row_at(const exact& time, long digits) const;
    void require_second_proof(const std::vector<exact>& times, const request& how, const answer& first) const;

    recognised_kepler of_;
};

std::array<ball, 4> kepler_solution::enclosed_at(const ode::number& elapsed) const {
    const auto value = [](const ode::number& x) { return ode::constant_value<ball>::of(x); };
    const ode::kepler_orbit orbit(value(of_.attraction), {value(of_.position[0]), value(of_.position[1]),
                                                          value(of_.velocity[0]), value(of_.velocity[1])});
    auto [x, y, vx, vy] = orbit.after(value(elapsed));
    return {std::move(x), std::move(vx), std::move(y), std::move(vy)};
}

// With more digits until each value is proved or, in the last run, contains 0 and has a bound.
kepler_row kepler_solution::row_at(const exact& time, long digits) const {
    const ode::number elapsed = time_of_problem(time) - system().point();
    return with_growing_precision(
        proving(digits), "the state at time " + time.text, [&](const precision_run& run) -> std::optional<kepler_row> {
            const auto values = enclosed_at(elapsed);
            closed_form_row row;
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (const auto decimal = to_proved_decimal(values[i], digits)) {
                    row.values.push_back({decimal->text, decimal->uncertainty});
                } else if (run.last && contains_zero(values[i])) {
                    const std::string bound = bound_text(values[i]);
                    row.values.push_back({"", bound});
                    row.missing =
                        error(error_kind::undecided, error_subject::time, time.text,
                              "has a value of " + quantities()[i] + " that " + std::to_string(digits + run.more) +
                                  " digits do not distinguish from 0: |" + quantities()[i] + "| < " + bound);
                } else {
                    return std::nullopt;
                }
            }
            return kepler_row{
                std::move(row),
                {{midpoint_of(values[0]), midpoint_of(values[1])}, {midpoint_of(values[2]), midpoint_of(values[3])}}};
        });
}

answer kepler_solution::states(const std::vector<exact>& times, const request& how) const {
    const bool proved = how.scalar.kind == scalar_kind::proved;
    const bool correct = proved || how.scalar.kind == scalar_kind::arbitrary;
    if (!correct || !how.derivatives.empty()) {
        return taylor_solution::states(times, how);
    }
    const ode::solution_state<mpfr> without_values(quantities().size() / 2);
    std::vector<ode::solution_state<mpfr>> reached;
    answer result = closed_form_states(closed_form(), quantities(), times, how, [&](const exact& time) {
        auto& state = reached.emplace_back(without_values);
        kepler_row row = row_at(time, how.printed_digits());
        state = std::move(row.state);
        return std::move(row.printed);
    });
    if (how.check) {
        require_second_proof(times, how, result);
    }
    if (!proved) {
        reached.resize(times.size(), without_values);
        result.drifts = drifts(times, reached, how.printed_digits());
    }
    return result;
}

// By integration.
void kepler_solution::require_second_proof(const std::vector<exact>& times, const request& how,
                                           const answer& first) const {
    request again = how;
    again.check = false;
    const answer second = taylor_solution::states(times, again);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::size_t compared = std::min(first.rows[i].size(), second.rows[i].size());
        for (std::size_t j = 0; j < compared; ++j) {
            const answer_value& a = first.rows[i][j];
            const answer_value& b = second.rows[i][j];
            if (!a.text.empty() && !b.text.empty()) {
                require_agreement({a.text, a.bound}, {b.text, b.bound}, quantities()[j] + " at time " + times[i].text);
            }
        }
    }
}

}  // namespace

known_facts facts_of_kepler() {
    return {.problem = "kepler", .closed_form = [](const ode::equation_system& equations) -> std::unique_ptr<solution> {
                if (equations.equations.size() == 1) {
                    return nullptr;
                }
                auto found = recognise_kepler(ode::explicit_system(equations));
                return found ? std::make_unique<kepler_solution>(equations, *std::move(found)) : nullptr;
            }};
}

}  // namespace libration
