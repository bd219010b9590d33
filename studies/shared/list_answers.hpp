// The results of radius tests for the coefficients of an equation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "equation_plan.hpp"
#include "libration/convergence/estimate/root_variable.hpp"
#include "libration/convergence/list/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/problem/unknown_lists.hpp"

namespace libration::studies {

inline constexpr int least_order_of_lists = 4;
/// Digits of coefficients in addition to those of the arithmetic of the tests.
inline constexpr long guard_of_lists = 20;

/// A result, with lengths in the unit of the variable.
struct answer_of_test {
    std::optional<mpfr> radius;
    convergence::radius_estimate<mpfr> of;
    long digits = 0;
};

inline answer_of_test in_full(const convergence::radius_estimate<mpfr>& found, long digits) {
    return {found.radius, found, digits};
}

inline const column_list<answer_of_test>& answer_columns() {
    using row = answer_of_test;
    static const column_list<row> all{
        {"radius", "estimated radius of convergence; empty where there is none",
         [](const row& r) { return decimal_cell(r.radius, r.digits); }},
        {"uncertainty", "that the test gives: an estimate, not a bound",
         [](const row& r) { return r.radius ? decimal_cell(r.of.uncertainty, 3) : cell(); }},
        {"log10_relative_uncertainty", "log10 of uncertainty/radius",
         [](const row& r) { return r.radius ? log10_cell(mpfr(r.of.uncertainty / *r.radius)) : cell(); }},
        {"position_re", "Re of a nearest singularity, from the expansion point",
         [](const row& r) { return r.of.position ? decimal_cell(r.of.position->re, r.digits) : cell(); }},
        {"position_im", "Im of it",
         [](const row& r) { return r.of.position ? decimal_cell(r.of.position->im, r.digits) : cell(); }},
        {"kind", "unknown | pole | logarithm | algebraic | boundary",
         [](const row& r) { return r.radius ? cell(convergence::name_of(r.of.kind)) : cell(); }},
        {"exponent", "nu of (1 - x/x0)^nu there, where it was measured",
         [](const row& r) { return r.radius ? decimal_cell(r.of.exponent, std::min(r.digits, 10L)) : cell(); }},
        {"count", "singularities on the circle; 0 where the test does not tell",
         [](const row& r) { return r.radius ? cell(r.of.count) : cell(); }},
        {"note", "which test decided, or why there is no radius",
         [](const row& r) { return without_commas(r.of.note); }}};
    return all;
}

/// The results for a list of an unknown.
struct answered_list {
    std::string unknown;
    int order;
    std::string method;
    answer_of_test found;
};

/// The first coefficients a_0 .. a_N of a longer list.
inline series::power_series<mpfr> first_of_list(const series::power_series<mpfr>& list, int order) {
    const auto& all = list.coefficients();
    return series::power_series<mpfr>({all.begin(), all.begin() + std::ptrdiff_t{order} + 1});
}

/// The coefficients of all unknowns about the initial point.
inline std::vector<unknown_series> lists_about_start(const ode::explicit_system& system, int order, long digits) {
    return unknown_lists(system, order, digits);
}

/// The results of the tests that are `shown` for the list up to this order, in powers of the root-th root of the
/// variable; the verdict first.
template <class Shown>
std::vector<answered_list> answers_to(const std::string& unknown, const series::power_series<mpfr>& list, int order,
                                      const scalar_spec& scalar, const Shown& shown, int root) {
    std::vector<answered_list> all;
    with_scalar(scalar, 0, [&]<class T>() {
        const auto part = first_of_list(list, order);
        const auto unit = convergence::unit_of(part);
        const auto report = convergence::report_on_radius(convergence::in_unit_of<T>(part, unit), epsilon<T>());
        std::vector<convergence::radius_estimate<T>> answers{report.verdict};
        answers.insert(answers.end(), report.tests.begin(), report.tests.end());
        const precision_scope scope(scalar.digits + guard_of_lists);
        for (const auto& each : answers) {
            if (shown(each.method)) {
                const auto found =
                    convergence::in_powers_of_root(convergence::in_unit(convergence::widened(each), unit.length), root);
                all.push_back({unknown, order, found.method, in_full(found, scalar.digits)});
            }
        }
    });
    return all;
}

/// The same for the requested unknowns and several orders, one order after the other.
template <class Shown>
std::vector<answered_list> answers_to(const std::vector<unknown_series>& lists, const equation_sweep& sweep,
                                      const std::vector<int>& orders, const scalar_spec& scalar, const Shown& shown) {
    std::vector<answered_list> all;
    for (const int order : orders) {
        for (const int unknown : sweep.unknowns()) {
            const auto& list = lists[static_cast<std::size_t>(unknown)].coefficients();
            const auto own = answers_to(sweep.name_of(unknown), list, order, scalar, shown, lists.front().lists.root);
            all.insert(all.end(), own.begin(), own.end());
        }
    }
    return all;
}

inline bool is_verdict(const std::string& method) { return method == "verdict"; }

/// The verdicts on the lists about the initial point.
inline std::vector<answered_list> verdicts_of(const ode::explicit_system& system, const equation_sweep& sweep,
                                              const std::vector<int>& orders, const scalar_spec& scalar) {
    const auto lists = lists_about_start(system, *std::ranges::max_element(orders), scalar.digits + guard_of_lists);
    return answers_to(lists, sweep, orders, scalar, is_verdict);
}

/// The columns of results for lists: <order>,<method>,<the result>,unknown.
inline const column_list<answered_list>& answered_columns() {
    using row = answered_list;
    static const column_list<row> all =
        joined(joined<row>({{"order", "N, last power of the list", [](const row& r) { return r.order; }},
                            {"method", "verdict, or the radius test", [](const row& r) { return r.method; }}},
                           columns_within(answer_columns(), &row::found)),
               {unknown_column<row>()});
    return all;
}

}  // namespace libration::studies
