// Sums of products of magnitudes in doubles.
//
// Each magnitude of a block is a double from 2^-300 to 2^300 times one power of 2, rounded up. Products of two of them
// and sums of up to 2^30 such products are then within 2^-600 and 2^630, so that they neither overflow nor underflow,
// and each product and each sum is computed as at least 1 - 2^-52 times the exact one, in any rounding mode. A sum of m
// <= 2^30 products is therefore computed as at least (1 - 2^-52)^(m+1) > 1 - 2^-21 times the exact sum; the factor 1 +
// 2^-20, with one more rounding, makes it an upper bound.
#include "radius_product.hpp"

#include "exponent_blocks.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration {

namespace {

constexpr double for_roundings = 1 + 1.0 / (1 << 20);
constexpr long block_height = 600;
constexpr int most_runs = 4096;

// Magnitudes as doubles, those of a block times 2^(block.low + block_height / 2).
struct double_blocks {
    explicit double_blocks(const std::vector<magnitude>& sizes) : values(sizes.size(), 0) {
        blocks = blocks_of(static_cast<int>(sizes.size()), block_height, [&](int k) -> std::optional<exponent_block> {
            const magnitude& size = sizes[static_cast<std::size_t>(k)];
            return size.is_zero() ? std::nullopt
                                  : std::optional(exponent_block{k, 1, size.exponent() - 1, size.exponent()});
        });
        for (const exponent_block& block : blocks) {
            for (int k = block.first; k < block.first + block.length; ++k) {
                const auto at = static_cast<std::size_t>(k);
                values[at] = sizes[at].shifted(-block.low - block_height / 2).above();
            }
        }
    }

    std::vector<exponent_block> blocks;
    std::vector<double> values;
};

// sums_k = sum_i a_i b_{k-i} for k < count.
void multiply(std::vector<double>& sums, const double* a, int a_terms, const double* b, int b_terms, int count) {
    sums.assign(static_cast<std::size_t>(count), 0);
    for (int i = 0; i < std::min(a_terms, count); ++i) {
        const double factor = a[i];
        double* const from = sums.data() + i;
        const int terms = std::min(b_terms, count - i);
        for (int j = 0; j < terms; ++j) {
            from[j] += factor * b[j];
        }
    }
}

// sums_n += sum_i a_i b_{n-i}, rounded up.
void add_product(std::vector<magnitude>& sums, const double_blocks& a, const double_blocks& b) {
    std::vector<double> part;
    for (const exponent_block& left : a.blocks) {
        for (const exponent_block& right : b.blocks) {
            const int first = left.first + right.first;
            const int count = std::min(static_cast<int>(sums.size()) - first, left.length + right.length - 1);
            if (count <= 0) {
                break;
            }
            multiply(part, &a.values[static_cast<std::size_t>(left.first)], left.length,
                     &b.values[static_cast<std::size_t>(right.first)], right.length, count);
            for (int k = 0; k < count; ++k) {
                const int n = first + k;
                sums[static_cast<std::size_t>(n)] += magnitude::at_least(
                    part[static_cast<std::size_t>(k)] * for_roundings, left.low + right.low + block_height);
            }
        }
    }
}

// |x|, r and |x| + r of a sequence, divided by 2^(scale k): the maxima over runs of `run` neighbours.
struct sizes_in_runs {
    sizes_in_runs(const ball* a, int terms, long scale, int run) {
        const auto runs = static_cast<std::size_t>((terms + run - 1) / run);
        middles.resize(runs);
        radii.resize(runs);
        sums.resize(runs);
        for (int k = 0; k < terms; ++k) {
            const magnitude middle = magnitude::midpoint_of(a[k]).shifted(-scale * k);
            const magnitude radius = magnitude::radius_of(a[k]).shifted(-scale * k);
            const auto at = static_cast<std::size_t>(k / run);
            middles[at] = std::max(middles[at], middle);
            radii[at] = std::max(radii[at], radius);
            sums[at] = std::max(sums[at], middle + radius);
        }
    }

    std::vector<magnitude> middles, radii, sums;
};

}  // namespace

// With runs of w neighbours, n = m w + t and t < w: of the pairs i + j = n, t + 1 in each pair of runs with sum m have
// i = i' w + p, p <= t, and w - 1 - t in each pair of runs with sum m - 1 have p > t.
void add_radii(std::vector<ball>& c, const ball* a, int a_terms, const ball* b, int b_terms, long scale) {
    const int count = static_cast<int>(c.size());
    const int run = (count + most_runs - 1) / most_runs;
    const sizes_in_runs left(a, a_terms, scale, run);
    const sizes_in_runs right(b, b_terms, scale, run);
    std::vector<magnitude> sums(static_cast<std::size_t>((count + run - 1) / run));
    add_product(sums, double_blocks(left.middles), double_blocks(right.radii));
    add_product(sums, double_blocks(left.radii), double_blocks(right.sums));
    for (int n = 0; n < count; ++n) {
        const auto m = static_cast<std::size_t>(n / run);
        const auto t = static_cast<unsigned>(n % run);
        magnitude radius = sums[m] * magnitude(t + 1);
        if (run > 1 && m > 0) {
            radius.add_product(sums[m - 1], magnitude(static_cast<unsigned>(run) - 1 - t));
        }
        mag_struct* const target = arb_radref(c[static_cast<std::size_t>(n)].handle());
        mag_add(target, target, radius.shifted(scale * n).handle());
    }
}

}  // namespace libration
