#include "libration/expansion/step_kernels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace libration::ode {

namespace {

// sum_{k=first}^{last} a_k b_{n-k} for a_last and b_{n-first}: the inner terms k, k + 4, .. in one partial sum each.
template <class R>
[[gnu::always_inline]] inline R sum_in_fours(const R* a, const R* b, int n, int first, int last, R a_last, R b_first) {
    if (first >= last) {
        return first == last ? a_last * b_first : R(0);
    }
    std::array<R, 4> sums{R(0), R(0), R(0), R(0)};
    int k = first + 1;
    for (; k + 3 < last; k += 4) {
        sums[0] += a[k] * b[n - k];
        sums[1] += a[k + 1] * b[n - k - 1];
        sums[2] += a[k + 2] * b[n - k - 2];
        sums[3] += a[k + 3] * b[n - k - 3];
    }
    if (k < last) {
        sums[0] += a[k] * b[n - k];
    }
    if (k + 1 < last) {
        sums[1] += a[k + 1] * b[n - k - 1];
    }
    if (k + 2 < last) {
        sums[2] += a[k + 2] * b[n - k - 2];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + (a[first] * b_first + a_last * b[n - last]);
}

// sum_{k=first}^{n-first} a_k a_{n-k} for a_{n-first} and n > 0, each product once.
template <class R>
R square_in_fours(const R* a, int n, int first, R a_last) {
    const int last = (n - 1) / 2;
    const R half = sum_in_fours(a, a, n, first, last, a[last], a_last);
    return n % 2 == 0 && n >= 2 * first ? half + half + a[n / 2] * a[n / 2] : half + half;
}

template <class R>
R quotient(const placed_step<R>& of, int n, R a_n, R b_n) {
    const R* const r = of.result;
    return n == 0 ? a_n / b_n : (a_n - sum_in_fours(of.b, r, n, 1, n, b_n, r[n - 1])) / of.b[0];
}

template <class R>
R primitive(const placed_step<R>& of, int n) {
    const R* const d = of.derivative;
    return sum_in_fours(of.b, d, n - 1, 0, n - 1, of.b[n - 1], d[n - 1]) / static_cast<R>(n);
}

template <class R>
R power(const placed_step<R>& of, int n) {
    const auto degree = static_cast<R>(n);
    const int last = n - 1;
    const R* const r = of.result;
    R* const slope = of.behind;
    const R rising = sum_in_fours(of.b, r, last, 0, last, of.b[last], r[last]) * of.factor;
    const R falling = last == 0 ? R(0) : sum_in_fours<R>(of.a, slope, last, 1, last, of.a[last], slope[last - 1]);
    const R here = (rising - falling) / (of.a[0] * degree);
    slope[last] = here * degree;
    return here;
}

// Both sums in one loop, which reads the slope once.
template <class R>
R sine_cosine(const placed_step<R>& of, int n) {
    const R* const slope = of.b;
    const R* const sine = of.result;
    R* const cosine = of.behind;
    const int last = n - 1;
    std::array<R, 4> sums{R(0), R(0), R(0), R(0)};
    int k = 1;
    for (; k + 1 < last; k += 2) {
        sums[0] += slope[k] * cosine[last - k];
        sums[1] += slope[k] * sine[last - k];
        sums[2] += slope[k + 1] * cosine[last - k - 1];
        sums[3] += slope[k + 1] * sine[last - k - 1];
    }
    if (k < last) {
        sums[0] += slope[k] * cosine[last - k];
        sums[1] += slope[k] * sine[last - k];
    }
    R of_cosine = slope[0] * cosine[last];
    R of_sine = slope[0] * sine[last];
    if (last > 0) {
        of_cosine += slope[last] * cosine[0];
        of_sine += slope[last] * sine[0];
    }
    const auto degree = static_cast<R>(n);
    cosine[n] = -(of_sine + (sums[1] + sums[3])) / degree;
    return (of_cosine + (sums[0] + sums[2])) / degree;
}

template <class R>
R coefficient(const placed_step<R>& of, int n, R a_n) {
    switch (of.rule) {
        case coefficient_rule::constant: return n == 0 ? of.factor : R(0);
        case coefficient_rule::raised: return n == 0 ? a_n + of.factor : a_n;
        case coefficient_rule::primitive: return primitive(of, n);
        case coefficient_rule::power: return power(of, n);
        case coefficient_rule::sine_cosine: return sine_cosine(of, n);
        case coefficient_rule::linear:
        case coefficient_rule::fraction:
        case coefficient_rule::product:
        case coefficient_rule::square:
        case coefficient_rule::quotient:
        case coefficient_rule::square_root:
        case coefficient_rule::slope:
        case coefficient_rule::otherwise: break;
    }
    return R(0);
}

}  // namespace

template <std::floating_point R>
void run_steps(std::span<const placed_step<R>> steps, std::span<const placed_integral<R>> integrals, int first,
               int last, const std::function<void(int, int)>& otherwise) {
    for (int n = first; n <= last; ++n) {
        const auto next = static_cast<R>(n + 1);
        R newest(0);
        for (const placed_step<R>& of : steps) {
            const auto a_n = [&] { return of.newest == newest_operand::a ? newest : of.a[n]; };
            const auto b_n = [&] { return of.newest == newest_operand::b ? newest : of.b[n]; };
            if (of.rule == coefficient_rule::linear) {
                newest = a_n() * of.factor + b_n() * of.other;
            } else if (of.rule == coefficient_rule::product) {
                newest = sum_in_fours(of.a, of.b, n, 0, n, a_n(), b_n());
            } else if (of.rule == coefficient_rule::fraction) {
                newest = a_n() * of.factor / of.other;
            } else if (of.rule == coefficient_rule::square) {
                newest = n == 0 ? a_n() * a_n() : square_in_fours(of.a, n, 0, a_n());
            } else if (of.rule == coefficient_rule::quotient) {
                newest = quotient(of, n, a_n(), b_n());
            } else if (of.rule == coefficient_rule::square_root) {
                newest = (a_n() - square_in_fours<R>(of.result, n, 1, of.result[n - 1])) / of.behind[0];
            } else if (of.rule == coefficient_rule::slope) {
                if (n > 0) {
                    of.result[n - 1] = a_n() * static_cast<R>(n);
                }
                continue;
            } else if (of.rule == coefficient_rule::otherwise) {
                otherwise(of.index, n);
                newest = of.result[n];
            } else {
                newest = coefficient(of, n, of.a == nullptr ? R(0) : a_n());
            }
            of.result[n] = newest;
            if (of.integral != nullptr) {
                of.integral[n + 1] = newest / next;
            }
        }
        for (const placed_integral<R>& of : integrals) {
            of.result[n + 1] = of.a[n] / next;
        }
    }
}

// Polynomials that are missing are replaced by the first one.
template <std::floating_point R>
void polynomial_values<R>::end() {
    if (count_ == 0) {
        return;
    }
    std::fill(polynomials_.begin() + static_cast<std::ptrdiff_t>(count_), polynomials_.end(), polynomials_[0]);
    const auto [a, b, c, d] = polynomials_;
    R at_a = a[degree_];
    R at_b = b[degree_];
    R at_c = c[degree_];
    R at_d = d[degree_];
    for (int n = degree_ - 1; n >= 0; --n) {
        at_a = at_a * t_ + a[n];
        at_b = at_b * t_ + b[n];
        at_c = at_c * t_ + c[n];
        at_d = at_d * t_ + d[n];
    }
    const std::array<R, 4> all{at_a, at_b, at_c, at_d};
    for (std::size_t i = 0; i < count_; ++i) {
        *values_[i] = all[i];
    }
    count_ = 0;
}

template void run_steps<double>(std::span<const placed_step<double>>, std::span<const placed_integral<double>>, int,
                                int, const std::function<void(int, int)>&);
template void run_steps<long double>(std::span<const placed_step<long double>>,
                                     std::span<const placed_integral<long double>>, int, int,
                                     const std::function<void(int, int)>&);
template class polynomial_values<double>;
template class polynomial_values<long double>;

}  // namespace libration::ode
