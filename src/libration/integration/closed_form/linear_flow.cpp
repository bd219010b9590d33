#include "linear_flow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/ball/traits.hpp"
#include "libration/scalar/error.hpp"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

namespace libration::ode {

namespace {

constexpr long guard_bits = 32;
// The largest |log2| of a value, far inside the range of every printed number.
constexpr long most_exponent = 1L << 30;
// The largest precision in multiples of that of the state.
constexpr long most_times_bits = 16;

std::optional<number> constant_of(const expression& e) {
    return e.kind() == node_kind::constant ? std::optional(e.constant()) : std::nullopt;
}

// The value where all unknowns are 0; std::nullopt also if division by 0 leaves none.
std::optional<number> value_at_zero(const expression& e) {
    try {
        return constant_of(replaced(e, [](const expression& leaf) {
            return leaf.kind() == node_kind::unknown ? std::optional(expression(0)) : std::nullopt;
        }));
    } catch (const error&) {
        return std::nullopt;
    }
}

bool is_zero(const number& x) { return x.fraction() == rational(0); }

// An exact 0, or a number of usual size with so many bits.
bool is_precise(const ball& x, long bits) {
    const auto* middle = arb_midref(x.handle());
    return arb_is_zero(x.handle()) != 0 ||
           (arb_rel_accuracy_bits(x.handle()) >= bits && arf_cmpabs_2exp_si(middle, most_exponent) < 0 &&
            arf_cmpabs_2exp_si(middle, -most_exponent) > 0);
}

// log2(e), rounded up.
constexpr double bits_per_e_fold = 1.45;

magnitude largest_of(std::span<const ball> values) {
    magnitude result;
    for (const ball& each : values) {
        result = std::max(result, magnitude(each));
    }
    return result;
}

// A bound on the sum of the terms after term k, by its largest entry and the norm rho: infinity for rho >= k + 1.
magnitude sum_of_rest(const magnitude& term, const magnitude& rho, unsigned long k) {
    const magnitude q = rho / (k + 1);
    return term.is_zero() ? term : term * q / magnitude::difference_below(magnitude(1U), q);
}

// Whether a rest is smaller than all that are distinguished from 0; an exact 0 among those that move has terms to come.
bool is_small_for_all(const magnitude& rest, const std::vector<ball>& state, const std::vector<bool>& moving) {
    for (std::size_t i = 0; i < state.size(); ++i) {
        const magnitude least = magnitude::below(state[i]);
        if (moving[i] && (arb_is_zero(state[i].handle()) != 0 || (!least.is_zero() && least < rest))) {
            return false;
        }
    }
    return true;
}

// A matrix of balls, freed at the end.
class arb_matrix {
public:
    arb_matrix(std::size_t rows, std::size_t columns) {
        arb_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns));
    }
    arb_matrix(const arb_matrix&) = delete;
    arb_matrix& operator=(const arb_matrix&) = delete;
    ~arb_matrix() { arb_mat_clear(matrix_); }

    arb_mat_struct* handle() { return matrix_; }
    arb_ptr at(std::size_t i, std::size_t j) {
        return arb_mat_entry(matrix_, static_cast<slong>(i), static_cast<slong>(j));
    }

private:
    arb_mat_t matrix_;
};

}  // namespace

std::optional<linear_flow> linear_flow::of(const explicit_system& system) {
    linear_flow result(system);
    return !system.singular() && result.read(system) ? std::optional(std::move(result)) : std::nullopt;
}

bool linear_flow::read(const explicit_system& system) {
    std::map<std::pair<std::string, int>, std::size_t> columns;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 0; j < system.unknowns()[i].order; ++j) {
            columns.emplace(std::pair(system.unknowns()[i].name, j), starts_.size());
            starts_.push_back(system.starts()[i][static_cast<std::size_t>(j)]);
        }
    }
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 1; j < system.unknowns()[i].order; ++j) {
            rows_.push_back({{rows_.size() + 1, number(rational(1))}});
            constants_.emplace_back(rational(0));
        }
        const expression& right = system.right()[i];
        if (!parts_lost({right}, {}, {}).empty()) {
            return false;  // folding may have removed them, as in x (1 - t)/(1 - t), but they end the solution
        }
        std::set<std::pair<std::string, int>> occurring;
        each_leaf(right, [&](const expression& leaf) {
            if (leaf.kind() == node_kind::unknown) {
                occurring.emplace(leaf.name(), leaf.derivative());
            }
        });
        auto& row = rows_.emplace_back();
        for (const auto& [name, derivative] : occurring) {
            const auto value = constant_of(partial(right, unknown(name, derivative)));
            if (!value) {
                return false;
            }
            if (!is_zero(*value)) {
                row.push_back({columns.at({name, derivative}), *value});
            }
        }
        const auto rest = value_at_zero(right);
        if (!rest) {
            return false;
        }
        constants_.push_back(*rest);
    }
    return true;
}

bool linear_flow::is_homogeneous() const { return std::ranges::all_of(constants_, is_zero); }

// Since the initial time.
ball linear_flow::elapsed(const number& time) const { return constant_value<ball>::of(time - point_); }

// In the precision of `bits`, which is not that of the result.
std::vector<ball> linear_flow::rounded_state(const number& time, long bits) const {
    auto by_products = by_series(time, bits);
    return by_products ? std::move(*by_products) : by_exponential(time, bits);
}

std::vector<ball> linear_flow::by_exponential(const number& time, long bits) const {
    const precision_scope scope(decimal_digits(bits));
    const std::size_t n = rows_.size();
    const std::size_t size = is_homogeneous() ? n : n + 1;
    arb_matrix matrix(size, size);
    arb_matrix state(size, 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (const entry& each : rows_[i]) {
            arb_set(matrix.at(i, each.column), constant_value<ball>::of(each.value).handle());
        }
        arb_set(state.at(i, 0), constant_value<ball>::of(starts_[i]).handle());
    }
    if (size > n) {
        for (std::size_t i = 0; i < n; ++i) {
            arb_set(matrix.at(i, n), constant_value<ball>::of(constants_[i]).handle());
        }
        arb_one(state.at(n, 0));
    }
    const ball gone = elapsed(time);
    arb_mat_scalar_mul_arb(matrix.handle(), matrix.handle(), gone.handle(), bits);
    arb_mat_exp(matrix.handle(), matrix.handle(), bits);
    arb_mat_mul(state.handle(), matrix.handle(), state.handle(), bits);
    std::vector<ball> result(n);
    for (std::size_t i = 0; i < n; ++i) {
        arb_swap(result[i].handle(), state.at(i, 0));
    }
    return result;
}

// The nonzero entries of s [A b; 0 0] + shift, s = t - t0; without the last row and column for b = 0.
linear_flow::rows_of_balls linear_flow::scaled_rows(const ball& gone, const magnitude& shift) const {
    const std::size_t n = rows_.size();
    rows_of_balls result(is_homogeneous() ? n : n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (const entry& each : rows_[i]) {
            result[i].emplace_back(each.column, constant_value<ball>::of(each.value) * gone);
        }
        if (!is_zero(constants_[i])) {
            result[i].emplace_back(n, constant_value<ball>::of(constants_[i]) * gone);
        }
    }
    for (std::size_t i = 0; i < result.size() && !shift.is_zero(); ++i) {
        const auto diagonal = std::ranges::find(result[i], i, [](const auto& each) { return each.first; });
        if (diagonal != result[i].end()) {
            diagonal->second += shift.exact();
        } else {
            result[i].emplace_back(i, shift.exact());
        }
    }
    return result;
}

// By the numbers of products of balls, those of the series weighted by its longer numbers: at most 2 terms a bit and 4
// nu, and some eight products of matrices. The column of b counts only in a series of more than one term with it.
std::optional<linear_flow::series_plan> linear_flow::planned_series(const number& time, long bits) const {
    const precision_scope scope(decimal_digits(bits));
    const ball gone = elapsed(time);
    const rows_of_balls plain = scaled_rows(gone, {});
    magnitude decay;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        for (const auto& [column, value] : plain[i]) {
            if (column == i && arb_is_negative(value.handle()) != 0) {
                decay = std::max(decay, magnitude(value));
            }
        }
    }
    std::optional<series_plan> best;
    double least = 8 * std::pow(static_cast<double>(rows_.size()), 3);
    for (const magnitude& shift : {magnitude(), decay}) {
        series_plan plan{shift, {}, 0};
        std::size_t entries = 0;
        for (const auto& row : scaled_rows(gone, shift)) {
            magnitude sum;
            for (const auto& [column, value] : row) {
                sum += column < rows_.size() || !shift.is_zero() ? magnitude(value) : magnitude();
            }
            plan.norm = std::max(plan.norm, sum);
            entries += row.size();
        }
        const double lost = bits_per_e_fold * std::max(0., plan.norm.above() - shift.above());
        const double products = (2 * static_cast<double>(bits) + 4 * plan.norm.above()) *
                                (1 + lost / static_cast<double>(bits)) * static_cast<double>(entries);
        if (products <= least) {
            least = products;
            plan.bits = bits + static_cast<long>(lost) + 8;
            best = plan;
        }
    }
    return best;
}

// (y(t), 1) = e^-c (T_0 + T_1 + T_2 + ..), T_0 = (y(t0), 1), T_(k+1) = N T_k/(k + 1), N = s [A b; 0 0] + c 1, s = t -
// t0. With nu, the largest row sum of |N|, and q = nu/(k + 1) < 1, the terms after T_k have at most q/(1 - q) times the
// largest entry of T_k as their sum. The radii grow like exp(nu), the factor is exp(-c): exp(nu - c) as more bits.
// Where N and y(t0) are not negative, as in chains of conversions, c costs no bits, and small unknowns have as many as
// large ones. std::nullopt where the products of matrices are estimated to cost less.
std::optional<std::vector<ball>> linear_flow::by_series(const number& time, long bits) const {
    const auto plan = planned_series(time, bits);
    if (!plan) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(plan->bits));
    const ball gone = elapsed(time);
    const rows_of_balls rows = scaled_rows(gone, plan->shift);
    std::vector<ball> start;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        start.push_back(i < rows_.size() ? constant_value<ball>::of(starts_[i]) : ball(1));
    }
    const std::vector<bool> moving = changing(product(scaled_rows(gone, {}), start));
    std::vector<ball> state = start;
    std::vector<ball> term = product(rows, start);
    magnitude rest;
    for (unsigned long k = 1;; ++k) {
        for (std::size_t i = 0; i < state.size(); ++i) {
            state[i] += term[i];
        }
        rest = sum_of_rest(largest_of(term), plan->norm, k);
        const magnitude size = std::max(largest_of(std::span(state).first(rows_.size())),
                                        largest_of(std::span(start).first(rows_.size())));
        if (rest <= size.shifted(-bits) &&
            (rest <= size.shifted(-most_times_bits * bits) || is_small_for_all(rest.shifted(bits), state, moving))) {
            break;
        }
        term = product(rows, term);
        for (ball& each : term) {
            each /= static_cast<long>(k + 1);
        }
    }
    const ball factor = exp(-plan->shift.exact());
    state.resize(rows_.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (moving[i]) {
            arb_add_error_mag(state[i].handle(), rest.handle());
            state[i] *= factor;
        } else {
            state[i] = start[i];
        }
    }
    return state;
}

std::vector<ball> linear_flow::product(const rows_of_balls& rows, const std::vector<ball>& x) {
    const slong bits = ball::working_bits();
    std::vector<ball> result(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const auto& [column, value] : rows[i]) {
            arb_addmul(result[i].handle(), value.handle(), x[column].handle(), bits);
        }
    }
    return result;
}

// The unknowns that are not exactly 0 in every term.
std::vector<bool> linear_flow::changing(const std::vector<ball>& first_term) const {
    std::vector<bool> result;
    result.reserve(first_term.size());
    for (const ball& each : first_term) {
        result.push_back(arb_is_zero(each.handle()) == 0);
    }
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!result[i] && std::ranges::any_of(rows_[i], [&](const entry& each) { return result[each.column]; })) {
                result[i] = true;
                more = true;
            }
        }
    }
    return result;
}

std::optional<std::vector<ball>> linear_flow::at(const number& time, long bits, const zeros_at& put_zeros) const {
    const long first = bits + guard_bits;
    return with_doubled_bits(first, most_times_bits * first, [&](long now) {
        std::vector<ball> state = rounded_state(time, now);
        if (put_zeros) {
            put_zeros(state);
        }
        const bool precise = std::ranges::all_of(state, [&](const ball& each) { return is_precise(each, bits); });
        return precise ? std::optional(std::move(state)) : std::nullopt;
    });
}

}  // namespace libration::ode
