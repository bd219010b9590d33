// Problems of the catalogue with other parameters and initial values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"

namespace libration::studies {

/// The equations of a problem of the catalogue with these changes, such as "b = 1/2".
inline ode::equation_system catalogue_system(const std::string& name, const std::vector<std::string>& changes = {}) {
    auto system = ode::parse(problem_text(name));
    for (const std::string& each : changes) {
        system = ode::changed(std::move(system), each);
    }
    return system;
}

}  // namespace libration::studies
