// A separate time in which an algebraic branch point of a solution is a regular point.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// Systems in a time s with dt/ds = w^(q-1) W, W nonzero, w a coordinate with simple zeros, at which t - t* ~ (s - s*)^q:
///     y' = a_d(t) y^d + .. + a_0(t), d >= 3:      v = 1/y, t' = v^(d-2), v' = -(a_d + a_(d-1) v + .. + a_0 v^d);
///     y' = N(t, y)/D(t, y), D a constant times w^m:  t' = D, y' = N;
///     x'' = A(x) x' + g(t, x), d = deg A + 1 >= 3, deg g <= d - 2, with z = x' - G(x), G' = A:
///                                                 v = 1/x, t' = v^(d-2), v' = -v^d (z + G(1/v)), z' = v^(d-2) g(t, 1/v).
/// In the first and the third w = v, q = d - 1, and y has the leading exponent -1/q there (p = 1); in the second q = m + 1,
/// and y is finite (p = 0). All unknowns of s are regular at the branch point.
class uniformizing_chart {
public:
    /// Returns std::nullopt for other systems.
    static std::optional<uniformizing_chart> of(const explicit_system& system);

    int sheets() const { return sheets_; }
    /// p: y = sum over j >= -p of c_j x^j, x = (1 - (t - t0)/(t* - t0))^(1/q).
    int pole() const { return pole_; }
    /// t, then v or y, then z; in s, without initial values.
    const explicit_system& system() const { return system_; }

    /// Its unknowns at a time from the state of the given system.
    template <field R>
    std::vector<R> from(const R& time, const std::vector<R>& state) const {
        if (pole_ == 0) {
            return {time, state[0]};
        }
        std::vector<R> result{time, R(R(1) / state[0])};
        if (state.size() > 1) {
            expression_values<R> at({lienard_of_}, time);
            at.push_back(state[0]);
            result.push_back(state[1] - at.of(lienard_));
        }
        return result;
    }

    /// w and dw/ds at a state in s.
    template <field R>
    std::pair<R, R> zero_and_slope(const std::vector<R>& state) const {
        expression_values<R> at(leaves_, R(0));
        for (const R& each : state) {
            at.push_back(each);
        }
        return {at.of(zero_), at.of(slope_)};
    }

    /// The state at the branch point, where v = 0 exactly.
    template <field R>
    std::vector<R> at_zero(std::vector<R> state) const {
        if (pole_ == 1) {
            state[1] = R(0);
        }
        return state;
    }

private:
    uniformizing_chart(int sheets, int pole, std::vector<expression> leaves, std::vector<expression> right,
                       expression zero);
    static std::optional<uniformizing_chart> of_first_order(const explicit_system& system);
    static std::optional<uniformizing_chart> of_second_order(const explicit_system& system);

    int sheets_, pole_;
    std::vector<expression> leaves_;
    explicit_system system_;
    expression zero_, slope_;
    expression lienard_, lienard_of_;  ///< G and the unknown in it
};

}  // namespace libration::ode
