#include "libration/ode/proved/proved_trajectory.hpp"

#include "proving_runs.hpp"

namespace libration::ode {

std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch) {
    return proving_runs(system, times, digits, watch).result();
}

}  // namespace libration::ode
