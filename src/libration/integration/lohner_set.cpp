#include "libration/integration/lohner_set.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

using set_column = std::vector<ball>;

ball dot(const set_column& a, const set_column& b) {
    ball sum(0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

set_column unit_vector(std::size_t size, std::size_t k) {
    set_column unit(size, ball(0));
    unit[k] = ball(1);
    return unit;
}

// Nearly orthonormal columns in the given order: a set_column in the span of the others is replaced by the unit vector
// farthest from their span. The last ones in that order are the unit vectors of the coordinates in `zero`, in which all
// columns are 0.
class orthogonal_factor {
public:
    std::vector<set_column> of(const std::vector<set_column>& all, const std::vector<std::size_t>& order,
                               const std::vector<std::size_t>& zero) {
        done_.assign(all.size(), {});
        const std::size_t others = all.size() - zero.size();
        for (std::size_t k = 0; k < zero.size(); ++k) {
            done_[order[others + k]] = unit_vector(all.size(), zero[k]);
            found_.push_back(order[others + k]);
        }
        for (std::size_t k = 0; k < others; ++k) {
            done_[order[k]] = reduced(all[order[k]], all.size());
            found_.push_back(order[k]);
        }
        return std::move(done_);
    }

private:
    set_column reduced(const set_column& given, std::size_t size) const {
        set_column best = without_others(given);
        if (!normalise(best, dot(given, given))) {
            best.clear();
            for (std::size_t k = 0; k < size && best.empty(); ++k) {
                set_column left = without_others(unit_vector(size, k));
                if (normalise(left, from_rational<ball>(rational(1, static_cast<int>(size))))) {
                    best = std::move(left);
                }
            }
        }
        return best;
    }

    // Twice, so that the remainder is orthogonal to the last place.
    set_column without_others(set_column v) const {
        for (int pass = 0; pass < 2; ++pass) {
            for (const std::size_t j : found_) {
                const ball along = exact_midpoint(dot(v, done_[j]));
                for (std::size_t i = 0; i < v.size(); ++i) {
                    v[i] = exact_midpoint(v[i] - along * done_[j][i]);
                }
            }
        }
        return v;
    }

    // Whether more than 2^-40 of the length remains.
    static bool normalise(set_column& v, const ball& squared_length) {
        const ball left = exact_midpoint(dot(v, v));
        const ball least = exact_midpoint(squared_length) * pow(ball(2), -40L);
        if (!certainly_less(least * pow(ball(2), -40L), left)) {
            return false;
        }
        const ball length = exact_midpoint(sqrt(left));
        for (ball& each : v) {
            each = exact_midpoint(each / length);
        }
        return true;
    }

    std::vector<set_column> done_;
    std::vector<std::size_t> found_;
};

// M = Q^T Q = 1 - E: M^-1 - 1 has entries of at most ||E||/(1 - ||E||), and Q^-1 = M^-1 Q^T.
ball_matrix inverse(const std::vector<set_column>& q) {
    const std::size_t size = q.size();
    magnitude norm;
    for (std::size_t i = 0; i < size; ++i) {
        magnitude row;
        for (std::size_t j = 0; j < size; ++j) {
            row += magnitude(dot(q[i], q[j]) - ball(i == j ? 1 : 0));
        }
        norm = std::max(norm, row);
    }
    if (!(norm <= magnitude(1U) / 4U)) {
        throw precision_exhausted("an error set");
    }
    const ball error = widened(ball(0), norm * magnitude(4U) / 3U);
    ball_matrix result(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            ball sum = q[i][k];
            for (std::size_t j = 0; j < size; ++j) {
                sum += error * q[j][k];
            }
            result[i].push_back(sum);
        }
    }
    return result;
}

}  // namespace

magnitude reach_of_row(const std::vector<ball>& row, const std::vector<std::size_t>& blocks,
                       const std::vector<magnitude>& radii) {
    magnitude sum;
    std::size_t set_column = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        magnitude norm(row[set_column++]);
        for (std::size_t k = 1; k < blocks[b]; ++k) {
            norm = hypotenuse(norm, magnitude(row[set_column++]));
        }
        sum.add_product(norm, radii[b]);
    }
    return sum;
}

lohner_set::lohner_set(std::vector<magnitude> radii)
    : blocks_(radii.size(), 1), radii_(std::move(radii)), added_(radii_.size()) {
    for (std::size_t i = 0; i < size(); ++i) {
        columns_.push_back(unit_vector(size(), i));
    }
}

magnitude lohner_set::reach(std::size_t i) const {
    set_column row;
    for (const set_column& each : columns_) {
        row.push_back(each[i]);
    }
    return reach_of_row(row, blocks_, radii_) + added_[i];
}

magnitude lohner_set::reach(const ball_matrix& map, std::size_t i) const {
    set_column row;
    magnitude sum;
    for (std::size_t j = 0; j < size(); ++j) {
        sum.add_product(magnitude(map[i][j]), added_[j]);
    }
    for (const set_column& each : columns_) {
        row.push_back(dot(map[i], each));
    }
    return sum + reach_of_row(row, blocks_, radii_);
}

std::vector<magnitude> lohner_set::radii_of_columns() const {
    std::vector<magnitude> result;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        result.insert(result.end(), blocks_[b], radii_[b]);
    }
    return result;
}

void lohner_set::add_coordinate(const std::vector<ball>& row, magnitude added) {
    for (std::size_t j = 0; j < row.size(); ++j) {
        added.add_product(magnitude(row[j]), added_[j]);
    }
    for (set_column& each : columns_) {
        each.push_back(dot(row, each));
    }
    added_.push_back(added);
}

lohner_set lohner_set::image(const ball_matrix& map, const std::vector<magnitude>& added) const {
    lohner_set result(ball_matrix(columns_.size()), blocks_, radii_, added);
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t j = 0; j < columns_.size(); ++j) {
            result.columns_[j].push_back(dot(map[i], columns_[j]));
            if (!is_finite(result.columns_[j][i])) {
                throw precision_exhausted("an error map");
            }
        }
        for (std::size_t j = 0; j < size(); ++j) {
            result.added_[i].add_product(magnitude(map[i][j]), added_[j]);
        }
    }
    return result;
}

lohner_set lohner_set::settled(const std::vector<long>& scales) const {
    if (columns_.size() > size()) {
        return settled_behind(columns_.size() - size(), scales);
    }
    const auto scale_of = [&](std::size_t i) { return scales.empty() ? 0 : scales[i]; };
    const std::vector<magnitude> radii = radii_of_columns();
    std::vector<set_column> midpoints(size());
    std::vector<set_column> scaled(size());
    std::vector<magnitude> lengths(size());
    std::vector<std::size_t> zero;
    for (std::size_t i = 0; i < size(); ++i) {
        const bool is_zero = reach(i).is_zero();
        if (is_zero) {
            zero.push_back(i);
        }
        for (std::size_t j = 0; j < size(); ++j) {
            scaled[j].push_back(ldexp(columns_[j][i], -scale_of(i)));
            midpoints[j].push_back(is_zero ? ball(0) : exact_midpoint(scaled[j][i]));
            lengths[j] += magnitude(scaled[j][i]) * radii[j];
        }
    }
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lengths[b] < lengths[a]; });
    lohner_set result(radii);
    result.columns_ = orthogonal_factor().of(midpoints, order, zero);
    const ball_matrix back = inverse(result.columns_);
    for (std::size_t i = 0; i < size(); ++i) {
        magnitude radius;
        for (std::size_t j = 0; j < size(); ++j) {
            radius += magnitude(dot(back[i], scaled[j])) * radii[j];
            radius += magnitude(back[i][j]) * added_[j] * magnitude::of(1, -scale_of(j));
        }
        result.radii_[i] = radius;
    }
    for (std::size_t k = 0; k < zero.size(); ++k) {
        result.radii_[order[size() - zero.size() + k]] = magnitude();
    }
    for (set_column& each : result.columns_) {
        for (std::size_t i = 0; i < size(); ++i) {
            each[i] = ldexp(each[i], scale_of(i));
        }
    }
    return result;
}

std::vector<ball> state_set::hull() const {
    std::vector<ball> box;
    for (std::size_t i = 0; i < centre.size(); ++i) {
        box.push_back(widened(centre[i] + 0, reach(i)));
    }
    return box;
}

}  // namespace libration::ode
