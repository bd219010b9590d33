// Conditions at times as functions of the free numbers of a system: the map of a shooting method, in balls.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/algebra/krawczyk.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// The midpoints of numbers, for proved_root().
std::vector<ball> first_iterate(const std::vector<number>& guess);

/// F_i(x) = g_i(x, y(t_1; x), ..., y(t_m; x)): the conditions g_i = 0 of the solution y with the free numbers x. Only
/// the unknowns that the conditions depend on are integrated. A time may depend on x: with the flow D = dy(t)/dy(t_0),
///     dF_i/dx_j = dg_i/dx_j + sum over k of dg_i/dy_k (D dy(t_0)/dx_j + y'(t_k) dt_k/dx_j).
class shooting {
public:
    /// Throws error for names that are neither parameters nor initial values, for conditions at no time, and for values
    /// that are not part of the state.
    shooting(const equation_system& given, const std::vector<std::string>& names, const conditions_at_times& conditions,
             const proof_route& route, march_watch watch);

    /// The same for a system whose `others` are the conditions and then the times of their values, in its leaves; the
    /// values are of its unknowns.
    shooting(const parametric_system& open, conditions_at_times conditions, const proof_route& route,
             march_watch watch);

    /// The system that is integrated, with the free numbers, and the conditions.
    const parametric_system& open() const { return open_; }
    const conditions_at_times& conditions() const { return conditions_; }
    /// The values of the free numbers in the system.
    const std::vector<number>& guess() const { return open_.values; }

    /// F and its derivative over a box, as map_of_unknowns.
    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const;

private:
    using number_values = expression_values<ball>;
    // The values that are wanted at one time.
    struct moment {
        expression time;
        std::vector<expression> slopes;                           // of the time, by the free numbers
        std::vector<std::pair<std::size_t, std::size_t>> values;  // index in the state, index among all values
        bool is_fixed() const;
    };
    // A moment at the values of the free numbers.
    struct timed_moment {
        const moment* what;
        ball time;
    };
    struct start {
        std::vector<ball> values;
        ball_matrix by_numbers;
    };

    void read_moments();
    std::size_t index_in_state(const expression& of) const;
    start start_at(number_values& numbers) const;
    std::vector<timed_moment> in_order(number_values& numbers) const;
    // Sets the values at the moments of one direction; false if more bits are needed.
    bool integrate(const start& from, const std::vector<timed_moment>& order, long bits, long error_bits,
                   number_values& numbers, enclosed_map& values) const;
    enclosed_map conditions_at(number_values& numbers, const enclosed_map& values) const;

    parametric_system open_;
    conditions_at_times conditions_;
    std::optional<first_order_form> form_;           // if a time depends on the free numbers
    std::vector<expression> leaves_;                 // the free numbers, then the values at times
    std::vector<std::vector<expression>> by_start_;  // the derivatives of the initial values
    std::vector<moment> moments_;
    std::vector<std::vector<expression>> gradients_;  // of the conditions, by leaves_
    proof_route route_;
    march_watch watch_;
};

}  // namespace libration::ode
