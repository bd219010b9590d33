#include "libration/integration/taylor/varied_problem.hpp"

#include <algorithm>

#include "libration/equation/polynomial_form.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

varied_problem::varied_problem(const equation_system& given, const std::vector<std::string>& names)
    : open_(opened(given, names)) {
    if (open_.system.singular()) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has a singular initial point, from which its values cannot vary: begin at another time");
    }
    const std::vector<std::string> own = given.unknowns();
    for (const unknown_function& each : open_.system.unknowns()) {
        const bool parameter = std::ranges::find(own, each.name) == own.end();
        parameters_.insert(parameters_.end(), static_cast<std::size_t>(each.order), parameter);
    }
}

void varied_problem::append_state(std::span<const double> values, std::vector<double>& to) const {
    expression_values<double> by_values(open_.leaves, 0.0);
    for (const double each : values) {
        by_values.push_back(each);
    }
    for (const expression& each : open_.starts) {
        to.push_back(by_values.of(each));
    }
}

void varied_problem::append_state(std::span<const double> values, std::span<const double> unknowns,
                                  std::vector<double>& to) const {
    std::size_t first = to.size();
    append_state(values, to);
    std::size_t next = 0;
    for (const bool parameter : parameters_) {
        if (!parameter) {
            to[first] = unknowns[next++];
        }
        ++first;
    }
}

}  // namespace libration::ode
