#include "algebraic_decay.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr double least_exponent = 0.01;
constexpr double agreement = 0.01;
constexpr long least_bits_of_changes = 20;

// log2(earlier/later).
std::optional<double> exponent_between(const ball& earlier, const ball& later) {
    if (arb_rel_accuracy_bits(earlier.handle()) < least_bits_of_changes ||
        arb_rel_accuracy_bits(later.handle()) < least_bits_of_changes) {
        return std::nullopt;
    }
    return static_cast<double>(midpoint_of(log(earlier / later) / log(ball(2))));
}

}  // namespace

void algebraic_decay::add(const std::vector<ball>& state) {
    if (!last_.empty()) {
        ball sum(0);
        for (std::size_t k = 0; k < state.size(); ++k) {
            sum += abs(state[k] - last_[k]);
        }
        changes_.push_back(std::move(sum));
    }
    last_ = state;
}

std::optional<double> algebraic_decay::exponent() const {
    if (changes_.size() < 3) {
        return std::nullopt;
    }
    const auto last = changes_.end() - 1;
    const auto later = exponent_between(*(last - 1), *last);
    const auto earlier = exponent_between(*(last - 2), *(last - 1));
    const bool agree = later && earlier && *later >= least_exponent && std::isfinite(*later) &&
                       std::abs(*later - *earlier) <= agreement * *later;  // false where changes are 0
    return agree ? later : std::nullopt;
}

std::string algebraic_decay::text() const {
    const auto q = exponent();
    if (!q) {
        return {};
    }
    std::array<char, 40> decimals{};
    const char* const end =
        std::to_chars(decimals.data(), decimals.data() + decimals.size(), *q, std::chars_format::fixed, 2).ptr;
    return "; its last three changes, from t to 2 t, decrease like t^-" +
           std::string(static_cast<const char*>(decimals.data()), end) + ", algebraically up to there";
}

}  // namespace libration::ode
