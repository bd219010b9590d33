// The digits that are lost where an exponential approximant is computed from a Vandermonde system.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "approximant_norms.hpp"

namespace libration::studies::approximant_norms {

/// The digits that double loses in the published form of the exponential approximants.
struct loss_row {
    std::string problem;
    int terms;
    mpfr condition, amplitudes, vandermonde, decay;
};

inline const column_list<loss_row>& loss_columns() {
    using row = loss_row;
    static const column_list<row> all{
        {"problem", "of the catalogue", [](const row& r) { return r.problem; }},
        {"terms", "number of the exponentials, as many as coefficients", [](const row& r) { return r.terms; }},
        {"log10_condition", "log10 of the condition number of the Vandermonde system in the maximum norm",
         [](const row& r) { return log10_cell(r.condition); }},
        {"log10_amplitudes", "log10 of sum |A_j|: digits that are lost where the exponentials are summed at the start",
         [](const row& r) { return log10_cell(r.amplitudes); }},
        {"log10_vandermonde",
         "log10 of the largest error of double with the A_j of that system, beside the same sum exactly",
         [](const row& r) { return log10_cell(r.vandermonde); }},
        {"log10_decay", "the same of the polynomial in 1 - e^(-a t), in double",
         [](const row& r) { return log10_cell(r.decay); }},
        {"lost_digits", "digits of double, 15.95 of them, that the system lost",
         [](const row& r) {
             const mpfr lost = log(mpfr(r.vandermonde / widen(epsilon<double>()))) / log(mpfr(10));
             return decimal_cell(lost < 0 ? mpfr(0) : lost, 4);
         }},
    };
    return all;
}

/// The sum of exponentials in double compared with the same polynomial exactly, both of f or of limit/f.
inline loss_row loss_of(const solved_problem& of, int order) {
    power_series<mpfr> g = of.f.truncated(order);
    mpfr limit = of.far.line[0];
    if (of.far.form == far_form::reciprocal_exponential) {
        auto numerator = power_series<mpfr>::zero(order);
        numerator[0] = limit;
        g = numerator / g;
        limit = 1;
    }
    std::vector<double> rounded;
    std::vector<mpfr> nodes;
    for (int n = 0; n <= order; ++n) {
        rounded.push_back(static_cast<double>(g[n]));
        nodes.emplace_back(n + 1);
    }
    const power_series<double> in_double(rounded);
    const auto rate = static_cast<double>(of.far.rate);
    const auto a = exponential_sum(in_double, static_cast<double>(limit), rate);
    const exponential_approximant<double> decaying(in_double, static_cast<double>(limit), rate);
    const exponential_approximant<mpfr> exact(g, limit, of.far.rate);
    loss_row row{of.far.problem, order + 1, vandermonde_condition(nodes), mpfr(0), mpfr(0), mpfr(0)};
    for (const mpfr& each : exponential_sum(g, limit, of.far.rate)) {
        row.amplitudes += abs(each);
    }
    for (const mpfr& t : of.times) {
        const auto time = static_cast<double>(t);
        double sum = 0;
        for (std::size_t j = a.size(); j-- > 0;) {
            sum = (sum + a[j]) * std::exp(-rate * time);
        }
        const mpfr value = exact.value(t);
        const auto keep = [](mpfr& largest, const mpfr& off) {
            largest = isnan(off) ? std::numeric_limits<mpfr>::infinity() : std::max(largest, off);  // beyond double
        };
        keep(row.vandermonde, abs(mpfr(widen(sum) + limit - value)));
        keep(row.decay, abs(mpfr(widen(decaying.value(time)) - value)));
    }
    return row;
}

inline std::vector<loss_row> losses_of(const solved_problem& of, const std::vector<int>& orders) {
    std::vector<loss_row> rows;
    if (of.far.form == far_form::exponential || of.far.form == far_form::reciprocal_exponential) {
        for (const int order : orders) {
            rows.push_back(loss_of(of, order));
        }
    }
    return rows;
}

}  // namespace libration::studies::approximant_norms
