// Equations whose solutions decay like a power of the time, and the autonomous system in its logarithm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/parametric_system.hpp"
#include "libration/query/connection/connection.hpp"

namespace libration::ode {

/// c t^p y^q y'^r, r a natural number.
struct power_term {
    expression factor;
    rational time, value, slope;

    /// The weights of v = c t^(p+2-r) y^(q+r-1), for which v' = (time + value z) v.
    rational weight_of_time() const { return time + 2 - slope; }
    rational weight_of_value() const { return value + slope - 1; }
    bool is_constant() const { return weight_of_time() == 0 && weight_of_value() == 0; }
    /// v at a time, for a value of y.
    expression at(const expression& t, const expression& y) const;
};

/// y'' = sum c t^p y^q y'^r.
struct power_terms {
    parametric_system open;
    std::vector<power_term> terms;  ///< factors in the leaves of `open`
};

/// The equation of a question about a single unknown of second order; std::nullopt for other ones.
std::optional<power_terms> power_terms_in(const connection_question& question, const std::string& name);

/// y'' = sum c t^p y^q y'^r [Emden-Fowler; Thomas-Fermi: t^(-1/2) y^(3/2)]. In s = log t, with z = t y'/y and the v of its terms,
///     z' = z - z^2 + sum v z^r,   v' = (p + 2 - r + (q + r - 1) z) v,
/// a polynomial system for all real p and q. If y decays like t^-m, m > 0, z tends to -m, the v of the leading term to a nonzero limit, by
/// which m = (p + 2 - r)/(q + r - 1), those of other ones to 0, or they are constant.
struct power_equation {
    parametric_system open;
    std::string name;               ///< of y
    std::vector<power_term> terms;  ///< factors in the leaves of `open`
    std::size_t leading = 0;
    rational decay;    ///< m
    expression limit;  ///< of the v of the leading term

    /// Whether the variable does not occur.
    bool is_autonomous() const;
    /// The least d for which all exponents of t are multiples of 1/d.
    long root() const;
    /// Whether solutions y > 0 with y(inf) = 0 are determined by the value at the initial point: the difference of two increases, if all c > 0, q > 0
    /// and r = 0, except for a term k y'/t.
    bool is_monotone() const;
};

/// The equation of a question with the limits y(inf) = 0, and y'(inf) = 0 or not, of a single unknown of second order. std::nullopt for other
/// questions, and if no term is the leading one.
std::optional<power_equation> power_equation_in(const connection_question& question);

/// z, then the v of the terms that are not constant, in terms of y, y' and the leaves of the equation.
std::vector<expression> logarithmic_state(const power_equation& of, const expression& time, const expression& value,
                                          const expression& slope);

/// The question about z and v in s = log(t/time), with names[i] as the parameter for free number i. Initial values in terms of y and y' at
/// that time, which are expressions in the leaves of the equation.
connection_question logarithmic_question(const power_equation& of, const std::vector<std::string>& names,
                                         const expression& time, const expression& value, const expression& slope);

}  // namespace libration::ode
