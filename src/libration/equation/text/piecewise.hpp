// Piecewise functions in the text of a problem, as formulas of step functions.
#pragma once

#include <string>
#include <vector>

#include "condition.hpp"
#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Collects the step functions of the equations of a problem: s = sign(u) with sign(0) = 0, its indicators [u > 0] and
/// [u >= 0], and n = floor(u), by which
///     if(u > 0, a, b) = [u > 0] a + (1 - [u > 0]) b, the same with >=,
///     if(u == 0, a, b) = if(u >= 0, if(u > 0, b, a), b),
///     if(v^2 w > 0, a, b) = if(v == 0, b, if(w > 0, a, b)),
///     if(p and q, a, b) = if(p, if(q, a, b), b), if(p or q, a, b) = if(p, a, if(q, a, b)), if(not p, a, b) = if(p, b, a).
/// With numbers for the step functions these formulas fold exactly to the branch that is chosen. Each comparison has
/// a separate surface, whatever the others are.
class step_collector {
public:
    /// The function of the text at this place, which messages name.
    step_collector(std::vector<step_function>& steps, std::string text, const place& at)
        : steps_(steps), text_(std::move(text)), at_(at) {}

    /// if(holds, a, b).
    expression chosen(const condition& holds, const expression& a, const expression& b);
    expression if_positive(const expression& u, const expression& a, const expression& b);
    expression if_not_negative(const expression& u, const expression& a, const expression& b);
    /// -1, 0 or 1.
    expression sign(const expression& u);
    /// floor(u/divisor) for a positive divisor. With pi and 2 pi its times are exact.
    expression floor(const expression& u, const number& divisor = number(rational(1)));

private:
    struct oriented_sign {
        std::string parameter;
        int orientation = 1;  // the sign is this times the one of the parameter
    };

    expression if_nonzero(const std::vector<expression>& all, const expression& a, const expression& b);
    oriented_sign step_of(const expression& u);
    const std::string& added(step_function made);

    std::vector<step_function>& steps_;
    std::string text_;
    place at_;
};

}  // namespace libration::ode
