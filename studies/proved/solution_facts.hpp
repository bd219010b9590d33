// Properties of the solution of a test problem in addition to its values: invariants, and singularities near a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/problem/axis.hpp"
#include "test_problems.hpp"

namespace libration::studies::proved {

/// A decimal in the working precision.
inline mpfr number_in(const std::string& decimal) {
    mpfr result;
    mpfr_set_str(handle(result), decimal.c_str(), 10, MPFR_RNDN);
    return result;
}

/// A time of a test problem, which is a finite decimal.
inline std::string decimal_in(const ode::number& time) { return decimal_of(rational(*time.fraction()), 60); }

/// The expressions after the words `invariant` in the text of a problem, in their order.
inline std::vector<std::string> invariant_texts(std::string_view text) {
    constexpr std::string_view word = "invariant ";
    std::vector<std::string> all;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(word)) {
            all.push_back(line.substr(word.size()));
        }
    }
    return all;
}

/// A conserved quantity.
struct invariant_value {
    std::string problem;
    std::string expression;
    std::string value;
    long digits;
    mpfr difference;  ///< bound of the drift of the invariant over the printed values
};

/// A singularity to the digits that its uncertainty permits, at most ten; empty if none was found.
struct nearest_singularity {
    std::string radius, re, im;
};

/// For one test problem, with values printed to this number of digits.
class solution_facts {
public:
    solution_facts(const test_problem& of, long digits)
        : of_(of), digits_(digits), system_(of.equations()), form_(system_) {}

    const std::vector<std::string>& names() const { return form_.names; }

    /// The invariants from the initial values, exact if they are fractions, and the differences for the printed states.
    std::vector<invariant_value> invariants(const std::vector<ode::number>& times,
                                            const std::vector<std::vector<std::string>>& states) const {
        const auto texts = invariant_texts(problem_text(of_.catalogue));
        std::vector<invariant_value> all;
        for (std::size_t i = 0; i < system_.invariants().size(); ++i) {
            const ode::expression in_leaves = form_.in_leaves(system_.invariants()[i]);
            const ode::number exact_value = at_start(in_leaves);
            const auto value = proved_value(digits_, [&] { return ode::constant_value<ball>::of(exact_value); });
            const precision_scope scope(digits_ + more_digits);
            const auto constant = ode::constant_value<mpfr>::of(exact_value);
            mpfr difference(0);
            for (std::size_t k = 0; k < times.size(); ++k) {
                const mpfr here = at_state(in_leaves, times[k], states[k]);
                difference = std::max(difference, mpfr(abs(mpfr(here - constant))));
            }
            all.push_back({of_.name, texts.at(i), value.text, digits_, difference});
        }
        return all;
    }

    /// From the coefficients of all unknowns about a time: heuristic.
    nearest_singularity nearest_about(const ode::number& time, const std::vector<std::string>& state) const {
        const precision_scope scope(digits_of_lists + more_digits);
        const ode::tape tape = ode::tape::about_points(system_);
        ode::taylor_expansion<mpfr> there(tape, order_of_lists);
        ode::solution_state<mpfr> values;
        std::size_t next = 0;
        for (const ode::unknown_function& each : system_.unknowns()) {
            auto& own = values.emplace_back();
            for (int j = 0; j < each.order; ++j) {
                own.push_back(number_in(state[next++]));
            }
        }
        const auto centre = ode::constant_value<mpfr>::of(time);
        there.about(centre, values);
        std::optional<convergence::radius_estimate<mpfr>> nearest;
        for (std::size_t i = 0; i < values.size(); ++i) {
            auto found = verdict_on(there.series_of(static_cast<int>(i)));
            if (found.radius && (!nearest || *found.radius < *nearest->radius)) {
                nearest = std::move(found);
            }
        }
        if (!nearest || !(*nearest->radius < far)) {
            return {};
        }
        const mpfr unit = nearest->uncertainty;
        nearest_singularity result{shown(*nearest->radius, unit), "", ""};
        if (nearest->position) {
            result.re = shown(mpfr(centre + nearest->position->re), unit);
            result.im = shown(nearest->position->im, unit);
        }
        return result;
    }

private:
    static constexpr long more_digits = 20;
    static constexpr long digits_of_lists = 30;
    static constexpr int order_of_lists = 60;
    static constexpr int far = 1'000'000;  // larger radii: entire as far as 60 coefficients show

    ode::number at_start(const ode::expression& e) const {
        const ode::expression value = ode::replaced(e, [&](const ode::expression& leaf) {
            for (std::size_t k = 0; k < form_.leaves.size(); ++k) {
                if (same_form(leaf, form_.leaves[k])) {
                    return std::optional<ode::expression>(form_.starts[k]);
                }
            }
            return std::optional<ode::expression>(system_.point());
        });
        return value.constant();
    }

    mpfr at_state(const ode::expression& e, const ode::number& time, const std::vector<std::string>& state) const {
        ode::expression_values<mpfr> values(form_.leaves, ode::constant_value<mpfr>::of(time));
        for (const std::string& each : state) {
            values.push_back(number_in(each));
        }
        return values.of(e);
    }

    static convergence::radius_estimate<mpfr> verdict_on(const series::power_series<mpfr>& list) {
        const auto unit = convergence::unit_of(list);
        const precision_scope scope(digits_of_lists);
        const auto verdict = convergence::verdict_in(convergence::in_unit_of<mpfr>(list, unit));
        return convergence::in_unit(convergence::estimate_of(verdict), unit.length);
    }

    // x to the position of its uncertainty; empty if no digit is left, "0" if x is negligible compared with it.
    static std::string shown(const mpfr& x, const mpfr& uncertainty) {
        constexpr long most_digits = 10;
        const mpfr size = abs(x);
        if (size <= uncertainty) {
            return size * 1000 <= uncertainty ? "0" : "";
        }
        const mpfr relative = uncertainty / size;
        const long digits = relative == 0 ? most_digits : mpfr(floor(mpfr(-log10(relative)))).convert_to<long>();
        return to_decimal(x, std::clamp(digits, 1L, most_digits));
    }

    test_problem of_;
    long digits_;
    ode::explicit_system system_;
    ode::first_order_form form_;
};

}  // namespace libration::studies::proved
