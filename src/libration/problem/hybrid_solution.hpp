// A solution with events and piecewise right-hand sides, from branch to branch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "taylor_solution.hpp"

namespace libration {

/// Values and events are those of all branches; series, radii and singularities those of the branch at the initial
/// point, which a note states.
class hybrid_solution : public solution {
public:
    /// Throws error as ode::hybrid_system, and of the kind undecided if the first branch is not determined.
    explicit hybrid_solution(ode::equation_system equations);

    answer states(const std::vector<exact>& times, const request& how) const override;
    answer states_along(const complex_path_request& along, const request& how) const override;
    answer limits(const request& how) const override;
    using solution::events;
    answer events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const override;
    ode::expression condition(const std::string& text) const override;
    using solution::series;
    void require_point(const std::string& about) const override;
    std::string form_of_points() const override { return "nothing: only the initial point is supported"; }
    answer series(const series_request& of, const request& how) const override;
    std::optional<answer> fractions(const series_request& of) const override;
    std::vector<unknown_series> coefficient_lists(const series_request& of, const scalar_spec& scalar) const override;
    answer singularities(const std::optional<double>& within, const request& how) const override;

    const ode::hybrid_system& system() const { return system_; }
    /// The branch at the initial point.
    const taylor_solution& first_branch() const { return first_; }

protected:
    answer proved_radius(const series_request& of, const request& how) const override;

private:
    answer proved_states(const std::vector<ode::number>& times, const request& how) const;
    ode::partial_trajectory proved_part(const std::vector<ode::number>& times, const request& how, long digits,
                                        const ode::march_watch& watch, const ode::proof_route& route) const;
    answer rounded_states(const std::vector<ode::number>& times, const request& how) const;

    ode::equation_system equations_;
    ode::hybrid_system system_;
    taylor_solution first_;
};

}  // namespace libration
