#include "conserved_sums.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "libration/ode/node_values.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_terms = 10'000;
constexpr int largest_expanded_power = 16;

// A product of variables, by their indices in ascending order, and a sum of such products.
using monomial = std::vector<std::size_t>;
using polynomial = std::map<monomial, rational>;

struct too_many_terms {};

void add_term(polynomial& to, const monomial& product, const rational& factor) {
    const auto place = to.try_emplace(product, 0).first;
    place->second += factor;
    if (place->second == 0) {
        to.erase(place);
    }
    if (to.size() > most_terms) {
        throw too_many_terms();
    }
}

polynomial product_of(const polynomial& a, const polynomial& b) {
    polynomial result;
    for (const auto& [left, left_factor] : a) {
        for (const auto& [right, right_factor] : b) {
            monomial both;
            std::ranges::merge(left, right, std::back_inserter(both));
            add_term(result, both, left_factor * right_factor);
        }
    }
    return result;
}

// Expressions as polynomials in leaves and in subexpressions of another form.
class expansion {
public:
    const polynomial& of(const expression& e) {
        return done_.of(e, [this](const expression& each) { return expanded(each); });
    }

private:
    polynomial expanded(const expression& e) {
        switch (e.kind()) {
            case node_kind::constant:
                if (const auto value = e.fraction()) {
                    return *value == 0 ? polynomial() : polynomial{{{}, *value}};
                }
                return variable(e);
            case node_kind::sum: {
                polynomial sum = done_.at(e.left());
                for (const auto& [product, factor] : done_.at(e.right())) {
                    add_term(sum, product, factor);
                }
                return sum;
            }
            case node_kind::product: return product_of(done_.at(e.left()), done_.at(e.right()));
            case node_kind::quotient: return divided(e);
            case node_kind::power: return raised(e);
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter:
            case node_kind::function: break;
        }
        return variable(e);
    }

    polynomial divided(const expression& e) {
        const polynomial& divisor = done_.at(e.right());
        const bool constant = divisor.size() == 1 && divisor.begin()->first.empty();
        return product_of(done_.at(e.left()), constant ? polynomial{{{}, 1 / divisor.begin()->second}}
                                                       : variable(expression(1) / e.right()));
    }

    polynomial raised(const expression& e) {
        const auto exponent = e.right().fraction();
        if (!exponent || denominator(*exponent) != 1 || *exponent < 0 || *exponent > largest_expanded_power) {
            return variable(e);
        }
        polynomial result{{{}, 1}};
        for (rational n = 0; n < *exponent; ++n) {
            result = product_of(result, done_.at(e.left()));
        }
        return result;
    }

    polynomial variable(const expression& e) {
        return {{{variables_.try_emplace(e, variables_.size()).first->second}, 1}};
    }

    node_values<polynomial> done_;
    std::unordered_map<expression, std::size_t, same_expression::hash, same_expression::equal> variables_;
};

// Rows in reduced echelon form, one equation at a time.
class echelon_form {
public:
    explicit echelon_form(std::size_t columns) : columns_(columns) {}

    void add(std::vector<rational> row) {
        for (const auto& [pivot, known] : rows_) {
            clear(row, pivot, known);
        }
        const auto first = std::ranges::find_if(row, [](const rational& each) { return each != 0; });
        if (first == row.end()) {
            return;
        }
        const auto pivot = static_cast<std::size_t>(first - row.begin());
        const rational by = *first;
        for (rational& each : row) {
            each /= by;
        }
        for (auto& known : rows_) {
            clear(known.second, pivot, row);
        }
        rows_.emplace(pivot, std::move(row));
    }

    bool has_pivot(std::size_t column) const { return rows_.contains(column); }
    // The component at a pivot of the vector of the kernel that is 1 at this column and 0 at the others without pivot.
    rational of_kernel(std::size_t pivot, std::size_t column) const { return -rows_.at(pivot)[column]; }

private:
    // Subtracts the multiple of a row that is 1 at the pivot which leaves 0 there.
    void clear(std::vector<rational>& row, std::size_t pivot, const std::vector<rational>& by) const {
        const rational factor = std::exchange(row[pivot], 0);
        for (std::size_t k = 0; factor != 0 && k < columns_; ++k) {
            if (k != pivot) {
                row[k] -= factor * by[k];
            }
        }
    }

    std::size_t columns_;
    std::map<std::size_t, std::vector<rational>> rows_;
};

// The combinations of the slopes that vanish are the kernel of the equations "the factor of each product is 0".
echelon_form equations_of_sums(const std::vector<expression>& slopes) {
    expansion all;
    std::map<monomial, std::vector<rational>> factors;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        for (const auto& [product, factor] : all.of(slopes[i])) {
            factors.try_emplace(product, slopes.size(), rational(0)).first->second[i] = factor;
        }
    }
    echelon_form equations(slopes.size());
    for (auto& each : factors) {
        equations.add(std::move(each.second));
    }
    return equations;
}

std::optional<echelon_form> bounded_equations_of_sums(const std::vector<expression>& slopes) {
    try {
        return equations_of_sums(slopes);
    } catch (const too_many_terms&) {
        return std::nullopt;
    }
}

}  // namespace

conserved_sums conserved_sums_of(const first_order_form& of) {
    const auto equations = bounded_equations_of_sums(of.slopes);
    conserved_sums result;
    for (std::size_t k = 0; k < of.slopes.size(); ++k) {
        (!equations || equations->has_pivot(k) ? result.kept : result.eliminated).push_back(k);
    }
    for (const std::size_t e : result.eliminated) {
        number constant = of.starts[e];
        auto& row = result.coefficients.emplace_back();
        for (const std::size_t k : result.kept) {
            const rational c = equations->of_kernel(k, e);
            row.push_back(-c);
            constant = c == 0 ? constant : constant + of.starts[k] * number(c);
        }
        result.constants.push_back(constant);
    }
    return result;
}

}  // namespace libration::ode
