// The errors of asymptotic approximants, and of the series that they are made of, against a solution that conditions at
// infinity determine.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "approximant_norms.hpp"
#include "libration/digits/agreed_values.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/limit_behaviour.hpp"

namespace libration::studies::approximant_norms {

/// 400 times after the start: Chebyshev points of the distance d up to where the solution has its asymptotic behaviour; of a
/// decay like a power of d/(d + c), c = m |f/f'| at the start, up to d = 65000 c.
inline std::vector<exact> times_to_infinity(const far_behaviour& far, const power_series<mpfr>& f) {
    constexpr long digits_of_times = 12;
    const mpfr start = ode::constant_value<mpfr>::of(far.system.point());
    const mpfr& slope = f[far.root];
    const mpfr length = slope == 0 ? mpfr(1) : mpfr(abs(mpfr(far.rate * f[0] / slope)));
    std::vector<exact> times;
    for (const double x : chebyshev_points(points)) {
        const bool is_end = far.form == far_form::algebraic && x == 1;
        if (x > 0 && !is_end) {
            const mpfr distance = far.form == far_form::algebraic ? mpfr(length * x / (1 - x)) : mpfr(far.end * x);
            times.push_back(read_exact(to_decimal(mpfr(start + distance), digits_of_times)));
        }
    }
    return times;
}

/// The series of the unknown of a behaviour, in the precision of the scope.
inline power_series<mpfr> series_of(const far_behaviour& far, int highest) {
    const ode::tape tape = ode::tape::about_start(far.system);
    ode::taylor_expansion<mpfr> expansion(tape, highest);
    expansion.about_start();
    return expansion.series_of(far.index());
}

/// A solution with so many digits and these times, or else those of times_to_infinity(). The values are proved, except for
/// singular initial points, where those on which two integrations from the proved initial values agree.
struct solution_at_infinity {
    solved_problem solved;
    std::vector<exact> times;  ///< `solved` has their distances from the start

    solution_at_infinity(const limit_problem& of, std::vector<exact> asked, int highest, long digits)
        : solved{behaviour_at_infinity(of, digits), {}, {}, {}}, times(std::move(asked)) {
        if (solved.far.form == far_form::exponential) {  // its powers of 1 - exp(-a t) lose digits
            solved.far = behaviour_at_infinity(of, digits + highest / 2);
        }
        const far_behaviour& far = solved.far;
        if (times.empty()) {
            times = times_to_infinity(far, series_of(far, far.root));
        }
        std::vector<ode::number> at;
        for (const exact& each : times) {
            at.push_back(as_exact_real(each));
            solved.times.push_back(ode::constant_value<mpfr>::of(at.back() - far.system.point()));
        }
        if (far.root > 1 || far.system.singular()) {
            for (const auto& state : ode::trajectory(far.system, at, digits)) {
                solved.truth.push_back(state[static_cast<std::size_t>(far.index())][0]);
            }
            return;
        }
        const answer states = limit_solution(of).states(times, {}, proved_digits(digits));
        if (states.missing) {
            throw error(*states.missing);
        }
        const auto column = std::ranges::find(states.names, far.unknown) - states.names.begin();
        for (const auto& row : states.rows) {
            solved.truth.emplace_back(row[static_cast<std::size_t>(column)].text);
        }
    }
};

/// A norm, and the number of its digits by those of the solution; 0 if it is not distinguished from 0.
struct judged_norm {
    norm_row of;
    long digits = 0;
    bool agreed = false;  ///< whether computations in two precisions agree on them
};

/// The norms of these orders, which increase, against a solution with so many digits.
inline std::vector<judged_norm> judged_norms(solution_at_infinity of, const std::vector<int>& orders, long digits) {
    constexpr long more_digits = 30;
    constexpr long least_digits = 2;
    const long working = digits + 20 + 3L * orders.back();
    const auto in_precision = [&](long of_digits) {
        const precision_scope scope(of_digits);
        of.solved.f = series_of(of.solved.far, orders.back());
        return norms_of(of.solved, orders);
    };
    const auto first = in_precision(working);
    const auto second = in_precision(working + more_digits);
    const precision_scope scope(working);
    mpfr size(0);
    for (const mpfr& each : of.solved.truth) {
        size = std::max(size, mpfr(abs(each)));
    }
    std::vector<judged_norm> result;
    for (std::size_t i = 0; i < first.size(); ++i) {
        judged_norm& judged = result.emplace_back(judged_norm{second[i]});
        if (first[i].found && second[i].found && second[i].found->norm > 0) {
            const mpfr& norm = second[i].found->norm;
            const bool infinite = mpfr_number_p(handle(norm)) == 0;
            const long known =
                infinite ? norm_digits : digits + static_cast<long>(floor(mpfr(log10(mpfr(norm / size)))));
            judged.digits = known < least_digits ? 0 : std::min(known, norm_digits);
            judged.agreed = infinite || agree(first[i].found->norm, norm, judged.digits);
        }
    }
    return result;
}

}  // namespace libration::studies::approximant_norms
