// A solution of equations with constant delays, by the method of steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/delay_system.hpp"
#include "libration/problem/solution.hpp"

namespace libration {

/// Values at times from the initial point on, and events. Everything else is not supported: error of the kind argument.
class delay_solution : public solution {
public:
    /// Throws error as ode::delay_system.
    explicit delay_solution(const ode::equation_system& equations);

    answer states(const std::vector<exact>& times, const request& how) const override;
    answer states_along(const complex_path_request& along, const request& how) const override;
    answer limits(const request& how) const override;
    using solution::events;
    answer events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const override;
    ode::expression condition(const std::string& text) const override;
    using solution::series;
    void require_point(const std::string& about) const override;
    std::string form_of_points() const override { return "nothing: no expansion point is supported"; }
    answer series(const series_request& of, const request& how) const override;
    std::vector<unknown_series> coefficient_lists(const series_request& of, const scalar_spec& scalar) const override;
    answer singularities(const std::optional<double>& within, const request& how) const override;

protected:
    answer proved_radius(const series_request& of, const request& how) const override;

private:
    ode::delay_system system_to(const std::vector<ode::number>& times) const;
    answer proved_states(const std::vector<ode::number>& times, const request& how) const;
    answer rounded_states(const std::vector<ode::number>& times, const request& how) const;

    ode::equation_system equations_;
    ode::delay_system system_;
};

}  // namespace libration
