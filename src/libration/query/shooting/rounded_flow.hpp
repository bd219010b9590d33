// The flow of a system in double precision, with which a proof of a periodic orbit begins; no proof depends on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

/// Where a solution comes near to its initial point again.
struct near_return {
    double time = 0;      ///< since the initial point
    double distance = 0;  ///< from it, relative to the largest distance before
};

class rounded_flow {
public:
    explicit rounded_flow(const explicit_system& system);

    /// The state after so long a time; std::nullopt if it is not reached.
    std::optional<std::vector<double>> at(const std::vector<double>& start, double time);
    /// The derivative by the state, by central differences, as rows; empty if it is not reached.
    std::vector<std::vector<double>> derivative(const std::vector<double>& start, double time);
    std::vector<double> slopes(const std::vector<double>& state) const;
    /// The state after so long a time in the working precision.
    std::optional<std::vector<mpfr>> at(const std::vector<mpfr>& start, const mpfr& time) const;
    const std::vector<double>& start() const { return start_; }

    /// The first close return, at a relative distance below 0.02, within 5000 steps and 24 local minima of the distance;
    /// the closest one if there is none. With a time, the closest one within 1.5 times of it.
    std::optional<near_return> closest_return(const std::optional<double>& about);

private:
    std::optional<near_return> return_in_step(double from, double to, double& slope, double& farthest);
    std::vector<double> in_series(double time) const;

    const explicit_system& system_;
    first_order_form form_;
    double origin_;
    taylor_march<double> march_;
    std::vector<double> start_;
};

/// The closest return in double precision. Throws error of the kind undecided, with that return, if it is farther than
/// 30 % of the size of the orbit, or if there is none within 1.5 times of a given period.
near_return guessed_return(rounded_flow& flow, const std::optional<number>& period);

/// "at time 6.3, at 2 % of the size of the orbit".
std::string described_return(const near_return& at);

}  // namespace libration::ode
