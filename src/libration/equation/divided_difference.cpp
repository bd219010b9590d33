#include "divided_difference.hpp"

#include <algorithm>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_linear_terms = 32;
constexpr int most_linear_nodes = 500;
constexpr int largest_difference_power = 16;

// `left` nodes may be read, so that no expression is too deep.
bool add_terms(linear_sum& to, const expression& e, const number& factor, int& left) {
    if (--left < 0) {
        return false;
    }
    switch (e.kind()) {
        case node_kind::constant: to.constant = to.constant + factor * e.constant(); return true;
        case node_kind::sum: return add_terms(to, e.left(), factor, left) && add_terms(to, e.right(), factor, left);
        case node_kind::product:
            if (e.left().kind() == node_kind::constant && !e.left().is(0)) {
                return add_terms(to, e.right(), factor * e.left().constant(), left);
            }
            break;
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter:
        case node_kind::quotient:
        case node_kind::power:
        case node_kind::function: break;
    }
    const auto found = std::ranges::find_if(to.terms, [&](const auto& term) { return same_form(term.first, e); });
    if (found != to.terms.end()) {
        found->second = found->second + factor;
        if (!is_proved_zero(found->second)) {
            return true;
        }
        const bool leaf = operands_of(e)[0] == nullptr;  // others need not be defined where their multiples cancel
        to.terms.erase(found);
        return leaf;
    }
    to.terms.emplace_back(e, factor);
    return to.terms.size() <= most_linear_terms;
}

bool is_relative_function(const expression& e) {
    return e.function() == function_kind::exprel || e.function() == function_kind::cosrel ||
           e.function() == function_kind::sinc;
}

expression relative_sine(const expression& x) { return cosrel(rational(1), x); }
expression relative_hyperbolic_sine(const expression& x) { return exp(-x) * exprel(rational(1), 2 * x); }

// (f(a) - f(a0))/(a - a0) for f(a) = exp(rate a).
expression of_exponential(const expression& a, const number& a0, const number& rate) {
    return expression(rate * apply(function_kind::exp, rate * a0)) *
           exprel(rational(1), expression(rate) * (a - expression(a0)));
}

// The same for f(a) = log(a)/scale, where `log_of` is log(a), and a0 > 0.
expression of_logarithm(const expression& log_of, const number& a0, const number& scale) {
    const expression v = log_of - expression(apply(function_kind::log, a0));
    return expression(number(rational(1)) / (a0 * scale)) / exprel(rational(1), v);
}

// sum_{i<n} a^i a0^(n-1-i) = (a^n - a0^n)/(a - a0).
expression of_whole_power(const expression& a, const number& a0, int n) {
    if (is_proved_zero(a0)) {
        return pow(a, expression(n - 1));
    }
    expression sum;
    for (int i = 0; i < n; ++i) {
        sum = sum + expression(power(a0, number(rational(n - 1 - i)))) * pow(a, expression(i));
    }
    return sum;
}

number natural_logarithm(int n) { return apply(function_kind::log, number(rational(n))); }

// (f(a) - f(a0))/(a - a0) for a function f, as a formula that holds for every a0.
std::optional<expression> anywhere(const expression& e, const number& a0) {
    using enum function_kind;
    const expression& a = e.left();
    const expression h = a - expression(a0);
    const expression middle = (a + expression(a0)) / 2;
    const number one(rational(1));
    const auto is = [&](function_kind f) { return e.function() == f; };
    if (is(exp) || is(expm1)) {
        return of_exponential(a, a0, one);
    }
    if (is(exp2)) {
        return of_exponential(a, a0, natural_logarithm(2));
    }
    if (is(log)) {
        return of_logarithm(e, a0, one);
    }
    if (is(log1p)) {
        return of_logarithm(e, one + a0, one);
    }
    if (is(log2) || is(log10)) {
        return of_logarithm(ode::log(a), a0, natural_logarithm(is(log2) ? 2 : 10));
    }
    if (is(sin) || is(cos)) {
        return (is(sin) ? ode::cos(middle) : -ode::sin(middle)) * relative_sine(h / 2);
    }
    if (is(tan)) {
        return relative_sine(h) / (expression(apply(cos, a0)) * ode::cos(a));
    }
    if (is(sinh) || is(cosh)) {
        return (is(sinh) ? ode::cosh(middle) : ode::sinh(middle)) * relative_hyperbolic_sine(h / 2);
    }
    if (is(tanh)) {
        return relative_hyperbolic_sine(h) / (expression(apply(cosh, a0)) * ode::cosh(a));
    }
    if (is(lambertw)) {  // a = w exp(w), a0 = w0 exp(w0)
        const number w0 = apply(lambertw, a0);
        const expression v = e - expression(w0);
        return expression(apply(exp, -w0)) / (ode::exp(v) + expression(w0) * ode::exprel(rational(1), v));
    }
    return std::nullopt;
}

// The same for a0 = 0.
std::optional<expression> about_zero(const expression& e) {
    using enum function_kind;
    const expression& a = e.left();
    const auto is = [&](function_kind f) { return e.function() == f; };
    if (is(sin)) {
        return relative_sine(a);
    }
    if (is(cos)) {
        return expression(rational(-1, 2)) * a * ode::cosrel(rational(2), a);
    }
    if (is(sinh)) {
        return relative_hyperbolic_sine(a);
    }
    if (is(atan)) {
        return ode::cos(e) / relative_sine(e);
    }
    if (is(asin)) {
        return 1 / relative_sine(e);
    }
    if (is(acos)) {  // pi/2 - asin
        return -1 / relative_sine(ode::asin(a));
    }
    if (is(asinh)) {
        return 1 / relative_hyperbolic_sine(e);
    }
    if (is(atanh)) {
        return ode::cosh(e) / relative_hyperbolic_sine(e);
    }
    if (is(exprel)) {
        const rational n = e.order();
        return expression(rational(1 / (n + 1))) * ode::exprel(rational(n + 1), a);
    }
    if (is(sinc) || is(cosrel)) {
        const rational n = is(sinc) ? rational(1) : e.order();
        return expression(rational(-1 / ((n + 1) * (n + 2)))) * a * ode::cosrel(rational(n + 2), a);
    }
    return is(sqrt) || is(cbrt) ? std::nullopt : anywhere(e, number());
}

// Roots only where they are analytic.
std::optional<expression> of_argument(const expression& e, const number& a0) {
    if (is_proved_zero(a0)) {
        return about_zero(e);
    }
    if (e.function() == function_kind::sqrt) {
        return 1 / (e + expression(apply(function_kind::sqrt, a0)));
    }
    if (e.function() == function_kind::cbrt) {
        const number c = apply(function_kind::cbrt, a0);
        return 1 / (e * e + expression(c) * e + expression(c * c));
    }
    return anywhere(e, a0);
}

}  // namespace

bool is_proved_zero(const number& x) {
    try {
        return x.sign() == 0;
    } catch (const error&) {
        return false;
    }
}

std::optional<linear_sum> linear_sum_of(const expression& e) {
    linear_sum result;
    int left = most_linear_nodes;
    return add_terms(result, e, number(rational(1)), left) ? std::optional(std::move(result)) : std::nullopt;
}

function_of_one::function_of_one(linear_sum u) : u_(std::move(u)) {}

bool function_of_one::spent() { return --budget_ < 0; }

std::optional<std::pair<number, number>> function_of_one::affine(const expression& e) {
    if (e.kind() == node_kind::constant) {
        return std::pair(number(), e.constant());
    }
    const auto form = linear_sum_of(e);
    if (!form || form->terms.size() != u_.terms.size()) {
        return std::nullopt;
    }
    std::optional<number> factor;
    for (const auto& [term, by] : form->terms) {
        const auto found =
            std::ranges::find_if(u_.terms, [&, &each = term](const auto& own) { return same_form(own.first, each); });
        if (found == u_.terms.end()) {
            return std::nullopt;
        }
        const number ratio = by / found->second;
        if (factor && !is_proved_zero(ratio - *factor)) {
            return std::nullopt;
        }
        factor = factor.value_or(ratio);
    }
    return factor ? std::optional(std::pair(*factor, form->constant)) : std::nullopt;
}

bool function_of_one::holds(const expression& e) {
    if (affine(e)) {
        return true;
    }
    const operand_pair below = operands_of(e);
    return !spent() && below[0] != nullptr && holds(*below[0]) && (below[1] == nullptr || holds(*below[1]));
}

std::optional<number> function_of_one::value(const expression& e, const number& u0) {
    if (const auto form = affine(e)) {
        return form->first * u0 + form->second;
    }
    const operand_pair below = operands_of(e);
    if (below[0] == nullptr || spent()) {
        return std::nullopt;
    }
    const auto a = value(*below[0], u0);
    const auto b = below[1] == nullptr || !a ? std::nullopt : value(*below[1], u0);
    if (!a || (below[1] != nullptr && !b)) {
        return std::nullopt;
    }
    switch (e.kind()) {
        case node_kind::sum: return *a + *b;
        case node_kind::product: return *a * *b;
        case node_kind::quotient: return *a / *b;
        case node_kind::power: return power(*a, *b);
        case node_kind::function:
            if (is_relative_function(e) && !is_proved_zero(*a)) {
                return std::nullopt;  // whose zeros, as pi of sinc, no precision decides
            }
            return e.has_order() ? apply(e.function(), e.order(), *a) : apply(e.function(), *a);
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    return std::nullopt;
}

std::optional<expression> function_of_one::difference(const expression& e, const number& u0) {
    if (const auto form = affine(e)) {
        return expression(form->first);
    }
    if (spent()) {
        return std::nullopt;
    }
    if (e.is_unfolded_zero()) {
        return value(e, u0) ? std::optional(e) : std::nullopt;  // 0 where it has a value, and so its difference
    }
    switch (e.kind()) {
        case node_kind::sum: {
            const auto a = difference(e.left(), u0);
            const auto b = a ? difference(e.right(), u0) : std::nullopt;
            return b ? std::optional(written_sum(*a, *b)) : std::nullopt;
        }
        case node_kind::product: return of_product(e, u0);
        case node_kind::quotient: return of_quotient(e, u0);
        case node_kind::power: return of_power(e, u0);
        case node_kind::function: return of_function(e, u0);
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    return std::nullopt;
}

// The factor that is 0 is divided alone, so that the other one may be any function; of two, the first one for which that is
// possible, as sqrt(h) is not divided by h.
std::optional<expression> function_of_one::of_product(const expression& e, const number& u0) {
    const auto a0 = value(e.left(), u0);
    const auto b0 = value(e.right(), u0);
    if (!a0 || !b0) {
        return std::nullopt;
    }
    const auto a = is_proved_zero(*b0) && !is_proved_zero(*a0) ? std::nullopt : difference(e.left(), u0);
    if (is_proved_zero(*b0) && !a) {
        const auto b = difference(e.right(), u0);
        return b ? std::optional(written_product(e.left(), *b)) : std::nullopt;
    }
    if (!a || is_proved_zero(*a0)) {
        return a ? std::optional(written_product(*a, e.right())) : std::nullopt;
    }
    const auto b = difference(e.right(), u0);
    return b ? std::optional(written_sum(written_product(*a, e.right()), written_product(expression(*a0), *b)))
             : std::nullopt;
}

std::optional<expression> function_of_one::of_quotient(const expression& e, const number& u0) {
    const auto a0 = value(e.left(), u0);
    const auto b0 = value(e.right(), u0);
    if (!a0 || !b0 || is_proved_zero(*b0)) {
        return std::nullopt;
    }
    const auto a = difference(e.left(), u0);
    const auto b = a ? difference(e.right(), u0) : std::nullopt;
    return b ? std::optional(
                   written_quotient(written_sum(*a, written_product(expression(-(*a0 / *b0)), *b)), e.right()))
             : std::nullopt;
}

// a^(p/q) = c^p with c = a^(1/q), a = c^q.
std::optional<expression> function_of_one::of_power(const expression& e, const number& u0) {
    const auto r = e.right().fraction();
    const auto a0 = value(e.left(), u0);
    if (!r || !a0 || abs(numerator(*r)) > largest_difference_power || denominator(*r) > largest_difference_power) {
        return std::nullopt;
    }
    const int p = abs(numerator(*r)).convert_to<int>();
    const int q = denominator(*r).convert_to<int>();
    const bool at_zero = is_proved_zero(*a0);
    const auto inner = difference(e.left(), u0);
    if (!inner || (at_zero && (q > 1 || *r < 0)) || (q > 1 && a0->sign() <= 0)) {
        return std::nullopt;
    }
    const expression& a = e.left();
    const expression c = q == 1 ? a : pow(a, expression(rational(1, q)));
    const number c0 = q == 1 ? *a0 : power(*a0, number(rational(1, q)));
    expression by_a = of_whole_power(c, c0, p);
    if (q > 1) {
        by_a = by_a / of_whole_power(c, c0, q);
    }
    if (*r < 0) {
        by_a = by_a * expression(-(number(rational(1)) / power(c0, number(rational(p))))) * e;
    }
    return written_product(by_a, *inner);
}

std::optional<expression> function_of_one::of_function(const expression& e, const number& u0) {
    const auto a0 = value(e.left(), u0);
    const auto inner = a0 ? difference(e.left(), u0) : std::nullopt;
    const auto outer = inner ? of_argument(e, *a0) : std::nullopt;
    return outer ? std::optional(written_product(*outer, *inner)) : std::nullopt;
}

}  // namespace libration::ode
