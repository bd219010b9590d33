// Error sets with more columns than coordinates: those in front are followed separately.
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "libration/integration/lohner_set.hpp"

namespace libration::ode {

namespace {

// log2 of the part of the reach of separate columns from which on other columns become separate ones too.
constexpr long log2_of_separate = 6;
// The most separate columns, times the number of coordinates.
constexpr std::size_t most_separate_columns = 12;

}  // namespace

// The sum over the columns from one index to another of |column_i| times its radius.
magnitude lohner_set::reach_of(std::size_t first, std::size_t last, std::size_t i) const {
    magnitude sum;
    for (std::size_t j = first; j < last; ++j) {
        sum.add_product(magnitude(columns_[j][i]), radii_[j]);
    }
    return sum;
}

// Whether the last columns contribute to the reach of any coordinate.
bool lohner_set::is_wide_behind(std::size_t kept) const {
    for (std::size_t i = 0; i < size(); ++i) {
        const magnitude rest = reach_of(kept, columns_.size(), i);
        if (!(rest <= reach_of(0, kept, i) * magnitude::of(1, -log2_of_separate))) {
            return true;
        }
    }
    return false;
}

// C [-q, q] is in M [-q, q] + [-d, d] with d = |C - M| q, M the midpoint of C.
lohner_set lohner_set::settled_behind(std::size_t kept, const std::vector<long>& scales) const {
    const std::size_t moving = size();
    lohner_set rounded(ball_matrix(columns_.size()), blocks_, radii_of_columns(), added_);
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        for (std::size_t i = 0; i < moving; ++i) {
            rounded.columns_[j].push_back(exact_midpoint(columns_[j][i]));
            rounded.added_[i].add_product(magnitude(columns_[j][i] - rounded.columns_[j][i]), rounded.radii_[j]);
        }
    }
    if (rounded.is_wide_behind(kept)) {
        rounded.keep_all_columns(scales);
        kept = rounded.columns_.size() - moving;
    }
    const auto behind = [kept](const auto& all) {
        return std::vector(all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
    };
    const lohner_set rest = lohner_set(behind(rounded.columns_), std::vector<std::size_t>(moving, 1),
                                       behind(rounded.radii_), rounded.added_)
                                .settled(scales);
    std::copy(rest.columns_.begin(), rest.columns_.end(), rounded.columns_.begin() + static_cast<std::ptrdiff_t>(kept));
    std::copy(rest.radii_.begin(), rest.radii_.end(), rounded.radii_.begin() + static_cast<std::ptrdiff_t>(kept));
    rounded.added_ = rest.added_;
    return rounded;
}

// All columns become separate ones, with new ones of radius 0 behind them. The shortest of too many are replaced by a
// box around their sum.
void lohner_set::keep_all_columns(const std::vector<long>& scales) {
    const std::size_t count = size();
    std::vector<std::size_t> order(columns_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<magnitude> lengths(columns_.size());
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        for (std::size_t i = 0; i < count; ++i) {
            const magnitude part = magnitude(columns_[j][i]) * radii_[j];
            lengths[j] = std::max(lengths[j], scales.empty() ? part : part.shifted(-scales[i]));
        }
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lengths[b] < lengths[a]; });
    const std::size_t left = std::min(order.size(), most_separate_columns * count);
    ball_matrix columns;
    std::vector<magnitude> radii;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t j = order[k];
        if (lengths[j].is_zero()) {
            continue;
        }
        if (k < left) {
            columns.push_back(columns_[j]);
            radii.push_back(radii_[j]);
            continue;
        }
        for (std::size_t i = 0; i < count; ++i) {
            added_[i].add_product(magnitude(columns_[j][i]), radii_[j]);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        columns.emplace_back(count, ball(0))[i] = ball(1);
        radii.emplace_back();
    }
    columns_ = std::move(columns);
    radii_ = std::move(radii);
    blocks_.assign(columns_.size(), 1);
}

}  // namespace libration::ode
