// The Taylor series of several solutions of one system, each about its own point.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "libration/expansion/lane_functions.hpp"
#include "libration/expansion/lane_numbers.hpp"
#include "libration/expansion/step_arrays.hpp"
#include "libration/expansion/tape.hpp"

namespace libration::ode {

/// What taylor_expansion<double>::about computes, for batch_lanes points and states at once: the operations of a step
/// of the tape are the same in all lanes and in the same order as there, so that each lane has the bits that its
/// solution would have alone, wherever the compiler does not fuse products and sums, as by default on x86-64. Sums and
/// quotients of coefficients, roots, powers, sin, cos, exp, log, tan and the hyperbolic ones run in vectors; the value
/// of a function at the point is that of double in each lane, and the coefficients of the other functions are computed
/// without vectors. What depends on parameters alone has one coefficient, and costs one operation.
class batch_expansion {
public:
    /// Up to the power N >= 1. parameters[i] states that component i of the state (names_of_state) is a parameter: an
    /// unknown with the slope 0, as in parametric_system.
    batch_expansion(const explicit_system& system, int order, std::vector<bool> parameters);
    ~batch_expansion();
    batch_expansion(const batch_expansion&) = delete;
    batch_expansion& operator=(const batch_expansion&) = delete;

    int order() const { return order_; }
    /// The number of components of the state, with parameters.
    std::size_t size() const { return components_.size(); }
    const std::vector<bool>& parameters() const { return parameters_; }

    /// Expands about points from the states there, [component][lane].
    void about(const lane_numbers& points, std::span<const lane_numbers> states);
    /// The polynomials of the components except parameters, at these distances from the points; the others are
    /// left as they are.
    void at(const lane_numbers& distances, std::span<lane_numbers> states) const;
    /// The largest |c_n| over the components except parameters; NaN where one of them is not finite.
    lane_numbers sizes(int n) const;

private:
    class program_builder;
    struct program;

    void compute(int step, int n);

    tape tape_;
    int order_;
    std::vector<bool> parameters_;
    step_arrays<lane_numbers> arrays_;
    std::vector<lane_numbers*> components_;  // the array of each component
    std::vector<const double*> moving_;      // those of components except parameters
    std::vector<std::size_t> places_;        // their places in the state
    std::unique_ptr<program> program_;
    mutable std::vector<lane_numbers> values_;
};

#ifdef LIBRATION_COMPILED
extern template class step_arrays<lane_numbers>;
#endif

}  // namespace libration::ode
