// The solution of a problem as an object: start here to solve an equation. Its implementation needs libration::proved.
//
//     const auto x = solve(problem("x' = 1 + x^2; x(0) = 0"));
//     x->states("1/2, 1", proved_digits(30)).at(0, "x");  // tan(1/2)
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"
#include "libration/scalar/exact.hpp"

namespace libration {

/// One solution of one problem. Not for several threads at once.
class solution {
public:
    virtual ~solution() = default;
    solution(const solution&) = delete;
    solution& operator=(const solution&) = delete;

    /// The unknowns and their lower derivatives, x, x', in order.
    const std::vector<std::string>& quantities() const { return quantities_; }
    /// The name of the problem as which the equations are recognised and whose closed forms are used, in words; empty
    /// if there is none.
    virtual std::string closed_form() const { return {}; }
    /// Times as decimals: exact if they terminate, else to this many digits.
    virtual std::vector<std::string> times_in_decimals(const std::vector<exact>& times, long digits) const;

    /// The quantities at times, in any order, on both sides of the initial point. A time that is not reached and a
    /// number that no precision within the limits decides are missing in the answer. Throws error of the kind argument
    /// for an unsupported time: before a singular initial point, beyond a singularity in arithmetic that rounds.
    virtual answer states(const std::vector<exact>& times, const request& how) const = 0;
    /// The same for a list given as text: "0, 1/2, sqrt(2)".
    answer states(const std::string& times, const request& how) const;
    /// The constants of the motion that are known in closed form, in one row: for the pendulum energy, gap (2 - E),
    /// period, tstar (the effective period) and radius (of convergence about the top), inf if they are infinite.
    /// std::nullopt if there are none.
    virtual std::optional<answer> constants(const request& /*how*/) const { return std::nullopt; }
    /// The quantities at infinite time, by a lemma. Throws error of the kind undecided if there is none.
    virtual answer limits(const request& how) const = 0;
    /// The first `count` times after the start at which a condition such as "x' = 1/2" holds: time and the quantities,
    /// proved, without omissions.
    virtual answer events(const std::string& condition, long count, const request& how) const = 0;
    /// The Taylor coefficients of powers 0 .. order of every unknown about a time, by default the initial point: one
    /// row per power, n and the unknowns.
    virtual answer series(long order, const std::string& about, const request& how) const = 0;
    /// Proved bounds of the radius of convergence of that series: lower and upper in one row; inf for both if every
    /// solution is entire. Throws error of the kind undecided if the search cannot bound it.
    virtual answer radius(const std::string& about, const request& how) const = 0;

protected:
    explicit solution(std::vector<std::string> quantities) : quantities_(std::move(quantities)) {}

private:
    std::vector<std::string> quantities_;
};

/// The method by which a problem is solved.
struct settings {
    /// By Taylor series of the equations, even if closed forms are known.
    bool general = false;
};

/// The solution of a problem: by closed forms if the equations are recognised as those of a problem that has them
/// (the pendulum in any notation), else by Taylor series with proved bounds. Throws error of the subject
/// "problem" as ode::explicit_system does.
std::unique_ptr<solution> solve(const problem& given, const settings& by = {});

}  // namespace libration
