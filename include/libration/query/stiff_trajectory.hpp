// The solution of any system, stiff or not, at a list of times in rounded arithmetic.
#pragma once

#include <vector>

#include "libration/integration/collocation/stiff_march.hpp"
#include "libration/query/trajectory.hpp"

namespace libration::ode {

/// As march_as_far_as_possible, by stiff_march.
template <ordered_scalar T>
partial_states<T> stiff_march_as_far_as_possible(const explicit_system& system, const std::vector<number>& times,
                                                 integrator_choice choice = integrator_choice::automatic,
                                                 const series::block_product<T>* fast = nullptr) {
    stiff_march<T> march(system, choice, fast);
    for (const number& each : times) {
        march.head_for(constant_value<T>::of(each));
    }
    auto part = states_by<T>(march, system, times);
    part.collocation = march.collocation();
    return part;
}

/// As part_of_march, by stiff_march.
template <ordered_scalar T>
partial_states<T> part_of_stiff_march(const explicit_system& system, const std::vector<number>& times,
                                      integrator_choice choice = integrator_choice::automatic) {
    return states_of_parts<T>(system, times.size(), [&](const explicit_system& part) {
        return stiff_march_as_far_as_possible<T>(part, times, choice);
    });
}

/// As part_of_trajectory: two integrations by stiff_march, which differ in precision and in the degrees of polynomials,
/// agree to the digits.
inline partial_states<mpfr> part_of_stiff_trajectory(const explicit_system& system, const std::vector<number>& times,
                                                     long digits,
                                                     integrator_choice choice = integrator_choice::automatic,
                                                     const series::block_product<mpfr>* fast = nullptr) {
    return part_of_trajectory(system, times, digits, [&](const explicit_system& part, const std::vector<number>& at) {
        return stiff_march_as_far_as_possible<mpfr>(part, at, choice, fast);
    });
}

}  // namespace libration::ode
