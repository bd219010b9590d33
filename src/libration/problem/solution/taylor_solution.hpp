// A solution by Taylor series of its equations: applicable to every problem.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/taylor_expansion.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

class taylor_solution : public solution {
public:
    /// Throws error as ode::explicit_system does.
    explicit taylor_solution(ode::equation_system equations);

    answer states(const std::vector<exact>& times, const request& how) const override;
    answer limits(const request& how) const override;
    answer events(const std::string& condition, long count, const request& how) const override;
    answer series(long order, const std::string& about, const request& how) const override;
    answer radius(const std::string& about, const request& how) const override;

    const ode::explicit_system& system() const { return system_; }

protected:
    /// The largest change of an invariant at these states, each correct to `digits` digits; empty if the problem states
    /// none or its initial point is singular.
    std::vector<std::string> drifts(const std::vector<exact>& times,
                                    const std::vector<ode::solution_state<mpfr>>& states, long digits) const;

private:
    answer proved_states(const std::vector<exact>& times, const request& how) const;
    answer rounded_states(const std::vector<exact>& times, const request& how) const;

    ode::equation_system equations_;
    ode::explicit_system system_;
};

}  // namespace libration
