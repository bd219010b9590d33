// Sums of fractions times exponentials of fractions, which are exact.
#pragma once

#include <map>
#include <optional>

#include "exact_real_atom.hpp"

namespace libration {

/// x = sum_r q_r exp(r) with fractions r and q_r != 0. The exponentials of different fractions are linearly independent
/// over the fractions (Lindemann and Weierstrass), so that equal numbers have equal sums.
class exact_real::exponential_form {
public:
    /// Of exp, expm1, sinh and cosh of fractions, and of sums, products, quotients by a single term, powers and roots;
    /// std::nullopt for other expressions and for more than a few terms.
    static std::optional<exponential_form> of(const exact_real& x);

    /// r if x = r exp(r), r >= -1: the value of lambertw at x.
    std::optional<rational> lambertw() const;

private:
    using terms = std::map<rational, rational>;  // r -> q_r

    static std::optional<exponential_form> of(const atom& x);
    static std::optional<exponential_form> of_function(const atom& x);
    static exponential_form exponential(const rational& q, const rational& r);
    std::optional<exponential_form> raised(const rational& exponent) const;
    void add(const rational& factor, const exponential_form& more);
    static exponential_form difference(exponential_form a, const exponential_form& b);
    static std::optional<exponential_form> product(const exponential_form& a, const exponential_form& b);

    terms terms_;
};

}  // namespace libration
