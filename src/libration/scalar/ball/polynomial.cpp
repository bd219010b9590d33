#include "libration/scalar/ball/polynomial.hpp"

#include <algorithm>
#include <cstdlib>

#include "exponent_blocks.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/ball/product_guard.hpp"
#include "libration/scalar/ball/product_self_test.hpp"
#include "radius_product.hpp"

namespace libration {

namespace {

// The length at which products in blocks and explicit sums take the same time.
int least_in_blocks(slong bits) { return bits < 128 ? 96 : bits < 512 ? 48 : bits < 1000 ? 32 : 20; }

bool fits_in_blocks(const ball* a, int terms) { return std::all_of(a, a + terms, has_moderate_exponents); }

std::vector<ball> as_written(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits) {
    std::vector<ball> c(static_cast<std::size_t>(count));
    for (int n = 0; n < std::min(count, a_terms + b_terms - 1); ++n) {
        const int first = std::max(0, n - b_terms + 1);
        const int last = std::min(n, a_terms - 1);
        arb_dot(c[static_cast<std::size_t>(n)].handle(), nullptr, 0, a[first].handle(), 1, b[n - first].handle(), -1,
                last - first + 1, bits);
    }
    return c;
}

// The midpoints as integers: those of a block times 2^(block.low + scale n).
struct integer_blocks {
    integer_blocks(const ball* a, int terms, long scale, slong bits)
        : blocks(blocks_of_midpoints(a, terms, scale, 3 * bits + 512)), integers(static_cast<std::size_t>(terms)) {
        for (const exponent_block& block : blocks) {
            for (int k = block.first; k < block.first + block.length; ++k) {
                arf_get_fmpz_fixed_si(&integers[static_cast<std::size_t>(k)], arb_midref(a[k].handle()),
                                      block.low + scale * k);
            }
        }
    }

    std::vector<exponent_block> blocks;
    integer_vector integers;
};

// c_{first+k} += 2^(exponent + scale (first + k)) sums_k.
void add_scaled(std::vector<ball>& c, int first, int count, const integer_vector& sums, long exponent, long scale,
                slong bits) {
    fmpz_t power;
    fmpz_init(power);
    for (int k = 0; k < count; ++k) {
        const int n = first + k;
        fmpz_set_si(power, exponent + scale * n);
        arb_struct* const target = c[static_cast<std::size_t>(n)].handle();
        arb_add_fmpz_2exp(target, target, &sums[static_cast<std::size_t>(k)], power, bits);
    }
    fmpz_clear(power);
}

// The products of the midpoints, exact up to one rounding per pair of blocks. In a square, every pair of two different
// blocks occurs twice.
void add_midpoints(std::vector<ball>& c, const integer_blocks& a, const integer_blocks& b, long scale, slong bits) {
    integer_vector sums(c.size());
    const bool square = &a == &b;
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        for (std::size_t j = square ? i : 0; j < b.blocks.size(); ++j) {
            const exponent_block& left = a.blocks[i];
            const exponent_block& right = b.blocks[j];
            const int first = left.first + right.first;
            const int count = std::min(static_cast<int>(c.size()) - first, left.length + right.length - 1);
            if (count > 0) {
                guarded_product(sums.data(), a.integers.data() + left.first, left.length,
                                b.integers.data() + right.first, right.length, count);
                add_scaled(c, first, count, sums, left.low + right.low + (square && i != j ? 1 : 0), scale, bits);
            }
        }
    }
}

std::vector<ball> in_blocks(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits) {
    require_flint_products();
    std::vector<ball> c(static_cast<std::size_t>(count));
    const long scale = common_slope(a, a_terms, b, b_terms);
    const integer_blocks left(a, a_terms, scale, bits);
    if (a == b && a_terms == b_terms) {
        add_midpoints(c, left, left, scale, bits);
    } else {
        add_midpoints(c, left, integer_blocks(b, b_terms, scale, bits), scale, bits);
    }
    add_radii(c, a, a_terms, b, b_terms, scale);
    return c;
}

// The recurrence, which loses digits faster than Newton's iteration.
void divide_by_recurrence(std::vector<ball>& q, const ball* a, const ball* b, const ball& inverse, int count,
                          slong bits) {
    for (int n = 0; n < count; ++n) {
        arb_struct* const target = q[static_cast<std::size_t>(n)].handle();
        if (n > 0) {
            arb_dot(target, a[n].handle(), 1, b[1].handle(), 1, q[static_cast<std::size_t>(n) - 1].handle(), -1, n,
                    bits);
            arb_mul(target, target, inverse.handle(), bits);
        } else {
            arb_div(target, a[0].handle(), b[0].handle(), bits);
        }
    }
}

// v of `count` terms with b v = 1, b of as many terms at least.
std::vector<ball> reciprocal(const ball* b, const ball& inverse, int count, slong bits) {
    constexpr int by_recurrence = 4;
    if (count <= by_recurrence) {
        std::vector<ball> one(static_cast<std::size_t>(count));
        std::vector<ball> v = one;
        arb_one(one[0].handle());
        divide_by_recurrence(v, one.data(), b, inverse, count, bits);
        return v;
    }
    const int known = (count + 1) / 2;
    std::vector<ball> v = reciprocal(b, inverse, known, bits);
    const std::vector<ball> w = leading_product(b, count, v.data(), known, count, bits);
    const std::vector<ball> next =
        leading_product(v.data(), known, w.data() + known, count - known, count - known, bits);
    for (const ball& each : next) {
        v.push_back(-each);
    }
    return v;
}

// The difference of terms m .. n-1 of a and of b q, as computed from m terms of q.
std::vector<ball> remainder(const ball* a, const ball* b, const std::vector<ball>& q, int count, slong bits) {
    const int known = static_cast<int>(q.size());
    std::vector<ball> d = leading_product(b, count, q.data(), known, count, bits);
    d.erase(d.begin(), d.begin() + known);
    for (int k = 0; k < count - known; ++k) {
        arb_struct* const target = d[static_cast<std::size_t>(k)].handle();
        arb_sub(target, a[known + k].handle(), target, bits);
    }
    return d;
}

}  // namespace

std::vector<ball> leading_product(const ball* a, int a_terms, const ball* b, int b_terms, int count, slong bits) {
    static_assert(sizeof(ball) == sizeof(arb_struct), "FLINT iterates over an array of balls");
    a_terms = std::min(a_terms, count);
    b_terms = std::min(b_terms, count);
    const bool blocks =
        std::min(a_terms, b_terms) >= least_in_blocks(bits) && fits_in_blocks(a, a_terms) && fits_in_blocks(b, b_terms);
    return (blocks ? in_blocks : as_written)(a, a_terms, b, b_terms, count, bits);
}

std::vector<ball> whole_product(const std::vector<ball>& a, const std::vector<ball>& b) {
    const int count = static_cast<int>(std::min(a.size(), b.size()));
    return leading_product(a.data(), count, b.data(), count, count, ball::working_bits());
}

std::vector<ball> whole_quotient(const std::vector<ball>& a, const std::vector<ball>& b) {
    const slong bits = ball::working_bits();
    const int count = static_cast<int>(std::min(a.size(), b.size()));
    std::vector<ball> q(static_cast<std::size_t>(count));
    const ball inverse = ball(1) / b[0];
    if (!is_finite(inverse)) {
        std::fill(q.begin(), q.end(), inverse);
        return q;
    }
    constexpr int by_recurrence = 16;
    if (count <= by_recurrence) {
        divide_by_recurrence(q, a.data(), b.data(), inverse, count, bits);
        return q;
    }
    const int known = (count + 1) / 2;
    const std::vector<ball> v = reciprocal(b.data(), inverse, known, bits);
    q = leading_product(a.data(), known, v.data(), known, known, bits);
    const std::vector<ball> d = remainder(a.data(), b.data(), q, count, bits);
    const int left = count - known;
    const std::vector<ball> next = leading_product(v.data(), left, d.data(), left, left, bits);
    q.insert(q.end(), next.begin(), next.end());
    return q;
}

}  // namespace libration
