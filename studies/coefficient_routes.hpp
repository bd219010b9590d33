// The routes to the coefficients of the pendulum's series and of its resummation, with what they start from and what
// they must give.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/other_recurrences.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/singularities.hpp"
#include "text/table.hpp"

namespace libration::studies::coefficient_routes {

using namespace series;
using namespace elliptic;
using namespace pendulum;

enum class route {
    direct,
    direct_parity,
    symmetric_squares,
    speed,
    arcsine,
    arcsine_parity,
    convolution,
    running_sums,
    alpha_beta
};

struct named_route {
    route which;
    std::string name;
    bool resums = false;
};

inline const std::vector<named_route>& routes() {
    static const std::vector<named_route> all{{route::direct, "direct"},
                                              {route::direct_parity, "direct_parity"},
                                              {route::symmetric_squares, "symmetric_squares"},
                                              {route::speed, "speed"},
                                              {route::arcsine, "arcsine"},
                                              {route::arcsine_parity, "arcsine_parity"},
                                              {route::convolution, "convolution", true},
                                              {route::running_sums, "running_sums", true},
                                              {route::alpha_beta, "alpha_beta", true}};
    return all;
}

// The input of every route: the top with its symmetry, R, T*, and for the resummation a_n T*^n and both ends.
template <class T>
struct given {
    taylor_start<T> top;
    T radius;
    T height;  // K~'
    power_series<T> series;
    std::vector<T> endpoint;
};

inline given<mpfr> given_by(const motion& m, int order) {
    const auto arc = arc_of<mpfr>(m);
    const auto lattice = *singularities<mpfr>(m);
    const auto top = phase_map<mpfr>::at_quarter(exact_solution<mpfr>::top_quarter(m));
    return {arc.start(), lattice.radius(top), lattice.height, arc_series(arc, order), arc_endpoint(arc)};
}

// These numbers in another arithmetic.
template <class T>
given<T> in(const given<mpfr>& exact) {
    const auto to = [](const mpfr& x) { return narrow<T>(x); };
    const auto& [state, pair, of_theta] = exact.top;
    std::vector<T> series;
    std::vector<T> endpoint;
    std::transform(exact.series.coefficients().begin(), exact.series.coefficients().end(), std::back_inserter(series),
                   to);
    std::transform(exact.endpoint.begin(), exact.endpoint.end(), std::back_inserter(endpoint), to);
    return {{{to(state.theta), to(state.omega), to(state.half_sine), to(state.half_cosine)},
             {to(pair.energy), to(pair.gap)},
             of_theta},
            to(exact.radius),
            to(exact.height),
            power_series<T>(std::move(series)),
            std::move(endpoint)};
}

template <class T>
power_series<T> by(route which, const given<T>& from, int order) {
    taylor_start<T> blind = from.top;
    blind.of_theta = parity::any;
    switch (which) {
        case route::direct: return taylor_by_sine_cosine(blind, order, from.radius);
        case route::direct_parity: return taylor_by_sine_cosine(from.top, order, from.radius);
        case route::symmetric_squares: return taylor_by_symmetric_squares(from.top, order, from.radius);
        case route::speed: return taylor_by_speed(from.top, order, from.radius);
        case route::arcsine: return taylor_by_arcsine(blind, order, from.radius);
        case route::arcsine_parity: return taylor_by_arcsine(from.top, order, from.radius);
        case route::convolution: return inner_series_by_convolution(from.series, from.endpoint);
        case route::running_sums: return inner_series(from.series, from.endpoint);
        default: return endpoint_corrected(from.series, from.endpoint);
    }
}

// The reason why a route does not exist here.
inline std::optional<std::string> refusal(route which, const given<mpfr>& from) {
    try {
        by(which, from, 2);
    } catch (const error& problem) {
        return problem.what();
    }
    return std::nullopt;
}

// The coefficients of (1-x)^2 h plus the two at the end: the polynomial that alpha and beta give directly.
inline power_series<mpfr> as_polynomial(const power_series<mpfr>& inner, const std::vector<mpfr>& endpoint) {
    auto result = power_series<mpfr>::zero(inner.order() + 2);
    for (int n = 0; n <= inner.order(); ++n) {
        result[n] += inner[n];
        result[n + 1] -= inner[n] * 2;
        result[n + 2] += inner[n];
    }
    const auto straight = expand_at_zero(endpoint);
    result[0] += straight[0];
    result[1] += straight[1];
    return result;
}

// The expected results of the routes; computed in the precision in force, before that of the routes is set.
struct expected_results {
    power_series<mpfr> coefficients;
    power_series<mpfr> inner;
    power_series<mpfr> polynomial;

    const power_series<mpfr>& of(const named_route& r) const {
        return !r.resums ? coefficients : r.which == route::alpha_beta ? polynomial : inner;
    }
};

inline expected_results expected_of(const given<mpfr>& exact, int order) {
    auto inner = by(route::running_sums, exact, order);
    auto polynomial = as_polynomial(inner, exact.endpoint);
    return {by(route::symmetric_squares, exact, order), std::move(inner), std::move(polynomial)};
}

// The largest |found_n - expected_n|, for the resummation relative to the largest |expected_n|.
template <class T>
cell difference_cell(const named_route& r, const power_series<T>& found, const power_series<mpfr>& expected) {
    mpfr largest(0);
    mpfr scale(r.resums ? 0 : 1);
    for (int n = 0; n <= expected.order(); ++n) {
        largest = std::max(largest, mpfr(abs(widen(found[n]) - expected[n])));
        scale = r.resums ? std::max(scale, mpfr(abs(expected[n]))) : scale;
    }
    return largest == 0 ? number_cell("-inf") : decimal_cell(mpfr(log10(mpfr(largest / scale))), 4);
}

}  // namespace libration::studies::coefficient_routes
