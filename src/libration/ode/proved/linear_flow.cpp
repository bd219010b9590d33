#include "libration/ode/proved/linear_flow.hpp"

#include <algorithm>

#include "libration/ode/constant_value.hpp"
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
    std::vector<expression> leaves;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 0; j < system.unknowns()[i].order; ++j) {
            leaves.push_back(unknown(system.unknowns()[i].name, j));
            starts_.push_back(system.starts()[i][static_cast<std::size_t>(j)]);
        }
    }
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 1; j < system.unknowns()[i].order; ++j) {
            auto& row = rows_.emplace_back(leaves.size(), number(rational(0)));
            row[rows_.size()] = number(rational(1));
            constants_.emplace_back(rational(0));
        }
        auto& row = rows_.emplace_back();
        for (const expression& leaf : leaves) {
            const auto entry = constant_of(partial(system.right()[i], leaf));
            if (!entry) {
                return false;
            }
            row.push_back(*entry);
        }
        const auto rest = value_at_zero(system.right()[i]);
        if (!rest) {
            return false;
        }
        constants_.push_back(*rest);
    }
    return true;
}

bool linear_flow::is_homogeneous() const { return std::ranges::all_of(constants_, is_zero); }

// In the precision of `bits`, which is not that of the result.
std::vector<ball> linear_flow::rounded_state(const number& time, long bits) const {
    const precision_scope scope(decimal_digits(bits));
    const std::size_t n = rows_.size();
    const std::size_t size = is_homogeneous() ? n : n + 1;
    arb_matrix matrix(size, size);
    arb_matrix state(size, 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            arb_set(matrix.at(i, j), constant_value<ball>::of(rows_[i][j]).handle());
        }
        arb_set(state.at(i, 0), constant_value<ball>::of(starts_[i]).handle());
    }
    if (size > n) {
        for (std::size_t i = 0; i < n; ++i) {
            arb_set(matrix.at(i, n), constant_value<ball>::of(constants_[i]).handle());
        }
        arb_one(state.at(n, 0));
    }
    const ball gone = constant_value<ball>::of(time - point_);
    arb_mat_scalar_mul_arb(matrix.handle(), matrix.handle(), gone.handle(), bits);
    arb_mat_exp(matrix.handle(), matrix.handle(), bits);
    arb_mat_mul(state.handle(), matrix.handle(), state.handle(), bits);
    std::vector<ball> result(n);
    for (std::size_t i = 0; i < n; ++i) {
        arb_swap(result[i].handle(), state.at(i, 0));
    }
    return result;
}

std::optional<std::vector<ball>> linear_flow::at(const number& time, long bits) const {
    for (long precision = bits + guard_bits; precision <= most_times_bits * (bits + guard_bits); precision *= 2) {
        std::vector<ball> state = rounded_state(time, precision);
        const bool precise = std::ranges::all_of(state, [&](const ball& each) { return is_precise(each, bits); });
        if (precise) {
            return state;
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
