// A solution by Taylor series of its equations: applicable to every problem.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/kept_integrations.hpp"
#include "libration/problem/solution.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// Minimum number of digits of integrations in addition to those of the result.
inline constexpr long digits_beyond_result = 20;
inline constexpr long digits_of_drift = 3;

inline long digits_of_integration(const request& how) { return std::max(how.printed_digits(), how.scalar.digits); }

/// A time of a problem as a number. Throws error for a multiple of a period.
ode::number time_of_problem(const exact& time);

class taylor_solution : public solution {
public:
    /// Throws error as ode::explicit_system does.
    explicit taylor_solution(ode::equation_system equations);

    answer states(const std::vector<exact>& times, const request& how) const override;
    answer states_along(const complex_path_request& along, const request& how) const override;
    answer limits(const request& how) const override;
    using solution::events;
    answer events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const override;
    ode::expression condition(const std::string& text) const override;
    using solution::series;
    void require_point(const std::string& about) const override;
    std::string form_of_points() const override { return "a time as 1/2, or a complex one as 1+2i"; }
    answer series(const series_request& of, const request& how) const override;
    std::optional<answer> fractions(const series_request& of) const override;
    std::vector<unknown_series> coefficient_lists(const series_request& of, const scalar_spec& scalar) const override;
    answer singularities(const std::optional<double>& within, const request& how) const override;
    proved_law law(const law_question& asked, const request& how) const override;
    answer proved_radius(const series_request& of, const request& how) const override;
    std::optional<bool> is_single_valued(const series_request& of, const complex_number<mpfr>& place,
                                         const request& how) const override;

    std::size_t steps_made() const override { return kept_.made(); }

    const ode::explicit_system& system() const { return system_; }

protected:
    /// The largest change of an invariant at these states, each correct to `digits` digits; empty if the problem states
    /// none or its initial point is singular.
    std::vector<std::string> drifts(const std::vector<exact>& times,
                                    const std::vector<ode::solution_state<mpfr>>& states, long digits) const;

private:
    ode::coefficient_request coefficients_of(const series_request& of) const;
    void require_second_series(const ode::coefficient_request& of, long digits,
                               const std::vector<proved_decimal>& first) const;
    std::vector<std::string> columns_of(const request& how) const;
    ode::partial_trajectory proved_part(const std::vector<exact>& times, const request& how, long digits,
                                        const ode::march_watch& watch, const ode::proof_route& route,
                                        const ode::step_observer& observer) const;
    void require_second_proof(const std::vector<exact>& times, const request& how,
                              const ode::partial_trajectory& first) const;
    answer proved_states(const std::vector<exact>& times, const request& how) const;
    answer rounded_states(const std::vector<exact>& times, const request& how) const;

    ode::equation_system equations_;
    ode::explicit_system system_;
    mutable ode::shared_integrations kept_;
};

}  // namespace libration
