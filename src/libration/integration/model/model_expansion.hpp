// The Taylor series of all solutions from a box of initial values, each coefficient a Taylor model on it.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/expansion/tail_bound.hpp"
#include "taylor_model.hpp"

namespace libration::ode {

/// Coefficients 0 .. N of the series of the unknowns about a point by the recurrences of taylor_expansion, for a tape of
/// a polynomial system of first order: of products, squares and linear operations, made by tape::about_points.
class model_expansion {
public:
    /// The tape and the set must outlive this object.
    model_expansion(const tape& of, int order, const monomial_set& in);

    /// About a point from models of all unknowns.
    void about(const ball& point, const std::vector<taylor_model>& state);

    int order() const { return order_; }
    const monomial_set& in() const { return *in_; }
    /// The polynomial of degree N of an unknown at every distance of a ball.
    taylor_model at(std::size_t unknown, const ball& distance) const;
    /// Bounds of the coefficients over the box: theorem T holds for all solutions with them.
    series_sizes sizes() const;
    /// Bounds of the coefficients of an unknown.
    std::vector<magnitude> sizes_of(std::size_t unknown) const;

private:
    taylor_model computed(const tape_step& step, std::size_t n) const;
    ball factor_of(const tape_step& step) const;

    const tape* tape_;
    int order_;
    const monomial_set* in_;
    ball point_;
    std::vector<ball> constants_;
    std::vector<int> states_;  // the steps of the unknowns, -1 if there is none
    std::vector<std::vector<taylor_model>> steps_;
    std::vector<std::vector<taylor_model>> unknowns_;
};

}  // namespace libration::ode
