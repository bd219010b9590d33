#include "libration/number/exact_real.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>
#include <utility>

#include "exact_fold.hpp"
#include "exact_real_atom.hpp"
#include "exponential_form.hpp"
#include "libration/function/list.hpp"

namespace libration {

namespace {

constexpr long deepest_expression = 200;
constexpr std::size_t most_terms = 10'000;

std::size_t mixed(std::size_t seed, std::size_t more) {
    return seed ^ (more + 0x9e3779b97f4a7c15ULL + (seed << 6U) + (seed >> 2U));
}

atom_kind kind_of(unit u) {
    switch (u) {
        case unit::pi: return atom_kind::pi;
        case unit::degree: return atom_kind::degree;
        case unit::period: return atom_kind::period;
        case unit::one:
        case unit::expression: break;
    }
    return atom_kind::one;
}

std::optional<unit> unit_of(atom_kind kind) {
    switch (kind) {
        case atom_kind::one: return unit::one;
        case atom_kind::pi: return unit::pi;
        case atom_kind::degree: return unit::degree;
        case atom_kind::period: return unit::period;
        case atom_kind::product:
        case atom_kind::quotient:
        case atom_kind::power:
        case atom_kind::function: break;
    }
    return std::nullopt;
}

void require_no_period(const exact_real& x) {
    if (x.periods() != 0) {
        refuse_number("has T in a product, a power or a function: only multiples of T are supported");
    }
}

}  // namespace

exact_real::exact_real(const rational& coefficient, unit measure) {
    if (coefficient != 0) {
        atom of;
        of.kind = kind_of(measure);
        of.hash = static_cast<std::size_t>(of.kind);
        terms_.push_back({coefficient, std::make_shared<const atom>(std::move(of))});
    }
}

std::optional<plain_number> exact_real::plain() const {
    if (terms_.empty()) {
        return plain_number{0, unit::one};
    }
    const term* const only = only_term();
    const auto measure = only != nullptr ? unit_of(only->of->kind) : std::nullopt;
    return measure ? std::optional(plain_number{only->coefficient, *measure}) : std::nullopt;
}

std::optional<rational> exact_real::fraction() const {
    const auto number = plain();
    return number && number->measure == unit::one ? std::optional(number->coefficient) : std::nullopt;
}

rational exact_real::periods() const {
    for (const term& each : terms_) {
        if (each.of->kind == atom_kind::period) {
            return each.coefficient;
        }
    }
    return 0;
}

exact_real exact_real::without_periods() const {
    exact_real result = *this;
    std::erase_if(result.terms_, [](const term& each) { return each.of->kind == atom_kind::period; });
    return result;
}

long exact_real::depth() const {
    long deepest_term = 0;
    for (const term& each : terms_) {
        deepest_term = std::max(deepest_term, each.of->depth);
    }
    return deepest_term;
}

long exact_real::functions() const {
    long all = 0;
    std::unordered_set<const atom*> seen;
    std::vector<const exact_real*> open{this};
    while (!open.empty()) {
        const exact_real& next = *open.back();
        open.pop_back();
        for (const term& each : next.terms_) {
            if (each.of->is_composed() && seen.insert(each.of.get()).second) {
                all += each.of->kind == atom_kind::function || each.of->kind == atom_kind::power ? 1 : 0;
                open.insert(open.end(), {&each.of->left, &each.of->right});
            }
        }
    }
    return all;
}

// Pairs of atoms already found equal are not compared again: shared parts would take exponential time.
class exact_real::comparison {
public:
    bool same(const exact_real& a, const exact_real& b) {
        return a.terms_.size() == b.terms_.size() && std::ranges::all_of(a.terms_, [&](const term& x) {
                   return std::ranges::any_of(
                       b.terms_, [&](const term& y) { return x.coefficient == y.coefficient && same(*x.of, *y.of); });
               });
    }

    bool same(const atom& a, const atom& b) {
        if (&a == &b) {
            return true;
        }
        if (a.hash != b.hash || a.kind != b.kind || a.f != b.f) {
            return false;
        }
        if (!a.is_composed() || same_.contains({&a, &b})) {
            return true;
        }
        const bool found = same(a.left, b.left) && same(a.right, b.right);
        if (found) {
            same_.emplace(&a, &b);
        }
        return found;
    }

private:
    std::set<std::pair<const atom*, const atom*>> same_;
};

bool same_form(const exact_real& a, const exact_real& b) { return exact_real::comparison().same(a, b); }

bool exact_real::same_atom(const atom& a, const atom& b) { return comparison().same(a, b); }

// Independent of the order of the terms.
std::size_t exact_real::hash() const {
    std::size_t of_terms = 0;
    for (const term& each : terms_) {
        of_terms += mixed(each.of->hash, std::hash<rational>()(each.coefficient));
    }
    return of_terms;
}

void exact_real::add(const rational& coefficient, const std::shared_ptr<const atom>& of) {
    const auto found = std::ranges::find_if(terms_, [&](const term& each) { return same_atom(*each.of, *of); });
    if (found == terms_.end()) {
        if (terms_.size() == most_terms) {
            refuse_number("has more than " + std::to_string(most_terms) + " different terms");
        }
        terms_.push_back({coefficient, of});
        return;
    }
    found->coefficient = within_limits(rational(found->coefficient + coefficient));
    if (found->coefficient == 0) {
        terms_.erase(found);
    }
}

// Degrees remain degrees only if no other unit occurs.
void exact_real::degrees_to_pi() {
    const auto found =
        std::ranges::find_if(terms_, [](const term& each) { return each.of->kind == atom_kind::degree; });
    if (found == terms_.end() || terms_.size() == 1) {
        return;
    }
    const exact_real in_pi(rational(found->coefficient / 180), unit::pi);
    terms_.erase(found);
    add(in_pi.terms_.front().coefficient, in_pi.terms_.front().of);
}

exact_real exact_real::operator-() const {
    exact_real result = *this;
    for (term& each : result.terms_) {
        each.coefficient = -each.coefficient;
    }
    return result;
}

exact_real operator+(const exact_real& a, const exact_real& b) {
    exact_real sum = a;
    for (const auto& each : b.terms_) {
        sum.add(each.coefficient, each.of);
    }
    sum.degrees_to_pi();
    return sum;
}

// A separate node, which can be evaluated within the limits of the cost, or is rejected.
exact_real exact_real::of_atom(atom a) {
    require_no_period(a.left);
    require_no_period(a.right);
    a.depth = 1 + std::max(a.left.depth(), a.right.depth());
    if (a.depth > deepest_expression) {
        refuse_number("nests more than " + std::to_string(deepest_expression) + " products, powers and functions");
    }
    a.hash = mixed(static_cast<std::size_t>(a.kind), static_cast<std::size_t>(a.f));
    a.hash = mixed(mixed(a.hash, a.left.hash()), a.right.hash());
    exact_real result;
    result.terms_.push_back({1, std::make_shared<const atom>(std::move(a))});
    long bits = 64;
    while (!result.bounds_at(bits)) {
        bits *= 2;
        if (bits > result.most_bits()) {
            throw error(error_kind::undecided, error_subject::number, "",
                        "has a part for which no precision within the limits decides whether it is defined");
        }
    }
    return result;
}

exact_real operator*(const exact_real& a, const exact_real& b) {
    const auto factor = a.fraction() ? a.fraction() : b.fraction();
    if (!factor) {
        // (c L/R) (d R) = c d L: 1/pi times pi is 1.
        for (const auto& [quotient, other] :
             {std::pair(a.only_term(), b.only_term()), {b.only_term(), a.only_term()}}) {
            const bool divides = quotient != nullptr && quotient->of->kind == atom_kind::quotient && other != nullptr;
            const auto* const below = divides ? quotient->of->right.only_term() : nullptr;
            if (below != nullptr && exact_real::same_atom(*below->of, *other->of)) {
                return quotient->of->left * exact_real(within_limits(rational(
                                                quotient->coefficient * other->coefficient / below->coefficient)));
            }
        }
        return exact_real::of_atom({atom_kind::product, function_kind::exp, a, b});
    }
    exact_real result = a.fraction() ? b : a;
    if (*factor == 0) {
        return {};
    }
    for (auto& each : result.terms_) {
        each.coefficient = within_limits(rational(each.coefficient * *factor));
    }
    return result;
}

exact_real operator/(const exact_real& a, const exact_real& b) {
    if (b.terms_.empty()) {
        refuse_number("divides by zero");
    }
    if (const auto divisor = b.fraction()) {
        return a * exact_real(rational(1 / *divisor));
    }
    const auto* const above = a.only_term();
    const auto* const below = b.only_term();
    if (above != nullptr && below != nullptr && exact_real::same_atom(*above->of, *below->of) && b.sign() != 0) {
        return exact_real(within_limits(rational(above->coefficient / below->coefficient)));
    }
    if (below != nullptr && below->of->kind == atom_kind::quotient && below->of->left.fraction()) {
        // a/(c L/R) = a R/(c L): 1/(1/pi) is pi.
        const rational rest = below->coefficient * *below->of->left.fraction();
        return a * below->of->right * exact_real(within_limits(rational(1 / rest)));
    }
    return exact_real::of_atom({atom_kind::quotient, function_kind::exp, a, b});
}

exact_real power(const exact_real& base, const exact_real& exponent) {
    const auto n = exponent.fraction();
    if (n && *n == 1) {
        return base;
    }
    require_no_period(base);
    require_no_period(exponent);
    if (n && *n == 0 && !base.terms_.empty()) {
        return exact_real(rational(1));
    }
    if (const auto b = base.fraction()) {
        if (*b == 0 && (!n || *n <= 0)) {
            refuse_number(n && *n == 0 ? "has 0^0, which has no value" : "divides by zero");
        }
        if (const auto folded = n ? folded_power(*b, *n) : *b == 1 ? std::optional(*b) : std::nullopt) {
            return exact_real(*folded);
        }
    }
    return exact_real::of_atom({atom_kind::power, function_kind::exp, base, exponent});
}

exact_real exact_real::of_function(function_kind f, const rational& order, const exact_real& x) {
    require_no_period(x);
    if (const auto number = x.plain()) {
        if (const auto folded = folded_function(f, order, *number)) {
            return exact_real(folded->coefficient, folded->measure);
        }
    }
    if (f == function_kind::lambertw) {
        const auto form = exponential_form::of(x);
        if (const auto folded = form ? form->lambertw() : std::nullopt) {
            return exact_real(*folded);
        }
    }
    return of_atom({atom_kind::function, f, x, exact_real(order)});
}

exact_real apply(function_kind f, const exact_real& x) {
    if (has_order(f)) {
        refuse_number("takes " + std::string(name_of(f)) + " without an order");
    }
    return exact_real::of_function(f, 0, x);
}

exact_real apply(function_kind f, const rational& order, const exact_real& x) {
    if (!has_order(f)) {
        refuse_number("takes " + std::string(name_of(f)) + " with an order, which it does not have");
    }
    return exact_real::of_function(f, order, x);
}

}  // namespace libration
