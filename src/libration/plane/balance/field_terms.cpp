#include "field_terms.hpp"

#include <map>

namespace libration::ode {

namespace {

constexpr std::size_t most_field_terms = 400;
constexpr int highest_field_power = 12;

// By the powers of the unknowns and, last, of the variable.
using monomial_sum = std::map<std::vector<int>, number>;

bool is_exactly_zero(const number& x) {
    const auto value = x.fraction();
    return value && *value == 0;
}

void add_monomial(monomial_sum& sum, const std::vector<int>& powers, const number& factor) {
    const auto [at, is_new] = sum.emplace(powers, factor);
    if (!is_new) {
        at->second = at->second + factor;
    }
    if (is_exactly_zero(at->second)) {
        sum.erase(at);
    }
}

class monomial_expansion {
public:
    explicit monomial_expansion(const std::vector<expression>& leaves) : leaves_(leaves) {}

    std::optional<monomial_sum> of(const expression& e) const {
        switch (e.kind()) {
            case node_kind::constant: return single(std::vector<int>(leaves_.size() + 1), e.constant());
            case node_kind::variable: return power_of(leaves_.size());
            case node_kind::unknown:
                for (std::size_t k = 0; k < leaves_.size(); ++k) {
                    if (same_form(e, leaves_[k])) {
                        return power_of(k);
                    }
                }
                return std::nullopt;
            case node_kind::sum: {
                auto a = of(e.left());
                const auto b = of(e.right());
                if (!a || !b) {
                    return std::nullopt;
                }
                for (const auto& [powers, factor] : *b) {
                    add_monomial(*a, powers, factor);
                }
                return a;
            }
            case node_kind::product: return product(of(e.left()), of(e.right()));
            case node_kind::power: {
                const auto n = e.right().fraction();
                if (!n || denominator(*n) != 1 || *n < 0 || *n > highest_field_power) {
                    return std::nullopt;
                }
                auto result = of(expression(1));
                for (int k = 0; k < static_cast<int>(*n); ++k) {
                    result = product(result, of(e.left()));
                }
                return result;
            }
            case node_kind::quotient:
            case node_kind::function:
            case node_kind::parameter: break;
        }
        return std::nullopt;
    }

private:
    static monomial_sum single(const std::vector<int>& powers, const number& factor) {
        monomial_sum result;
        add_monomial(result, powers, factor);
        return result;
    }
    monomial_sum power_of(std::size_t k) const {
        std::vector<int> powers(leaves_.size() + 1);
        powers[k] = 1;
        return single(powers, number(rational(1)));
    }
    static std::optional<monomial_sum> product(const std::optional<monomial_sum>& a,
                                               const std::optional<monomial_sum>& b) {
        if (!a || !b) {
            return std::nullopt;
        }
        monomial_sum result;
        for (const auto& [p, x] : *a) {
            for (const auto& [q, y] : *b) {
                std::vector<int> powers = p;
                for (std::size_t k = 0; k < q.size(); ++k) {
                    powers[k] += q[k];
                }
                add_monomial(result, powers, x * y);
            }
        }
        return result.size() > most_field_terms ? std::nullopt : std::optional(result);
    }

    const std::vector<expression>& leaves_;
};

}  // namespace

std::optional<std::vector<std::vector<field_term>>> field_terms_of(const explicit_system& of,
                                                                   const std::vector<expression>& leaves) {
    const monomial_expansion expansion(leaves);
    std::vector<std::vector<field_term>> rows;
    for (const expression& each : of.right()) {
        const auto sum = expansion.of(each);
        if (!sum) {
            return std::nullopt;
        }
        std::map<std::vector<int>, std::vector<number>> by_powers;
        for (const auto& [powers, factor] : *sum) {
            auto& list = by_powers[{powers.begin(), powers.end() - 1}];
            const auto s = static_cast<std::size_t>(powers.back());
            if (list.size() <= s) {
                list.resize(s + 1);
            }
            list[s] = factor;
        }
        auto& row = rows.emplace_back();
        for (auto& [powers, list] : by_powers) {
            row.push_back({powers, std::move(list)});
        }
    }
    return rows;
}

}  // namespace libration::ode
