#include "sum_candidates.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "libration/scalar/integer_power.hpp"

namespace libration::convergence {

namespace {

constexpr int lengths_compared = 3;
constexpr int least_step_digits = 51;

bool is_finite(const mpfr& x) { return mpfr_number_p(handle(x)) != 0; }

// The value of the same method in another set.
std::optional<mpfr> value_in(const std::vector<summation>& all, const summation& method, std::size_t point) {
    const auto found = std::ranges::find_if(all, [&](const summation& each) { return each.is_same_method(method); });
    const bool known = found != all.end() && found->values[point] && is_finite(found->values[point]->value);
    return known ? std::optional(found->values[point]->value) : std::nullopt;
}

// Each coefficient moved by its noise, with signs from a linear congruence.
std::vector<mpfr> perturbed_list(const reduced_list& list, unsigned seed) {
    std::vector<mpfr> moved = list.values();
    for (std::size_t n = 0; n < moved.size(); ++n) {
        seed = seed * 1664525U + 1013904223U;
        moved[n] += list.noise()[n] * ((seed >> 16U) % 2 == 0 ? 1 : -1);
    }
    return moved;
}

}  // namespace

sum_candidates::sum_candidates(const reduced_list& list, const sum_shape& shape, std::vector<mpfr> points,
                               const task_runner& run)
    : list_(list), points_(std::move(points)) {
    const int last = static_cast<int>(list.values().size()) - 1;
    const summations all(list.values(), shape, points_, run);
    for (int i = 0; i < lengths_compared; ++i) {
        by_length_.push_back(all.of_length(last - i));
    }
    if (!list.is_exact()) {
        for (const unsigned seed : {1U, 2U}) {
            perturbed_.push_back(summations(perturbed_list(list, seed), shape, points_, run).of_length(last));
        }
    }
}

std::vector<candidate> sum_candidates::at(std::size_t point) const {
    std::vector<candidate> found;
    for (const summation& method : by_length_.front()) {
        if (const auto step = step_of(method, point)) {
            found.push_back({method.kind, {method.values[point]->value, *step}});
        }
    }
    std::ranges::stable_sort(found, [](const candidate& a, const candidate& b) { return a.sum.step < b.sum.step; });
    return found;
}

std::optional<mpfr> sum_candidates::step_of(const summation& method, std::size_t point) const {
    std::vector<mpfr> values;
    for (const method_values& all : by_length_) {
        const auto value = value_in(all, method, point);
        if (!value) {
            return std::nullopt;
        }
        values.push_back(*value);
    }
    mpfr square(0);
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const mpfr change = values[i] - values[i + 1];
        square += change * change / (lengths_compared - 1);
    }
    mpfr step = std::max({mpfr(sqrt(square)), method.values[point]->error, least_step(values.front())});
    if (method.kind == sum_kind::partial_sum) {
        step = std::max(step, last_terms(point));
    }
    for (const method_values& other : perturbed_) {
        const auto moved = value_in(other, method, point);
        if (!moved) {
            return std::nullopt;
        }
        step = std::max(step, mpfr(abs(mpfr(*moved - values.front()))));
    }
    return step;
}

mpfr sum_candidates::least_step(const mpfr& value) const {
    mpfr size = abs(value);
    for (std::size_t k = 0; k < 3; ++k) {
        size = std::max(size, mpfr(abs(list_.values()[k])));
    }
    return size * pow(mpfr(10), -least_step_digits);
}

// Half the largest of the last four terms: that some of them are 0 is not convergence.
mpfr sum_candidates::last_terms(std::size_t point) const {
    const auto& b = list_.values();
    mpfr largest(0);
    for (std::size_t n = b.size() - 4; n < b.size(); ++n) {
        largest = std::max(largest, mpfr(abs(mpfr(b[n] * integer_power(points_[point], static_cast<long>(n))))));
    }
    return largest / 2;
}

}  // namespace libration::convergence
