// The solution of any system at a list of times, to correct digits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "libration/equation/dependency.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

/// Adds the states of an independent subsystem to those of the whole system.
template <class R>
void add_part(partial_states<R>& whole, partial_states<R> part, const closed_subsystem& of) {
    for (std::size_t i = 0; i < part.states.size(); ++i) {
        for (std::size_t k = 0; k < part.states[i].size(); ++k) {
            whole.states[i][of.unknowns[k]] = std::move(part.states[i][k]);
        }
    }
    if (!whole.missing) {
        whole.missing = std::move(part.missing);
    }
    std::ranges::move(part.collocation, std::back_inserter(whole.collocation));
}

/// The states of the independent subsystems, each by integrate(system), together.
template <ordered_scalar T, class Integrate>
partial_states<T> states_of_parts(const explicit_system& system, std::size_t times, const Integrate& integrate) {
    partial_states<T> whole;
    whole.states.assign(times, solution_state<T>(system.unknowns().size()));
    for (const closed_subsystem& each : independent_subsystems(system)) {
        add_part(whole, integrate(each.system), each);
    }
    return whole;
}

/// An integration of a system in mpfr of the working precision to times.
using march_of_system = std::function<partial_states<mpfr>(const explicit_system&, const std::vector<number>& times)>;

/// The states at times in any order, each value with `digits` correct digits: two integrations (taylor_march) that
/// differ in precision and in order agree to them, with as many additional digits as the flow loses. Nothing is proved.
/// Unknowns that do not influence each other are integrated separately, each as far as its steps lead. A value that is
/// exactly 0 at a time that is not the start has no digits, and takes long (agreed_values). Throws error of the kind
/// undecided if no precision within the limits suffices. A fast product of whole sequences (expansion/fast_product.hpp)
/// is useful beyond some hundred digits.
partial_states<mpfr> part_of_trajectory(const explicit_system& system, const std::vector<number>& times, long digits,
                                        const series::block_product<mpfr>* fast = nullptr);
/// The same by another integration, whose order grows with the precision.
partial_states<mpfr> part_of_trajectory(const explicit_system& system, const std::vector<number>& times, long digits,
                                        const march_of_system& march);

/// The same if nothing is missing; otherwise throws the reason.
std::vector<solution_state<mpfr>> trajectory(const explicit_system& system, const std::vector<number>& times,
                                             long digits, const series::block_product<mpfr>* fast = nullptr);

/// The states in a scalar of fixed precision, with the accuracy of one integration; unknowns that do not influence each
/// other are integrated separately.
template <ordered_scalar T>
partial_states<T> part_of_march(const explicit_system& system, const std::vector<number>& times) {
    return states_of_parts<T>(system, times.size(),
                              [&](const explicit_system& part) { return march_as_far_as_possible<T>(part, times); });
}

/// The states at points of the complex t-plane, each along the same corners and then straight to it (complex_path): two
/// such continuations that differ in precision and in order agree to `digits` digits of each part
/// (agreed_complex_values). Nothing is proved. Throws error if a point is not reached, and of the kind undecided if no
/// precision within the limits suffices.
std::vector<solution_state<complex_number<mpfr>>> trajectory_along(const explicit_system& system,
                                                                   const std::vector<complex_constant>& corners,
                                                                   const std::vector<complex_constant>& times,
                                                                   long digits);

}  // namespace libration::ode
