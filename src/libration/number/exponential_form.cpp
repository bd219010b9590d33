#include "exponential_form.hpp"

#include <utility>

#include "exact_fold.hpp"

namespace libration {

namespace {

constexpr std::size_t most_exponentials = 16;

}  // namespace

std::optional<exact_real::exponential_form> exact_real::exponential_form::of(const exact_real& x) {
    exponential_form sum;
    for (const term& each : x.terms_) {
        const auto value = of(*each.of);
        if (!value) {
            return std::nullopt;
        }
        sum.add(each.coefficient, *value);
    }
    return sum.terms_.size() > most_exponentials ? std::nullopt : std::optional(std::move(sum));
}

std::optional<rational> exact_real::exponential_form::lambertw() const {
    if (terms_.size() != 1) {
        return std::nullopt;
    }
    const auto& [r, q] = *terms_.begin();
    return q == r && r >= -1 ? std::optional(r) : std::nullopt;
}

std::optional<exact_real::exponential_form> exact_real::exponential_form::of(const atom& x) {
    switch (x.kind) {
        case atom_kind::one: return exponential(1, 0);
        case atom_kind::function: return of_function(x);
        case atom_kind::product:
        case atom_kind::quotient:
        case atom_kind::power: break;
        case atom_kind::pi:
        case atom_kind::degree:
        case atom_kind::period: return std::nullopt;
    }
    const auto left = of(x.left);
    if (!left) {
        return std::nullopt;
    }
    if (x.kind == atom_kind::power) {
        const auto exponent = x.right.fraction();
        return exponent ? left->raised(*exponent) : std::nullopt;
    }
    const auto right = of(x.right);
    const auto factor = right && x.kind == atom_kind::quotient ? right->raised(-1) : right;
    return factor ? product(*left, *factor) : std::nullopt;
}

std::optional<exact_real::exponential_form> exact_real::exponential_form::of_function(const atom& x) {
    if (x.f == function_kind::sqrt || x.f == function_kind::cbrt) {
        const auto argument = of(x.left);
        return argument ? argument->raised(rational(1, x.f == function_kind::sqrt ? 2 : 3)) : std::nullopt;
    }
    const auto r = x.left.fraction();
    if (!r) {
        return std::nullopt;
    }
    const rational half(1, 2);
    const bool is_sinh = x.f == function_kind::sinh;
    if (x.f == function_kind::exp) {
        return exponential(1, *r);
    }
    if (x.f == function_kind::expm1) {
        return difference(exponential(1, *r), exponential(1, 0));
    }
    return is_sinh || x.f == function_kind::cosh
               ? std::optional(difference(exponential(half, *r), exponential(is_sinh ? half : rational(-half), -*r)))
               : std::nullopt;
}

exact_real::exponential_form exact_real::exponential_form::exponential(const rational& q, const rational& r) {
    exponential_form result;
    result.terms_.emplace(r, q);
    return result;
}

// Of a single term; its root is that of a negative number only if the order is odd, as of cbrt.
std::optional<exact_real::exponential_form> exact_real::exponential_form::raised(const rational& exponent) const {
    if (terms_.size() != 1) {
        return std::nullopt;
    }
    const auto& [r, q] = *terms_.begin();
    const auto size = folded_power(abs(q), exponent);
    if (!size || (q < 0 && denominator(exponent) % 2 == 0)) {
        return std::nullopt;
    }
    const bool negative = q < 0 && numerator(exponent) % 2 != 0;
    return exponential(negative ? rational(-*size) : *size, within_limits(rational(r * exponent)));
}

void exact_real::exponential_form::add(const rational& factor, const exponential_form& more) {
    for (const auto& [r, q] : more.terms_) {
        rational& sum = terms_[r];
        sum = within_limits(rational(sum + factor * q));
        if (sum == 0) {
            terms_.erase(r);
        }
    }
}

exact_real::exponential_form exact_real::exponential_form::difference(exponential_form a, const exponential_form& b) {
    a.add(-1, b);
    return a;
}

std::optional<exact_real::exponential_form> exact_real::exponential_form::product(const exponential_form& a,
                                                                                  const exponential_form& b) {
    exponential_form result;
    for (const auto& [r, q] : a.terms_) {
        exponential_form shifted;
        for (const auto& [s, p] : b.terms_) {
            shifted.terms_.emplace(within_limits(rational(r + s)), within_limits(rational(q * p)));
        }
        result.add(1, shifted);
    }
    return result.terms_.size() > most_exponentials ? std::nullopt : std::optional(std::move(result));
}

}  // namespace libration
