// Many solutions of one system in double at once: from many states, with many values of its parameters.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libration/expansion/batch_expansion.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

/// The solutions to be computed.
struct batch_request {
    double begin = 0;                ///< the time of the states
    std::span<const double> states;  ///< of one solution after the other, each in the order of names_of_state
    std::span<const double> times;   ///< in any order, on both sides of `begin`
};

/// The indices of times in the order in which steps reach them: those from `begin` on ascending, then the others
/// descending.
std::vector<std::size_t> in_order_of_steps(double begin, std::span<const double> times);

/// Integrates batch_lanes solutions in lock step, one in each lane of SIMD vectors (batch_expansion): each has its own
/// time and length of steps, chosen by the rule of taylor_march<double>, and when it has passed the last time the next
/// solution takes its lane. A solution has the same steps and, wherever its operations are not fused, the same bits as
/// in taylor_march<double>, whatever the others do: some epsilon of max(1, its largest component) per step, amplified
/// by the flow; nothing is proved. The length of the steps does not depend on parameters. An object is for one thread.
class batch_march {
public:
    /// Steps and order of taylor_march<double>. parameters[i] states that component i of the states is a parameter (the
    /// constant unknown of parametric_system); none if it is empty.
    explicit batch_march(const explicit_system& system, std::vector<bool> parameters = {})
        : batch_march(system, step_accuracy{0, taylor_order(digits<double>())}, std::move(parameters)) {}
    /// With steps of a chosen accuracy.
    batch_march(const explicit_system& system, const step_accuracy& accuracy, std::vector<bool> parameters = {});

    /// The number of components of a state, and of those that are written: without parameters.
    std::size_t size() const { return expansion_.size(); }
    std::size_t written() const { return written_.size(); }

    /// values[solution][time][component], without parameters; NaN at times that are not reached since the steps become
    /// too small or a value is not finite, near a singularity, of that solution alone.
    /// finished(k) is called with the number of solutions that are complete, after each of them and from time to time;
    /// its exceptions end the integration.
    void run(const batch_request& request, std::span<double> values,
             const std::function<void(std::size_t)>& finished = {});

private:
    class integration;
    void run_alone(const batch_request& request, std::span<double> values,
                   const std::function<void(std::size_t)>& finished);

    batch_expansion expansion_;
    step_accuracy accuracy_;
    std::vector<std::size_t> written_;  // the components except parameters
    std::vector<int> orders_;
    std::optional<taylor_march<double>> alone_;  // where parts are hidden (hidden_parts): one solution after the other
};

}  // namespace libration::ode
