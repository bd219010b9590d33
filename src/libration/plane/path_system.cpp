#include "libration/equation/first_order_form.hpp"
#include "libration/plane/local_series.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_start(const std::string& with) {
    throw error(error_kind::argument, error_subject::problem, "",
                "has a singular initial point with " + with +
                    ", from which singularities are not searched: choose another initial point");
}

}  // namespace

path_system::path_system(const explicit_system& system)
    : form(lifted_for_paths(beyond_start(system))),
      points(tape::about_points(form.lifted.system)),
      origin(system.point()) {
    for (const unknown_function& each : system.unknowns()) {
        functions.push_back(given);
        given += static_cast<std::size_t>(each.order);
    }
    for (const auto& of_unknown : system.starts()) {
        starts.insert(starts.end(), of_unknown.begin(), of_unknown.end());
    }
    if (system.singular()) {
        singular = tape::about_start(system);
        if (singular->root() != 1) {
            refuse_start("powers of a root of the distance");
        }
        if (form.lifted.given != given) {
            refuse_start("functions of several values");
        }
    } else if (form.lifted.given != given) {
        first = ode::lifted(system);
    }
}

}  // namespace libration::ode
