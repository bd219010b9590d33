// Approximations of a problem's solution from its coefficients about the initial point, with their errors.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "approximants_of_unknown.hpp"
#include "libration/digits/printed_values.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/integration/fixed_step/runge_kutta.hpp"
#include "libration/problem/axis.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/limit_behaviour.hpp"
#include "libration/query/trajectory.hpp"
#include "problem_trajectory.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr long most_error_digits = 6;
constexpr long digits_of_judge = 40;  // of the solution with which a fixed scalar is compared

// Values of the unknowns at the times, one time after the other, and the corresponding values of the solution.
struct compared_values {
    std::vector<std::string> unknowns;
    std::vector<bool> there;  // whether an unknown has such an approximant
    std::vector<mpfr> values;
    std::vector<mpfr> truth;
};

list_approximation method_named(const std::string& name) {
    return name == "series"  ? list_approximation::series
           : name == "pade"  ? list_approximation::pade
           : name == "euler" ? list_approximation::euler
           : name == "gauge" ? list_approximation::gauge
                             : list_approximation::endpoint;
}

bool is_one_sided(const std::string& method) { return method == "endpoint" || has_scale(method_named(method)); }

// In the arithmetic of T; the solution in the current precision.
template <rounding_scalar T>
compared_values by_list(const ode::explicit_system& system, const chosen_approximation& by,
                        const std::vector<ode::number>& times) {
    const auto truth = solve_on(system, times);
    const series_about_start<T> list(system, by.order);
    compared_values result;
    std::vector<std::optional<typename approximants_of_unknown<T>::function>> functions;
    std::vector<T> x;
    for (int i = 0; i < static_cast<int>(system.unknowns().size()); ++i) {
        const approximants_of_unknown<T> own(list, truth, i);
        const auto scale = by.scale ? std::optional(from_exact<mpfr>(*by.scale)) : std::nullopt;
        functions.push_back(own.of(method_named(by.method), by.order, scale));
        result.unknowns.push_back(system.unknowns()[static_cast<std::size_t>(i)].name);
        result.there.push_back(functions.back().has_value());
        if (x.empty()) {
            for (const mpfr& t : truth.times) {
                x.push_back(own.coordinate(t));
            }
        }
    }
    if (has_scale(method_named(by.method)) && std::ranges::find(result.there, true) == result.there.end()) {
        throw input_error(
            "--method", by.method,
            fmt::format("needs a length, and the coefficients up to N = {} show no radius of convergence", by.order),
            "add --scale C, or take more coefficients");
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        for (std::size_t i = 0; i < functions.size(); ++i) {
            result.values.push_back(functions[i] ? widen((*functions[i])(x[k])) : mpfr(1));
            result.truth.push_back(truth.values[i][k]);
        }
    }
    return result;
}

// The fixed-step Runge-Kutta method in the arithmetic of T; the solution in the current precision.
template <rounding_scalar T>
compared_values by_runge_kutta(const ode::explicit_system& system, const exact& step,
                               const std::vector<ode::number>& times) {
    const auto truth = solve_on(system, times);
    ode::fixed_runge_kutta<T> march(system, from_exact<T>(step));
    compared_values result;
    for (const auto& each : system.unknowns()) {
        result.unknowns.push_back(each.name);
        result.there.push_back(true);
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto& state = march.advance_to(ode::constant_value<T>::of(times[k]));
        for (std::size_t i = 0; i < state.size(); ++i) {
            result.values.push_back(widen(state[i][0]));
            result.truth.push_back(truth.values[i][k]);
        }
    }
    return result;
}

template <rounding_scalar T>
compared_values by_method(const ode::explicit_system& system, const chosen_approximation& by,
                          const std::vector<ode::number>& times) {
    return by.method == "rk4" ? by_runge_kutta<T>(system, by.step, times) : by_list<T>(system, by, times);
}

// In the current precision.
compared_values by_far_behaviour(const far_behaviour& far, int order, const std::vector<ode::number>& times) {
    const auto truth = solve_on(far.system, times);
    const series_about_start<mpfr> list(far.system, order);
    const auto approximant = asymptotic_approximant(far, list.expansion.series_of(far.index()));
    compared_values result{{far.unknown}, {approximant.has_value()}, {}, {}};
    for (std::size_t k = 0; k < times.size(); ++k) {
        const mpfr distance = truth.times[k] - truth.start;
        result.values.push_back(approximant ? (*approximant)(distance) : mpfr(1));
        result.truth.push_back(truth.values[static_cast<std::size_t>(far.index())][k]);
    }
    return result;
}

void require_known_far_behaviour(const problem_options& problem) {
    const auto& known = problems_with_far_behaviour();
    if (std::ranges::find(known, *problem.problem()) == known.end()) {
        std::string names;
        for (const std::string& each : known) {
            names += (names.empty() ? "" : ", ") + each;
        }
        throw input_error("--method", "asymptotic", "needs the asymptotic behaviour of the problem, which is not known",
                          "choose one of " + names + ", or --method pade");
    }
}

void require_asymptotic_scalar(const arithmetic& numbers) {
    if (numbers.scalar.kind != scalar_kind::arbitrary) {
        throw input_error("--scalar", numbers.scalar.name(), "has no asymptotic approximants",
                          fmt::format("use mpfr:{}", numbers.scalar.digits));
    }
}

// Checked before the integration.
void require_one_side(const ode::explicit_system& system, const std::vector<ode::number>& times,
                      const std::string& method) {
    const precision_scope scope(digits_of_judge);
    bool before = false;
    bool after = false;
    for (const ode::number& time : times) {
        const mpfr distance = ode::constant_value<mpfr>::of(time - system.point());
        before = before || distance < 0;
        after = after || distance > 0;
    }
    if (before == after) {
        throw input_error("--method", method, "needs times on one side of the initial point, not only that point",
                          "choose such times");
    }
}

// The values on which both runs agree, with the other members.
compared_values agreed_comparison(long digits, const std::vector<ode::number>& times,
                                  const ode::explicit_system& system,
                                  const std::function<compared_values(long digits)>& compute) {
    compared_values last;
    const auto both = agreed_values(
        digits,
        [&](long guard) {
            const precision_scope scope(digits + guard);
            last = compute(digits + guard / 2);
            auto all = last.values;
            all.insert(all.end(), last.truth.begin(), last.truth.end());
            return all;
        },
        [&] {
            std::vector<bool> zeros;
            for (const ode::number& time : times) {
                for (const std::string& name : last.unknowns) {
                    const auto& all = system.unknowns();
                    const auto place = std::ranges::find(all, name, &ode::unknown_function::name) - all.begin();
                    const bool zero =
                        system.starts()[static_cast<std::size_t>(place)].front().fraction() == rational(0);
                    zeros.push_back(zero && (time - system.point()).fraction() == rational(0));
                }
            }
            const auto own = zeros;
            zeros.insert(zeros.end(), own.begin(), own.end());
            return zeros;
        });
    const auto half = both.begin() + static_cast<std::ptrdiff_t>(last.values.size());
    last.values.assign(both.begin(), half);
    last.truth.assign(half, both.end());
    return last;
}

// |value - truth| with the digits supported by both, at least two; empty if there are fewer.
cell error_cell(const mpfr& value, const mpfr& truth, long digits) {
    const precision_scope scope(digits + digits_of_judge);
    const mpfr off = abs(mpfr(value - truth));
    if (off == 0) {
        return truth == 0 ? number_cell("0") : cell();
    }
    const mpfr size = std::max(abs(value), abs(truth));
    const long told = digits + static_cast<long>(floor(mpfr(log10(mpfr(off / size)))));
    return told < 2 ? cell() : decimal_cell(off, std::min(told, most_error_digits));
}

compared_values compare_with_solution(const problem_options& problem, const chosen_approximation& by,
                                      const std::vector<ode::number>& times, const arithmetic& numbers) {
    const auto system = problem.choose();
    if (by.method == "asymptotic") {
        require_known_far_behaviour(problem);
        require_asymptotic_scalar(numbers);
        const auto given = problem.equations();
        return agreed_comparison(numbers.scalar.digits, times, system, [&](long digits) {
            return by_far_behaviour(far_behaviour_of(*problem.problem(), given, digits), by.order, times);
        });
    }
    if (numbers.scalar.kind == scalar_kind::arbitrary) {
        return agreed_comparison(numbers.scalar.digits, times, system,
                                 [&](long /*digits*/) { return by_method<mpfr>(system, by, times); });
    }
    const precision_scope scope(digits_of_judge);
    return with_scalar(numbers.scalar, 0, [&]<class T>() { return by_method<T>(system, by, times); });
}

table table_of_comparison(const compared_values& found, const std::vector<exact>& times, const arithmetic& numbers) {
    std::vector<column> columns{{"time", ""}};
    for (const std::string& name : found.unknowns) {
        columns.push_back({name, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"time_typed", ""}});
    for (const std::string& name : found.unknowns) {
        columns.push_back({name + "_error", ""});
    }
    table data(std::move(columns));
    const bool agreed = numbers.scalar.kind == scalar_kind::arbitrary;
    const std::size_t count = found.unknowns.size();
    for (std::size_t k = 0; k < times.size(); ++k) {
        table_row_cells row{number_cell(decimal_of(times[k], numbers.digits))};
        table_row_cells errors;
        for (std::size_t i = 0; i < count; ++i) {
            const mpfr& value = found.values[k * count + i];
            row.push_back(found.there[i] ? decimal_cell(value, numbers.digits) : cell());
            errors.push_back(found.there[i] ? error_cell(value, found.truth[k * count + i],
                                                         agreed ? numbers.scalar.digits : digits_of_judge)
                                            : cell());
        }
        row.emplace_back(numbers.digits);
        row.emplace_back(agreed ? "two-method" : "heuristic");
        row.emplace_back(times[k].text);
        row.insert(row.end(), errors.begin(), errors.end());
        data.add_row(std::move(row));
    }
    return data;
}

table table_of_comparison(const std::function<compared_values()>& compute, const std::vector<exact>& times,
                          const arithmetic& numbers) {
    try {
        return table_of_comparison(compute(), times, numbers);
    } catch (const error& complaint) {
        if (complaint.kind() != error_kind::argument ||
            (!complaint.is_about(error_subject::time) && !complaint.is_about(error_subject::start))) {
            throw;
        }
        throw input_error(complaint.is_about(error_subject::time) ? "--times" : "--problem", complaint.value(),
                          complaint.reason(), "choose times nearer to the initial point, or another initial point");
    }
}

}  // namespace

table limit_approximation(const limit_problem& of, int order, const std::vector<exact>& times,
                          const arithmetic& numbers) {
    require_asymptotic_scalar(numbers);
    const auto at = constants_of(times);
    return table_of_comparison(
        [&] {
            const long digits = numbers.scalar.digits;
            const precision_scope scope(digits);
            const auto system = behaviour_at_infinity(of, digits).system;
            return agreed_comparison(digits, at, system, [&](long finer) {
                return by_far_behaviour(behaviour_at_infinity(of, finer), order, at);
            });
        },
        times, numbers);
}

table problem_approximation(const problem_options& problem, const chosen_approximation& by,
                            const std::vector<exact>& times, const arithmetic& numbers) {
    if (numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--scalar", numbers.scalar.name(), "cannot prove --method " + by.method,
                          fmt::format("use mpfr:{}, or --method taylor", numbers.scalar.digits));
    }
    const auto at = constants_of(times);
    if (is_one_sided(by.method)) {
        require_one_side(problem.choose(), at, by.method);
    }
    return table_of_comparison([&] { return compare_with_solution(problem, by, at, numbers); }, times, numbers);
}

}  // namespace libration
