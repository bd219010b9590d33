#include "local_matching.hpp"

#include <cmath>
#include <utility>

#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

namespace libration::ode {

namespace {

constexpr long guard_bits_of_series = 64;

// The solution of matrix x = right, the columns of the matrix given.
std::vector<complex_ball> solution_of(const std::vector<std::vector<complex_ball>>& columns,
                                      const std::vector<complex_ball>& right) {
    const auto size = static_cast<slong>(right.size());
    acb_mat_t matrix, vector;
    acb_mat_init(matrix, size, size);
    acb_mat_init(vector, size, 1);
    for (slong i = 0; i < size; ++i) {
        for (slong j = 0; j < size; ++j) {
            acb_set(acb_mat_entry(matrix, i, j),
                    flint_complex(columns[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]).handle());
        }
        acb_set(acb_mat_entry(vector, i, 0), flint_complex(right[static_cast<std::size_t>(i)]).handle());
    }
    const bool solved = acb_mat_solve(vector, matrix, vector, ball::working_bits()) != 0;
    std::vector<complex_ball> result;
    for (slong i = 0; i < size; ++i) {
        flint_complex entry;
        acb_set(entry.handle(), acb_mat_entry(vector, i, 0));
        result.push_back(entry.number());
    }
    acb_mat_clear(matrix);
    acb_mat_clear(vector);
    if (!solved) {
        throw precision_exhausted("the constants at a singular point");
    }
    return result;
}

}  // namespace

std::unique_ptr<precision_scope> scope_for_series(const local_operator& about, const series_demand& demand) {
    const double ratio = std::log2(demand.reach / demand.at);
    const double count =
        static_cast<double>(std::max(demand.least_terms, static_cast<long>(static_cast<double>(demand.bits) / ratio))) *
            1.2 +
        100;
    const double lost = about.bits_lost(demand.reach) * count;
    return std::make_unique<precision_scope>(
        decimal_digits(std::max(static_cast<long>(ball::working_bits()), demand.bits) + guard_bits_of_series +
                       static_cast<long>(lost)));
}

frobenius_series series_about(const linear_equation& of, const complex_ball& centre,
                              const std::vector<complex_ball>& derivatives, const std::vector<complex_ball>& roots,
                              const series_demand& demand) {
    // The balls of the derivatives do not pass through the recurrence.
    const auto more = scope_for_series(operator_about(of, centre, roots), demand);
    const local_operator about = operator_about(of, centre, roots);
    std::vector<frobenius_series> solutions;
    for (std::size_t i = 0; i < derivatives.size(); ++i) {
        std::vector<std::vector<complex_ball>> first(derivatives.size(), {complex_ball(0)});
        first[i] = {complex_ball(1)};
        solutions.emplace_back(about, complex_ball(0), std::move(first), demand);
    }
    return frobenius_series::combination(solutions, derivatives);
}

std::vector<local_part> matched_parts(const fuchsian_point& structure, const local_operator& about,
                                      const std::vector<complex_ball>& derivatives, const series_demand& demand,
                                      bool real) {
    ball at;
    arb_set_d(at.handle(), demand.at);
    struct found_class {
        std::optional<rational> exponent;
        std::vector<frobenius_series> solutions;
    };
    std::vector<found_class> classes;
    for (const exponent_class& each : structure.classes()) {
        found_class made{each.exponent, {}};
        for (const exact_local_solution& solution : each.solutions) {
            std::vector<std::vector<complex_ball>> first;
            for (const auto& v : solution.v) {
                first.emplace_back();
                for (const rational_polynomial& c : v) {
                    first.back().push_back(about.value_of(c));
                }
            }
            made.solutions.emplace_back(about, complex_ball(from_rational<ball>(each.exponent)), std::move(first),
                                        demand);
        }
        classes.push_back(std::move(made));
    }
    const std::size_t rational_exponents =
        about.exponents.size() + 1 - std::max<std::size_t>(structure.other_exponents().size(), 1);
    for (std::size_t k = rational_exponents; k < about.exponents.size(); ++k) {
        classes.push_back({std::nullopt, {frobenius_series(about, about.exponents[k], {{complex_ball(1)}}, demand)}});
    }
    std::vector<std::vector<complex_ball>> columns;
    for (const found_class& each : classes) {
        for (const frobenius_series& solution : each.solutions) {
            columns.push_back(solution.derivatives(complex_ball(at), derivatives.size()));
        }
    }
    std::vector<complex_ball> constants = solution_of(columns, derivatives);
    std::vector<local_part> result;
    auto next = constants.begin();
    for (const found_class& each : classes) {
        std::vector<complex_ball> own(next, next + static_cast<std::ptrdiff_t>(each.solutions.size()));
        next += static_cast<std::ptrdiff_t>(own.size());
        if (real && each.exponent) {
            for (complex_ball& c : own) {
                c.im = ball(0);
            }
        }
        result.push_back({frobenius_series::combination(each.solutions, own), each.exponent});
    }
    return result;
}

}  // namespace libration::ode
