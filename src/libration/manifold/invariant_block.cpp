#include "invariant_block.hpp"

#include <algorithm>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "linear_steps.hpp"

namespace libration::ode {

namespace {

constexpr int most_subspace_steps = 40;
constexpr int most_subspace_boxes = 12;

complex_jet midpoint_jet(const complex_jet& x) {
    return complex_ball(exact_midpoint(x.value.re), exact_midpoint(x.value.im));
}

complex_jet without_slopes(const complex_jet& x) { return x.value; }

// The equation of V; its unknowns are the other rows of V, one after the other.
class subspace_equation {
public:
    subspace_equation(const jet_matrix& a, const std::vector<std::size_t>& pivots) : a_(a), pivots_(pivots) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (std::ranges::find(pivots, i) == pivots.end()) {
                rows_.push_back(i);
            }
        }
    }

    std::vector<complex_jet> unknowns_of(const std::vector<std::vector<complex_jet>>& columns) const {
        std::vector<complex_jet> z;
        for (const std::size_t row : rows_) {
            for (const auto& column : columns) {
                z.push_back(column[row]);
            }
        }
        return z;
    }
    invariant_block at(const std::vector<complex_jet>& z) const {
        const std::size_t size = pivots_.size();
        invariant_block result{jet_matrix(a_.size()), {}};
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const auto first = z.begin() + static_cast<std::ptrdiff_t>(r * size);
            result.columns[rows_[r]] = {first, first + static_cast<std::ptrdiff_t>(size)};
        }
        for (std::size_t b = 0; b < size; ++b) {
            result.columns[pivots_[b]].resize(size);
            result.columns[pivots_[b]][b] = real_jet(ball(1));
        }
        const jet_matrix image = product(a_, result.columns);
        for (const std::size_t pivot : pivots_) {
            result.inner.push_back(image[pivot]);
        }
        return result;
    }
    std::vector<complex_jet> value(const std::vector<complex_jet>& z) const {
        const invariant_block here = at(z);
        const jet_matrix image = product(a_, here.columns);
        const jet_matrix back = product(here.columns, here.inner);
        std::vector<complex_jet> result;
        for (const std::size_t row : rows_) {
            for (std::size_t c = 0; c < pivots_.size(); ++c) {
                result.push_back(image[row][c] - back[row][c]);
            }
        }
        return result;
    }
    // By V_(s,e): d A V - d V M - V d M, of the rows r and the columns c.
    jet_matrix derivative(const std::vector<complex_jet>& z) const {
        const invariant_block here = at(z);
        const std::size_t size = pivots_.size();
        jet_matrix result(z.size(), std::vector<complex_jet>(z.size()));
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            for (std::size_t s = 0; s < rows_.size(); ++s) {
                complex_jet along = without_slopes(a_[rows_[r]][rows_[s]]);
                for (std::size_t b = 0; b < size; ++b) {
                    along.add_product(-without_slopes(here.columns[rows_[r]][b]),
                                      without_slopes(a_[pivots_[b]][rows_[s]]));
                }
                for (std::size_t c = 0; c < size; ++c) {
                    result[r * size + c][s * size + c] += along;
                    for (std::size_t e = 0; e < size && r == s; ++e) {
                        result[r * size + c][s * size + e] -= without_slopes(here.inner[e][c]);
                    }
                }
            }
        }
        return result;
    }
    std::optional<std::vector<complex_jet>> enclosed(std::vector<complex_jet> z) const {
        if (rows_.empty()) {
            return z;  // the block is the whole space
        }
        if (!improve(z)) {
            return std::nullopt;
        }
        const auto near = inverse(derivative(z));
        if (!near) {
            return std::nullopt;
        }
        jet_matrix by = *near;
        for (auto& row : by) {
            std::ranges::transform(row, row.begin(), midpoint_jet);
        }
        std::vector<complex_jet> step = product(by, value(z));
        magnitude largest;
        for (complex_jet& each : step) {
            each = without_slopes(each);
            largest = std::max(largest, size_of_complex(each.value));
        }
        // Of one size, as a step may vanish by chance in some components.
        std::vector<magnitude> radii(z.size(), largest.shifted(2) + magnitude::of(1, -2 * ball::working_bits()));
        for (int k = 0; k < most_subspace_boxes; ++k) {
            if (auto found = in_box(z, by, step, radii)) {
                return with_slopes(*std::move(found));
            }
            for (magnitude& each : radii) {
                each = each.shifted(2);
            }
        }
        return std::nullopt;
    }

private:
    bool improve(std::vector<complex_jet>& z) const {
        magnitude last;
        for (int k = 0; k < most_subspace_steps; ++k) {
            const auto by = inverse(derivative(z));
            if (!by) {
                return k > 0;
            }
            const auto step = product(*by, value(z));
            magnitude size;
            for (std::size_t i = 0; i < z.size(); ++i) {
                const complex_jet now = midpoint_jet(step[i]);
                size = std::max(size, size_of_complex(now.value));
                z[i] = midpoint_jet(z[i] - now);
            }
            if (size.is_zero() || (k > 2 && !(size.shifted(1) < last)) || !size.is_finite()) {
                break;
            }
            last = size;
        }
        return true;
    }

    std::optional<std::vector<complex_jet>> in_box(const std::vector<complex_jet>& z, const jet_matrix& by,
                                                   const std::vector<complex_jet>& step,
                                                   const std::vector<magnitude>& radii) const {
        std::vector<complex_jet> box = z;
        for (std::size_t i = 0; i < z.size(); ++i) {
            box[i] = complex_ball(widened(z[i].value.re, radii[i]), widened(z[i].value.im, radii[i]));
        }
        const jet_matrix rest = product(by, derivative(box));
        std::vector<complex_jet> found;
        for (std::size_t i = 0; i < z.size(); ++i) {
            magnitude reach;
            for (std::size_t j = 0; j < z.size(); ++j) {
                const complex_ball entry = complex_ball(ball(i == j ? 1 : 0), ball(0)) - rest[i][j].value;
                reach.add_product(size_of_complex(entry), radii[j]);
            }
            if (!(size_of_complex(step[i].value) + reach < radii[i])) {
                return std::nullopt;
            }
            const complex_ball at = z[i].value - step[i].value;
            found.emplace_back(complex_ball(widened(at.re, reach), widened(at.im, reach)));
        }
        return found;
    }

    std::optional<std::vector<complex_jet>> with_slopes(std::vector<complex_jet> z) const {
        const auto by = inverse(derivative(z));
        if (!by) {
            return std::nullopt;
        }
        const auto change = product(*by, value(z));  // the slopes of A alone
        for (std::size_t i = 0; i < z.size(); ++i) {
            for (const complex_ball& each : change[i].slopes) {
                z[i].slopes.push_back(-each);
            }
        }
        return z;
    }

    const jet_matrix& a_;
    const std::vector<std::size_t>& pivots_;
    std::vector<std::size_t> rows_;  // the others
};

}  // namespace

std::optional<invariant_block> enclosed_block(const jet_matrix& a, const std::vector<std::size_t>& pivots,
                                              const std::vector<std::vector<complex_jet>>& near) {
    const subspace_equation equation(a, pivots);
    const auto z = equation.enclosed(equation.unknowns_of(near));
    return z ? std::optional(equation.at(*z)) : std::nullopt;
}

}  // namespace libration::ode
