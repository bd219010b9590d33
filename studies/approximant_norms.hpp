// The errors of a series, of its Pade approximants and of the asymptotic approximant, up to where the solution agrees
// with its asymptotic behaviour.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "libration/approximant/asymptotic.hpp"
#include "libration/approximant/difference_norm.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/query/trajectory.hpp"
#include "text/table.hpp"

namespace libration::studies::approximant_norms {

using series::power_series;

inline constexpr int points = 401;

/// A norm on [0, end] of one approximation computed from a series.
struct norm_row {
    std::string problem, unknown;
    int order;
    std::string method;
    std::optional<norm_at<mpfr>> found;
    std::optional<mpfr> predicted;
};

// A problem with reference values of its solution at the points and its series, in the precision of the scope.
struct solved_problem {
    far_behaviour far;
    std::vector<mpfr> times, truth;
    power_series<mpfr> f;
};

inline solved_problem solve(const std::string& problem, const ode::equation_system& given, int highest, long digits) {
    solved_problem result{far_behaviour_of(problem, given, digits), {}, {}, {}};
    const far_behaviour& far = result.far;
    std::vector<ode::number> at;
    for (const double x : chebyshev_points(points)) {
        const double t = x * static_cast<double>(far.end);
        if (x < 1 || far.form != far_form::branch) {  // the branch point itself is not reached
            at.emplace_back(rational(t));
            result.times.emplace_back(t);
        }
    }
    const auto unknown = static_cast<std::size_t>(far.index());
    for (const auto& state : ode::trajectory(far.system, at, digits)) {
        result.truth.push_back(state[unknown][0]);
    }
    const ode::tape tape = ode::tape::about_start(far.system);
    ode::taylor_expansion<mpfr> expansion(tape, highest);
    expansion.about_start();
    result.f = expansion.series_of(far.index());
    return result;
}

using function_of_time = std::function<mpfr(const mpfr&)>;

inline norm_at<mpfr> norm_of(const solved_problem& of, const function_of_time& method) {
    norm_at<mpfr> largest{mpfr(0), mpfr(0)};
    for (std::size_t i = 0; i < of.times.size(); ++i) {
        const mpfr off = abs(mpfr(method(of.times[i]) - of.truth[i]));
        if (mpfr_number_p(handle(off)) == 0) {
            return {std::numeric_limits<double>::infinity(), of.times[i]};
        }
        if (!(off <= largest.norm)) {
            largest = {off, of.times[i]};
        }
    }
    return largest;
}

// The series whose radius is decisive: the bracket in t, or the polynomial in 1 - e^(-rate t).
inline std::optional<power_series<mpfr>> deciding_series(const solved_problem& of) {
    switch (of.far.form) {
        case far_form::power: return bracket_of_power(of.f, of.far.line, mpfr(-1));
        case far_form::exponential: return series_in_decay(of.f, of.far.rate);
        case far_form::reciprocal_exponential: {
            auto limit = power_series<mpfr>::zero(of.f.order());
            limit[0] = of.far.line[0];
            return series_in_decay(limit / of.f, of.far.rate);
        }
        default: return std::nullopt;
    }
}

// The radius of convergence from the slope of log |a_n| between the largest coefficients of the middle and of the last
// third, ignoring a phase of complex singularities: correct to some per cent; the singularities are assumed unknown
// here.
inline mpfr radius_of(const power_series<mpfr>& a, int count) {
    const auto log_of = [&](int n) { return a[n] == 0 ? mpfr(-1'000'000) : mpfr(log(mpfr(abs(a[n])))); };
    const mpfr rough = log_of(count) / std::max(count, 1);
    const auto highest_of = [&](int first, int end) {
        int best = first;
        for (int n = first; n < end; ++n) {
            best = log_of(n) - rough * n > log_of(best) - rough * best ? n : best;
        }
        return best;
    };
    const int lower = highest_of(count / 3, count * 2 / 3);
    const int upper = highest_of(count * 2 / 3, count + 1);
    return exp(mpfr((log_of(lower) - log_of(upper)) / std::max(upper - lower, 1)));
}

// The distance of the solution from its asymptotic behaviour at a time between two points, linear in its logarithm.
inline mpfr distance_from_far_at(const solved_problem& of, const mpfr& t) {
    for (std::size_t i = 1; i < of.times.size(); ++i) {
        if (of.times[i] >= t) {
            const auto off = [&](std::size_t k) {
                return mpfr(log(mpfr(abs(mpfr(of.truth[k] - evaluate_value(of.far.line, of.times[k]))))));
            };
            const mpfr part = (t - of.times[i - 1]) / (of.times[i] - of.times[i - 1]);
            return exp(mpfr(off(i - 1) * (1 - part) + off(i) * part));
        }
    }
    return 0;
}

// The predicted norm as a function of the order; empty if the form gives no prediction.
inline std::function<std::optional<mpfr>(int)> prediction(const solved_problem& of) {
    if (of.far.form == far_form::branch) {
        return [](int order) { return std::optional(mpfr(exp(mpfr(log(mpfr(order)) * -8 / 5)))); };
    }
    const auto decides = deciding_series(of);
    if (!decides) {
        return [](int /*order*/) { return std::optional<mpfr>(); };
    }
    int count = decides->order();
    while (of.far.form != far_form::power && count > 0 && abs((*decides)[count]) < pow(mpfr(10), -20)) {
        --count;  // coefficients below this are dominated by rounding errors of the initial value
    }
    const mpfr radius = radius_of(*decides, count);
    if (of.far.form == far_form::power) {
        return [limit = distance_from_far_at(of, radius)](int /*order*/) { return std::optional(limit); };
    }
    return [radius](int order) { return std::optional(mpfr(pow(radius, -order))); };
}

// [N - m, m] with the largest m <= N/2 for which it exists: gaps of the series exclude some.
inline std::optional<pade_approximant<mpfr>> largest_pade(const power_series<mpfr>& f) {
    for (int m = f.order() / 2; m >= 0; --m) {
        if (auto found = pade(f, f.order() - m, m)) {
            return found;
        }
    }
    return std::nullopt;
}

inline std::vector<norm_row> norms_of(const solved_problem& of, const std::vector<int>& orders) {
    const auto predicted = prediction(of);
    std::vector<norm_row> rows;
    for (const int order : orders) {
        const auto f = of.f.truncated(order);
        const auto add = [&](const std::string& method, const std::optional<function_of_time>& found) {
            norm_row row{of.far.problem, of.far.unknown, order, method, {}, {}};
            if (found) {
                row.found = norm_of(of, *found);
            }
            row.predicted = method == "asymptotic" ? predicted(order) : std::nullopt;
            rows.push_back(std::move(row));
        };
        add("series", [&](const mpfr& t) { return evaluate_value(f, t); });
        const auto rational_function = largest_pade(f);
        add("pade", rational_function
                        ? std::optional<function_of_time>([&](const mpfr& t) { return (*rational_function)(t).value; })
                        : std::nullopt);
        add("asymptotic", asymptotic_approximant(of.far, f));
    }
    return rows;
}

/// Significant digits of norms and of the quantities in the same rows.
inline constexpr long norm_digits = 12;

/// The columns of norms, without those that identify the problem and unknown.
inline const column_list<norm_row>& columns_of_norms() {
    using row = norm_row;
    static const column_list<row> all{
        {"order", "N, last power of the series at the start that is used", [](const row& r) { return r.order; }},
        {"method", "series | pade: [N - m, m] with the largest m <= N/2 that there is | asymptotic",
         [](const row& r) { return r.method; }},
        {"norm",
         "largest |method - solution| at 401 Chebyshev points from the start to where the solution is its far "
         "behaviour, in the unit of the unknown; empty where there is no Pade approximant",
         [](const row& r) { return r.found ? decimal_cell(r.found->norm, norm_digits) : cell(); }},
        {"time_of_maximum", "which of the points, in the unit of the variable",
         [](const row& r) { return r.found ? decimal_cell(r.found->place, norm_digits) : cell(); }},
        {"log10_norm", "log10 of norm", [](const row& r) { return r.found ? log10_cell(r.found->norm) : cell(); }},
        {"rigour", "two-method: the solution is what two marches agree on, the approximant in as many digits",
         [](const row& /*r*/) { return "two-method"; }},
        {"predicted",
         "what the form says of its norm as N grows, but for a factor: the distance of the solution from its "
         "far behaviour at the radius of the bracket (power), rho^-N (exponential), N^-(8/5) (branch)",
         [](const row& r) { return decimal_cell(r.predicted, norm_digits); }},
        {"log10_predicted", "log10 of predicted", [](const row& r) { return log10_cell(r.predicted); }},
    };
    return all;
}

}  // namespace libration::studies::approximant_norms
