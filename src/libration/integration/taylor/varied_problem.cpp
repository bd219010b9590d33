#include "libration/integration/taylor/varied_problem.hpp"

#include <algorithm>

#include "libration/equation/polynomial_form.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

template <class R>
void append_starts(const parametric_system& of, std::span<const R> values, std::vector<R>& to) {
    expression_values<R> by_values(of.leaves, R(0));
    for (const R& each : values) {
        by_values.push_back(each);
    }
    for (const expression& each : of.starts) {
        to.push_back(by_values.of(each));
    }
}

}  // namespace

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
    append_starts(open_, values, to);
}

std::vector<mpfr> varied_problem::state_of(std::span<const mpfr> values) const {
    std::vector<mpfr> state;
    append_starts(open_, values, state);
    return state;
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
