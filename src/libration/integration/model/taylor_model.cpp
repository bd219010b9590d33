#include "taylor_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace libration::ode {

namespace {

constexpr int lowest_degree = 2;
constexpr int highest_degree = 16;

// The unit roundoff of double is 2^-53. One bit more covers 1/(1 - n 2^-53) for sums of n < 2^52 terms.
constexpr long log2_of_rounding = -52;
// Every product that is not normal is in error by at most 2^-1075.
constexpr long log2_of_underflow = -1074;

magnitude infinity() { return magnitude(1U) / magnitude(); }

ball exact(double x) {
    ball result;
    arf_set_d(arb_midref(result.handle()), x);
    return result;
}

// A double near the midpoint, and a bound of its distance from all numbers of the ball.
std::pair<double, magnitude> nearest(const ball& x) {
    const double near = arf_get_d(arb_midref(x.handle()), ARF_RND_NEAR);
    if (!std::isfinite(near)) {
        return {0, infinity()};
    }
    ball distance;
    arb_sub(distance.handle(), x.handle(), exact(near).handle(), ARF_PREC_EXACT);
    return {near, magnitude(distance)};
}

// An upper bound of a sum of numbers >= 0 that was computed in double with at most 2^20 additions.
magnitude above(double sum) {
    constexpr unsigned long one_and_more = (1UL << 29) + 1;
    return std::isfinite(sum) ? magnitude::at_least(sum, 0) * magnitude::of(one_and_more, -29) : infinity();
}

// All exponents of a degree in the variables from `from` on.
void append_exponents(std::vector<std::vector<std::uint8_t>>& all, std::vector<std::uint8_t>& chosen, std::size_t from,
                      int degree) {
    if (from + 1 >= chosen.size()) {
        if (from < chosen.size()) {
            chosen[from] = static_cast<std::uint8_t>(degree);
        }
        all.push_back(chosen);
        return;
    }
    for (int here = degree; here >= 0; --here) {
        chosen[from] = static_cast<std::uint8_t>(here);
        append_exponents(all, chosen, from + 1, degree - here);
    }
}

// The number of monomials of at most a degree, which for twice the variables is that of the products of a set; capped.
double number_of_monomials(std::size_t variables, int degree) {
    double number = 1;
    for (int d = 1; d <= degree; ++d) {
        number *= static_cast<double>(variables + static_cast<std::size_t>(d)) / d;
    }
    return number;
}

}  // namespace

monomial_set::monomial_set(std::size_t variables, int degree) : variables_(variables) {
    for (int d = 0; d <= degree; ++d) {
        std::vector<std::uint8_t> chosen(variables, 0);
        append_exponents(exponents_, chosen, 0, d);
        ends_.push_back(exponents_.size());
        degrees_.resize(exponents_.size(), d);
    }
    std::map<std::vector<std::uint8_t>, std::uint32_t> index;
    for (const auto& each : exponents_) {
        index.emplace(each, static_cast<std::uint32_t>(index.size()));
        even_.push_back(std::ranges::all_of(each, [](std::uint8_t e) { return e % 2 == 0; }));
    }
    by_variable_.resize(variables);
    for (std::size_t j = 0; j < variables; ++j) {
        std::ranges::transform(exponents_, std::back_inserter(by_variable_[j]),
                               [j](const auto& each) { return each[j]; });
    }
    std::vector<std::uint8_t> sum(variables);
    for (std::size_t i = 0; i < size(); ++i) {
        first_products_.push_back(products_.size());
        for (std::size_t j = 0; j < size_to(degree - degree_of(i)); ++j) {
            std::ranges::transform(exponents_[i], exponents_[j], sum.begin(), std::plus<>());
            products_.push_back(index.at(sum));
        }
    }
}

monomial_set monomial_set::of_cost(std::size_t variables, std::size_t most_products) {
    int degree = lowest_degree;
    while (degree < highest_degree &&
           number_of_monomials(2 * variables, degree + 1) <= static_cast<double>(most_products)) {
        ++degree;
    }
    return {variables, degree};
}

taylor_model::taylor_model(const monomial_set& in, const ball& constant) : taylor_model(in, constant, {}) {}

taylor_model::taylor_model(const monomial_set& in, const ball& constant, std::span<const ball> linear) : in_(&in) {
    const auto append = [this](const ball& x) {
        const auto [near, distance] = nearest(x);
        coefficients_.push_back(near);
        rest_ += distance;
    };
    append(constant);
    for (const ball& each : linear) {
        append(each);
    }
    measure();
}

// Drops the last degrees with coefficients 0 alone, and sums the others.
void taylor_model::measure() {
    norms_.clear();
    std::size_t kept = 0;
    std::size_t begin = 0;
    for (int d = 0; begin < coefficients_.size(); ++d) {
        const std::size_t end = in_->size_to(d);
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += std::abs(coefficients_[i]);
        }
        norms_.push_back(above(sum));
        kept = sum == 0 ? kept : end;
        begin = end;
    }
    coefficients_.resize(kept);
    while (!norms_.empty() && norms_.back().is_zero()) {
        norms_.pop_back();
    }
}

// For so many roundings of each coefficient, in sums of terms whose absolute values have the sum `of`.
void taylor_model::add_rounding(const magnitude& of, std::size_t roundings) {
    if (!of.is_zero()) {
        rest_.add_product(of, magnitude::of(roundings, log2_of_rounding));
        rest_ += magnitude::of(roundings, 0) * magnitude::of(in_->size(), log2_of_underflow);
    }
}

magnitude taylor_model::norm(int degree) const {
    const auto d = static_cast<std::size_t>(degree);
    return d < norms_.size() ? norms_[d] : magnitude();
}

magnitude taylor_model::norm_from(std::size_t degree) const {
    magnitude sum;
    for (std::size_t d = degree; d < norms_.size(); ++d) {
        sum += norms_[d];
    }
    return sum;
}

magnitude taylor_model::nonlinear_share(std::size_t variable) const {
    const auto& exponents = in_->exponents_of(variable);
    double sum = 0;
    for (std::size_t i = in_->size_to(1); i < coefficients_.size(); ++i) {
        sum += std::abs(coefficients_[i]) * exponents[i];
    }
    return above(sum);
}

// A square is 1/2 +- 1/2, any other monomial 0 +- 1.
ball taylor_model::range() const {
    double middle = coefficient(0);
    double spread = 0;
    for (std::size_t i = 1; i < coefficients_.size(); ++i) {
        const bool even = in_->is_even(i);
        middle += even ? coefficients_[i] / 2 : 0;
        spread += std::abs(coefficients_[i]) / (even ? 2 : 1);
    }
    if (!std::isfinite(middle)) {
        return widened(ball(0), infinity());
    }
    taylor_model rounding(*in_);
    rounding.add_rounding(norm(), coefficients_.size());
    return widened(exact(middle), above(spread) + rounding.rest_ + rest_);
}

// c a^e = c 2^-e (b +- 1)^e, by synthetic division in the powers of the variable: every coefficient is a sum of terms of
// which none has been rounded more often than once in each of the passes, and the absolute values of all of them have
// the sum of the |c_i|. An underflow of c 2^-e, of at most 2^-1075, is multiplied by the sum 2^e of the |coefficients| of
// (b +- 1)^e; sums have none.
taylor_model taylor_model::on_half(std::size_t variable, bool upper) const {
    taylor_model result = *this;
    auto& c = result.coefficients_;
    const auto& exponents = in_->exponents_of(variable);
    std::vector<double> halves(static_cast<std::size_t>(in_->degree()) + 1, 1);  // powers of 1/2
    for (std::size_t e = 1; e < halves.size(); ++e) {
        halves[e] = halves[e - 1] / 2;
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
        c[i] *= halves[exponents[i]];
    }
    const std::uint32_t* const raised = in_->products_of(1 + variable);
    const double shift = upper ? 1 : -1;
    const std::size_t below = norms_.size() < 2 ? 0 : in_->size_to(static_cast<int>(norms_.size()) - 2);
    for (std::size_t pass = 0; pass + 1 < norms_.size(); ++pass) {
        for (std::size_t i = below; i-- > 0;) {
            if (exponents[i] >= pass) {
                c[i] += shift * c[raised[i]];
            }
        }
    }
    result.measure();
    result.add_rounding(norm(), norms_.size() + 1);
    if (!norms_.empty()) {
        const long degree = static_cast<long>(norms_.size()) - 1;
        result.rest_ += magnitude::of(in_->size(), log2_of_underflow + degree);
    }
    return result;
}

taylor_model taylor_model::truncated(const monomial_set& to) const {
    taylor_model result(to);
    const std::size_t kept = std::min(coefficients_.size(), to.size());
    result.coefficients_.assign(coefficients_.begin(), coefficients_.begin() + static_cast<std::ptrdiff_t>(kept));
    result.rest_ = rest_;
    for (int d = to.degree() + 1; static_cast<std::size_t>(d) < norms_.size(); ++d) {
        result.rest_ += norm(d);
    }
    result.measure();
    return result;
}

taylor_model taylor_model::combined(const taylor_model& a, const taylor_model& b, int sign) {
    taylor_model result(*a.in_);
    result.coefficients_ = a.coefficients_;
    result.coefficients_.resize(std::max(a.coefficients_.size(), b.coefficients_.size()), 0);
    for (std::size_t i = 0; i < b.coefficients_.size(); ++i) {
        result.coefficients_[i] += sign * b.coefficients_[i];
    }
    result.rest_ = a.rest_ + b.rest_;
    result.measure();
    if (!a.norms_.empty() && !b.norms_.empty()) {
        result.add_rounding(result.norm(), 1);
    }
    return result;
}

taylor_model operator*(const ball& factor, const taylor_model& x) {
    const auto [near, distance] = nearest(factor);
    taylor_model result(*x.in_);
    for (const double each : x.coefficients_) {
        result.coefficients_.push_back(near * each);
    }
    result.measure();
    result.rest_ = magnitude(exact(near)) * x.rest_;
    result.rest_.add_product(distance, x.size());
    if (near != 0) {
        result.add_rounding(x.norm() * magnitude(exact(near)), 1);
    }
    return result;
}

taylor_model linear_combination(const std::vector<ball>& factors, const std::vector<taylor_model>& x) {
    taylor_model result(*x.front().in_);
    magnitude norms;
    for (std::size_t j = 0; j < x.size(); ++j) {
        const auto [near, distance] = nearest(factors[j]);
        const magnitude size(exact(near));
        result.coefficients_.resize(std::max(result.coefficients_.size(), x[j].coefficients_.size()), 0);
        for (std::size_t i = 0; i < x[j].coefficients_.size(); ++i) {
            result.coefficients_[i] += near * x[j].coefficients_[i];
        }
        norms.add_product(size, x[j].norm());
        result.rest_.add_product(size, x[j].rest_);
        result.rest_.add_product(distance, x[j].size());
    }
    result.measure();
    result.add_rounding(norms, x.size() + 1);
    return result;
}

taylor_model product_coefficient(const std::vector<taylor_model>& a, const std::vector<taylor_model>& b,
                                 std::size_t n) {
    const monomial_set& in = *a.front().in_;
    const int degree = in.degree();
    taylor_model result(in);
    result.coefficients_.assign(in.size(), 0);
    magnitude norms;
    std::size_t roundings = 1;
    for (std::size_t l = 0; l <= n; ++l) {
        const taylor_model& left = a[l];
        const taylor_model& right = b[n - l];
        result.rest_.add_product(left.rest_, right.size());
        result.rest_.add_product(left.norm(), right.rest_);
        if (left.norms_.empty() || right.norms_.empty()) {
            continue;
        }
        norms.add_product(left.norm(), right.norm());
        roundings += left.coefficients_.size();
        for (std::size_t i = 0; i < left.coefficients_.size(); ++i) {
            if (const double factor = left.coefficients_[i]; factor != 0) {
                const std::uint32_t* const at = in.products_of(i);
                const std::size_t last = std::min(right.coefficients_.size(), in.size_to(degree - in.degree_of(i)));
                for (std::size_t j = 0; j < last; ++j) {
                    result.coefficients_[at[j]] += factor * right.coefficients_[j];
                }
            }
        }
        for (std::size_t d = 0; d < left.norms_.size(); ++d) {
            for (std::size_t e = static_cast<std::size_t>(degree) - d + 1; e < right.norms_.size(); ++e) {
                result.rest_.add_product(left.norms_[d], right.norms_[e]);
            }
        }
    }
    result.measure();
    result.add_rounding(norms, roundings);
    return result;
}

}  // namespace libration::ode
