// The certificate of a root: unknown initial values, and the time if it is unknown too, for which as many conditions hold.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../query/certificate/certificate.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// At the end the unknown or lower derivative with this index in names_of_state() has a value, or that at the beginning.
struct end_condition {
    std::size_t place = 0;
    std::optional<rational> value = {};
};

struct certified_root {
    /// The system with these values of the unknown initial values.
    std::function<ode::explicit_system(const std::vector<rational>& values)> system;
    /// Their indices in names_of_state(), in increasing order, and intervals that contain them.
    std::vector<std::size_t> places;
    std::vector<ode::decimal_interval> starts;
    /// The time of the conditions, if it is given; otherwise an interval that contains it.
    rational time;
    std::optional<ode::decimal_interval> period = {};
    std::vector<end_condition> conditions;
};

/// The text (docs/certificates.md): values of the solution for the numbers m in the middle of the intervals, its
/// derivatives by each unknown initial value for all of them, and a matrix C with which Newton's method contracts. The
/// box is that of the intervals, or smaller if the derivatives change too much in it. Throws error of the subject
/// "certificate" as ode::certificate_of, and if the condition for a contraction does not hold.
std::string text_of_root(const certified_root& root, const request& how);

}  // namespace libration
