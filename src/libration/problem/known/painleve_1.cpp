#include "libration/problem/known/painleve_1.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

// Of the integration, in addition to those of the result.
constexpr long tritronquee_guard_bits = 40;
// The smallest term is about exp(-1.77 X^(5/4)).
constexpr double smallest_term_rate = 1.77;
constexpr double farther_out = 1.1;
constexpr int least_start = 6;
constexpr int most_terms = 1'000'000;

// (25 k^2 - 1)/4
ball factor_of_slope(int k) { return ball(25 * k * k - 1) / 4; }

// The expansion in eta at X, and its truncation error.
class tritronquee_expansion {
public:
    tritronquee_expansion(int start, int most, long bits)
        : x_(start), eta_(ball(1) / (sqrt(ball(6)) * x_ * x_ * sqrt(x_))) {
        const ball small = ldexp(ball(1), -bits);
        b_.emplace_back(1);
        ball power(1);
        ball last(1);
        while (order() < most) {
            const ball next = next_coefficient();
            power *= eta_;
            const ball term = abs(next * power);
            if (b_.size() > 2 && !certainly_less(term, last)) {
                return;
            }
            b_.push_back(next);
            last = term;
            if (certainly_less(term, small)) {
                return;
            }
        }
    }

    // w and w' at X, by the lemma.
    value_and_slope at_start() const {
        ball sum(0), slope(0), rest(0), turned(0);
        ball power(1);
        for (std::size_t i = 0; i < b_.size(); ++i, power *= eta_) {
            const int k = static_cast<int>(i);
            const ball term = b_[i] * power;
            sum += term;
            slope += term * (1 - 5 * k) / 2;
            if (k > 0) {
                rest += abs(term);
                turned += abs(term) * k;
            }
        }
        const ball least = ball(1) - rest;
        if (!certainly_less(ball(0), least)) {
            throw precision_exhausted("the expansion of the tritronquee solution");
        }
        const ball four_roots = sqrt(ball(6)) * 2;  // q = 2 sqrt(6 x) sum b_k eta^k
        const ball kappa = ball(1) / 8 + turned / least * 5 / 8;
        const ball a = ball(1) / fourth_root(four_roots * least);
        const int first = 5 * order() + 5;  // s = first/2 - 15/8
        const ball s = ball(first) / 2 - ball(15) / 8;
        const ball eighth = sqrt(fourth_root(x_));
        const ball defect = defect_at_start() * a / eighth * x_;  // C A X^(-s)
        const ball h = defect * 2 / (s - kappa);
        const ball steep = a * a * a * x_ / (eighth * eighth * eighth) * 6;
        if (!certainly_less(ball(5) / 8, s) || !certainly_less(ball(kappa * h + steep * h * h + defect), ball(s * h))) {
            throw precision_exhausted("the lemma of the tritronquee solution");
        }
        const ball away = h * a / eighth;
        const ball away_of_slope = h * fourth_root(four_roots * (ball(1) + rest)) * eighth;
        return {widened(-sqrt(x_ / 6) * sum, magnitude(away)),
                widened(-slope / sqrt(x_ * 6), magnitude(away_of_slope))};
    }

private:
    static ball fourth_root(const ball& x) { return sqrt(sqrt(x)); }

    int order() const { return static_cast<int>(b_.size()) - 1; }

    // Of (sum b eta^k)^2, beyond N.
    ball product_of_order(std::size_t m) const {
        ball sum(0);
        for (std::size_t i = m - b_.size() + 1; i < b_.size(); ++i) {
            sum += b_[i] * b_[m - i];
        }
        return sum;
    }

    ball next_coefficient() const {
        const std::size_t m = b_.size();
        ball sum = factor_of_slope(order()) * b_.back();
        for (std::size_t i = 1; i < m; ++i) {
            sum += b_[i] * b_[m - i];
        }
        return -sum / 2;
    }

    // C X^(1 - 5(N+1)/2): x times the powers of eta beyond N in (sum b eta^k)^2 + sum (25 k^2 - 1)/4 b_k eta^(k+1), by
    // absolute values, since eta decreases.
    ball defect_at_start() const {
        ball sum(0);
        ball power = pow(eta_, order() + 1);
        const std::size_t count = b_.size();
        for (std::size_t m = count; m < 2 * count - 1; ++m, power *= eta_) {
            const ball own = m == count ? factor_of_slope(order()) * b_.back() : ball(0);
            sum += abs(product_of_order(m) + own) * power;
        }
        return sum * x_;
    }

    ball x_, eta_;
    std::vector<ball> b_;
};

}  // namespace

value_and_slope tritronquee_far_out(int x, int most) {
    return tritronquee_expansion(x, most, ball::working_bits()).at_start();
}

value_and_slope tritronquee_start() {
    const auto bits = static_cast<long>(ball::working_bits());
    const long more = bits + tritronquee_guard_bits;
    const double far = std::pow(static_cast<double>(more) * std::log(2.0) / smallest_term_rate, 0.8) * farther_out;
    const int start = least_start + static_cast<int>(far);
    const precision_scope scope(decimal_digits(more));
    const value_and_slope from = tritronquee_far_out(start, most_terms);
    const std::string x = std::to_string(start);
    const explicit_system system(parse("variable x; w'' = 6*w^2 - x; w(" + x + ") = 0; w'(" + x + ") = 0"));
    proved_march march(system, {from.value, from.slope}, more);
    const auto state = march.at(ball(0));
    if (!state) {
        throw precision_exhausted("the integration of the tritronquee solution to 0");
    }
    return {(*state)[0], -(*state)[1]};
}

}  // namespace libration::ode

namespace libration {

known_facts facts_of_painleve_1() {
    static constexpr const char* without_oscillations = "-sqrt(-z/6)";
    return {.problem = "painleve_1",
            .condition =
                condition_at_infinity{.unknowns = {"u(0)", "u'(0)"},
                                      .of = "u(-inf)",
                                      .limits = without_oscillations,
                                      .holds = [](const std::string& limit) { return limit == without_oscillations; },
                                      .values =
                                          [](const ode::equation_system&, const std::string&, long digits) {
                                              return proved_decimals(digits, [] {
                                                  const auto start = ode::tritronquee_start();
                                                  return std::vector{start.value, start.slope};
                                              });
                                          }}};
}

}  // namespace libration
