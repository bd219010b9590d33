#include "libration/algebra/krawczyk.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int most_root_steps = 60;
constexpr int most_boxes = 6;
constexpr int most_proofs = 12;
// The maximum number of proofs that fail for another reason than too few digits, each with half as many bits more, and with twice
// the bits of the derivative, which loses digits where solutions diverge.
constexpr int most_failed_proofs = 5;

constexpr long digits_of_iterate = 10;
constexpr long digits_of_residual = 3;

std::string rounded_text(const ball& x, long digits) {
    const precision_scope scope(digits + 20);
    return is_finite(x) ? to_decimal(midpoint_of(x), digits) : "not finite";
}

std::vector<ball> times(const ball_matrix& a, const std::vector<ball>& x) {
    std::vector<ball> result;
    for (const auto& row : a) {
        ball sum(0);
        for (std::size_t j = 0; j < x.size(); ++j) {
            sum += row[j] * x[j];
        }
        result.push_back(sum);
    }
    return result;
}

// Unknowns that are not distinguished from 0.
enum class zero_values {
    undecided,  // end the proof
    bounded     // are bounded by 10^-digits
};

class root_search {
public:
    root_search(const map_of_unknowns& f, const std::vector<ball>& guess, long digits,
                const std::vector<std::string>& names, zero_values zeros, long settled_bits = 0)
        : f_(f), digits_(digits), names_(names), zeros_(zeros), settled_bits_(settled_bits) {
        const precision_scope scope(decimal_digits(std::max(bits_of_first_iterate, settled_bits)));
        std::ranges::transform(guess, std::back_inserter(x_), exact_midpoint);
    }

    std::vector<known_value> result() {
        long reached = settled_bits_ > 0 ? settled_bits_ : bits_of_first_iterate;
        if (settled_bits_ == 0) {
            settle(reached);
        }
        int proofs = 0;
        int failed = 0;
        std::vector<known_value> values;
        const auto missing = prove_digits(
            digits_, error_subject::solution,
            [&](const run_bits& run, run_demand& demand) {
                while (reached < run.bits) {
                    reached = std::min(reached * 2, run.bits);
                    improve(reached);
                }
                const auto root = proved(run.bits, run_bits::usual_error_bits << failed);
                if (++proofs > most_proofs || (!root && ++failed >= most_failed_proofs)) {
                    refuse_root("is not proved at any precision, as if it were not isolated", "change a condition");
                }
                root ? print(*root, values, demand) : demand.more_bits(run.bits + run.bits / 2, "");
            },
            {.bits = std::max(bits_of_first_iterate, bits_of_first_run(digits_))});
        if (missing) {
            throw error(*missing);
        }
        return values;
    }

private:
    // The message ends with the last iterate and the values of F there.
    [[noreturn]] void refuse_root(const std::string& reason, const std::string& remedy,
                                  error_subject subject = error_subject::solution) const {
        std::string where;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const std::string name = i < names_.size() ? names_[i] : "x" + std::to_string(i + 1);
            where += (i == 0 ? "" : ", ") + name + " = " + rounded_text(x_[i], digits_of_iterate);
        }
        std::string residual;
        for (const ball& each : residual_) {
            residual += (residual.empty() ? "" : ", ") + rounded_text(each, digits_of_residual);
        }
        throw error(error_kind::undecided, subject, "",
                    reason + "; the last iterate is " + where +
                        (residual.empty() ? ", where the conditions have no value" : ", with residual " + residual) +
                        ": " + remedy);
    }

    [[noreturn]] void refuse_guess(const std::string& reason) const {
        refuse_root(reason, "try a better initial guess", error_subject::first_guess);
    }

    enclosed_map at(const std::vector<ball>& x, long bits, long error_bits) {
        residual_.clear();
        auto map = f_(x, bits, error_bits);
        if (!map) {
            refuse_guess("is not reached with " + std::to_string(bits) + " bits");
        }
        residual_ = map->value;
        return *std::move(map);
    }

    // Newton's method until the steps are below the precision; its first steps may be long.
    void settle(long bits) {
        magnitude before;
        for (int i = 0; i < most_root_steps; ++i) {
            const magnitude step = improve(bits);
            if (step <= magnitude::of(1, -bits / 2)) {
                return;
            }
        }
        refuse_guess("is not found, since Newton's method did not converge");
    }

    // Performs one step; returns its length relative to x.
    magnitude improve(long bits) {
        const precision_scope scope(decimal_digits(bits));
        const long error_bits = std::max(run_bits::usual_error_bits, bits / 2 + 48);
        const enclosed_map map = at(x_, bits, error_bits);
        const auto inverse = inverse_near(map.derivative);
        if (!inverse) {
            refuse_guess("is not isolated: the derivative of the conditions is singular");
        }
        const auto step = times(*inverse, map.value);
        magnitude longest;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (!is_finite(step[i])) {
                refuse_guess("is lost by Newton's method");
            }
            x_[i] = exact_midpoint(x_[i] - step[i]);
            longest =
                std::max(longest, magnitude(exact_midpoint(step[i])) / (magnitude(x_[i]) + magnitude::of(1, -20)));
        }
        return longest;
    }

    // The proved solution, by Krawczyk's test.
    std::optional<std::vector<ball>> proved(long bits, long error_bits) {
        const precision_scope scope(decimal_digits(bits));
        const enclosed_map here = at(x_, bits, error_bits);
        const auto inverse = inverse_near(here.derivative);
        if (!inverse) {
            refuse_guess("is not isolated: the derivative of the conditions is singular");
        }
        const auto step = times(*inverse, here.value);
        std::vector<magnitude> radii;
        radii.reserve(step.size());
        for (const ball& each : step) {
            radii.push_back(magnitude(each) * magnitude(2U) + magnitude::of(1, -2 * bits));
        }
        for (int box = 0; box < most_boxes; ++box) {
            if (auto root = krawczyk(*inverse, step, radii, error_bits)) {
                return root;
            }
            for (magnitude& each : radii) {
                each *= magnitude(16U);
            }
        }
        return std::nullopt;
    }

    std::optional<std::vector<ball>> krawczyk(const ball_matrix& inverse, const std::vector<ball>& step,
                                              const std::vector<magnitude>& radii, long error_bits) {
        std::vector<ball> box;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            box.push_back(widened(x_[i], radii[i]));
        }
        const auto over_box = f_(box, 2 * error_bits, error_bits);
        if (!over_box) {
            return std::nullopt;
        }
        const ball_matrix map = product(inverse, over_box->derivative);
        std::vector<ball> root;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            magnitude rest;
            for (std::size_t j = 0; j < x_.size(); ++j) {
                rest += magnitude(ball(i == j ? 1 : 0) - map[i][j]) * radii[j];
            }
            const magnitude reach = magnitude(step[i]) + rest;
            if (!(reach < radii[i])) {
                return std::nullopt;
            }
            root.push_back(widened(x_[i] - step[i], rest));
        }
        return root;
    }

    void print(const std::vector<ball>& root, std::vector<known_value>& values, run_demand& demand) const {
        values.assign(root.size(), {});
        for (std::size_t i = 0; i < root.size(); ++i) {
            if (zeros_ == zero_values::bounded && contains_zero(root[i]) && !is_exact(root[i]) &&
                certainly_less(abs(root[i]), pow(ball(10), -digits_))) {
                values[i].bound = bound_text(root[i]);
            } else {
                demand.improve(values[i], root[i], "", "");
            }
        }
    }

    const map_of_unknowns& f_;
    long digits_;
    const std::vector<std::string>& names_;
    zero_values zeros_;
    long settled_bits_;
    std::vector<ball> residual_;  // of the last iterate; empty if it has none
    std::vector<ball> x_;
};

}  // namespace

std::vector<proved_decimal> proved_root(const map_of_unknowns& f, const std::vector<ball>& guess, long digits,
                                        const std::vector<std::string>& names) {
    std::vector<proved_decimal> decimals;
    for (const known_value& each : root_search(f, guess, digits, names, zero_values::undecided).result()) {
        decimals.push_back(each.decimal.value());
    }
    return decimals;
}

std::vector<known_value> proved_part_of_root(const map_of_unknowns& f, const std::vector<ball>& guess, long digits,
                                             const std::vector<std::string>& names, long settled_bits) {
    return root_search(f, guess, digits, names, zero_values::bounded, settled_bits).result();
}

}  // namespace libration::ode
