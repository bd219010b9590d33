// Highway compiles the code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set of this
// architecture, by including this file again. It is compiled without contraction of products and sums, so that all
// instruction sets round alike.
#include "lane_vectors.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libration/expansion/lane_vectors.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace libration::ode::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using doubles = hn::CappedTag<double, widest_vector>;
using vector = hn::Vec<doubles>;

// The coefficients in some lanes.
class column {
public:
    HWY_INLINE column(const lane_rows& rows, std::size_t place)
        : first_(rows.numbers.data() + place), length_(rows.length) {}
    HWY_INLINE vector operator[](int n) const {
        return hn::LoadU(doubles(), first_ + static_cast<std::size_t>(n) * length_);
    }

private:
    const double* first_;
    std::size_t length_;
};

// sum_{k=first}^{last} a_k b_{n-k}, term by term as in sum_in_fours (step_kernels.cpp).
HWY_INLINE vector sum_of_products(const column& a, const column& b, int n, int first, int last) {
    const doubles d;
    if (first >= last) {
        return first == last ? hn::Mul(a[first], b[n - first]) : hn::Zero(d);
    }
    vector s0 = hn::Zero(d);
    vector s1 = hn::Zero(d);
    vector s2 = hn::Zero(d);
    vector s3 = hn::Zero(d);
    int k = first + 1;
    for (; k + 3 < last; k += 4) {
        s0 = hn::Add(s0, hn::Mul(a[k], b[n - k]));
        s1 = hn::Add(s1, hn::Mul(a[k + 1], b[n - k - 1]));
        s2 = hn::Add(s2, hn::Mul(a[k + 2], b[n - k - 2]));
        s3 = hn::Add(s3, hn::Mul(a[k + 3], b[n - k - 3]));
    }
    if (k < last) {
        s0 = hn::Add(s0, hn::Mul(a[k], b[n - k]));
    }
    if (k + 1 < last) {
        s1 = hn::Add(s1, hn::Mul(a[k + 1], b[n - k - 1]));
    }
    if (k + 2 < last) {
        s2 = hn::Add(s2, hn::Mul(a[k + 2], b[n - k - 2]));
    }
    return hn::Add(hn::Add(hn::Add(s0, s1), hn::Add(s2, s3)),
                   hn::Add(hn::Mul(a[first], b[n - first]), hn::Mul(a[last], b[n - last])));
}

// sum_{k=first}^{n-first} a_k a_{n-k}, each product once.
HWY_INLINE vector sum_of_squares(const column& a, int n, int first) {
    const vector half = sum_of_products(a, a, n, first, (n + 1) / 2 - 1);
    const vector twice = hn::Add(half, half);
    return n % 2 == 0 && n >= 2 * first ? hn::Add(twice, hn::Mul(a[n / 2], a[n / 2])) : twice;
}

// Each of the following is coefficient n of some lanes of a group.

HWY_INLINE vector sum(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    return hn::Add(column(rows, of.left + lane)[n], column(rows, of.right + lane)[n]);
}

HWY_INLINE vector difference(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    return hn::Sub(column(rows, of.left + lane)[n], column(rows, of.right + lane)[n]);
}

HWY_INLINE vector scaled(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    return hn::Mul(column(rows, of.left + lane)[n], hn::LoadU(doubles(), rows.factors.data() + of.factors + lane));
}

HWY_INLINE vector product(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    return sum_of_products(column(rows, of.left + lane), column(rows, of.right + lane), n, 0, n);
}

HWY_INLINE vector square(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    return sum_of_squares(column(rows, of.left + lane), n, 0);
}

HWY_INLINE vector quotient(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    const column b(rows, of.right + lane);
    const vector sum = sum_of_products(b, column(rows, of.result + lane), n, 1, n);
    return hn::Div(hn::Sub(column(rows, of.left + lane)[n], sum), b[0]);
}

HWY_INLINE vector square_root(const lane_group& of, const lane_rows& rows, std::size_t lane, int n) {
    const vector sum = sum_of_squares(column(rows, of.result + lane), n, 1);
    const vector twice_root = hn::LoadU(doubles(), rows.factors.data() + of.factors + lane);
    return hn::Div(hn::Sub(column(rows, of.left + lane)[n], sum), twice_root);
}

template <vector (*coefficient)(const lane_group&, const lane_rows&, std::size_t, int)>
HWY_INLINE void in_all_lanes(const lane_group& of, lane_rows& rows, int n) {
    const doubles d;
    double* const results = rows.row(n) + of.result;
    for (std::size_t lane = 0; lane < of.lanes; lane += hn::Lanes(d)) {
        hn::StoreU(coefficient(of, rows, lane, n), d, results + lane);
    }
}

HWY_INLINE void run_group(const lane_group& of, lane_rows& rows, int n) {
    switch (of.kind) {
        case operation::sum: in_all_lanes<sum>(of, rows, n); break;
        case operation::difference: in_all_lanes<difference>(of, rows, n); break;
        case operation::scaled: in_all_lanes<scaled>(of, rows, n); break;
        case operation::product: in_all_lanes<product>(of, rows, n); break;
        case operation::square: in_all_lanes<square>(of, rows, n); break;
        case operation::quotient: in_all_lanes<quotient>(of, rows, n); break;
        case operation::square_root: in_all_lanes<square_root>(of, rows, n); break;
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::slope:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;  // excluded by has_lanes()
    }
}

// Gathers scattered elements of row n into contiguous ones.
HWY_INLINE void gather(lane_rows& rows, std::ptrdiff_t indices, std::size_t place, std::size_t lanes, int n) {
    const doubles d;
    const hn::RebindToSigned<doubles> whole;
    double* const row = rows.row(n);
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
        const auto from = hn::LoadU(whole, rows.indices.data() + indices + lane);
        hn::StoreU(hn::GatherIndex(d, row, from), d, row + place + lane);
    }
}

void run(std::span<const lane_group> groups, lane_rows& rows, int n) {
    for (const lane_group& of : groups) {
        if (of.gathered_left >= 0) {
            gather(rows, of.gathered_left, of.left, of.lanes, n);
        }
        if (of.gathered_right >= 0) {
            gather(rows, of.gathered_right, of.right, of.lanes, n);
        }
        run_group(of, rows, n);
    }
}

}  // namespace libration::ode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace libration::ode {

HWY_EXPORT(run);

void run_lanes(std::span<const lane_group> groups, lane_rows& rows, int n) {
    HWY_DYNAMIC_DISPATCH(run)(groups, rows, n);
}

}  // namespace libration::ode

#endif
