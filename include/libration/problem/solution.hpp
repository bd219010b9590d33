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
    /// The problem that the equations are recognised as and by whose closed forms it answers, in words; empty where
    /// there is none.
    virtual std::string closed_form() const { return {}; }
    /// Times as decimals: exact where they end, else to so many digits.
    virtual std::vector<std::string> times_in_decimals(const std::vector<exact>& times, long digits) const;

    /// The quantities at times, in any order, on both sides of the start. A time that is not reached and a number that
    /// no precision within the limits decides are missing in the answer. Throws error of the kind argument for a time
    /// of which nothing can be said: before a singular start, beyond a singularity in arithmetic that rounds.
    virtual answer states(const std::vector<exact>& times, const request& how) const = 0;
    /// The same of a list as it is typed: "0, 1/2, sqrt(2)".
    answer states(const std::string& times, const request& how) const;
    /// What is constant along it and known in closed form, in one row: of the pendulum energy, gap (2 - E), period, tstar
    /// (the effective period) and radius (of convergence about the top), inf where they are infinite. std::nullopt
    /// where nothing is.
    virtual std::optional<answer> constants(const request& /*how*/) const { return std::nullopt; }
    /// The quantities at infinite time, by a lemma. Throws error of the kind undecided where there is none.
    virtual answer limits(const request& how) const = 0;
    /// The first `count` times after the start at which a condition such as "x' = 1/2" holds: time and the quantities,
    /// proved, none left out between.
    virtual answer events(const std::string& condition, long count, const request& how) const = 0;
    /// The Taylor coefficients of powers 0 .. order of every unknown about a time, the start where it is empty: a row
    /// a power, n and the unknowns.
    virtual answer series(long order, const std::string& about, const request& how) const = 0;
    /// Proved bounds of the radius of convergence of that series: lower and upper in one row; inf for both where every
    /// solution is entire. Throws error of the kind undecided where the search cannot bound it.
    virtual answer radius(const std::string& about, const request& how) const = 0;

protected:
    explicit solution(std::vector<std::string> quantities) : quantities_(std::move(quantities)) {}

private:
    std::vector<std::string> quantities_;
};

/// How a problem is solved.
struct settings {
    /// By Taylor series of the equations, even where closed forms are known.
    bool general = false;
};

/// The solution of a problem: by closed forms where the equations are recognised as those of a problem that has them
/// (the pendulum, however it is written), else by Taylor series with proved bounds. Throws error of the subject
/// "problem" as ode::explicit_system does.
std::unique_ptr<solution> solve(const problem& given, const settings& by = {});

}  // namespace libration
