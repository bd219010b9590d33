// A solution in the complex plane, along a path.
#include <algorithm>

#include "libration/equation/constant_value.hpp"
#include "libration/expansion/invariant.hpp"
#include "libration/plane/path.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/decimal.hpp"
#include "taylor_solution.hpp"

namespace libration {

namespace {

using wide_complex = complex_number<mpfr>;
using complex_states = std::vector<ode::solution_state<wide_complex>>;

// In the arithmetic in which they are printed.
template <class T>
complex_states in_wide_numbers(const std::vector<ode::solution_state<complex_number<T>>>& states) {
    complex_states all;
    for (const auto& state : states) {
        auto& wide = all.emplace_back();
        for (const auto& of_unknown : state) {
            auto& values = wide.emplace_back();
            for (const auto& value : of_unknown) {
                values.push_back({widen(value.re), widen(value.im)});
            }
        }
    }
    return all;
}

complex_states integrated_along(const ode::explicit_system& system, const complex_path_request& along,
                                const request& how) {
    if (how.scalar.kind == scalar_kind::arbitrary) {
        return ode::trajectory_along(system, along.corners, along.times, digits_of_integration(how));
    }
    const precision_scope wide(how.scalar.digits + digits_beyond_result);
    return with_scalar(how.scalar, 0, [&]<class T>() {
        return in_wide_numbers(ode::states_along<T>(system, along.corners, along.times));
    });
}

// The largest change of an invariant at each time; empty if the problem states none or its initial point is singular.
std::vector<std::string> complex_drifts(const ode::explicit_system& system, const complex_path_request& along,
                                        const complex_states& states, long digits) {
    std::vector<std::string> drifts;
    if (system.invariants().empty() || system.singular()) {
        return drifts;
    }
    const precision_scope scope(digits + digits_beyond_result);
    ode::invariants<wide_complex> constant(system);
    for (std::size_t i = 0; i < along.times.size(); ++i) {
        const auto drift = constant.drift(ode::constant_value<wide_complex>::of(along.times[i]), states[i]);
        drifts.push_back(to_decimal(drift, digits_of_drift));
    }
    return drifts;
}

}  // namespace

answer taylor_solution::states_along(const complex_path_request& along, const request& how) const {
    if (how.scalar.kind == scalar_kind::proved) {
        throw error(error_kind::argument, "scalar", how.scalar.name(), "cannot prove a path in the complex plane");
    }
    const auto states = integrated_along(system_, along, how);
    const bool agreed = how.scalar.kind == scalar_kind::arbitrary;
    answer result{.names = {}, .rows = {}, .rigour = agreed ? "two-method" : "heuristic"};
    for (const std::string& name : quantities()) {
        result.names.push_back(name + "_re");
        result.names.push_back(name + "_im");
    }
    for (const auto& state : states) {
        auto& row = result.rows.emplace_back();
        for (const auto& of_unknown : state) {
            for (const wide_complex& value : of_unknown) {
                row.push_back({to_decimal(value.re, how.printed_digits()), ""});
                row.push_back({to_decimal(value.im, how.printed_digits()), ""});
            }
        }
    }
    result.drifts = complex_drifts(system_, along, states, digits_of_integration(how));
    return result;
}

}  // namespace libration
