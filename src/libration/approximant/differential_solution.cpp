#include "libration/approximant/differential_solution.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "differential_system.hpp"
#include "libration/scalar/convert.hpp"

namespace libration {

namespace {

constexpr int degree_of_step = 130;
constexpr int most_axis_steps = 150;
constexpr int shortest_step = -12;  // exponent of 2, relative to the distance from 0
constexpr long guard_bits = 184;

using polynomial = std::vector<mpfr>;

// p(t + h) in powers of h, up to h^last, by repeated division by x - t. O(degree last).
polynomial shifted(polynomial p, const mpfr& t, int last) {
    const std::size_t kept = std::min(p.size(), static_cast<std::size_t>(last) + 1);
    for (std::size_t i = 0; i < kept; ++i) {
        for (std::size_t j = p.size() - 1; j-- > i;) {
            add_product(p[j], t, p[j + 1]);
        }
    }
    p.resize(kept);
    return p;
}

// n (n-1) .. (n-i+1).
long falling(int n, int i) {
    long product = 1;
    for (int j = 0; j < i; ++j) {
        product *= n - j;
    }
    return product;
}

// The equation in powers of d/dx.
class axis_equation {
public:
    axis_equation(const differential_relation& relation, std::span<const mpfr> a) : order_(relation.track.order) {
        for (int m = 0; m <= relation.track.degree && m < static_cast<int>(a.size()); ++m) {
            right_.push_back(narrow<mpfr>(coefficient_of(relation, a, m).value));
        }
        constexpr std::array<std::array<int, 4>, 4> stirling{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}, {0, 1, 3, 1}}};
        for (int i = 0; i <= order_; ++i) {
            polynomial& c = coefficients_.emplace_back();
            for (int k = i; k <= order_; ++k) {
                const auto& q = relation.q[static_cast<std::size_t>(k)];
                const int factor = stirling[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
                c.resize(std::max(c.size(), q.size() + static_cast<std::size_t>(i)), mpfr(0));
                for (std::size_t j = 0; j < q.size(); ++j) {
                    c[j + static_cast<std::size_t>(i)] += narrow<mpfr>(q[j]) * factor;
                }
            }
        }
    }

    int order() const { return order_; }

    /// f_0 .. f_last about t from f_0 .. f_(M-1); std::nullopt if Q_M is 0 there.
    std::optional<polynomial> taylor_coefficients(const mpfr& t, polynomial f, int last) const {
        const auto order = static_cast<std::size_t>(order_);
        std::vector<polynomial> c;
        for (const polynomial& each : coefficients_) {
            c.push_back(shifted(each, t, last));
        }
        const polynomial p = shifted(right_, t, last);
        if (c.back().empty() || c.back().front() == 0) {
            return std::nullopt;
        }
        // derivatives[i][k] = (k+i)!/k! f_{k+i}, the coefficients of the i-th derivative.
        std::vector<polynomial> derivatives(order + 1);
        const auto enter = [&](int n, const mpfr& value) {
            for (int i = 0; i <= std::min(order_, n); ++i) {
                derivatives[static_cast<std::size_t>(i)].push_back(value * falling(n, i));
            }
        };
        for (int n = 0; n < order_; ++n) {
            enter(n, f[static_cast<std::size_t>(n)]);
        }
        for (int m = 0; m + order_ <= last; ++m) {
            const auto at = static_cast<std::size_t>(m);
            mpfr sum = at < p.size() ? p[at] : mpfr(0);
            derivatives[order].emplace_back(0);
            for (std::size_t i = 0; i <= order; ++i) {
                const int count = std::min(m + 1, static_cast<int>(c[i].size()));
                sum -= inner_product(c[i].data(), 1, derivatives[i].data() + m, -1, count);
            }
            derivatives[order].pop_back();
            f.push_back(sum / (c[order].front() * falling(m + order_, order_)));
            enter(m + order_, f.back());
        }
        return f;
    }

private:
    int order_;
    std::vector<polynomial> coefficients_;
    polynomial right_;
};

// The length at which the last eight terms are 2^-solution_bits of the first ones, which are compared at the distance
// `unit`; 0 if they are not finite, std::nullopt if all of them are 0.
std::optional<mpfr> step_length(const polynomial& f, const mpfr& unit) {
    constexpr std::size_t compared = 8;
    mpfr size(0);
    mpfr power(1);
    for (std::size_t k = 0; k < compared; ++k, power *= unit) {
        size = std::max(size, mpfr(abs(f[k]) * power));
    }
    std::optional<mpfr> length;
    for (std::size_t k = f.size() - compared; k < f.size(); ++k) {
        if (mpfr_number_p(handle(f[k])) == 0 || size == 0) {
            return mpfr(0);
        }
        if (f[k] != 0) {
            const mpfr within = exp2(mpfr((log2(mpfr(size / abs(f[k]))) - solution_bits) / static_cast<int>(k)));
            length = length && *length < within ? *length : within;
        }
    }
    return length;
}

// f^(i)(t + h)/i!.
mpfr shifted_coefficient(const polynomial& f, int i, const mpfr& h) {
    mpfr sum(0);
    for (int k = static_cast<int>(f.size()) - 1; k >= i; --k) {
        mpfr term = f[static_cast<std::size_t>(k)] * falling(k, i);
        for (int divisor = 2; divisor <= i; ++divisor) {
            term /= divisor;
        }
        sum = sum * h + term;
    }
    return sum;
}

}  // namespace

std::vector<std::optional<mpfr>> solution_along_axis(const differential_relation& relation, std::span<const mpfr> a,
                                                     int length, std::span<const mpfr> targets) {
    std::vector<std::optional<mpfr>> values(targets.size());
    if (targets.empty()) {
        return values;
    }
    const auto list = continued_by(relation, a, length, std::max(0, degree_of_step - length));
    const precision_scope scope(decimal_digits(solution_bits + guard_bits));
    const axis_equation equation(relation, a);
    polynomial f;
    for (int n = 0; n <= degree_of_step; ++n) {
        f.push_back(narrow<mpfr>(list[static_cast<std::size_t>(n)]));
    }
    const int sign = targets.front() < 0 ? -1 : 1;
    mpfr t(0);
    std::size_t next = 0;
    for (int step = 0; step < most_axis_steps; ++step) {
        const mpfr unit = mpfr(t == 0 ? mpfr(1) : mpfr(abs(t))) / 8;
        const auto h = step_length(f, unit);
        for (; next < targets.size() && (!h || abs(mpfr(targets[next] - t)) <= *h); ++next) {
            values[next] = shifted_coefficient(f, 0, narrow<mpfr>(mpfr(targets[next] - t)));
        }
        if (next == targets.size() || *h <= ldexp(mpfr(abs(t)), shortest_step)) {
            break;
        }
        const mpfr forward = *h * sign;
        polynomial first;
        for (int i = 0; i < equation.order(); ++i) {
            first.push_back(shifted_coefficient(f, i, forward));
        }
        t += forward;
        auto following = equation.taylor_coefficients(t, std::move(first), degree_of_step);
        if (!following) {
            break;
        }
        f = *std::move(following);
    }
    return values;
}

}  // namespace libration
