#include "unknown_count.hpp"

#include <string>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

std::string count_of(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

}  // namespace

void require_square(const connection_map& map, std::size_t unknowns) {
    const std::size_t stable = map.right().variables();
    if (map.left_variables() > 2) {
        throw error(error_kind::undecided, error_subject::conditions, "",
                    "has a first end with an unstable manifold of dimension " + std::to_string(map.left_variables()) +
                        ", and only 1 and 2 are supported: exchange the ends, by t -> -t");
    }
    if (map.has_two_ends() && map.left_variables() == 0) {
        throw error(error_kind::argument, error_subject::conditions, "",
                    "begins at an equilibrium that no solution leaves: exchange the limits");
    }
    if (stable == 0) {
        throw error(error_kind::argument, error_subject::conditions, "",
                    "has the limits of an equilibrium without a direction of exponential decay: choose other limits");
    }
    const std::string what = map.may_rest ? "solutions that decay like this power of the time" : "these limits";
    const std::size_t others = map.coordinates() + stable + (map.has_two_ends() ? map.left_variables() - 1 : 0);
    const std::size_t n = map.dimension();
    if (others > n || (others == n && unknowns > 0)) {
        throw error(error_kind::argument, error_subject::unknowns, "",
                    "has too many names: " + std::string(map.may_rest ? "" : "solutions with ") + what +
                        " are found for every value of them, since " +
                        count_of(stable, "exponentially decaying direction") + " of " + std::to_string(n) +
                        " lead there: leave out the unknowns, ask for another limit, or, along the fastest directions "
                        "alone, write fast after the limit");
    }
    if (unknowns == 0 && others < n) {
        throw error(error_kind::argument, error_subject::unknowns, "",
                    "is missing: " + what + " determine " + count_of(n - others, "number") + ", since of " +
                        count_of(n, "component") + " of the state " + count_of(stable, "direction") +
                        " of exponential decay: name as many parameters or initial values by --unknown");
    }
    if (unknowns + others != n) {
        throw error(error_kind::argument, error_subject::unknowns, std::to_string(unknowns),
                    "is not the number that " + what + " determine, " + std::to_string(n - others) +
                        ": the state has " + count_of(n, "component") + ", and " + count_of(stable, "direction") +
                        " of exponential decay: give as many --unknown");
    }
}

}  // namespace libration::ode
