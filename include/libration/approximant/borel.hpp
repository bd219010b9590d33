// Borel summation of a divergent series of Gevrey order s, a_n ~ C Gamma(s n - t) A^-n: with
//     B(t) = sum a_n t^n/Gamma(s n + b),   f(x) = int_0^oo e^-u u^(b-1) B(x u^s) du,
// where B, whose nearest singularity is A, is continued along the ray of x by a Pade approximant or in the variable of
// the map of the plane without the ray from A to infinity [LeGuillouZinnJustin1980, CalicetiEtAl2007]. The integral is
// computed by the double exponential rule [TakahasiMori1974] in u = exp(v - e^-v).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libration/approximant/pade.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// a_n/Gamma(s n + b), n = 0 .. N, in the working precision; s, b > 0.
std::vector<mpfr> borel_transform(std::span<const mpfr> a, const rational& s, const rational& b);

/// An integral and its estimated error.
struct laplace_value {
    mpfr value, error;
};

/// The rule for int_0^oo e^-u u^(b-1) g(u^s) du with nodes at v = k/32, of which those of even k are the coarser rule:
/// the error is the difference of the two. With g analytic about the ray it reaches about 45 digits.
class laplace_rule {
public:
    laplace_rule(const rational& s, const rational& b);

    /// u^s at the nodes, ascending.
    std::vector<mpfr> points() const;

    /// int_0^oo e^-u u^(b-1) g(u^s) du.
    laplace_value integral(const std::function<mpfr(const mpfr&)>& g) const;

    /// The same of g(t) = P(x t)/Q(x t). Each pole on the ray adds pi times its residue in u to the error: half the
    /// difference of the integrals above and below it. std::nullopt if a node is a pole.
    std::optional<laplace_value> integral(const pade_approximant<mpfr>& quotient, const mpfr& x) const;

private:
    struct node {
        mpfr at;  ///< u^s
        mpfr weight;
        bool coarse;
    };
    mpfr pole_between(const pade_approximant<mpfr>& quotient, const mpfr& x, mpfr below, mpfr above) const;

    mpfr s_, b_;
    std::vector<node> nodes_;
};

}  // namespace libration
