#include "regular_solution.hpp"

#include <algorithm>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t least_regular_terms = 8;
constexpr std::size_t regular_terms_per_bit = 4;

magnitude scaled_size(const std::vector<ball>& p, const ball& w, const ball& divisor) {
    magnitude sum;
    ball power = w;
    for (std::size_t i = 1; i < p.size(); ++i, power *= w) {
        sum += magnitude(p[i] * power / divisor);
    }
    return sum;
}

}  // namespace

ball regular_equation::exponent() const {
    const ball last = above.front() / below.front();
    return p == 0 ? sqrt(last) : ldexp(sqrt(last * 4 + 1) + 1, -1);
}

std::optional<regular_value> regular_solution_at(const regular_equation& of, const ball& w, std::size_t terms) {
    const slong bits = ball::working_bits();
    const ball rho = of.exponent();
    const ball& divisor = of.below.front();
    if (arb_is_positive(rho.handle()) == 0 || contains_zero(divisor)) {
        return std::nullopt;
    }
    const std::size_t degree = std::max({of.above.size(), of.below.size(), std::size_t{2}}) - 1;
    const magnitude a = scaled_size(of.below, w, divisor);
    const magnitude c = scaled_size(of.above, w, divisor);
    if (!(a <= magnitude::of(1, -1))) {
        return std::nullopt;
    }
    std::vector<ball> e{ball(1)};  // c_k w^k
    std::vector<ball> powers{ball(1)};
    for (std::size_t i = 1; i <= degree; ++i) {
        powers.push_back(powers.back() * w);
    }
    magnitude later;
    while (e.size() < least_regular_terms + regular_terms_per_bit * static_cast<std::size_t>(bits)) {
        const auto k = static_cast<long>(e.size());
        ball sum(0);
        for (std::size_t i = 1; i <= degree && i <= e.size(); ++i) {
            const ball r = rho + (k - static_cast<long>(i));
            ball factor(0);
            if (i < of.above.size()) {
                factor += of.above[i];
            }
            if (i < of.below.size()) {
                factor -= of.below[i] * (r * r - r * of.p);
            }
            sum += factor * powers[i] * e[e.size() - i];
        }
        e.push_back(sum / (divisor * (rho * 2 * k + k * k - of.p * k)));
        later += magnitude(e.back());
        magnitude last;
        for (std::size_t i = e.size() - std::min(degree, e.size()); i < e.size(); ++i) {
            last = std::max(last, magnitude(e[i]));
        }
        const ball square = (rho + k) * (rho + k);
        const ball least = rho * 2 * k + k * k - of.p * k;
        const magnitude q = (a * magnitude(square) + c) / magnitude::below(least);
        const bool enough =
            terms > 0 ? e.size() > terms : e.size() >= least_regular_terms && last <= magnitude::of(1, -bits);
        if (!enough || !(q <= magnitude::of(3, -2))) {
            continue;
        }
        const magnitude rest = magnitude::difference_below(magnitude(1U), q);
        const magnitude window(static_cast<unsigned long>(degree));
        const magnitude quotient = q / rest;
        const magnitude tail = window * quotient * last;
        const magnitude index_tail =
            window * last * (magnitude(static_cast<unsigned long>(k)) * quotient + window * quotient / rest);
        ball value(0);
        ball slope(0);
        for (std::size_t i = e.size(); i-- > 0;) {
            value += e[i];
            slope += (rho + static_cast<long>(i)) * e[i];
        }
        return regular_value{widened(value, tail), widened(slope, index_tail + magnitude(rho) * tail),
                             later + tail < magnitude(1U)};
    }
    return std::nullopt;
}

}  // namespace libration::ode
