// Where expressions that are 0 are defined: 0*log(1 - t) is 0 for t < 1 and has no value from t = 1 on.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The expression with its leaves replaced, as by replaced(), and what folding has removed from it.
struct folded_expression {
    expression value;
    /// The functions, powers and reciprocals of divisors, leaves replaced, that are not analytic for all real arguments
    /// and not constant, and do not occur in the value.
    std::vector<expression> lost;
};

folded_expression folded_by(const expression& e, const replacement& by);

/// Such parts of some expressions, leaves replaced, that do not occur in others.
std::vector<expression> parts_lost(const std::vector<expression>& from, const replacement& by,
                                   const std::vector<expression>& others);

/// 0 where the expression is analytic, without a value elsewhere: the product 0*e, which no operation folds; 0 itself
/// if the expression has only parts that are analytic for all real arguments.
expression zero_where_defined(const expression& e);

/// Whether an expression has only parts that are analytic for all real arguments.
inline bool is_defined_everywhere(const expression& e) { return zero_where_defined(e).is(0); }

/// The expression with 0 for such products.
expression without_zeros(const expression& e);

/// The operations of formulas as they are written: with zero_where_defined() of an operand that folding would remove.
expression written_sum(const expression& a, const expression& b);
expression written_product(const expression& a, const expression& b);
expression written_quotient(const expression& a, const expression& b);
expression written_power(const expression& base, const expression& exponent);

/// replaced(), likewise.
expression replaced_as_written(const expression& e, const replacement& by);

/// Whether an expression is identically 0 where its leaves have these values, and where: the parts that have to be
/// analytic for it, none if it is 0 everywhere. std::nullopt if that does not follow by folding, which is exact.
std::optional<std::vector<expression>> zero_with_domain(const expression& e, const replacement& by);

/// The unknowns that keep their initial values: the largest set of unknowns of these names with derivatives 0 whose
/// right-hand sides vanish identically where all of them have these values.
std::set<std::string> resting_unknowns(const explicit_system& of, std::set<std::string> among);
/// The values of these unknowns and of their derivatives at the initial point.
replacement at_starts(const explicit_system& of, const std::set<std::string>& names);

/// The parts of the right-hand sides that do not move the solution from the initial values, but end it where they are
/// not analytic: those of unfolded zeros, and those that resting unknowns multiply by 0. A method whose steps follow
/// from the size of the solution's coefficients has to limit them by these, too.
std::vector<expression> hidden_parts(const explicit_system& of);

}  // namespace libration::ode
