#include "first_integrals.hpp"

#include <algorithm>
#include <optional>

#include "libration/scalar/error.hpp"
#include "power_sum.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_unknowns_with_cubes = 4;
constexpr std::size_t most_candidates = 700;

// A term of an integral, and its derivative along the solution.
struct integral_term {
    expression value;
    int degree;
    std::string text;
    power_sum slope = {};
};

bool is_nonzero_start(const number& start) {
    try {
        return start.sign() != 0;
    } catch (const error&) {
        return false;  // not decided
    }
}

bool is_natural(const rational& exponent) { return denominator(exponent) == 1 && exponent > 0; }

class integral_terms {
public:
    explicit integral_terms(const first_order_form& of) : form_(of) {
        for (const expression& leaf : of.leaves) {
            places_.push_back(sums_.of(leaf).begin()->first.front().first);
        }
        for (const expression& each : of.slopes) {
            slopes_.push_back(sums_.of(each));
        }
    }

    std::vector<first_integral> integrals(const std::vector<expression>& declared) {
        add_products();
        add_powers();
        add_logarithms();
        add_declared(declared);
        std::vector<power_sum> slopes;
        for (const integral_term& each : all_) {
            slopes.push_back(each.slope);
        }
        std::vector<first_integral> result;
        for (const auto& factors : sums_.relations(slopes)) {
            first_integral each = combined(factors);
            if (!std::ranges::all_of(each.gradient, [this](const expression& by) { return is_zero(by); })) {
                result.push_back(std::move(each));
            }
        }
        std::ranges::stable_sort(result, {}, &first_integral::degree);
        return result;
    }

private:
    bool is_zero(const expression& e) { return !sums_.relations(std::vector<power_sum>{sums_.of(e)}).empty(); }

    void add(const expression& value, int degree, const std::string& text) {
        if (all_.size() < most_candidates) {
            all_.push_back({value, degree, text, sums_.of(form_.slope_of(value))});
        }
    }

    void add_products() {
        const std::size_t n = form_.leaves.size();
        for (std::size_t i = 0; i < n; ++i) {
            add(form_.leaves[i], 1, form_.names[i]);
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i; j < n; ++j) {
                add(form_.leaves[i] * form_.leaves[j], 2, product_text({i, j}));
            }
        }
        for (std::size_t i = 0; i < n && n <= most_unknowns_with_cubes; ++i) {
            for (std::size_t j = i; j < n; ++j) {
                for (std::size_t k = j; k < n; ++k) {
                    add(form_.leaves[i] * form_.leaves[j] * form_.leaves[k], 3, product_text({i, j, k}));
                }
            }
        }
        add_products_in_slopes();
    }

    // Products of f with one more leaf, of higher degree.
    void add_products_in_slopes() {
        const std::size_t n = form_.leaves.size();
        const std::size_t known = n <= most_unknowns_with_cubes ? 3 : 2;
        std::vector<std::vector<std::size_t>> seen;
        for (const power_sum& slope : slopes_) {
            for (const auto& [product, factor] : slope) {
                const auto leaves = leaves_in(product);
                for (std::size_t j = 0; leaves && leaves->size() >= known && j < n; ++j) {
                    auto longer = *leaves;
                    longer.insert(std::ranges::upper_bound(longer, j), j);
                    if (std::ranges::find(seen, longer) == seen.end()) {
                        seen.push_back(longer);
                        expression value(1);
                        for (const std::size_t k : longer) {
                            value = value * form_.leaves[k];
                        }
                        add(value, 3, product_text(longer));
                    }
                }
            }
        }
    }

    // The leaves of a product, each as often as it occurs; std::nullopt for another product.
    std::optional<std::vector<std::size_t>> leaves_in(const power_product& product) const {
        std::vector<std::size_t> result;
        for (const auto& [base, exponent] : product) {
            const auto found = std::ranges::find(places_, base);
            if (found == places_.end() || !is_natural(exponent)) {
                return std::nullopt;
            }
            result.insert(result.end(), static_cast<std::size_t>(numerator(exponent)),
                          static_cast<std::size_t>(found - places_.begin()));
        }
        std::ranges::sort(result);
        return result;
    }

    void add_powers() {
        std::vector<std::pair<std::size_t, rational>> powers;
        for (const power_sum& slope : slopes_) {
            for (const auto& [product, factor] : slope) {
                for (const auto& power : product) {
                    if (!is_natural(power.second) && std::ranges::find(powers, power) == powers.end()) {
                        powers.push_back(power);
                    }
                }
            }
        }
        const std::size_t functions = sums_.bases().size();
        for (const auto& [base, exponent] : powers) {
            const expression u = sums_.bases()[base].typed;
            add_with_factors(exponent == -1 ? log(u) : pow(u, expression(rational(exponent + 1))));
        }
        for (std::size_t k = 0; k < functions; ++k) {
            const expression of = sums_.bases()[k].typed;
            if (of.kind() == node_kind::function && is_in_slopes(k)) {
                add_related(of);
            }
        }
    }

    // The functions with which derivatives of this one are combined.
    void add_related(const expression& of) {
        const function_kind kind = of.function();
        if (kind == function_kind::sin || kind == function_kind::cos) {
            add_other(sin(of.left()));
            add_other(cos(of.left()));
        } else if (kind == function_kind::sinh || kind == function_kind::cosh) {
            add_other(sinh(of.left()));
            add_other(cosh(of.left()));
        } else if (kind == function_kind::exp) {
            add_other(of);
        }
    }

    bool is_in_slopes(std::size_t base) const {
        return std::ranges::any_of(slopes_, [&](const power_sum& slope) {
            return std::ranges::any_of(slope, [&](const auto& term) {
                return std::ranges::any_of(term.first, [&](const auto& power) { return power.first == base; });
            });
        });
    }

    void add_other(const expression& value) { add(value, 3, ""); }

    // Few unknowns: also times a leaf, as in the vector of Laplace, Runge and Lenz.
    void add_with_factors(const expression& value) {
        add_other(value);
        for (std::size_t j = 0; j < form_.leaves.size() && form_.leaves.size() <= most_unknowns_with_cubes; ++j) {
            add_other(form_.leaves[j] * value);
        }
    }

    void add_logarithms() {
        for (std::size_t i = 0; i < form_.leaves.size(); ++i) {
            const bool divides = std::ranges::all_of(slopes_[i], [&](const auto& term) {
                return std::ranges::any_of(term.first, [&](const auto& power) {
                    return power.first == places_[i] && is_natural(power.second);
                });
            });
            if (divides && !slopes_[i].empty() && is_nonzero_start(form_.starts[i])) {
                all_.push_back({log(form_.leaves[i]), 3, "log |" + form_.names[i] + "|",
                                sums_.of(form_.slopes[i] / form_.leaves[i])});
            }
        }
    }

    void add_declared(const std::vector<expression>& declared) {
        for (const expression& each : declared) {
            const expression value = form_.in_leaves(each);
            if (!value.has_variable() && has_only_powers_of_slopes(power_sum(sums_.of(value)))) {
                add_other(value);
            }
        }
    }

    // u^s in an integral is continuously differentiable where f has a value: u^r in f, r < 0 (u != 0), and r not whole
    // if s is not (u > 0).
    bool has_only_powers_of_slopes(const power_sum& value) {
        return std::ranges::all_of(value, [&](const auto& term) {
            return std::ranges::all_of(term.first, [&](const auto& power) { return is_covered(power); });
        });
    }

    bool is_covered(const std::pair<std::size_t, rational>& power) {
        const power_sums::base base = sums_.bases()[power.first];
        const bool smooth =
            base.typed.kind() == node_kind::constant || base.typed.kind() == node_kind::unknown || base.as_sum ||
            (base.typed.kind() == node_kind::function &&
             (base.typed.function() == function_kind::sin || base.typed.function() == function_kind::cos ||
              base.typed.function() == function_kind::exp) &&
             has_only_powers_of_slopes(power_sum(sums_.of(base.typed.left()))));
        if (!smooth) {
            return false;
        }
        if (is_natural(power.second)) {
            return !base.as_sum || has_only_powers_of_slopes(*base.as_sum);
        }
        const bool whole = denominator(power.second) == 1;
        return std::ranges::any_of(slopes_, [&](const power_sum& slope) {
            return std::ranges::any_of(slope, [&](const auto& term) {
                return std::ranges::any_of(term.first, [&](const auto& each) {
                    return each.first == power.first && each.second < 0 && (whole || denominator(each.second) != 1);
                });
            });
        });
    }

    std::string product_text(const std::vector<std::size_t>& leaves) const {
        std::string text;
        for (std::size_t k = 0; k < leaves.size();) {
            std::size_t end = k;
            while (end < leaves.size() && leaves[end] == leaves[k]) {
                ++end;
            }
            text += (text.empty() ? "" : "*") + form_.names[leaves[k]];
            if (end - k > 1) {
                text += "^" + std::to_string(end - k);
            }
            k = end;
        }
        return text;
    }

    first_integral combined(const std::vector<rational>& factors) const {
        first_integral result;
        bool more = false;
        for (std::size_t k = 0; k < factors.size(); ++k) {
            if (factors[k] == 0) {
                continue;
            }
            result.value = result.value + expression(factors[k]) * all_[k].value;
            result.degree = std::max(result.degree, all_[k].degree);
            if (all_[k].text.empty()) {
                more = true;
                continue;
            }
            const rational size = abs(factors[k]);
            result.text += result.text.empty() ? (factors[k] < 0 ? "-" : "") : (factors[k] < 0 ? " - " : " + ");
            result.text += (size == 1 ? "" : size.str() + "*") + all_[k].text;
        }
        if (more) {
            result.text += result.text.empty() ? "..." : " + ...";
        }
        for (const expression& leaf : form_.leaves) {
            result.gradient.push_back(partial(result.value, leaf));
        }
        return result;
    }

    const first_order_form& form_;
    power_sums sums_;
    std::vector<std::size_t> places_;  // of the leaves among the bases
    std::vector<power_sum> slopes_;
    std::vector<integral_term> all_;
};

}  // namespace

std::vector<first_integral> first_integrals_of(const first_order_form& of, const std::vector<expression>& declared) {
    if (of.leaves.size() > most_unknowns_with_integrals) {
        return {};
    }
    try {
        return integral_terms(of).integrals(declared);
    } catch (const no_power_sum&) {
        return {};
    }
}

}  // namespace libration::ode
