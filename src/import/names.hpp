// Identifiers of a model as names of a problem.
#pragma once

#include <map>
#include <set>
#include <string>

namespace libration::import {

/// Names that differ from each other and from the words of the notation: y for y, e_ for e, x_1 for _1.
class problem_names {
public:
    /// The same name for the same identifier.
    const std::string& of(const std::string& id);
    /// A new name that begins like this.
    std::string free(const std::string& wish);

private:
    std::map<std::string, std::string> names_;
    std::set<std::string> taken_;
};

}  // namespace libration::import
