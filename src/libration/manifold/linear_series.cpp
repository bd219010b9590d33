#include "linear_series.hpp"

#include <algorithm>
#include <cmath>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_halvings = 400;
constexpr long terms_per_bit = 8;
constexpr long least_terms = 12;

std::vector<ball> scaled_by_powers(std::vector<ball> p, const ball& h, long first) {
    ball power = pow(h, first);
    for (ball& each : p) {
        each *= power;
        power *= h;
    }
    return p;
}

magnitude sum_of_sizes(const std::vector<ball>& p, std::size_t first, const magnitude& divisor) {
    magnitude sum;
    for (std::size_t i = first; i < p.size(); ++i) {
        sum += magnitude(p[i]);
    }
    return sum / divisor;
}

}  // namespace

std::vector<ball> shifted(std::vector<ball> p, const ball& s0) {
    for (std::size_t first = 0; first + 1 < p.size(); ++first) {
        for (std::size_t i = p.size() - 1; i-- > first;) {
            p[i] += p[i + 1] * s0;
        }
    }
    return p;
}

ball linear_series::value(const ball& tau) const {
    ball sum(0);
    for (std::size_t k = c_.size(); k-- > 0;) {
        sum = sum * tau + c_[k];
    }
    return widened(sum, tail_);
}

ball linear_series::slope(const ball& tau) const {
    ball sum(0);
    for (std::size_t k = c_.size(); k-- > 1;) {
        sum = sum * tau + c_[k] * static_cast<long>(k);
    }
    return widened(sum, slope_tail_) / length_;
}

std::optional<second_order_step> second_order_step::towards(const second_order_equation& of, const ball& s0,
                                                            const ball& to, double size) {
    const auto a = shifted(of.a, s0);
    const auto b = shifted(of.b, s0);
    const auto c = shifted(of.c, s0);
    const magnitude divisor = magnitude::below(a.front());
    if (divisor.is_zero()) {
        return std::nullopt;
    }
    const magnitude most_b = magnitude::at_least(size, 0);
    const magnitude most_c = magnitude::at_least(size * size, 0);
    second_order_step step;
    step.length_ = to - s0;
    step.inverse_ = ball(1) / a.front();
    // All of the distance, else the largest power of 2 that is small enough.
    for (int k = 0; k < most_halvings; ++k) {
        step.a_ = scaled_by_powers(a, step.length_, 0);
        step.b_ = scaled_by_powers(b, step.length_, 1);
        step.c_ = scaled_by_powers(c, step.length_, 2);
        step.a_size_ = sum_of_sizes(step.a_, 1, divisor);
        step.b_size_ = sum_of_sizes(step.b_, 0, divisor);
        step.c_size_ = sum_of_sizes(step.c_, 0, divisor);
        if (step.a_size_ <= magnitude::of(1, -1) && step.b_size_ <= most_b && step.c_size_ <= most_c) {
            return step;
        }
        const bool backward = arb_is_negative(step.length_.handle()) != 0;
        const ball next = ldexp(ball(backward ? -1 : 1), magnitude(step.length_).exponent() - 2);
        step.length_ = k == 0 ? next : ldexp(step.length_, -1);
    }
    return std::nullopt;
}

std::optional<linear_series> second_order_step::solution(const ball& value, const ball& slope,
                                                         std::size_t terms) const {
    const slong bits = ball::working_bits();
    const std::size_t window = std::max({a_.size() - 1, b_.size(), c_.size() + 1});
    linear_series result;
    result.length_ = length_;
    auto& y = result.c_;
    y = {value, slope * length_};
    magnitude largest = std::max(magnitude(y[0]), magnitude(y[1]));
    const auto largest_of_last = [&] {
        magnitude last;
        for (std::size_t i = y.size() - std::min(window, y.size()); i < y.size(); ++i) {
            last = std::max(last, magnitude(y[i]));
        }
        return last;
    };
    const auto most_terms = static_cast<std::size_t>(least_terms + terms_per_bit * bits);
    ball sum;
    ball term;
    while (y.size() < most_terms) {
        const auto k = static_cast<long>(y.size());
        arb_zero(sum.handle());
        for (std::size_t j = 0; j < c_.size() && j + 2 <= y.size(); ++j) {
            arb_addmul(sum.handle(), c_[j].handle(), y[y.size() - 2 - j].handle(), bits);
        }
        for (std::size_t i = 0; i < b_.size() && i + 1 < y.size(); ++i) {
            const long n = k - 1 - static_cast<long>(i);
            arb_mul_si(term.handle(), y[static_cast<std::size_t>(n)].handle(), n, bits);
            arb_submul(sum.handle(), b_[i].handle(), term.handle(), bits);
        }
        for (std::size_t i = 1; i < a_.size() && i + 1 < y.size(); ++i) {
            const long n = k - static_cast<long>(i);
            arb_mul_si(term.handle(), y[static_cast<std::size_t>(n)].handle(), n * (n - 1), bits);
            arb_submul(sum.handle(), a_[i].handle(), term.handle(), bits);
        }
        y.push_back(sum * inverse_ / (k * (k - 1)));
        largest = std::max(largest, magnitude(y.back()));
        if (terms > 0 ? y.size() <= terms : k < least_terms || !(magnitude(y.back()) <= largest.shifted(-bits))) {
            continue;
        }
        const auto n = static_cast<unsigned long>(k);
        const magnitude last = largest_of_last();
        const magnitude rho = a_size_ + b_size_ / (n + 1) + c_size_ / (n * (n + 1));
        if ((terms > 0 || last <= largest.shifted(-bits)) && rho <= magnitude::of(3, -2)) {
            const magnitude w(static_cast<unsigned long>(window));
            const magnitude rest = magnitude::difference_below(magnitude(1U), rho);
            const magnitude quotient = rho / rest;
            result.tail_ = w * quotient * last;
            result.slope_tail_ = w * last * (magnitude(n) * quotient + w * quotient / rest);
            return result;
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
