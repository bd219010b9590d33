// A system of differential equations solved for its highest derivatives.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// An unknown function and the order of its highest derivative.
struct unknown_function {
    std::string name;
    int order = 0;
};

/// The place of each unknown in a list of them.
std::map<std::string, std::size_t> places_of(const std::vector<unknown_function>& unknowns);

/// The name of the parameter that stands for s = t - t0 in scaled right sides, where t does not occur.
inline constexpr const char* distance_name = "s";

/// A right side y^(q) = f at a start t0 about which f has factors s^r, r < 0 or no whole number: the series go in
/// powers of s^(1/root), and
///     s^q y^(q) = scaled,
/// where powers of s are factors of their own, as power(s, r). Its coefficient n reads a derivative y^(l) up to the
/// index n - l root alone, that is the unknowns up to y_n; and y_{k,n} enters it as
///     sum over l of weights[k][l] (n/root)(n/root - 1) .. (n/root - l + 1) y_{k,n},
/// n > 0: with s^q y^(q) on the left, the indicial equation.
struct scaled_right_side {
    expression scaled;
    std::vector<std::vector<number>> weights;
};

/// What a system is at a start where its right sides are singular.
struct singular_start {
    int root = 1;
    std::vector<scaled_right_side> right;
};

/// y_i^(q_i) = f_i(t, y, y', ...), f_i of lower derivatives alone, parameters replaced by their values.
///
/// The given equations have to be linear in the highest derivatives of their unknowns, with coefficients that may hold
/// everything else; they are solved by elimination over expressions.
class explicit_system {
public:
    /// Throws error of the subject "problem" with the place and the remedy: as many equations as unknowns; a start for
    /// each unknown and its lower derivatives, all at one point; highest derivatives that come out linearly; every
    /// function inside its domain at the start. A factor t^k or (t - t0)^k on the highest derivative is a regular
    /// singular start; one beyond that, irregular, is refused.
    explicit explicit_system(const equation_system& given);
    /// y_k' = right_k in the unknowns y_k, without starts: for expansions about points that are given with their
    /// states.
    static explicit_system first_order(const std::vector<expression>& unknowns, std::vector<expression> right,
                                       const number& point);

    const std::string& variable() const { return variable_; }
    const std::vector<unknown_function>& unknowns() const { return unknowns_; }
    /// f_i, which has values about every point but singular ones.
    const std::vector<expression>& right() const { return right_; }
    /// t0.
    const number& point() const { return point_; }
    /// starts()[i][j] is the j-th derivative of unknown i at t0, j below its order.
    const std::vector<std::vector<number>>& starts() const { return starts_; }
    /// Where the start is singular.
    const std::optional<singular_start>& singular() const { return singular_; }
    /// What stays constant along a solution.
    const std::vector<expression>& invariants() const { return invariants_; }
    /// Closed forms of unknowns.
    const std::vector<definition>& exact() const { return exact_; }

private:
    explicit_system() = default;
    void read_unknowns(const equation_system& given);
    void read_starts(const equation_system& given, parameter_values& parameters);

    std::string variable_;
    std::vector<unknown_function> unknowns_;
    std::vector<expression> right_;
    number point_;
    std::vector<std::vector<number>> starts_;
    std::optional<singular_start> singular_;
    std::vector<expression> invariants_;
    std::vector<definition> exact_;
};

}  // namespace libration::ode
