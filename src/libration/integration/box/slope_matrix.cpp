#include "slope_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The largest norm of N times the length: its exponential has as many terms and more.
constexpr double most_growth_of_piece = 48;
// The rest of the exponential is this number of bits below the radii where the number of terms permits it.
constexpr long bits_below_radii = 12;
constexpr unsigned long most_terms_of_growth = 400;
constexpr double most_parts_of_piece = 64;
constexpr long bits_of_growth = 64;

// The weights grow until N w is at most this multiple of w/length, in at most so many passes.
constexpr unsigned long wanted_growth = 4;
constexpr int most_passes_of_weights = 40;

// N, c, w and nu.
struct nonnegative_part {
    std::vector<magnitude> diagonal;
    ball decay;
    std::vector<magnitude> weights;
    magnitude norm;
};

// Exact: a double at least as large as the decay of each unknown.
ball common_decay(const slope_matrix& of) {
    double most = 0;
    for (const ball& each : of.diagonal) {
        if (arb_is_negative(each.handle()) != 0) {
            most = std::max(most, magnitude(each).above());
        }
    }
    ball decay;
    arb_set_d(decay.handle(), most);
    return decay;
}

magnitude product_of_row(const slope_matrix& of, const nonnegative_part& n, const std::vector<magnitude>& by,
                         std::size_t i) {
    magnitude sum = n.diagonal[i] * by[i];
    for (std::size_t k = of.first[i]; k < of.first[i + 1]; ++k) {
        sum.add_product(of.beside[k], by[of.columns[k]]);
    }
    return sum;
}

// nu with N w <= nu w.
magnitude norm_of(const slope_matrix& of, const nonnegative_part& n, const std::vector<magnitude>& w) {
    magnitude norm;
    for (std::size_t i = 0; i < of.size(); ++i) {
        norm = std::max(norm, product_of_row(of, n, w, i) / w[i]);
    }
    return norm;
}

// With weights that are at least the given ones, for which nu is less: an unknown that is much smaller than one on
// which it depends does not remain so.
nonnegative_part part_of(const slope_matrix& of, const std::vector<magnitude>& weights, const magnitude& length) {
    nonnegative_part result{{}, common_decay(of), weights, {}};
    for (const ball& each : of.diagonal) {
        const ball shifted = upper_bound(each + result.decay);
        result.diagonal.push_back(arb_is_positive(shifted.handle()) != 0 ? magnitude(shifted) : magnitude());
    }
    std::vector<magnitude>& w = result.weights;
    bool grows = true;
    for (int pass = 0; pass < most_passes_of_weights && grows; ++pass) {
        grows = false;
        for (std::size_t i = 0; i < of.size(); ++i) {
            const magnitude next = product_of_row(of, result, w, i) * length / wanted_growth;
            if (w[i] < next) {
                w[i] = next.shifted(1);
                grows = true;
            }
        }
    }
    result.norm = norm_of(of, result, w);
    if (const magnitude before = norm_of(of, result, weights); before <= result.norm) {
        result.norm = before;
        w = weights;
    }
    return result;
}

// Whether each unknown depends on one whose radius is nonzero, in as many passes in turn as dependence needs.
std::vector<bool> reached_by_errors(const slope_matrix& of, const std::vector<magnitude>& start) {
    std::vector<bool> reached;
    for (const magnitude& each : start) {
        reached.push_back(!each.is_zero());
    }
    if (std::ranges::find(reached, false) == reached.end() || std::ranges::find(reached, true) == reached.end()) {
        return reached;
    }
    const auto depends = [&](std::size_t i) {
        for (std::size_t k = of.first[i]; k < of.first[i + 1]; ++k) {
            if (reached[of.columns[k]] && !of.beside[k].is_zero()) {
                return true;
            }
        }
        return false;
    };
    bool changes = true;
    for (bool forward = true; changes; forward = !forward) {
        changes = false;
        for (std::size_t k = 0; k < of.size(); ++k) {
            const std::size_t i = forward ? k : of.size() - 1 - k;
            if (!reached[i] && depends(i)) {
                reached[i] = true;
                changes = true;
            }
        }
    }
    return reached;
}

// sum_k (N length)^k/k! start, with the bound of the rest.
std::optional<std::vector<magnitude>> exponential_sum(const slope_matrix& of, const nonnegative_part& n,
                                                      const std::vector<magnitude>& start, const magnitude& length,
                                                      const std::vector<bool>& reached) {
    const std::vector<magnitude>& weights = n.weights;
    const magnitude exponent = n.norm * length;
    if (!(exponent <= magnitude::at_least(most_growth_of_piece, 0))) {
        return std::nullopt;
    }
    magnitude rest = exponential(exponent);
    magnitude of_start;
    for (std::size_t i = 0; i < start.size(); ++i) {
        of_start = std::max(of_start, start[i] / weights[i]);
    }
    rest *= of_start;
    std::vector<magnitude> sum = start;
    std::vector<magnitude> term = start;
    std::vector<magnitude> next(start.size());
    const auto is_small = [&] {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            if (!sum[i].is_zero() && !((rest * weights[i]).shifted(bits_below_radii) <= sum[i])) {
                return false;
            }
        }
        return true;
    };
    for (unsigned long k = 1; k <= most_terms_of_growth; ++k) {
        rest = rest * exponent / k;
        if (is_small()) {
            break;
        }
        const magnitude factor = length / k;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            next[i] = product_of_row(of, n, term, i) * factor;
        }
        std::swap(term, next);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += term[i];
        }
        if (k == most_terms_of_growth) {
            rest = rest * exponent / (k + 1);
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (reached[i]) {
            sum[i].add_product(rest, weights[i]);
        }
    }
    return sum;
}

bool are_finite(const std::vector<magnitude>& all) {
    return std::ranges::all_of(all, [](const magnitude& each) { return each.is_finite(); });
}

}  // namespace

std::optional<grown_radii> grown(const slope_matrix& of, const std::vector<magnitude>& start, const magnitude& length,
                                 const std::vector<magnitude>& weights) {
    const bool has_bounds = are_finite(of.beside) && are_finite(start) &&
                            std::ranges::all_of(of.diagonal, [](const ball& each) { return is_finite(each); });
    if (!has_bounds) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(bits_of_growth));
    const nonnegative_part n = part_of(of, weights, length);
    const double parts = std::ceil((magnitude(n.decay) * length).above());
    if (!(parts <= most_parts_of_piece)) {
        return std::nullopt;
    }
    const auto count = static_cast<unsigned long>(std::max(parts, 1.0));
    const magnitude part = length / count;
    const magnitude factor(exp(-(n.decay * length.exact() / static_cast<long>(count))));
    const auto reached = reached_by_errors(of, start);
    grown_radii result{start, start};
    for (unsigned long k = 0; k < count; ++k) {
        auto sum = exponential_sum(of, n, result.last, part, reached);
        if (!sum || !are_finite(*sum)) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < sum->size(); ++i) {
            result.most[i] = std::max(result.most[i], (*sum)[i]);
            result.last[i] = (*sum)[i] * factor;
        }
    }
    return result;
}

}  // namespace libration::ode
