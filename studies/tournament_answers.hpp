// The results of radius tests on series whose radius is known, compared with it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "libration/pendulum/known_arc_series.hpp"
#include "libration/problem/known/known_series.hpp"
#include "population/logarithmic_families.hpp"
#include "population/radius_families.hpp"
#include "shared/list_answers.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies::tournament_results {

using namespace series;
using namespace convergence;
using namespace pendulum;

inline constexpr long score_guard_digits = 30;
inline constexpr long digits_of_errors = 6;
inline constexpr long digits_of_scores = digits_of_errors + score_guard_digits;

// The problems in one precision.
using problem_list = std::vector<known_series<mpfr>>;

// A motion of the pendulum as a problem: named by its energy, or by its gap if that was given.
inline std::string label_of(const sweep_energy& at, const exact& point) {
    const std::string energy = at.energy_typed.empty() ? "2-E=" + at.gap_typed : "E=" + at.energy_typed;
    return "pendulum " + energy + " x=" + point.text;
}

// The k-th random list: of the families in turn, drawn from the seed.
inline known_series<mpfr> drawn_problem(int k, int seed) {
    static const std::vector<tests::series_family> families = [] {
        auto all = tests::all_series_families();
        const auto logarithmic = tests::logarithmic_families();
        all.insert(all.end(), logarithmic.begin(), logarithmic.end());
        return all;
    }();
    const auto count = static_cast<int>(families.size());
    const tests::series_family& family = families[static_cast<std::size_t>(k % count)];
    const auto own_seed = static_cast<std::uint64_t>(seed) * 1'000'003 + static_cast<std::uint64_t>(k);
    const auto draw = [&family, own_seed](int order) {
        tests::dice random(own_seed);
        return family.draw(random, order);
    };
    constexpr int short_list = 24;
    const tests::drawn_series drawn = draw(short_list);
    known_series<mpfr> problem;
    problem.name = family.name + " #" + std::to_string(k / count + 1);
    problem.expand = [draw](int order) { return draw(order).a; };
    problem.radius = drawn.radius;
    problem.radius_error = drawn.radius_error;
    if (!drawn.nearest.empty()) {
        problem.position = drawn.nearest.front().at;
    }
    return problem;
}

// All problems, in the working precision in force; the random ones last.
inline problem_list problems_of(const pendulum_sweep& sweep, int lists, int seed) {
    auto all = all_known_series<mpfr>();
    for (const sweep_energy& at : sweep.energies) {
        for (const exact& point : sweep.points) {
            all.push_back(known_arc_series(label_of(at, point), motion::of_energy(at.value), point.coefficient));
        }
    }
    for (int k = 0; k < lists; ++k) {
        all.push_back(drawn_problem(k, seed));
    }
    return all;
}

// One result and its error.
struct judged_answer {
    std::string problem, half, method, scalar;
    int order;
    long digits;
    radius_estimate<mpfr> found;
    std::optional<mpfr> radius;  // the exact one; none for an entire function
    singularity_kind kind;
    int count;
    bool covered = false;
    mpfr reached = 0;           // correct digits
    std::optional<mpfr> error;  // relative
    std::optional<mpfr> ratio;  // uncertainty/error

    bool has_radius() const { return radius && *radius > 0; }
    bool answered() const { return found.radius.has_value(); }
};

inline std::string kind_text(singularity_kind kind) { return kind == singularity_kind::unknown ? "" : name_of(kind); }

inline cell covered_cell(const judged_answer& r) {
    return r.has_radius() && !r.answered() ? cell() : cell(r.covered ? "yes" : "no");
}

inline column_list<judged_answer> columns_of_truth() {
    using row = judged_answer;
    return {
        {"kind", "of the nearest singularities by the verdict", [](const row& r) { return kind_text(r.found.kind); }},
        {"exact_kind", "of the one of least argument, truly; empty where there is none",
         [](const row& r) { return kind_text(r.kind); }},
        {"count", "nearest singularities as the test sees them",
         [](const row& r) { return r.found.count > 0 ? cell(r.found.count) : cell(); }},
        {"exact_count", "truly; 0 for none and for a boundary", [](const row& r) { return r.count; }},
        {"note", "why there is no radius, or what a reader should know", [](const row& r) { return r.found.note; }}};
}

inline column_list<judged_answer> columns_of_error() {
    using row = judged_answer;
    return {
        {"relative_error", "|radius/exact - 1|", [](const row& r) { return decimal_cell(r.error, digits_of_errors); }},
        {"log10_relative_error", "log10 of relative_error; empty where it is 0",
         [](const row& r) { return r.ratio ? log10_cell(r.error) : cell(); }},
        {"digits", "correct digits of the radius, at most those of the scalar",
         [](const row& r) { return r.error ? decimal_cell(r.reached, digits_of_errors) : cell(); }},
        {"uncertainty_over_error", "empty where the error is 0",
         [](const row& r) { return decimal_cell(r.ratio, digits_of_errors); }},
        {"covered", "yes: the error is within the uncertainty, or no radius is given where there is none | no",
         covered_cell}};
}

inline const column_list<judged_answer>& columns() {
    using row = judged_answer;
    static const auto all = joined(
        joined<row>(
            {{"problem", "the function, or theta of the pendulum: its energy and expansion point",
              [](const row& r) { return r.problem; }},
             {"half", "calibration: safety factors were chosen on it; judged: not used for that",
              [](const row& r) { return r.half; }},
             {"order", "N, last power of the list", [](const row& r) { return r.order; }},
             {"scalar", "arithmetic of the coefficients and of the tests", [](const row& r) { return r.scalar; }},
             {"method", "radius test, or the verdict of all", [](const row& r) { return r.method; }},
             {"radius", "estimated; empty where the test gives none",
              [](const row& r) { return decimal_cell(r.found.radius, r.digits); }},
             {"uncertainty", "of the radius, by the test itself",
              [](const row& r) { return r.answered() ? decimal_cell(r.found.uncertainty, digits_of_errors) : cell(); }},
             {"exact", "radius of convergence; inf for an entire function, 0 for a divergent series",
              [](const row& r) { return r.radius ? decimal_cell(*r.radius, r.digits) : number_cell("inf"); }}},
            columns_of_error()),
        columns_of_truth());
    return all;
}

// Digits of agreement, between 0 and the maximum of the scalar.
inline mpfr correct_digits(const mpfr& relative_error, long most) {
    const mpfr reached = relative_error == 0 ? mpfr(most) : mpfr(-log10(relative_error));
    return std::clamp(reached, mpfr(0), mpfr(most));
}

inline judged_answer judge(const known_series<mpfr>& problem, const std::string& half, int order,
                           const scalar_spec& scalar, const radius_estimate<mpfr>& found) {
    judged_answer answer{problem.name,  half,    found.method,   scalar.name(), order,
                         scalar.digits, found,   problem.radius, problem.kind,  problem.count,
                         false,         mpfr(0), std::nullopt,   std::nullopt};
    if (!answer.has_radius()) {
        answer.covered = !answer.answered();
    } else if (answer.answered()) {
        const mpfr away = std::max(mpfr(abs(mpfr(*found.radius - *problem.radius)) - problem.radius_error), mpfr(0));
        answer.error = away / *problem.radius;
        answer.covered = away <= found.uncertainty;
        answer.reached = correct_digits(*answer.error, scalar.digits);
        if (away != 0) {
            answer.ratio = found.uncertainty / away;
        }
    }
    return answer;
}

// All tests on one problem in one scalar, at all orders.
inline std::vector<judged_answer> answers_of(const known_series<mpfr>& problem, const std::string& half,
                                             const std::vector<int>& orders, const scalar_spec& scalar) {
    std::vector<judged_answer> answers;
    const power_series<mpfr> wide = problem.expand(orders.back());
    for (const int order : orders) {
        const power_series<mpfr> list = wide.truncated(order);
        const coefficient_unit unit = unit_of(list);
        with_scalar(scalar, 0, [&]<class T>() {
            const auto estimates = estimates_of(in_unit_of<T>(list, unit), is_any_test);
            const precision_scope judging(scalar.digits + score_guard_digits);
            const mpfr length = narrow<mpfr>(unit.length);
            for (const auto& each : estimates) {
                answers.push_back(judge(problem, half, order, scalar, in_unit(each, length)));
            }
        });
    }
    return answers;
}

}  // namespace libration::studies::tournament_results
