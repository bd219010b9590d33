// The paper's whole construction with the T* of a rule and its error: the resummation, folded and shifted with that T*.
#pragma once

#include <utility>
#include <vector>

#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "libration/scalar/dispatch.hpp"
#include "value_with_error.hpp"

namespace libration::studies {

/// (fullresummation) of one order, extended by (newseries) with the T* of the rule, at all times; for motions that
/// start at the bottom.
inline std::vector<value_with_error> folded(const pendulum::motion& m, const std::vector<exact>& times, int order,
                                            const pendulum::period_rule& by, const scalar_spec& scalar) {
    return resolved(scalar.digits, digits_below(m, order), [&] {
        return with_scalar(scalar, working_digits() - scalar.digits, [&]<class T>() {
            const pendulum::exact_solution<mpfr> truth(m);
            const pendulum::periodic_extension<T, endpoint_approximant<T>> extension(
                m, resummation_from_top(arc_of<T>(m, by), order), by);
            std::vector<value_with_error> values;
            values.reserve(times.size());
            for (const exact& time : times) {
                const pendulum::phase<mpfr> at = truth.phases().at(time);
                const mpfr expected = truth.at(at).theta;
                const series::jet<T> found = extension(time);
                // The initial value is exact, and with the exact T* every top and bottom too.
                const bool interpolated = at.side == 0 && (time.is_zero() || by.method == pendulum::period_method::agm);
                const mpfr theta = fixed_scalar<T> || !interpolated ? widen(found.value) : expected;
                values.push_back({theta, widen(found.slope), abs(theta - expected), interpolated});
            }
            return values;
        });
    });
}

/// T by a rule, and its error: 0 where the rule is exact.
inline value_with_error period_by(const pendulum::motion& m, const pendulum::period_rule& by,
                                  const scalar_spec& scalar) {
    return resolved(scalar.digits, 0,
                    [&] {
                        return with_scalar(scalar, working_digits() - scalar.digits, [&]<class T>() {
                            const int quarters = quarters_per_period(m.regime());
                            const mpfr expected = effective_period(energy_level_of<mpfr>(m)) * quarters;
                            const mpfr period = widen(effective_period_by(by, energy_level_of<T>(m))) * quarters;
                            return std::vector<value_with_error>{
                                {period, period, abs(period - expected), by.method == pendulum::period_method::agm}};
                        });
                    })
        .front();
}

}  // namespace libration::studies
