#include "conserved_sums.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"

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
            case node_kind::product:
                return e.is_unfolded_zero() ? variable(e) : product_of(done_.at(e.left()), done_.at(e.right()));
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

// p/y for a variable y that divides each product; std::nullopt if it does not.
std::optional<polynomial> divided_by(const polynomial& p, std::size_t y) {
    polynomial result;
    for (const auto& [product, factor] : p) {
        const auto place = std::ranges::find(product, y);
        if (place == product.end()) {
            return std::nullopt;
        }
        monomial rest = product;
        rest.erase(rest.begin() + (place - product.begin()));
        result.emplace(std::move(rest), factor);
    }
    return result;
}

// A term of a relation: an unknown or its logarithm, and its derivative along the solution.
struct term {
    std::size_t unknown;
    bool logarithm;
    polynomial slope;
};

bool is_nonzero(const number& start) {
    try {
        return start.sign() != 0;
    } catch (const error&) {
        return false;  // not decided
    }
}

// Logarithms first.
std::vector<term> terms_of(const first_order_form& of) {
    expansion all;
    std::vector<term> logarithms;
    std::vector<term> unknowns;
    for (std::size_t i = 0; i < of.slopes.size(); ++i) {
        const polynomial slope = all.of(of.slopes[i]);
        unknowns.push_back({i, false, slope});
        const std::size_t y = all.of(of.leaves[i]).begin()->first.front();
        if (auto relative = slope.empty() ? std::nullopt : divided_by(slope, y); relative && is_nonzero(of.starts[i])) {
            logarithms.push_back({i, true, *std::move(relative)});
        }
    }
    logarithms.insert(logarithms.end(), unknowns.begin(), unknowns.end());
    return logarithms;
}

// The combinations of the terms that are constant are the kernel of the equations "the factor of each product is 0".
echelon_form equations_of(const std::vector<term>& terms) {
    std::map<monomial, std::vector<rational>> factors;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        for (const auto& [product, factor] : terms[i].slope) {
            factors.try_emplace(product, terms.size(), rational(0)).first->second[i] = factor;
        }
    }
    echelon_form equations(terms.size());
    for (auto& each : factors) {
        equations.add(std::move(each.second));
    }
    return equations;
}

std::vector<term> bounded_terms_of(const first_order_form& of) {
    try {
        return terms_of(of);
    } catch (const too_many_terms&) {
        return {};
    }
}

// The first unknown of which the logarithm occurs in a relation although it is eliminated; the number of terms if none.
std::size_t first_implicit(const std::vector<term>& terms, const echelon_form& equations) {
    const auto is_eliminated = [&](std::size_t unknown) {
        const auto own =
            std::ranges::find_if(terms, [&](const term& each) { return !each.logarithm && each.unknown == unknown; });
        return !equations.has_pivot(static_cast<std::size_t>(own - terms.begin()));
    };
    for (std::size_t e = 0; e < terms.size(); ++e) {
        for (std::size_t p = 0; p < terms.size() && !terms[e].logarithm && !equations.has_pivot(e); ++p) {
            if (terms[p].logarithm && equations.has_pivot(p) && equations.of_kernel(p, e) != 0 &&
                is_eliminated(terms[p].unknown)) {
                return terms[p].unknown;
            }
        }
    }
    return terms.size();
}

// The terms in an order in which no unknown is eliminated whose logarithm a relation contains; without logarithms if
// none of those tried is.
std::vector<term> ordered_terms(const first_order_form& of) {
    std::vector<term> terms = bounded_terms_of(of);
    const auto first_unknown = [&] { return std::ranges::find(terms, false, &term::logarithm); };
    for (std::size_t tried = 0; tried < of.slopes.size(); ++tried) {
        const std::size_t implicit = first_implicit(terms, equations_of(terms));
        if (implicit == terms.size()) {
            return terms;
        }
        const auto own =
            std::ranges::find_if(terms, [&](const term& each) { return !each.logarithm && each.unknown == implicit; });
        std::rotate(first_unknown(), own, own + 1);
    }
    std::erase_if(terms, [](const term& each) { return each.logarithm; });
    return terms;
}

}  // namespace

conserved_sums conserved_sums_of(const first_order_form& of) {
    const std::vector<term> terms = ordered_terms(of);
    const echelon_form equations = equations_of(terms);
    conserved_sums result;
    std::vector<std::size_t> places;  // of the eliminated unknowns among the terms
    for (std::size_t k = 0; k < of.slopes.size(); ++k) {
        const auto own =
            std::ranges::find_if(terms, [&](const term& each) { return !each.logarithm && each.unknown == k; });
        const auto place = static_cast<std::size_t>(own - terms.begin());
        if (own == terms.end() || equations.has_pivot(place)) {
            result.kept.push_back(k);
        } else {
            result.eliminated.push_back(k);
            places.push_back(place);
        }
    }
    for (const std::size_t e : places) {
        auto& row = result.coefficients.emplace_back(result.kept.size());
        auto& logarithms = result.logarithms.emplace_back(result.kept.size());
        for (std::size_t p = 0; p < terms.size(); ++p) {
            const auto kept = std::ranges::find(result.kept, terms[p].unknown);
            if (equations.has_pivot(p) && kept != result.kept.end()) {
                auto& of_term = terms[p].logarithm ? logarithms : row;
                of_term[static_cast<std::size_t>(kept - result.kept.begin())] = -equations.of_kernel(p, e);
            }
        }
    }
    return result;
}

}  // namespace libration::ode
