// An integrator for stiff systems: collocation of high degree, proved by theorem K.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/collocation/tube.hpp"

namespace libration::ode {

class step_tube;
class tube_proof;
struct tube_candidate;

/// The tube of a step that begins with a set, from its polynomials; std::nullopt if none is proved.
using tube_rule =
    std::function<std::optional<solution_tube>(tube_proof& by, const tube_candidate& found, const tube_set& start)>;

/// Steps of theorem K for the polynomial form of a system, in sequence: each begins with the set in which the previous
/// one ended, so that its tube contains every solution that began in the first set.
///
/// The polynomials of a step satisfy the equation at Chebyshev-Radau nodes, by Newton's method. Modes, by the
/// eigenvalues of f_y in the middle, that decay within the step are fast. V has constant fast columns, the
/// eigenvectors, and slow ones that solve v' = f_y v and are kept from step to step as long as their number and their
/// angles permit. The length is chosen such that the last coefficients are negligible in the given bits, and that no
/// given unknown decays by more than about 10^-5, so that each has its own relative precision. The proof does not
/// assume any of this: the tube is proved from the polynomials alone.
class collocation_integrator {
public:
    /// The limit between slow and fast modes, from an eigenvalue times half of the length on.
    static constexpr double usual_slowest_fast = 3;

    /// What loses least depends on the solution. Limits up to 8 keep more modes slow, and the scales of unknowns, whose
    /// lower bounds are in proportion to the width of the set, may be smaller by some digits: both lose less along chaotic
    /// solutions, and more where fast modes are much faster or unknowns decay.
    struct tuning {
        double slowest_fast = usual_slowest_fast;
        double digits_below_width = 0;
    };

    /// `more_terms` is added to the degree of the polynomials, for a second proof.
    collocation_integrator(const polynomial_form& of, long bits, int more_terms, const tuning& by);
    collocation_integrator(const polynomial_form& of, long bits, int more_terms = 0)
        : collocation_integrator(of, bits, more_terms, tuning()) {}
    ~collocation_integrator();

    /// From now on the tubes are those of this rule, which may change the polynomials before it proves them.
    void prove_by(tube_rule rule);

    /// True if explicit steps of this length are much too short: the solution from this state is smooth over 32 of
    /// them, estimated by an L-stable method in long double. No proof depends on it.
    bool is_smooth_over(const ball& time, const std::vector<ball>& state, const ball& length) const;

    /// Sets the initial time, a ball represents each of its times, and the set of all unknowns of the polynomial form;
    /// `length` is the first length that is tried, and its sign the direction.
    void begin(const ball& time, tube_set start, const ball& length);
    /// Prepares a step from reached(); false if no step can be proved after many reductions of its length.
    bool prepare();
    /// The length of the prepared step, exact, with the sign of the direction.
    const ball& length() const;
    /// The length that is tried next, between two steps.
    const ball& next_length() const;
    /// The unknowns at a distance from reached(), between 0 and length(); after prepare().
    std::vector<ball> values_at(const ball& distance) const;
    /// The prepared step, which remains.
    std::shared_ptr<const step_tube> prepared() const;
    /// Takes the prepared step.
    void step();

    /// The degree of the polynomials, and the precision of their values.
    int degree() const;
    long bits() const;

    const ball& reached() const;
    const tube_set& set() const;
    /// The number of consecutive steps up to now without a fast mode.
    int steps_without_fast_modes() const;

private:
    friend class step_tube;
    struct parts;
    std::shared_ptr<parts> parts_;
};

/// The tube of a step, from its beginning over length(), which is exact and has the sign of the direction.
class step_tube {
public:
    step_tube(std::shared_ptr<collocation_integrator::parts> by, solution_tube tube)
        : by_(std::move(by)), tube_(std::move(tube)) {}

    const ball& length() const { return tube_.on.length; }
    const solution_tube& tube() const { return tube_; }
    /// The unknowns of the polynomial form at a distance between 0 and length().
    std::vector<ball> values_at(const ball& distance) const;
    /// Their derivatives there, from that of the approximate solution and bounds over the step (tube_proof).
    std::vector<ball> slopes_at(const ball& distance) const;
    /// The set at its end.
    tube_set end() const;

private:
    std::shared_ptr<collocation_integrator::parts> by_;
    solution_tube tube_;
    mutable std::optional<std::vector<magnitude>> slope_errors_;  // computed on demand
    mutable std::once_flag has_slope_errors_;
};

}  // namespace libration::ode
