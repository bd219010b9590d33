// The sums of the kernels by fast products of whole sequences, for series whose coefficients become known one by one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "libration/series/kernel.hpp"

namespace libration::series {

/// A fast product of whole sequences, provided by a library (expansion/fast_product.hpp has FLINT's).
template <ring R>
class block_product {
public:
    virtual ~block_product() = default;
    /// sums[i] += sum_k a_k b_{length+i-k} for 0 <= i < count <= length: a has `length` terms, b `terms`, which is
    /// `length` or twice that; terms beyond are 0.
    virtual void add_middle(R* sums, int count, const R* a, int length, const R* b, int terms) const = 0;
    /// The smallest length for which that is faster than term by term.
    virtual int least_length() const = 0;
};

/// The sums of term_by_term (kernel.hpp) on arrays at fixed addresses, n after n.
///
/// Of the pairs i + j = n those with i, j below c, the last multiple of a length B that is not above n, have been
/// computed in rectangles: at c, with L = B 2^p the largest such divisor of c, the terms [c-L, c) of either sequence
/// were multiplied by the first 2L of the other, and at c = L the first L by each other, for c <= n < c + L
/// [vdHoeven2002]. The rest, i or j in [c, n], is summed term by term. O(M(N) log N) for all n <= N, M the cost of a
/// fast product. Rounding error of the fast product and of the sums of log N parts.
template <ring R>
class blocked_sums {
public:
    /// For n <= order; term by term without a fast product.
    blocked_sums(const block_product<R>* by, int order) : by_(by), order_(order) {}

    /// Discards all sums: the same arrays contain another series.
    void restart() { all_.clear(); }

    R convolution(const R* a, const R* b, int n, int first, int last, progression of_a) {
        const int m = index_of(n, of_a);
        prepared* const sums = prepared_up_to(a, b, n, m, of_a);
        if (sums == nullptr) {
            return series::convolution(a, b, n, first, last, of_a);
        }
        const int c = sums->known;
        R result = sums->sums[static_cast<std::size_t>(m)];
        result += series::convolution(a, b, n, first, degree_of(m - c, of_a), of_a);
        result += series::convolution(a, b, n, degree_of(c, of_a), last, of_a);
        return result;
    }
    R product(const R* a, const R* b, int n, progression of_a) { return convolution(a, b, n, 0, n, of_a); }
    R pairs(const R* a, int n, int first, progression of_a) {
        const int m = index_of(n, of_a);
        prepared* const sums = of_a.holds(n - of_a.first) ? prepared_up_to(a, a, n, m, of_a) : nullptr;
        if (sums == nullptr) {
            return sum_of_pairs(a, n, first, of_a);
        }
        R result = series::convolution(a, a, n, first, degree_of(m - sums->known, of_a), of_a);
        result += result;
        result += sums->sums[static_cast<std::size_t>(m)];
        return result;
    }

private:
    // Only the terms of one residue each of a and b are used: a' = a_{first + i stride}, and b' likewise. Term n of a b
    // is term m of a' b'.
    struct prepared {
        const R* a;
        const R* b;
        progression of_a;
        progression of_b;
        int length;  // B; 0 if the series are too short
        int known;   // c
        std::vector<R> sums;
    };

    static int index_of(int n, progression of_a) { return n < of_a.first ? 0 : (n - of_a.first) / of_a.stride; }
    static int degree_of(int index, progression of) { return of.first + index * of.stride; }

    // B between the smallest length and twice that, such that the last rectangle ends where the series does.
    int block_length(progression of_a) const {
        const int terms = index_of(order_, of_a) + 1;
        int blocks = 1;
        while (terms / (2 * blocks) >= by_->least_length()) {
            blocks *= 2;
        }
        return blocks == 1 ? 0 : (terms + blocks - 1) / blocks;
    }

    prepared* prepared_up_to(const R* a, const R* b, int n, int m, progression of_a) {
        if (by_ == nullptr || m < by_->least_length()) {
            return nullptr;
        }
        prepared& sums = sums_of(a, b, {of_a.stride, (n - of_a.first) % of_a.stride}, of_a);
        if (sums.length == 0 || m < sums.length) {
            return nullptr;
        }
        while (sums.known + sums.length <= m) {
            sums.known += sums.length;
            add_rectangles(sums);
        }
        return &sums;
    }

    prepared& sums_of(const R* a, const R* b, progression of_b, progression of_a) {
        for (prepared& each : all_) {
            if (each.a == a && each.b == b && each.of_a.first == of_a.first && each.of_a.stride == of_a.stride &&
                each.of_b.first == of_b.first) {
                return each;
            }
        }
        const int length = block_length(of_a);
        const auto terms = static_cast<std::size_t>(length == 0 ? 0 : index_of(order_, of_a) + 1);
        return all_.emplace_back(prepared{a, b, of_a, of_b, length, 0, std::vector<R>(terms, R(0))});
    }

    void add_rectangles(prepared& sums) {
        const int c = sums.known;
        int length = sums.length;
        while (c % (2 * length) == 0) {
            length *= 2;
        }
        const bool square = sums.a == sums.b && sums.of_a.first == sums.of_b.first;
        add_rectangle(sums, sums.a, sums.of_a, sums.b, sums.of_b, length, square && c != length);
        if (!square && c != length) {
            add_rectangle(sums, sums.b, sums.of_b, sums.a, sums.of_a, length, false);
        }
    }

    // [c-L, c) of a times the first 2L of b, or L if c = L; twice.
    void add_rectangle(prepared& sums, const R* a, progression of_a, const R* b, progression of_b, int length,
                       bool twice) {
        const int c = sums.known;
        const int count = std::min(length, static_cast<int>(sums.sums.size()) - c);
        const int terms = c == length ? length : 2 * length;
        R* const target = sums.sums.data() + c;
        if (!twice) {
            by_->add_middle(target, count, terms_of(a, of_a, c - length, length, left_), length,
                            terms_of(b, of_b, 0, terms, right_), terms);
            return;
        }
        std::vector<R> half(static_cast<std::size_t>(count), R(0));
        by_->add_middle(half.data(), count, terms_of(a, of_a, c - length, length, left_), length,
                        terms_of(b, of_b, 0, terms, right_), terms);
        for (int i = 0; i < count; ++i) {
            target[i] += half[static_cast<std::size_t>(i)];
            target[i] += half[static_cast<std::size_t>(i)];
        }
    }

    // Terms first .. first + count - 1 of the residue, contiguous.
    static const R* terms_of(const R* a, progression of, int first, int count, std::vector<R>& room) {
        if (of.stride == 1) {
            return a + first;
        }
        room.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            room[static_cast<std::size_t>(i)] = a[degree_of(first + i, of)];
        }
        return room.data();
    }

    const block_product<R>* by_;
    int order_;
    std::vector<prepared> all_;
    std::vector<R> left_, right_;
};

}  // namespace libration::series
