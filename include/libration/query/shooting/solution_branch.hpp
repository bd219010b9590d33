// Branches of solutions of boundary-value problems in a parameter, past turning points.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/equation/equation_system.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// A branch of solutions z = (x, lambda) of F(z) = 0, with n conditions for n unknowns x and one more, the parameter.
struct branch_question {
    equation_system system;  ///< with the first guess of the unknowns
    std::vector<std::string> unknowns;
    conditions_at_times conditions;
    std::string parameter;            ///< a parameter or an initial value
    std::vector<std::string> values;  ///< of the parameter, at least two, in one direction, exact as typed
    long digits = 50;
};

enum class branch_point_kind { solution, turning_point };

/// A point of a branch: the parameter, then the unknowns.
struct branch_point {
    branch_point_kind kind;
    std::vector<known_value> values;
};

/// Why a branch ends.
enum class branch_end {
    left,          ///< the parameter left the range of the values
    closed,        ///< the branch returned to its first point
    no_more,       ///< the last thirty steps led to no point
    not_continued  ///< the steps became too small
};

struct branch_result {
    branch_end end;
    std::string where;                  ///< the last step, "lambda = 1.5, y'(0) = 2.3", not proved
    std::vector<std::string> unproved;  ///< points whose proof failed, with the reason
};

/// Follows the branch by pseudo-arclength [Keller1977] in floating-point arithmetic, from the solution at the first
/// value that the first guess leads to, in the direction of the second value. Wherever the parameter passes one of the
/// values, in either direction, and at every turning point, `found` is called with a point of which each digit is
/// proved, or a bound below 10^-digits. It ends if the parameter is a tenth of the range outside of it, if the branch is closed, or
/// after thirty steps without a point.
///
/// A solution at a value is proved by Krawczyk's test with the parameter fixed: it is isolated. A turning point is
/// proved by the same test for the system
///     F(x, lambda) = 0,  F_x(x, lambda) v = 0,  v_k = 1,
/// whose solution at which its derivative is regular is a simple quadratic turning point [MooreSpence1980, theorem 2.1]:
/// lambda has a strict local extremum along the branch. F_x v is the derivative of the conditions along the variation u
/// of the solution, u' = f_y u, of which the equations are added to the system. That consecutive points are connected is
/// not proved, nor that no turning point between them was passed over.
///
/// Throws error like proved_unknowns if the first solution is not proved, and of the subject "along" for values that are not in one direction.
branch_result follow_branch(const branch_question& question, const std::function<void(const branch_point&)>& found,
                            const proof_route& route = {}, const march_watch& watch = {});

}  // namespace libration::ode
