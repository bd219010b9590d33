// The right-hand sides of an autonomous system, without the unknowns that conserved sums determine.
#pragma once

#include <cstddef>
#include <vector>

#include "../algebra/dense_matrix.hpp"
#include "conserved_sums.hpp"

namespace libration::ode {

/// f and its derivative on boxes of the kept unknowns; all results enclose the values at every point of a box, in the
/// working precision.
class reduced_field {
public:
    explicit reduced_field(const explicit_system& of);

    /// Whether t occurs in f.
    bool depends_on_time() const { return depends_on_time_; }
    /// The number of kept unknowns.
    std::size_t size() const { return sums_.kept.size(); }

    std::vector<ball> kept_of(const std::vector<ball>& state) const;
    /// The whole state.
    std::vector<ball> state_of(const std::vector<ball>& kept) const;
    std::vector<ball> slopes(const std::vector<ball>& kept) const;
    /// The eliminated unknowns, and the derivative of one of them by a kept one.
    std::vector<ball> eliminated_of(const std::vector<ball>& kept) const;
    ball relation_slope(std::size_t e, std::size_t k, const std::vector<ball>& kept) const;
    /// The indices in the state of the eliminated unknowns.
    const std::vector<std::size_t>& eliminated() const { return sums_.eliminated; }
    /// All slopes at any state.
    std::vector<ball> slopes_of_state(const std::vector<ball>& state) const;
    /// By rows: the derivative of each of the slopes by each kept unknown, also through the eliminated ones.
    dense_matrix derivative(const std::vector<ball>& kept) const;

private:
    void keep_domain();
    ball start_of(std::size_t unknown) const;
    expression_values<ball> values_at(const std::vector<ball>& kept) const;

    first_order_form form_;
    conserved_sums sums_;
    std::vector<std::vector<expression>> partials_;  ///< of kept slopes by all unknowns
    bool depends_on_time_ = false;
};

}  // namespace libration::ode
