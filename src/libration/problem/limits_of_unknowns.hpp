// States and limits of a solution from the proved numbers on which it depends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// The ball of all numbers within the uncertainty of a decimal, in the working precision.
ball enclosure_of(const proved_decimal& of);
/// With so many digits if they are proved, else with a bound.
known_value known_of(const ball& value, long digits);

/// The solution for the numbers within the uncertainties of decimals.
class limits_of_unknowns {
public:
    /// In the working precision. The quantities are unknowns and lower derivatives, all in order.
    limits_of_unknowns(const ode::equation_system& of, const std::vector<std::string>& unknowns,
                       std::vector<ode::limit_condition> limits, const std::vector<proved_decimal>& values,
                       const std::vector<std::string>& quantities);

    std::optional<std::vector<std::vector<ball>>> states(const std::vector<ball>& times, long bits,
                                                         const ode::proof_route& route, const ode::march_watch& watch);
    /// The limit of a quantity that a condition gives, with so many digits; if it is one at which the solution comes to rest (`rests`), also
    /// 0 of its derivative; of a boundary layer (`of_layer`), where the limit of f' is positive, also infinity of f. std::nullopt for others.
    std::optional<answer_value> limit(const std::string& quantity, int direction, long digits, bool rests,
                                      bool of_layer);

private:
    std::vector<ode::limit_condition> limits_;
    ode::parametric_system open_;
    std::vector<std::size_t> places_;
    ode::expression_values<ball> values_;
};

}  // namespace libration
