#include "power_sum.hpp"

#include <flint/fmpq_mat.h>

#include <algorithm>
#include <iterator>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_products = 20'000;
constexpr int largest_whole_power = 16;

bool is_whole(const rational& q) { return denominator(q) == 1; }

void add_product(power_sum& to, const power_product& product, const rational& factor) {
    const auto place = to.try_emplace(product, 0).first;
    place->second += factor;
    if (place->second == 0) {
        to.erase(place);
    }
    if (to.size() > most_products) {
        throw no_power_sum();
    }
}

power_product multiplied(const power_product& a, const power_product& b) {
    power_product both;
    auto left = a.begin();
    auto right = b.begin();
    while (left != a.end() || right != b.end()) {
        if (right == b.end() || (left != a.end() && left->first < right->first)) {
            both.push_back(*left++);
        } else if (left == a.end() || right->first < left->first) {
            both.push_back(*right++);
        } else {
            if (const rational sum = left->second + right->second; sum != 0) {
                both.emplace_back(left->first, sum);
            }
            ++left;
            ++right;
        }
    }
    return both;
}

rational whole_power(const rational& base, long exponent) {
    rational result = 1;
    for (long k = 0; k < std::abs(exponent); ++k) {
        result *= base;
    }
    return exponent < 0 ? rational(1 / result) : result;
}

power_sum one() { return {{{}, 1}}; }

power_sum power_of_sum(const power_sum& sum, long exponent) {
    power_sum result = one();
    for (long k = 0; k < exponent; ++k) {
        result = power_sums::product(result, sum);
    }
    return result;
}

rational exponent_in(const power_product& product, std::size_t base) {
    const auto found = std::ranges::find(product, base, &std::pair<std::size_t, rational>::first);
    return found == product.end() ? rational(0) : found->second;
}

// q - floor(q).
rational part_below_one(const rational& q) {
    integer whole = numerator(q) / denominator(q);
    if (q < 0 && !is_whole(q)) {
        whole -= 1;
    }
    return q - rational(whole);
}

// The kernel of a matrix, given by the equations of its rows.
std::vector<std::vector<rational>> kernel_of(const std::vector<std::map<std::size_t, rational>>& rows,
                                             std::size_t columns) {
    fmpq_mat_t matrix;
    fmpq_mat_init(matrix, static_cast<slong>(rows.size()), static_cast<slong>(columns));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const auto& [j, value] : rows[i]) {
            fmpq_set_mpq(fmpq_mat_entry(matrix, static_cast<slong>(i), static_cast<slong>(j)), value.backend().data());
        }
    }
    const auto rank = static_cast<std::size_t>(fmpq_mat_rref(matrix, matrix));
    std::vector<std::size_t> pivots;
    for (std::size_t i = 0; i < rank; ++i) {
        std::size_t j = pivots.empty() ? 0 : pivots.back() + 1;
        while (fmpq_is_zero(fmpq_mat_entry(matrix, static_cast<slong>(i), static_cast<slong>(j))) != 0) {
            ++j;
        }
        pivots.push_back(j);
    }
    std::vector<std::vector<rational>> kernel;
    for (std::size_t j = 0; j < columns; ++j) {
        if (std::ranges::find(pivots, j) != pivots.end()) {
            continue;
        }
        auto& vector = kernel.emplace_back(columns, rational(0));
        vector[j] = 1;
        for (std::size_t i = 0; i < rank; ++i) {
            rational entry;
            fmpq_get_mpq(entry.backend().data(), fmpq_mat_entry(matrix, static_cast<slong>(i), static_cast<slong>(j)));
            vector[pivots[i]] = -entry;
        }
    }
    fmpq_mat_clear(matrix);
    return kernel;
}

}  // namespace

power_sum power_sums::product(const power_sum& a, const power_sum& b) {
    power_sum result;
    for (const auto& [left, of_left] : a) {
        for (const auto& [right, of_right] : b) {
            add_product(result, multiplied(left, right), of_left * of_right);
        }
    }
    return result;
}

const power_sum& power_sums::of(const expression& e) {
    return done_.of(e, [this](const expression& each) { return converted(each); });
}

power_sum power_sums::converted(const expression& e) {
    switch (e.kind()) {
        case node_kind::constant:
            if (const auto value = e.fraction()) {
                return *value == 0 ? power_sum() : power_sum{{{}, *value}};
            }
            return single(e);
        case node_kind::sum: {
            power_sum sum = done_.at(e.left());
            for (const auto& [product, factor] : done_.at(e.right())) {
                add_product(sum, product, factor);
            }
            return sum;
        }
        case node_kind::product:
            return e.is_unfolded_zero() ? single(e) : product(done_.at(e.left()), done_.at(e.right()));
        case node_kind::quotient: return product(done_.at(e.left()), raised(e.right(), done_.at(e.right()), -1));
        case node_kind::power:
            if (const auto exponent = e.right().fraction()) {
                return raised(e.left(), done_.at(e.left()), *exponent);
            }
            return single(e);
        case node_kind::function:
            if (e.function() == function_kind::sqrt) {
                return raised(e.left(), done_.at(e.left()), rational(1, 2));
            }
            return single(e);
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    return single(e);
}

power_sum power_sums::single(const expression& e) {
    const auto [place, is_new] = singles_.try_emplace(e, bases_.size());
    if (is_new) {
        bases_.push_back({e, {}});
    }
    return {{{{place->second, 1}}, 1}};
}

std::size_t power_sums::index_of(const expression& typed, const power_sum& sum) {
    const auto [place, is_new] = sums_.try_emplace(sum, bases_.size());
    if (is_new) {
        bases_.push_back({typed, sum});
    }
    return place->second;
}

power_sum power_sums::raised(const expression& of, const power_sum& sum, const rational& exponent) {
    if (exponent == 0) {
        return one();
    }
    if (sum.empty() || abs(exponent) > largest_whole_power) {
        throw no_power_sum();
    }
    if (is_whole(exponent) && exponent > 0) {
        return power_of_sum(sum, static_cast<long>(numerator(exponent)));
    }
    if (sum.size() == 1) {
        const auto& [product, factor] = *sum.begin();
        const bool odd = product.size() == 1 && factor == 1 &&
                         (!is_whole(product.front().second) || numerator(product.front().second) % 2 != 0);
        if (is_whole(exponent) || odd) {
            power_product raised = product;
            for (auto& each : raised) {
                each.second *= exponent;
            }
            return {{raised,
                     is_whole(exponent) ? whole_power(factor, static_cast<long>(numerator(exponent))) : rational(1)}};
        }
    }
    return {{{{index_of(of, sum), exponent}}, 1}};
}

// u^e becomes u^m (u^(e - m)) with the smallest exponent m of those that differ from e by a whole number, at most 0 for
// whole e.
void power_sums::expand(std::vector<power_sum>& sums, std::size_t index) const {
    std::map<rational, rational> smallest;
    for (const power_sum& each : sums) {
        for (const auto& [product, factor] : each) {
            const rational exponent = exponent_in(product, index);
            const auto [place, is_new] = smallest.try_emplace(part_below_one(exponent), exponent);
            place->second = std::min(place->second, exponent);
        }
    }
    for (power_sum& each : sums) {
        power_sum expanded;
        for (const auto& [product, factor] : each) {
            const rational exponent = exponent_in(product, index);
            const rational least = smallest.at(part_below_one(exponent));
            const rational more = exponent - least;
            if (more > largest_whole_power) {
                throw no_power_sum();
            }
            const power_sum by = power_of_sum(*bases_[index].as_sum, static_cast<long>(numerator(more)));
            const power_product rest =
                more == 0 ? product : multiplied(product, power_product{{index, rational(-more)}});
            for (const auto& [power, of_power] : by) {
                add_product(expanded, multiplied(rest, power), factor * of_power);
            }
        }
        each = std::move(expanded);
    }
}

std::vector<std::vector<rational>> power_sums::relations(std::vector<power_sum> of) const {
    std::vector<std::vector<power_sum>> rows;
    for (power_sum& each : of) {
        rows.push_back({std::move(each)});
    }
    return relations(rows);
}

std::vector<std::vector<rational>> power_sums::relations(const std::vector<std::vector<power_sum>>& rows) const {
    std::vector<power_sum> all;
    for (const auto& row : rows) {
        all.insert(all.end(), row.begin(), row.end());
    }
    for (std::size_t k = bases_.size(); k-- > 0;) {  // a sum contains only bases before it
        if (bases_[k].as_sum) {
            expand(all, k);
        }
    }
    std::map<std::pair<std::size_t, power_product>, std::map<std::size_t, rational>> factors;
    const std::size_t width = rows.empty() ? 0 : rows.front().size();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const auto& [product, factor] : all[i]) {
            factors[{i % width, product}].emplace(i / width, factor);
        }
    }
    std::vector<std::map<std::size_t, rational>> equations;
    std::ranges::transform(factors, std::back_inserter(equations), [](const auto& each) { return each.second; });
    return kernel_of(equations, rows.size());
}

}  // namespace libration::ode
