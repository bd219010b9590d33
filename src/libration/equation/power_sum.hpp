// Expressions as sums of products of rational powers: exact linear relations between expressions.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libration/equation/node_values.hpp"

namespace libration::ode {

/// A product of powers u_k^(r_k), r_k != 0, by ascending indices of the u_k.
using power_product = std::vector<std::pair<std::size_t, rational>>;
/// A sum of such products with their factors, none of which is 0.
using power_sum = std::map<power_product, rational>;

/// More terms than are examined, or a power that has no such form.
struct no_power_sum {};

/// The forms of expressions as power sums in common u_k, each of which is a leaf, a function, a constant that is not a
/// fraction, or a sum that occurs with an exponent other than 1, 2, .. in the expressions. Wherever an expression has a
/// value, its form has the same: (u^a)^b becomes u^(ab) only if a is not an even number, since then u > 0 where the
/// powers have values.
class power_sums {
public:
    /// Throws no_power_sum.
    const power_sum& of(const expression& e);
    static power_sum product(const power_sum& a, const power_sum& b);

    /// The object with an index.
    struct base {
        expression typed;                 ///< its first form
        std::optional<power_sum> as_sum;  ///< of a sum
    };
    const std::vector<base>& bases() const { return bases_; }

    /// All c with c_1 e_1 + .. + c_n e_n = 0 identically that follow from equal products of powers, a basis: wherever
    /// all e_k have values. Whole powers of a sum are expanded to the smallest exponent that occurs for it.
    std::vector<std::vector<rational>> relations(std::vector<power_sum> of) const;
    /// The same between rows of expressions: every entry of the combined row is 0.
    std::vector<std::vector<rational>> relations(const std::vector<std::vector<power_sum>>& rows) const;

private:
    power_sum converted(const expression& e);
    power_sum raised(const expression& of, const power_sum& sum, const rational& exponent);
    power_sum single(const expression& e);
    std::size_t index_of(const expression& typed, const power_sum& sum);
    void expand(std::vector<power_sum>& sums, std::size_t index) const;

    node_values<power_sum> done_;
    std::vector<base> bases_;
    std::unordered_map<expression, std::size_t, same_expression::hash, same_expression::equal> singles_;
    std::map<power_sum, std::size_t> sums_;
};

}  // namespace libration::ode
