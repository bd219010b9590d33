// The solution of a problem as an object: start here to solve an equation.
//
//     const auto x = solve(problem("x' = 1 + x^2; x(0) = 0"));
//     x->states("1/2, 1", proved_digits(30)).at(0, "x");  // tan(1/2)
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/problem.hpp"
#include "libration/problem/series_request.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

class ball;
class proved_law;
struct law_question;

namespace ode {
struct event_request;
struct known_event;
using event_watch = std::function<void(const ball& reached, long bits, const std::vector<known_event>& known)>;
}  // namespace ode

/// Which constants of a motion, all of them without names.
struct constants_request {
    std::vector<std::string> names = {};
    /// The point of the radius, as of series_request; if it is empty the top of a pendulum, at E = 2 the bottom.
    std::string about = {};
};

/// A solution in double precision, prepared for many times. Immutable: for several threads at once.
class double_sampler {
public:
    double_sampler() = default;
    virtual ~double_sampler() = default;
    double_sampler(const double_sampler&) = delete;
    double_sampler& operator=(const double_sampler&) = delete;

    /// Whether the times are within the range in which nothing is allocated.
    virtual bool reaches(std::span<const double> times) const = 0;
    /// Each of the quantities at all times, in an array of as many; the arrays may be the same memory. Throws error for
    /// a time or a value that is not finite: the contents of the arrays are then unspecified.
    virtual void at(std::span<const double> times, std::span<double* const> quantities) const = 0;
};

/// One solution of one problem. Not for several threads at once. Of equations without events and delays it keeps the steps
/// of its proved integrations, as far as they fit into 64 MiB in each direction of time: proved states at other times,
/// events, and coefficients about a time are then read from them, if the digits are not more than before.
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
    /// number that no precision within the limits decides are missing in the answer. For request::derivatives these
    /// follow, those of the first quantity first. Throws error of the kind argument
    /// for an unsupported time: before a singular initial point, beyond a singularity in arithmetic that rounds.
    virtual answer states(const std::vector<exact>& times, const request& how) const = 0;
    /// The same for a list given as text: "0, 1/2, sqrt(2)".
    answer states(const std::string& times, const request& how) const;
    /// The quantities at points of the complex plane, NAME_re and NAME_im each. A part far smaller than the other is 0
    /// (agreed_complex_values). Throws error of the subject "point" for a point that is not reached, and for balls,
    /// which cannot prove such a path.
    virtual answer states_along(const complex_path_request& along, const request& how) const = 0;
    /// The constants of the motion that are known in closed form, in one row: for the pendulum energy, gap (2 - E),
    /// period, tstar (the effective period) and radius (of convergence), inf if they are infinite; proved, whatever the
    /// scalar. std::nullopt if there are none. Throws error of the subject "constant" for another name.
    virtual std::optional<answer> constants(const request& /*how*/, const constants_request& /*of*/ = {}) const {
        return std::nullopt;
    }
    /// The quantities in double precision at many times; nullptr if there is no closed form for it.
    virtual std::unique_ptr<double_sampler> sampler() const { return nullptr; }
    /// The quantities at infinite time: at a stable equilibrium that the solution approaches, or by a lemma on the problem.
    /// Throws error of the kind undecided if neither is found.
    virtual answer limits(const request& how) const = 0;
    /// The events of a request: time and the quantities, proved, without omissions; `watch` is that of
    /// ode::searched_events. Throws std::runtime_error if the second proof of request::check disagrees.
    virtual answer events(const ode::event_request& of, const request& how, const ode::event_watch& watch) const = 0;
    /// The first `count` times after the start at which a condition such as "x' = 1/2" holds.
    answer events(const std::string& condition, long count, const request& how) const;
    /// The difference of the two sides of a condition. Throws error of the subject "problem".
    virtual ode::expression condition(const std::string& text) const = 0;
    /// Throws error of the kind argument unless the text is the notation of an expansion point of this solution; an
    /// empty text is the usual one.
    virtual void require_point(const std::string& about) const = 0;
    /// The notation of such points, for messages: "a time as 1/2, or a complex one as 1+2i".
    virtual std::string form_of_points() const = 0;
    /// Taylor coefficients of the unknowns about a point: one row per power, n and the unknowns (about a complex point
    /// NAME_re and NAME_im); in powers of a root of the variable also `power`, the exponent. Throws error of the
    /// subject "time" or "point" for a point that is not reached or, in balls, to which no path is proved.
    virtual answer series(const series_request& of, const request& how) const = 0;
    /// Those of powers 0 .. order.
    answer series(long order, const std::string& about, const request& how) const;
    /// The same as exact fractions about the initial point; std::nullopt if this solution has only decimals. Throws
    /// error if a coefficient is not a fraction.
    virtual std::optional<answer> fractions(const series_request& /*of*/) const { return std::nullopt; }
    /// The numbers that tests of convergence examine, a_0 .. a_order, with more digits than the scalar.
    virtual std::vector<unknown_series> coefficient_lists(const series_request& of,
                                                          const scalar_spec& scalar) const = 0;
    /// The radius of convergence of the series about a point, for a request in balls: proved bounds `lower` and `upper`
    /// in one row, both inf if every solution is entire; the order is not used. Throws error of the kind undecided if
    /// the search cannot bound it. For any other scalar: all tests of the coefficients up to the order (radius_answer),
    /// heuristic.
    answer radius(const series_request& of, const request& how) const;
    /// The same with the usual order.
    answer radius(const std::string& about, const request& how) const;
    /// The singularities in the complex plane within a distance of the initial point, by default twice that of the
    /// nearest, on the branch reached along rays from it: position_re, position_im, modulus, uncertainty, kind,
    /// exponent_re, exponent_im, rigour, unknown, coefficient_re, coefficient_im, resonances, evidence. Heuristic; for
    /// a request in balls each position is proved, and those that are not have the reason as evidence. A note states
    /// what was searched; if none is found there, another that this proves nothing, and the answer is heuristic. Throws
    /// error of the kind undecided if no distance is given and none is found.
    virtual answer singularities(const std::optional<double>& within, const request& how) const = 0;
    /// The law of all Taylor coefficients about the start, proved (problem/proved_law.hpp), independent of this object. Throws
    /// error as proved_law does, and of the kind undecided for piecewise equations and delays.
    virtual proved_law law(const law_question& asked, const request& how) const;

    /// The steps of kept integrations that have been made up to now; 0 if none are kept.
    virtual std::size_t steps_made() const { return 0; }

protected:
    virtual answer proved_radius(const series_request& of, const request& how) const = 0;
    /// The radius as known without coefficients, correct to `digits` digits, infinity included; std::nullopt if it is
    /// not known.
    virtual std::optional<mpfr> exact_radius(const std::string& /*about*/, long /*digits*/) const {
        return std::nullopt;
    }

    /// Whether the solution is single-valued around its singularity at this place, relative to the point of the series, by
    /// the analysis of singularities(), heuristic; std::nullopt if that does not find it.
    virtual std::optional<bool> is_single_valued(const series_request& /*of*/, const complex_number<mpfr>& /*place*/,
                                                 const request& /*how*/) const {
        return std::nullopt;
    }

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
