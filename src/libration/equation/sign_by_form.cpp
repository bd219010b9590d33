#include "sign_by_form.hpp"

#include "divided_difference.hpp"

namespace libration::ode {

namespace {

constexpr int deepest_sign = 64;

// Wherever e is defined: sign e > 0 if it is strict, else sign e >= 0; no statement for the sign 0.
struct known_range {
    int sign = 0;
    bool strict = false;
};

known_range range_of(const expression& e, int depth);

bool is_within_one(const expression& e) {
    using enum function_kind;
    return e.kind() == node_kind::function &&
           (e.function() == sin || e.function() == cos || e.function() == tanh || e.function() == erf);
}

// Terms of absolute value at most 1 are taken from the constant.
known_range of_sum(const expression& e, int depth) {
    const auto sum = linear_sum_of(e);
    if (!sum) {
        return {};
    }
    number bounded;
    int sign = 0;
    bool strict = false;
    const auto add = [&](const known_range& term) {
        const bool fits = term.sign != 0 && (sign == 0 || sign == term.sign);
        sign = fits ? term.sign : 0;
        strict = strict || term.strict;
        return fits;
    };
    bool constant_is_bound = false;
    for (const auto& [term, by] : sum->terms) {
        if (is_within_one(term)) {
            bounded = bounded + (by.sign() < 0 ? -by : by);
            constant_is_bound = true;
            continue;
        }
        known_range of = range_of(term, depth);
        of.sign *= by.sign();
        if (!add(of)) {
            return {};
        }
    }
    const int of_constant = sum->constant.sign();
    if (constant_is_bound) {
        const number rest = of_constant < 0 ? -sum->constant - bounded : sum->constant - bounded;
        const int left = rest.sign();
        return left >= 0 && of_constant != 0 && add({of_constant, left > 0}) ? known_range{sign, strict}
                                                                             : known_range{};
    }
    return of_constant == 0 || add({of_constant, true}) ? known_range{sign, strict} : known_range{};
}

known_range of_power(const expression& e, int depth) {
    const auto r = e.right().fraction();
    if (!r) {
        return {};
    }
    const known_range base = range_of(e.left(), depth);
    const bool even = denominator(*r) == 1 && numerator(*r) % 2 == 0;
    if (base.sign > 0 || (even && base.sign != 0)) {
        return {1, base.strict || *r < 0};
    }
    if (even) {
        return {1, *r < 0};
    }
    return denominator(*r) == 1 ? base : known_range{};
}

known_range range_of(const expression& e, int depth) {
    using enum function_kind;
    if (depth > deepest_sign) {
        return {};
    }
    switch (e.kind()) {
        case node_kind::constant: return {e.constant().sign(), true};
        case node_kind::sum: return of_sum(e, depth + 1);
        case node_kind::product:
        case node_kind::quotient: {
            const known_range a = range_of(e.left(), depth + 1);
            const known_range b = range_of(e.right(), depth + 1);
            return {a.sign * b.sign, a.strict && (b.strict || e.kind() == node_kind::quotient)};
        }
        case node_kind::power: return of_power(e, depth + 1);
        case node_kind::function: {
            if (e.function() == exp || e.function() == exp2 || e.function() == cosh) {
                return {1, true};
            }
            return e.function() == sqrt ? known_range{1, range_of(e.left(), depth + 1).strict} : known_range{};
        }
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    return {};
}

}  // namespace

int sign_by_form(const expression& e) {
    const known_range range = range_of(e, 0);
    return range.strict ? range.sign : 0;
}

}  // namespace libration::ode
