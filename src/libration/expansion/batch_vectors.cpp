// Highway compiles the code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set of this
// architecture, by including this file again. It is compiled without contraction of products and sums, so that all
// instruction sets round alike.
#include "batch_vectors.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libration/expansion/batch_vectors.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace libration::ode::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using doubles = hn::CappedTag<double, batch_lanes>;
using vector = hn::Vec<doubles>;

constexpr std::size_t vector_lanes = hn::MaxLanes(doubles());
static_assert(batch_lanes % vector_lanes == 0);

// The coefficients in the lanes of one vector.
class column {
public:
    HWY_INLINE explicit column(const double* first) : first_(first) {}
    HWY_INLINE vector operator[](int n) const {
        return hn::Load(doubles(), first_ + static_cast<std::size_t>(n) * batch_lanes);
    }

private:
    const double* first_;
};

HWY_INLINE void store(vector x, double* first, int n) {
    hn::Store(x, doubles(), first + static_cast<std::size_t>(n) * batch_lanes);
}

// x/n, rounded to nearest in the normal range. With a fused operation by r = 1/n rounded: q = x r is within two units of
// x/n, x - q n is exact, and adding its product with r leaves an error below 2^-50 units before the last rounding, while
// x/n is not the midpoint of two doubles (n times a number of 54 bits has no 53) and at least 1/(2n) units from the next one.
HWY_INLINE vector over(vector x, const degree& n) {
    const doubles d;
    const vector by = hn::Set(d, n.value);
#if HWY_NATIVE_FMA
    const vector reciprocal = hn::Set(d, n.reciprocal);
    const vector quotient = hn::Mul(x, reciprocal);
    return hn::MulAdd(hn::NegMulAdd(quotient, by, x), reciprocal, quotient);
#else
    return hn::Div(x, by);
#endif
}

// The four partial sums of sum_{k=first}^{last} a_k b_{n-k}: terms 0, 4, .. in the first one, and so on.
struct partial_sums {
    vector s0, s1, s2, s3;

    HWY_INLINE vector in_pairs() const { return hn::Add(hn::Add(s0, s1), hn::Add(s2, s3)); }
    HWY_INLINE vector crosswise() const { return hn::Add(hn::Add(s0, s2), hn::Add(s1, s3)); }
};

HWY_INLINE partial_sums no_sums() {
    const vector zero = hn::Zero(doubles());
    return {zero, zero, zero, zero};
}

HWY_INLINE void add_product(vector& sum, vector a, vector b) { sum = hn::Add(sum, hn::Mul(a, b)); }

// The terms of sum_{k=first}^{last} a_k b_{n-k} and sum_{k=first}^{last+1} a_k b_{n+1-k} without the first and the last
// one: in one loop, which reads each coefficient once for both.
class sums_of_two_degrees {
public:
    HWY_INLINE sums_of_two_degrees(const column& a, const column& b, int n, int first, int last)
        : a_(a), b_(b), n_(n), later_(b[n - first]) {
        int k = first + 1;
        for (; k + 3 < last; k += 4) {
            add(now.s0, next.s0, k);
            add(now.s1, next.s1, k + 1);
            add(now.s2, next.s2, k + 2);
            add(now.s3, next.s3, k + 3);
        }
        const int left = last - k;
        if (left == 0) {
            add_product(next.s0, a_[last], later_);
            return;
        }
        add(now.s0, next.s0, k);
        if (left == 1) {
            add_product(next.s1, a_[last], later_);
            return;
        }
        add(now.s1, next.s1, k + 1);
        if (left == 2) {
            add_product(next.s2, a_[last], later_);
            return;
        }
        add(now.s2, next.s2, k + 2);
        add_product(next.s3, a_[last], later_);
    }

    partial_sums now = no_sums(), next = no_sums();

private:
    HWY_INLINE void add(vector& to_now, vector& to_next, int k) {
        const vector x = a_[k];
        add_product(to_next, x, later_);
        later_ = b_[n_ - k];
        add_product(to_now, x, later_);
    }

    column a_, b_;
    int n_;
    vector later_;  // b_{n+1-k} for the next k
};

// sum_{k=first}^{last} a_k b_{n-k}, term by term as in sum_in_fours (step_kernels.cpp), for n = 0, 1, 2, .. in turn,
// with last + 1 for n + 1; at an even n, `ahead` receives the inner terms for n + 1.
HWY_INLINE vector sum_of_products(const column& a, const column& b, int n, int first, int last, double* ahead) {
    const doubles d;
    vector inner = hn::Zero(d);
    if (n % 2 != 0) {
        inner = hn::Load(d, ahead);
    } else if (first < last) {
        const sums_of_two_degrees sums(a, b, n, first, last);
        hn::Store(sums.next.in_pairs(), d, ahead);
        inner = sums.now.in_pairs();
    } else {
        hn::Store(inner, d, ahead);
    }
    if (first >= last) {
        return first == last ? hn::Mul(a[first], b[n - first]) : hn::Zero(d);
    }
    return hn::Add(inner, hn::Add(hn::Mul(a[first], b[n - first]), hn::Mul(a[last], b[n - last])));
}

// sum_{k=first}^{last} a_k b_{n-k} like sum_in_lanes (fixed_traits.hpp).
HWY_INLINE vector sum_in_turns(const column& a, const column& b, int n, int first, int last) {
    partial_sums sums = no_sums();
    int k = first;
    for (; k + 3 <= last; k += 4) {
        add_product(sums.s0, a[k], b[n - k]);
        add_product(sums.s1, a[k + 1], b[n - k - 1]);
        add_product(sums.s2, a[k + 2], b[n - k - 2]);
        add_product(sums.s3, a[k + 3], b[n - k - 3]);
    }
    if (k <= last) {
        add_product(sums.s0, a[k], b[n - k]);
    }
    if (k + 1 <= last) {
        add_product(sums.s1, a[k + 1], b[n - k - 1]);
    }
    if (k + 2 <= last) {
        add_product(sums.s2, a[k + 2], b[n - k - 2]);
    }
    return sums.crosswise();
}

// sum_{k=0}^{n} a_k b_{n-k} and the same with c, by sum_in_turns: in one loop, because the second sum does not wait for
// the first one then, and a is read once.
struct two_sums {
    vector of_b, of_c;
};

HWY_INLINE two_sums sums_with_both(const column& a, const column& b, const column& c, int n) {
    partial_sums with_b = no_sums();
    partial_sums with_c = no_sums();
    const auto add = [&](vector& to_b, vector& to_c, int k) {
        const vector x = a[k];
        add_product(to_b, x, b[n - k]);
        add_product(to_c, x, c[n - k]);
    };
    int k = 0;
    for (; k + 3 <= n; k += 4) {
        add(with_b.s0, with_c.s0, k);
        add(with_b.s1, with_c.s1, k + 1);
        add(with_b.s2, with_c.s2, k + 2);
        add(with_b.s3, with_c.s3, k + 3);
    }
    if (k <= n) {
        add(with_b.s0, with_c.s0, k);
    }
    if (k + 1 <= n) {
        add(with_b.s1, with_c.s1, k + 1);
    }
    if (k + 2 <= n) {
        add(with_b.s2, with_c.s2, k + 2);
    }
    return {with_b.crosswise(), with_c.crosswise()};
}

// sum_{k=0}^{n} a_k b_{n-k} and the same with c, term by term as in sine_cosine (step_kernels.cpp): of an even
// degree together with the inner terms of the next one, which ahead_b and ahead_c receive.
HWY_INLINE two_sums sums_by_slope(const column& a, const column& b, const column& c, int n, double* ahead_b,
                                  double* ahead_c) {
    const doubles d;
    const vector zero = hn::Zero(d);
    vector inner_b = zero;
    vector inner_c = zero;
    if (n % 2 != 0) {
        inner_b = hn::Load(d, ahead_b);
        inner_c = hn::Load(d, ahead_c);
    } else {
        partial_sums now{zero, zero, zero, zero};  // two of b, two of c
        partial_sums next = now;
        const auto add = [&](vector& now_b, vector& now_c, vector& next_b, vector& next_c, int k) {
            const vector x = a[k];
            add_product(now_b, x, b[n - k]);
            add_product(now_c, x, c[n - k]);
            add_product(next_b, x, b[n + 1 - k]);
            add_product(next_c, x, c[n + 1 - k]);
        };
        int k = 1;
        for (; k + 1 < n; k += 2) {
            add(now.s0, now.s2, next.s0, next.s2, k);
            add(now.s1, now.s3, next.s1, next.s3, k + 1);
        }
        if (k < n) {  // then the last term of the next degree is at k + 1
            add(now.s0, now.s2, next.s0, next.s2, k);
            add_product(next.s1, a[n], b[1]);
            add_product(next.s3, a[n], c[1]);
        }
        inner_b = hn::Add(now.s0, now.s1);
        inner_c = hn::Add(now.s2, now.s3);
        hn::Store(hn::Add(next.s0, next.s1), d, ahead_b);
        hn::Store(hn::Add(next.s2, next.s3), d, ahead_c);
    }
    vector outer_b = hn::Mul(a[0], b[n]);
    vector outer_c = hn::Mul(a[0], c[n]);
    if (n > 0) {
        add_product(outer_b, a[n], b[0]);
        add_product(outer_c, a[n], c[0]);
    }
    return {hn::Add(outer_b, inner_b), hn::Add(outer_c, inner_c)};
}

// sum_{k=first}^{n-first} a_k a_{n-k}, each product once.
HWY_INLINE vector sum_of_squares(const column& a, int n, int first, double* ahead) {
    const vector half = sum_of_products(a, a, n, first, (n + 1) / 2 - 1, ahead);
    const vector twice = hn::Add(half, half);
    return n % 2 == 0 && n >= 2 * first ? hn::Add(twice, hn::Mul(a[n / 2], a[n / 2])) : twice;
}

// sum_{k=0}^{n} a_k a_{n-k}, n > 0, like sum_of_pairs (convolution.hpp).
HWY_INLINE vector square_in_turns(const column& a, int n) {
    const vector half = sum_in_turns(a, a, n, 0, (n - 1) / 2);
    const vector twice = hn::Add(half, half);
    return n % 2 == 0 ? hn::Add(twice, hn::Mul(a[n / 2], a[n / 2])) : twice;
}

// Each of the following computes coefficient n of a step in the lanes of one vector.

HWY_INLINE void run_sum(const lane_step& of, std::size_t lane, const degree& at) {
    store(hn::Add(column(of.a + lane)[at.n], column(of.b + lane)[at.n]), of.result + lane, at.n);
}

HWY_INLINE void run_difference(const lane_step& of, std::size_t lane, const degree& at) {
    store(hn::Sub(column(of.a + lane)[at.n], column(of.b + lane)[at.n]), of.result + lane, at.n);
}

HWY_INLINE void run_multiple(const lane_step& of, std::size_t lane, const degree& at) {
    const vector product = hn::Mul(column(of.a + lane)[at.n], hn::Set(doubles(), of.factor));
    store(of.divisor.n == 1 ? product : over(product, of.divisor), of.result + lane, at.n);
}

HWY_INLINE void run_lane_multiple(const lane_step& of, std::size_t lane, const degree& at) {
    store(hn::Mul(column(of.a + lane)[at.n], column(of.b + lane)[0]), of.result + lane, at.n);
}

HWY_INLINE void run_product(const lane_step& of, std::size_t lane, const degree& at) {
    store(sum_of_products(column(of.a + lane), column(of.b + lane), at.n, 0, at.n, of.ahead + lane), of.result + lane,
          at.n);
}

HWY_INLINE void run_square(const lane_step& of, std::size_t lane, const degree& at) {
    store(sum_of_squares(column(of.a + lane), at.n, 0, of.ahead + lane), of.result + lane, at.n);
}

HWY_INLINE void run_quotient(const lane_step& of, std::size_t lane, const degree& at) {
    const column b(of.b + lane);
    const vector sum = sum_of_products(b, column(of.result + lane), at.n, 1, at.n, of.ahead + lane);
    store(hn::Div(hn::Sub(column(of.a + lane)[at.n], sum), b[0]), of.result + lane, at.n);
}

HWY_INLINE void run_lane_quotient(const lane_step& of, std::size_t lane, const degree& at) {
    store(hn::Div(column(of.a + lane)[at.n], column(of.b + lane)[0]), of.result + lane, at.n);
}

HWY_INLINE void run_copy(const lane_step& of, std::size_t lane, const degree& at) {
    store(column(of.a + lane)[at.n], of.result + lane, at.n);
}

HWY_INLINE void run_square_root(const lane_step& of, std::size_t lane, const degree& at) {
    const vector sum = sum_of_squares(column(of.result + lane), at.n, 1, of.ahead + lane);
    store(hn::Div(hn::Sub(column(of.a + lane)[at.n], sum), column(of.behind + lane)[0]), of.result + lane, at.n);
}

HWY_INLINE void run_primitive(const lane_step& of, std::size_t lane, const degree& at) {
    const int n = at.n - 1;
    const vector sum = sum_of_products(column(of.b + lane), column(of.derivative + lane), n, 0, n, of.ahead + lane);
    store(over(sum, at), of.result + lane, at.n);
}

HWY_INLINE void run_exponential(const lane_step& of, std::size_t lane, const degree& at) {
    const int n = at.n - 1;
    store(over(sum_in_turns(column(of.b + lane), column(of.result + lane), n, 0, n), at), of.result + lane, at.n);
}

// n f_n in the array of the slope.
HWY_INLINE void run_slope(const lane_step& of, std::size_t lane, const degree& at) {
    const int n = at.n;
    if (n > 0) {
        const vector times = hn::Set(doubles(), at.value);
        store(hn::Mul(column(of.a + lane)[n], times), of.result + lane, n - 1);
    }
}

HWY_INLINE void run_sine_cosine(const lane_step& of, std::size_t lane, const degree& at) {
    const two_sums sums = sums_by_slope(column(of.b + lane), column(of.behind + lane), column(of.result + lane),
                                        at.n - 1, of.ahead + lane, of.ahead + batch_lanes + lane);
    store(over(sums.of_b, at), of.result + lane, at.n);
    store(over(hn::Neg(sums.of_c), at), of.behind + lane, at.n);
}

HWY_INLINE void run_hyperbolic_sine_cosine(const lane_step& of, std::size_t lane, const degree& at) {
    const two_sums sums =
        sums_with_both(column(of.b + lane), column(of.behind + lane), column(of.result + lane), at.n - 1);
    store(over(sums.of_b, at), of.result + lane, at.n);
    store(over(sums.of_c, at), of.behind + lane, at.n);
}

HWY_INLINE void run_logarithm(const lane_step& of, std::size_t lane, const degree& at) {
    const int n = at.n;
    const column f(of.a + lane);
    const vector sum = sum_in_turns(column(of.behind + lane), f, n - 1, 0, n - 2);
    const vector scaled = hn::Mul(f[n], hn::Set(doubles(), at.value));
    const vector slope = hn::Div(hn::Sub(scaled, sum), f[0]);
    store(slope, of.behind + lane, n - 1);
    store(over(slope, at), of.result + lane, n);
}

HWY_INLINE void run_tangent(const lane_step& of, std::size_t lane, const degree& at, bool hyperbolic) {
    const int n = at.n;
    const column t(of.result + lane);
    store(over(sum_in_turns(column(of.b + lane), column(of.behind + lane), n - 1, 0, n - 1), at), of.result + lane, n);
    const vector square = square_in_turns(t, n);
    store(hyperbolic ? hn::Neg(square) : square, of.behind + lane, n);
}

HWY_INLINE void run_power(const lane_step& of, std::size_t lane, const degree& at) {
    const int n = at.n;
    const doubles d;
    const column a(of.a + lane);
    const column result(of.result + lane);
    const vector degree = hn::Set(d, at.value);
    double* const ahead = of.ahead + lane;
    const vector rising =
        hn::Mul(sum_of_products(column(of.b + lane), result, n - 1, 0, n - 1, ahead), hn::Set(d, of.factor));
    const vector falling = sum_of_products(a, column(of.behind + lane), n - 1, 1, n - 1, ahead + batch_lanes);
    const vector next = hn::Div(hn::Sub(rising, falling), hn::Mul(a[0], degree));
    store(next, of.result + lane, n);
    store(hn::Mul(next, degree), of.behind + lane, n - 1);
}

HWY_INLINE void run_circular_tangent(const lane_step& of, std::size_t lane, const degree& at) {
    run_tangent(of, lane, at, false);
}

HWY_INLINE void run_hyperbolic_tangent(const lane_step& of, std::size_t lane, const degree& at) {
    run_tangent(of, lane, at, true);
}

template <void (*run_in_vector)(const lane_step&, std::size_t, const degree&)>
HWY_INLINE void in_all_lanes(const lane_step& of, const degree& at) {
    for (std::size_t lane = 0; lane < batch_lanes; lane += vector_lanes) {
        run_in_vector(of, lane, at);
    }
}

HWY_INLINE void run_step(const lane_step& of, const degree& at, const std::function<void(int, int)>& otherwise) {
    switch (of.kind) {
        case lane_operation::sum: in_all_lanes<run_sum>(of, at); break;
        case lane_operation::difference: in_all_lanes<run_difference>(of, at); break;
        case lane_operation::multiple: in_all_lanes<run_multiple>(of, at); break;
        case lane_operation::lane_multiple: in_all_lanes<run_lane_multiple>(of, at); break;
        case lane_operation::product: in_all_lanes<run_product>(of, at); break;
        case lane_operation::square: in_all_lanes<run_square>(of, at); break;
        case lane_operation::quotient: in_all_lanes<run_quotient>(of, at); break;
        case lane_operation::lane_quotient: in_all_lanes<run_lane_quotient>(of, at); break;
        case lane_operation::copy: in_all_lanes<run_copy>(of, at); break;
        case lane_operation::square_root: in_all_lanes<run_square_root>(of, at); break;
        case lane_operation::primitive: in_all_lanes<run_primitive>(of, at); break;
        case lane_operation::exponential: in_all_lanes<run_exponential>(of, at); break;
        case lane_operation::slope: in_all_lanes<run_slope>(of, at); break;
        case lane_operation::sine_cosine: in_all_lanes<run_sine_cosine>(of, at); break;
        case lane_operation::hyperbolic_sine_cosine: in_all_lanes<run_hyperbolic_sine_cosine>(of, at); break;
        case lane_operation::logarithm: in_all_lanes<run_logarithm>(of, at); break;
        case lane_operation::tangent: in_all_lanes<run_circular_tangent>(of, at); break;
        case lane_operation::hyperbolic_tangent: in_all_lanes<run_hyperbolic_tangent>(of, at); break;
        case lane_operation::power: in_all_lanes<run_power>(of, at); break;
        case lane_operation::other: otherwise(of.index, at.n); break;
    }
}

// Coefficient n of the unknowns and their lower derivatives.
HWY_INLINE void advance(const lane_program& program, const degree& to) {
    for (const lane_state& each : program.states) {
        for (std::size_t lane = 0; lane < batch_lanes; lane += vector_lanes) {
            store(over(column(each.above + lane)[to.n - 1], to), each.here + lane, to.n);
        }
    }
}

void run(const lane_program& program, const std::function<void(int, int)>& otherwise) {
    for (std::size_t n = 0; n + 1 < program.degrees.size(); ++n) {
        if (static_cast<int>(n) <= program.steps_until) {
            for (const lane_step& each : n == 0 ? program.first : program.later) {
                run_step(each, program.degrees[n], otherwise);
            }
        }
        advance(program, program.degrees[n + 1]);
    }
}

void values(std::span<const double* const> arrays, int order, const double* distances, double* to) {
    const doubles d;
    for (std::size_t lane = 0; lane < batch_lanes; lane += vector_lanes) {
        const vector distance = hn::Load(d, distances + lane);
        for (std::size_t i = 0; i < arrays.size(); ++i) {
            const column c(arrays[i] + lane);
            vector value = c[order];
            for (int n = order - 1; n >= 0; --n) {
                value = hn::Add(hn::Mul(value, distance), c[n]);
            }
            hn::Store(value, d, to + i * batch_lanes + lane);
        }
    }
}

void sizes(std::span<const double* const> arrays, int n, double* to) {
    const doubles d;
    for (std::size_t lane = 0; lane < batch_lanes; lane += vector_lanes) {
        vector largest = hn::Zero(d);
        vector finite = hn::Zero(d);  // 0, NaN with one that is not finite
        for (const double* const each : arrays) {
            const vector c = column(each + lane)[n];
            largest = hn::Max(largest, hn::Abs(c));
            finite = hn::Add(finite, hn::Sub(c, c));
        }
        hn::Store(hn::Add(largest, finite), d, to + lane);
    }
}

}  // namespace libration::ode::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace libration::ode {

HWY_EXPORT(run);
HWY_EXPORT(values);
HWY_EXPORT(sizes);

void run_batch(const lane_program& program, const std::function<void(int, int)>& otherwise) {
    HWY_DYNAMIC_DISPATCH(run)(program, otherwise);
}

void batch_values(std::span<const double* const> arrays, int order, const double* distances, double* values) {
    HWY_DYNAMIC_DISPATCH(values)(arrays, order, distances, values);
}

void batch_sizes(std::span<const double* const> arrays, int n, double* sizes) {
    HWY_DYNAMIC_DISPATCH(sizes)(arrays, n, sizes);
}

}  // namespace libration::ode

#endif
