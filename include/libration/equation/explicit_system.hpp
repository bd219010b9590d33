// A system of differential equations solved for its highest derivatives.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// An unknown function and the order of its highest derivative.
struct unknown_function {
    std::string name;
    int order = 0;
};

/// The index of each unknown in the list.
std::map<std::string, std::size_t> places_of(const std::vector<unknown_function>& unknowns);

/// The name of the parameter that represents s = t - t0 in scaled right-hand sides, in which t does not occur.
inline constexpr const char* distance_name = "s";

/// A right-hand side y^(q) = f at an initial point t0 about which f has factors s^r, r < 0 or non-integer: the series
/// are in powers of s^(1/root), and
///     s^q y^(q) = scaled,
/// where powers of s are separate factors, as power(s, r). Its coefficient n depends on a derivative y^(l) only up to
/// the index n - l root, that is on the unknowns up to y_n; and y_{k,n} enters it as
///     sum over l of weights[k][l] (n/root)(n/root - 1) .. (n/root - l + 1) y_{k,n},
/// n > 0: with s^q y^(q) on the left, the indicial equation.
struct scaled_right_side {
    expression scaled;
    std::vector<std::vector<number>> weights;
};

struct divisor;

/// The form of a system at an initial point at which its right-hand sides are singular.
struct singular_start {
    int root = 1;
    std::vector<scaled_right_side> right;
};

/// y_i^(q_i) = f_i(t, y, y', ...), where f_i depends only on lower derivatives and parameters are replaced by their
/// values.
///
/// The given equations must be linear in the highest derivatives of their unknowns, with coefficients that may contain
/// everything else; they are solved by elimination over expressions. Equations from which elimination removes all
/// highest derivatives, as 0 = x^2 + y^2 - 1, are algebraic: their derivatives take their place, as often as necessary
/// (theorem D). An unknown without a derivative in the equations has order 1; its initial value may be left out where
/// the algebraic equations are linear in it.
///
/// The right-hand sides have no value where the given equations have none, or where a divisor of the elimination is 0:
/// what it removed from them remains as zero_where_defined() (domain/defined_zero.hpp).
class explicit_system {
public:
    /// Throws error of the subject "problem" with the position and the remedy unless there are as many equations as
    /// unknowns; an initial value for each unknown and its lower derivatives, all at one point, for which the algebraic
    /// equations hold exactly; highest derivatives that can be solved for linearly; and every function inside its
    /// domain at the initial point. A factor t^k or (t - t0)^k on the highest derivative gives a regular singular
    /// initial point; an irregular singular one is rejected.
    explicit explicit_system(const equation_system& given);
    /// y_k' = right_k in the unknowns y_k, without initial values: for expansions about points given with their states.
    static explicit_system first_order(const std::vector<expression>& unknowns, std::vector<expression> right,
                                       const number& point);

    const std::string& variable() const { return variable_; }
    const std::vector<unknown_function>& unknowns() const { return unknowns_; }
    /// f_i, which has values about every nonsingular point.
    const std::vector<expression>& right() const { return right_; }
    /// t0.
    const number& point() const { return point_; }
    /// starts()[i][j] is the j-th derivative of unknown i at t0, j below its order.
    const std::vector<std::vector<number>>& starts() const { return starts_; }
    /// The form at the initial point if that is singular.
    const std::optional<singular_start>& singular() const { return singular_; }
    /// Expressions that are 0 along the solution: the algebraic equations, and the derivatives of these that are
    /// algebraic again.
    const std::vector<expression>& algebraic() const { return algebraic_; }
    /// The invariants: expressions that are constant along a solution.
    const std::vector<expression>& invariants() const { return invariants_; }
    /// Closed forms of unknowns.
    const std::vector<definition>& exact() const { return exact_; }

private:
    explicit_system() = default;
    void read_unknowns(const equation_system& given);
    void keep_domain(const std::vector<equation>& equations, const std::vector<divisor>& divisors);
    void read_equations(const std::vector<equation>& equations);
    void read_starts(const equation_system& given, parameter_values& parameters);

    std::string variable_;
    std::vector<unknown_function> unknowns_;
    std::vector<expression> right_;
    std::vector<expression> algebraic_;
    number point_;
    std::vector<std::vector<number>> starts_;
    std::optional<singular_start> singular_;
    std::vector<expression> invariants_;
    std::vector<definition> exact_;
};

/// The names of the unknowns and their lower derivatives, in order: x, x', ...
std::vector<std::string> names_of_state(const explicit_system& system);

}  // namespace libration::ode
