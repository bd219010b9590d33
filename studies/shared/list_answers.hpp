// The results of radius tests for lists of coefficients: about any point of the pendulum's motion, where the exact
// radius is known, and about the initial point of any equation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "equation_plan.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/convergence/root_variable.hpp"
#include "libration/pendulum/series_on_arc.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/problem/unknown_lists.hpp"
#include "sweep_columns.hpp"

namespace libration::studies {

inline constexpr int least_order_of_lists = 4;
/// Digits of coefficients, and of comparisons of radii, in addition to those of the arithmetic of the tests.
inline constexpr long guard_of_lists = 20;
inline constexpr long digits_of_errors = 12;

/// A result for a list of coefficients, in the unit of the variable, to this number of digits.
struct answered_list {
    int order = 0;
    convergence::radius_estimate<mpfr> found = {};
    long digits = 0;
    std::string unknown = {};              ///< of an equation
    std::optional<mpfr> true_radius = {};  ///< of the pendulum
    const sweep_energy* at = nullptr;      ///< of the pendulum
    const exact* point = nullptr;          ///< of the pendulum
};

/// |radius/exact - 1|, in the working precision in force; std::nullopt if one of them is not known.
inline std::optional<mpfr> relative_error(const answered_list& of) {
    return of.found.radius && of.true_radius ? std::optional(mpfr(abs(mpfr(*of.found.radius / *of.true_radius - 1))))
                                             : std::nullopt;
}

/// All columns of results, from which a table chooses.
inline const column_list<answered_list>& answer_columns() {
    using row = answered_list;
    const auto if_found = [](auto value) {
        return [value](const row& r) { return r.found.radius ? cell(value(r)) : cell(); };
    };
    const auto place = [](mpfr complex_number<mpfr>::*part) {
        return [part](const row& r) {
            return r.found.position ? decimal_cell((*r.found.position).*part, r.digits) : cell();
        };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"order", "N, last power of the list", [](const row& r) { return r.order; }},
        {"method", "verdict, or the radius test", [](const row& r) { return r.found.method; }},
        {"radius", "estimated radius of convergence, in the unit of the variable; empty where there is none",
         [](const row& r) { return decimal_cell(r.found.radius, r.digits); }},
        {"uncertainty", "that the test gives: an estimate, not a bound",
         if_found([](const row& r) { return decimal_cell(r.found.uncertainty, 3); })},
        {"exact", "radius of convergence from the lattice of singularities, dimensionless time",
         [](const row& r) { return decimal_cell(r.true_radius, r.digits); }},
        {"relative_error", "|radius/exact - 1|",
         [](const row& r) { return decimal_cell(relative_error(r), digits_of_errors); }},
        {"log10_relative_error", "log10 of relative_error", [](const row& r) { return log10_cell(relative_error(r)); }},
        {"log10_relative_uncertainty", "log10 of uncertainty/radius", if_found([](const row& r) {
             return log10_cell(mpfr(r.found.uncertainty / (r.true_radius ? *r.true_radius : *r.found.radius)));
         })},
        {"position_re", "Re of a nearest singularity, from the expansion point", place(&complex_number<mpfr>::re)},
        {"position_im", "Im of it", place(&complex_number<mpfr>::im)},
        {"kind", "unknown | pole | logarithm | algebraic | boundary | confluent | irregular",
         if_found([](const row& r) { return convergence::name_of(r.found.kind); })},
        {"exponent", "nu of (1 - x/x0)^nu there, where it was measured",
         if_found([](const row& r) { return decimal_cell(r.found.exponent, std::min(r.digits, 10L)); })},
        {"count", "singularities on the circle; 0 where the test does not tell",
         if_found([](const row& r) { return r.found.count; })},
        {"note", "which test decided, or why there is no radius", [](const row& r) { return r.found.note; }},
        gap_column<row>(),
        log10_gap_column<row>(),
        {"unknown", "of the problem", [](const row& r) { return r.unknown; }},
    });
    return all;
}

/// answer_columns() with the meanings of the pendulum.
inline const column_list<answered_list>& answer_columns_of_pendulum() {
    static const auto all = with_meanings(
        answer_columns(),
        {{"order", "N, last power of t of the list"},
         {"radius", "estimated radius of convergence, dimensionless time; empty where the test does not apply"},
         {"uncertainty", "that the test gives, dimensionless time: an estimate, not a bound"},
         {"log10_relative_uncertainty", "log10 of uncertainty/exact"},
         {"position_re", "Re of the estimated nearest singularity, from the point, dimensionless time"},
         {"kind", "of the singularity by the verdict: logarithm is right"},
         {"count", "singularities on the circle by the verdict: 4 about the top and 2 elsewhere is right"}});
    return all;
}

/// The columns of a table of the pendulum with all tests, and of one of an equation.
inline const column_list<answered_list>& judged_answer_columns() {
    static const auto all = columns_named(
        "energy,point,order,method,radius,uncertainty,exact,relative_error,log10_relative_error,"
        "log10_relative_uncertainty,note,energy_typed,gap_typed",
        with_meanings(answer_columns_of_pendulum(),
                      {{"note", "why there is no radius, or what a reader should know"}}));
    return all;
}
inline const column_list<answered_list>& result_columns() {
    static const auto all =
        columns_named("radius,uncertainty,log10_relative_uncertainty,position_re,position_im,kind,exponent,count,note",
                      answer_columns());
    return all;
}
inline const column_list<answered_list>& answered_columns() {
    static const auto all = joined(joined(columns_named("order,method", answer_columns()), result_columns()),
                                   columns_named("unknown", answer_columns()));
    return all;
}

/// Whether a table shows the results of a test.
inline bool is_verdict(const std::string& method) { return method == "verdict"; }
inline bool is_any_test(const std::string& /*method*/) { return true; }
inline bool is_by_size(const std::string& method) {
    const auto tests = convergence::all_radius_tests<double>();
    return is_verdict(method) || std::ranges::any_of(tests, [&](const convergence::radius_test<double>& test) {
               return test.method == method && test.kind == convergence::radius_test_kind::sizes;
           });
}

/// The verdict and the results of the tests that are `shown`, in this order.
template <class T, class Shown>
std::vector<convergence::radius_estimate<mpfr>> estimates_of(const series::power_series<T>& list, const Shown& shown) {
    std::vector<convergence::radius_estimate<mpfr>> all{convergence::estimate_of(convergence::verdict_in(list))};
    const precision_scope scope(decimal_digits(digits<T>()) + guard_of_lists);
    for (const auto& each : convergence::report_on_radius(list, epsilon<T>()).tests) {
        all.push_back(convergence::widened(each));
    }
    std::erase_if(all, [&](const auto& each) { return !shown(each.method); });
    return all;
}

/// The results for the lists of these orders (the largest last), about one point of one motion of the pendulum.
template <class Shown>
std::vector<answered_list> judged_answers(const sweep_energy& at, const exact& point, const std::vector<int>& orders,
                                          const scalar_spec& scalar, const Shown& shown) {
    // Lists are passed to the tests in units of 9/8 of the radius, so that no test finds the answer 1 by construction.
    const rational hidden_unit = rational(9) / 8;
    const precision_scope scope(scalar.digits + guard_of_lists);
    const pendulum::motion m = pendulum::motion::of_energy(at.value);
    const mpfr truth = coverage_from<mpfr>(m, point.coefficient).radius;
    std::vector<answered_list> all;
    with_scalar(scalar, 0, [&]<class T>() {
        const auto list = series_on_arc<T>(m, point.coefficient, orders.back(), hidden_unit);
        for (const int order : orders) {
            for (const auto& each : estimates_of(list.scaled.truncated(order), shown)) {
                const precision_scope judging(scalar.digits + guard_of_lists);
                all.push_back({order, in_unit(each, widen(list.unit)), scalar.digits, "", truth, &at, &point});
            }
        }
    });
    return all;
}

/// judged_answers() as a table.
template <class Shown>
table answers_about(const sweep_energy& at, const exact& point, const std::vector<int>& orders,
                    const scalar_spec& scalar, const Shown& shown) {
    const precision_scope judging(scalar.digits + guard_of_lists);
    return make_table(judged_answer_columns(), judged_answers(at, point, orders, scalar, shown));
}

/// The coefficients of all unknowns about the initial point.
inline std::vector<unknown_series> lists_about_start(const ode::explicit_system& system, int order, long digits) {
    return unknown_lists(system, order, digits);
}

/// The results for the list up to this order, in powers of the root-th root of the variable.
template <class Shown>
std::vector<answered_list> answers_to(const std::string& unknown, const series::power_series<mpfr>& list, int order,
                                      const scalar_spec& scalar, const Shown& shown, int root) {
    std::vector<answered_list> all;
    with_scalar(scalar, 0, [&]<class T>() {
        const auto part = list.truncated(order);
        const auto unit = convergence::unit_of(part);
        const auto answers = estimates_of(convergence::in_unit_of<T>(part, unit), shown);
        const precision_scope scope(scalar.digits + guard_of_lists);
        for (const auto& each : answers) {
            auto found = convergence::in_powers_of_root(convergence::in_unit(each, unit.length), root);
            found.note = without_commas(found.note);
            all.push_back({order, std::move(found), scalar.digits, unknown});
        }
    });
    return all;
}

/// answers_to() for the requested unknowns and several orders, one order after the other.
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

/// The verdicts on the lists about the initial point.
inline std::vector<answered_list> verdicts_of(const ode::explicit_system& system, const equation_sweep& sweep,
                                              const std::vector<int>& orders, const scalar_spec& scalar) {
    const auto lists = lists_about_start(system, *std::ranges::max_element(orders), scalar.digits + guard_of_lists);
    return answers_to(lists, sweep, orders, scalar, is_verdict);
}

/// The parameter --prove of a study of lists.
inline study_parameter law_parameter() {
    return {"--prove", "", "proves the law of all coefficients (docs/asymptotics.md), and adds it to table and figure"};
}

/// Whether it is given.
inline bool proves_law(const study_request& request) { return !request.values.of("prove").empty(); }

/// A proved number as a cell and its bound as another: empty if no digit of it is proved.
inline cell value_cell(const known_value& of) { return of.decimal ? number_cell(of.decimal->text) : cell(); }
inline cell bound_cell(const known_value& of) { return number_cell(of.decimal ? of.decimal->uncertainty : of.bound); }

/// The list of an unknown about the initial point, and the results for all lists.
struct list_of_unknown {
    const series::power_series<mpfr>& list;
    int root;  ///< q: the series proceeds in powers of the q-th root of the variable
    const std::string& unknown;
    long digits;
    const std::vector<answered_list>& answers;
    const proved_law* law = nullptr;  ///< with --prove
};

/// The law of an unknown. Throws error of the kind undecided with the law's reason, and the unknown if there are
/// several.
inline proved_law law_of_unknown(const ode::explicit_system& system, const std::string& unknown, long digits) {
    try {
        return {system, {.show = unknown}, proved_digits(digits)};
    } catch (const error& missing) {
        const std::string of = system.unknowns().size() > 1 ? " of " + unknown : "";
        throw error(missing.kind(), "--prove", "", "has no law" + of + ": the problem " + missing.reason());
    }
}

/// The plan of a study of these lists: a table of the rows(list of an unknown), and one of the results of the tests
/// that are shown. Throws input_error with the reason `too_short` for an order below least_order_of_lists.
template <class Row, class Rows, class Shown>
study_plan plan_of_lists(const study_request& request, const char* too_short, const column_list<Row>& columns,
                         const Rows& rows, const std::string& suffix_of_results, const Shown& shown) {
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, least_order_of_lists, too_short);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns), head_of(*sweep, suffix_of_results, scalar, answered_columns())}, sweep,
        [sweep, orders, scalar, &columns, rows, shown, proves = proves_law(request)](std::size_t i) {
            const precision_scope scope(scalar.digits + guard_of_lists);
            const auto system = sweep->system(i);
            std::vector<proved_law> laws;  // first, so that a problem without one fails at once
            for (const int unknown : proves ? sweep->unknowns() : std::vector<int>{}) {
                laws.push_back(law_of_unknown(system, sweep->name_of(unknown), scalar.digits));
            }
            const auto lists = lists_about_start(system, orders.back(), scalar.digits + guard_of_lists);
            const auto answers = answers_to(lists, *sweep, orders, scalar, shown);
            std::vector<Row> all;
            for (std::size_t k = 0; k < sweep->unknowns().size(); ++k) {
                const int unknown = sweep->unknowns()[k];
                const auto& list = lists[static_cast<std::size_t>(unknown)].coefficients();
                const auto own = rows({list, lists.front().lists.root, sweep->name_of(unknown), scalar.digits, answers,
                                       proves ? &laws[k] : nullptr});
                all.insert(all.end(), own.begin(), own.end());
            }
            return std::vector<table>{make_table(columns, all), make_table(answered_columns(), answers)};
        });
}

}  // namespace libration::studies
