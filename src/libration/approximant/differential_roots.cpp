#include "differential_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

#include "libration/algebra/polynomial_roots.hpp"
#include "libration/scalar/complex_functions.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration {

namespace {

using complex_double = std::complex<double>;
using polynomial = std::vector<mpfr>;

constexpr long root_digits = 97;  // 320 bits
constexpr int most_steps = 60;

complex_double rounded(const complex_number<mpfr>& z) { return {z.re.convert_to<double>(), z.im.convert_to<double>()}; }

// p^(m)/m!.
polynomial taylor_coefficient(const polynomial& p, int m) {
    polynomial q;
    for (int k = m; k < static_cast<int>(p.size()); ++k) {
        integer binomial(1);
        for (int i = 0; i < m; ++i) {
            binomial = binomial * (k - i) / (i + 1);
        }
        q.push_back(p[static_cast<std::size_t>(k)] * mpfr(binomial));
    }
    return q.empty() ? polynomial{mpfr(0)} : q;
}

// p(z) by division by the real quadratic factor z^2 - 2 re z + |z|^2: two real products per coefficient.
complex_number<mpfr> value_at(const polynomial& p, const complex_number<mpfr>& z) {
    if (z.im == 0) {
        mpfr sum = p.back();
        for (std::size_t k = p.size() - 1; k-- > 0;) {
            horner_step(sum, z.re, p[k]);
        }
        return {sum, mpfr(0)};
    }
    const mpfr twice = z.re * 2;
    const mpfr square = -(z.re * z.re + z.im * z.im);
    mpfr above(0);
    mpfr now = p.back();
    for (std::size_t k = p.size() - 1; k-- > 0;) {
        mpfr next = p[k];
        add_product(next, twice, now);
        add_product(next, square, above);
        above = std::exchange(now, std::move(next));
    }
    // The remainder is now + above (z - 2 re).
    return {mpfr(now - above * z.re), mpfr(above * z.im)};
}

class equation_roots {
public:
    equation_roots(const differential_relation& relation, root_annulus within)
        : order_(relation.track.order),
          assumed_(relation.track.lowest == relation.track.order),
          within_(within),
          exact_(relation.exact) {
        for (const auto& q : relation.q) {
            polynomial& rounded_to = q_.emplace_back();
            for (const mpfr& c : q) {
                rounded_to.push_back(narrow<mpfr>(c));
            }
        }
        while (q_.back().size() > 1 && q_.back().back() == 0) {
            q_.back().pop_back();
        }
    }

    std::vector<differential_root> all() {
        if (q_.back().size() < 2 || within_.inner >= within_.outer) {
            return {};
        }
        find_starts();
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            if (within_annulus(starts_[i])) {
                add_simple(i);
                add_multiple(i);
            }
        }
        return std::move(found_);
    }

private:
    // Q_k^(m)/m!, kept.
    const polynomial& taylor(std::size_t k, int m) const {
        if (m == 0) {
            return q_[k];
        }
        const auto known = derivatives_.find({k, m});
        return known != derivatives_.end()
                   ? known->second
                   : derivatives_.emplace(std::pair(k, m), taylor_coefficient(q_[k], m)).first->second;
    }

    bool within_annulus(const complex_double& z) const {
        return std::abs(z) > within_.inner && std::abs(z) < within_.outer;
    }

    // The roots in long double, and the nearest other one of each if that is near.
    void find_starts() {
        std::vector<long double> c;
        for (const mpfr& each : q_.back()) {
            c.push_back(each.convert_to<long double>());
        }
        while (c.size() > 1 && c.back() == 0) {
            c.pop_back();
        }
        if (c.size() < 2) {
            return;
        }
        for (const auto& root : roots_of(series::power_series<long double>(std::move(c))).all) {
            fine_starts_.push_back(root.at);
            starts_.emplace_back(static_cast<double>(root.at.re), static_cast<double>(root.at.im));
        }
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            const auto near = nearest_to(starts_[i], {i});
            neighbours_.push_back(near && apart(*near, i) <= near_each_other * std::abs(starts_[i]) ? near
                                                                                                    : std::nullopt);
        }
    }

    double apart(std::size_t i, std::size_t j) const { return std::abs(starts_[i] - starts_[j]); }

    std::optional<std::size_t> nearest_to(const complex_double& z, const std::vector<std::size_t>& except) const {
        std::optional<std::size_t> best;
        for (std::size_t k = 0; k < starts_.size(); ++k) {
            if (std::ranges::find(except, k) == except.end() &&
                (!best || std::abs(starts_[k] - z) < std::abs(starts_[*best] - z))) {
                best = k;
            }
        }
        return best;
    }

    void add_simple(std::size_t i) {
        const complex_number<mpfr> start{mpfr(fine_starts_[i].re), mpfr(fine_starts_[i].im)};
        if (starts_[i].imag() <= -1e-9 * std::abs(starts_[i])) {
            return;
        }
        auto root = newton(start, 1, std::nullopt);
        if (root && is_known(*root)) {  // two starts that end in one root: without it
            root = newton(start, 1, root);
        }
        if (root && !is_known(*root)) {
            simple_.push_back(rounded(*root));
            add_root(*root, 1, std::min(1, order_));
        }
    }

    bool is_known(const complex_number<mpfr>& z) const {
        return std::ranges::any_of(simple_, [&](const complex_double& known) {
            return std::abs(known - rounded(z)) < 4e-16 * std::abs(known);
        });
    }

    // A pair of neighbours as one double root, with both lower polynomials and with one; with a third as a triple one.
    void add_multiple(std::size_t i) {
        const auto j = neighbours_[i];
        if (!j || *j < i || neighbours_[*j] != i) {
            return;
        }
        const complex_double middle = (starts_[i] + starts_[*j]) / 2.0;
        for (int lower = std::min(2, order_); lower >= std::min(1, order_); --lower) {
            add_between(middle, 1e-6, 2, lower);
        }
        const auto third = nearest_to(middle, {i, *j});
        if (third && *third > i && order_ != 1 &&
            std::abs(starts_[*third] - middle) < near_each_other * std::abs(starts_[i])) {
            const complex_double of_three = (starts_[i] + starts_[*j] + starts_[*third]) / 3.0;
            for (int lower = std::min(3, order_); lower >= std::min(2, order_); --lower) {
                add_between(of_three, 1e-4, 3, lower);
            }
        }
    }

    void add_between(complex_double start, double real_within, int multiplicity, int lower) {
        if (std::abs(start.imag()) < real_within * std::abs(start)) {
            start = start.real();
        }
        if (start.imag() <= -1e-9 * std::abs(start)) {
            return;
        }
        if (const auto root = newton({mpfr(start.real()), mpfr(start.imag())}, multiplicity, std::nullopt)) {
            if (lower == multiplicity || !is_contradicted(*root, multiplicity, lower)) {
                add_root(*root, multiplicity, lower);
            }
        }
    }

    // Newton's iteration for the zero of Q_M^(m-1), divided by z - `without` if that is given.
    std::optional<complex_number<mpfr>> newton(complex_number<mpfr> z, int multiplicity,
                                               const std::optional<complex_number<mpfr>>& without) const {
        const complex_number<mpfr> start = z;
        const mpfr size = modulus_of(z);
        if (abs(z.im) < size * 1e-14) {
            z.im = 0;
        }
        for (int step = 0; step < most_steps; ++step) {
            const complex_number<mpfr> value = value_at(taylor(q_.size() - 1, multiplicity - 1), z);
            complex_number<mpfr> slope = value_at(taylor(q_.size() - 1, multiplicity), z) * multiplicity;
            if (without) {
                const complex_number<mpfr> away = z - *without;
                if (away.re == 0 && away.im == 0) {
                    return std::nullopt;
                }
                slope = slope - value / away;
            }
            if (slope.re == 0 && slope.im == 0) {
                return std::nullopt;
            }
            const complex_number<mpfr> move = value / slope;
            z = z - move;
            const long change = std::max(binary_exponent(move.re), binary_exponent(move.im));
            if (change < binary_exponent(size) - 165) {  // the error is now the square of it
                return is_near(z, start, multiplicity) ? std::optional(z) : std::nullopt;
            }
        }
        return std::nullopt;
    }

    static bool is_near(const complex_number<mpfr>& z, const complex_number<mpfr>& start, int multiplicity) {
        const double size = std::abs(rounded(start));
        const double moved = std::abs(rounded(z - start));
        return moved < (multiplicity > 1 ? 0.05 : 1e-3) * size && z.im >= -1e-17 * size;
    }

    // c_l = z^(M-l) Q_{M-l}^((m-l))(z)/(m-l)!, l = 0 .. e.
    std::vector<complex_number<mpfr>> indicial_coefficients(const complex_number<mpfr>& z, int m, int e) const {
        std::vector<complex_number<mpfr>> c;
        for (int l = 0; l <= e; ++l) {
            complex_number<mpfr> value = value_at(taylor(static_cast<std::size_t>(order_ - l), m - l), z);
            for (int i = l; i < order_; ++i) {
                value = value * z;
            }
            c.push_back(value);
        }
        return c;
    }

    void add_root(const complex_number<mpfr>& z, int multiplicity, int lower) {
        differential_root root{.position = z, .multiplicity = multiplicity, .lower = lower, .assumed = assumed_};
        if (lower == 0) {
            root.exponent = {mpfr(-multiplicity), mpfr(0)};
            found_.push_back(std::move(root));
            return;
        }
        const auto v = zeros_of_indicial(indicial_coefficients(z, multiplicity, lower));
        if (v.empty() || !(std::abs(rounded(v.front())) < 1e6)) {
            return;
        }
        const int shift = order_ - lower;
        root.exponent = {mpfr(v.front().re + shift), v.front().im};
        if (v.size() > 1) {
            root.second = v[1].re.convert_to<double>() + shift;
        }
        root.irregular = exact_ && multiplicity > 1 && multiplicity == lower && !vanishing_enough(z, multiplicity, 20);
        found_.push_back(std::move(root));
    }

    // Whether fewer lower polynomials give an exponent that all of them, of a regular singular point, do not have: that
    // is one of two confluent powers then, and the sum of both by fewer.
    bool is_contradicted(const complex_number<mpfr>& z, int multiplicity, int lower) const {
        if (multiplicity > order_ || !vanishing_enough(z, multiplicity, exact_ ? 20 : 4)) {
            return false;
        }
        const auto fewer = zeros_of_indicial(indicial_coefficients(z, multiplicity, lower));
        const auto all = zeros_of_indicial(indicial_coefficients(z, multiplicity, multiplicity));
        return !fewer.empty() && !all.empty() && std::ranges::none_of(all, [&](const auto& each) {
            const auto away = rounded(each - fewer.front()) - static_cast<double>(multiplicity - lower);
            return std::abs(away) < 0.05 * (1 + std::abs(rounded(each)));
        });
    }

    // A regular singular point: Q_(M-l) vanishes to order m - l, 0 < l < m, to 10^-digits of its terms.
    bool vanishing_enough(const complex_number<mpfr>& z, int m, int digits) const {
        for (int l = 1; l < m; ++l) {
            for (int i = 0; i < m - l; ++i) {
                const polynomial& p = taylor(static_cast<std::size_t>(order_ - l), i);
                polynomial sizes;
                std::ranges::transform(p, std::back_inserter(sizes), [](const mpfr& c) { return mpfr(abs(c)); });
                const mpfr terms = value_at(sizes, {modulus_of(z), mpfr(0)}).re;
                if (modulus_of(value_at(p, z)) > terms / pow(mpfr(10), digits)) {
                    return false;
                }
            }
        }
        return true;
    }

    // The zeros v of sum_l c_l v (v-1) .. (v-e+l+1), by real part; empty where c_0 is too small.
    static std::vector<complex_number<mpfr>> zeros_of_indicial(const std::vector<complex_number<mpfr>>& c) {
        if (c[0].re == 0 && c[0].im == 0) {
            return {};
        }
        std::vector<complex_number<mpfr>> v;
        const complex_number<mpfr> b = c[1] / c[0];
        if (c.size() == 2) {
            v = {-b};
        } else if (c.size() == 3) {  // v^2 + (b - 1) v + c_2/c_0
            const complex_number<mpfr> half = (complex_number<mpfr>(1) - b) / 2;
            const complex_number<mpfr> root = sqrt(half * half - c[2] / c[0]);
            v = {half - root, half + root};
        } else {
            v = zeros_of_cubic(c[3] / c[0], complex_number<mpfr>(2) - b + c[2] / c[0], b - complex_number<mpfr>(3));
        }
        std::ranges::stable_sort(v, [](const auto& x, const auto& y) { return x.re < y.re; });
        return v;
    }

    // Of v^3 + c v^2 + b v + a, by the iteration of Durand and Kerner.
    static std::vector<complex_number<mpfr>> zeros_of_cubic(const complex_number<mpfr>& a,
                                                            const complex_number<mpfr>& b,
                                                            const complex_number<mpfr>& c) {
        const mpfr size = 1 + modulus_of(a) + modulus_of(b) + modulus_of(c);
        const complex_number<mpfr> turn{mpfr(mpfr(2) / 5), mpfr(mpfr(9) / 10)};
        std::vector<complex_number<mpfr>> v{{size, mpfr(0)}, turn * size, turn * turn * size};
        for (int step = 0; step < 200; ++step) {
            long change = exponent_of_zero;
            for (std::size_t i = 0; i < 3; ++i) {
                const complex_number<mpfr> others = (v[i] - v[(i + 1) % 3]) * (v[i] - v[(i + 2) % 3]);
                if (others.re == 0 && others.im == 0) {
                    continue;
                }
                const complex_number<mpfr> move = (((v[i] + c) * v[i] + b) * v[i] + a) / others;
                v[i] = v[i] - move;
                change = std::max({change, binary_exponent(move.re), binary_exponent(move.im)});
            }
            if (change < binary_exponent(size) - 150) {
                break;
            }
        }
        return v;
    }

    static constexpr double near_each_other = 0.08;

    int order_;
    bool assumed_;
    root_annulus within_;
    bool exact_;
    std::vector<polynomial> q_;
    mutable std::map<std::pair<std::size_t, int>, polynomial> derivatives_;  ///< Q_k^(m)/m!
    std::vector<complex_number<long double>> fine_starts_;
    std::vector<complex_double> starts_;
    std::vector<std::optional<std::size_t>> neighbours_;
    std::vector<complex_double> simple_;
    std::vector<differential_root> found_;
};

}  // namespace

std::vector<differential_root> roots_of_equation(const differential_relation& relation, root_annulus within) {
    const precision_scope scope(root_digits);
    return equation_roots(relation, within).all();
}

}  // namespace libration
