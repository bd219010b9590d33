// Highway compiles the code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set of this
// architecture, by including this file again. It is compiled without contraction of products and sums, so that all
// instruction sets round alike.
#include "libration/ode/batch/batch_vectors.hpp"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libration/ode/batch/batch_vectors.cpp"
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

HWY_INLINE partial_sums sums_in_fours(const column& a, const column& b, int n, int first, int& last) {
    const vector zero = hn::Zero(doubles());
    partial_sums sums{zero, zero, zero, zero};
    int k = first;
    for (; k + 3 <= last; k += 4) {
        sums.s0 = hn::Add(sums.s0, hn::Mul(a[k], b[n - k]));
        sums.s1 = hn::Add(sums.s1, hn::Mul(a[k + 1], b[n - k - 1]));
        sums.s2 = hn::Add(sums.s2, hn::Mul(a[k + 2], b[n - k - 2]));
        sums.s3 = hn::Add(sums.s3, hn::Mul(a[k + 3], b[n - k - 3]));
    }
    last = k;  // the first term that is left
    return sums;
}

// sum_{k=first}^{last} a_k b_{n-k} like sum_in_fours (placed_steps.hpp): what is left in the first partial sum.
HWY_INLINE vector sum_of_products(const column& a, const column& b, int n, int first, int last) {
    int rest = last;
    partial_sums sums = sums_in_fours(a, b, n, first, rest);
    for (; rest <= last; ++rest) {
        sums.s0 = hn::Add(sums.s0, hn::Mul(a[rest], b[n - rest]));
    }
    return sums.in_pairs();
}

// The same like sum_in_lanes (fixed_traits.hpp): what is left in one partial sum after the other.
HWY_INLINE vector sum_in_turns(const column& a, const column& b, int n, int first, int last) {
    int rest = last;
    partial_sums sums = sums_in_fours(a, b, n, first, rest);
    if (rest <= last) {
        sums.s0 = hn::Add(sums.s0, hn::Mul(a[rest], b[n - rest]));
    }
    if (rest + 1 <= last) {
        sums.s1 = hn::Add(sums.s1, hn::Mul(a[rest + 1], b[n - rest - 1]));
    }
    if (rest + 2 <= last) {
        sums.s2 = hn::Add(sums.s2, hn::Mul(a[rest + 2], b[n - rest - 2]));
    }
    return sums.crosswise();
}

// sum_{k=0}^{n} a_k b_{n-k} and the same with c, by sum_of_products or by sum_in_turns: in one loop, because the second
// sum does not wait for the first one then, and a is read once.
struct two_sums {
    vector of_b, of_c;
};

template <bool in_turns>
HWY_INLINE two_sums sums_with_both(const column& a, const column& b, const column& c, int n) {
    const vector zero = hn::Zero(doubles());
    partial_sums first{zero, zero, zero, zero};
    partial_sums second = first;
    const auto add = [&](vector& to_b, vector& to_c, int k) {
        const vector x = a[k];
        to_b = hn::Add(to_b, hn::Mul(x, b[n - k]));
        to_c = hn::Add(to_c, hn::Mul(x, c[n - k]));
    };
    int k = 0;
    for (; k + 3 <= n; k += 4) {
        add(first.s0, second.s0, k);
        add(first.s1, second.s1, k + 1);
        add(first.s2, second.s2, k + 2);
        add(first.s3, second.s3, k + 3);
    }
    if (k <= n) {
        add(first.s0, second.s0, k);
    }
    if (k + 1 <= n) {
        add(in_turns ? first.s1 : first.s0, in_turns ? second.s1 : second.s0, k + 1);
    }
    if (k + 2 <= n) {
        add(in_turns ? first.s2 : first.s0, in_turns ? second.s2 : second.s0, k + 2);
    }
    return in_turns ? two_sums{first.crosswise(), second.crosswise()} : two_sums{first.in_pairs(), second.in_pairs()};
}

// sum_{k=first}^{n-first} a_k a_{n-k}, each product once.
HWY_INLINE vector sum_of_squares(const column& a, int n, int first) {
    const vector half = sum_of_products(a, a, n, first, (n + 1) / 2 - 1);
    const vector twice = hn::Add(half, half);
    return n % 2 == 0 && n >= 2 * first ? hn::Add(twice, hn::Mul(a[n / 2], a[n / 2])) : twice;
}

// sum_{k=0}^{n} a_k a_{n-k}, n > 0, like sum_of_pairs (convolution.hpp).
HWY_INLINE vector square_in_turns(const column& a, int n) {
    const vector half = sum_in_turns(a, a, n, 0, (n - 1) / 2);
    const vector twice = hn::Add(half, half);
    return n % 2 == 0 ? hn::Add(twice, hn::Mul(a[n / 2], a[n / 2])) : twice;
}

// The steps that only read coefficients of their operands and of themselves.
HWY_INLINE vector algebraic(const lane_step& of, std::size_t lane, const degree& at) {
    const doubles d;
    const int n = at.n;
    const column a(of.a + lane);
    const column b(of.b + lane);
    const column result(of.result + lane);
    switch (of.kind) {
        case lane_operation::sum: return hn::Add(a[n], b[n]);
        case lane_operation::difference: return hn::Sub(a[n], b[n]);
        case lane_operation::multiple: {
            const vector product = hn::Mul(a[n], hn::Set(d, of.factor));
            return of.divisor.n == 1 ? product : over(product, of.divisor);
        }
        case lane_operation::lane_multiple: return hn::Mul(a[n], b[0]);
        case lane_operation::product: return sum_of_products(a, b, n, 0, n);
        case lane_operation::square: return sum_of_squares(a, n, 0);
        case lane_operation::quotient: return hn::Div(hn::Sub(a[n], sum_of_products(b, result, n, 1, n)), b[0]);
        case lane_operation::lane_quotient: return hn::Div(a[n], b[0]);
        case lane_operation::copy: return a[n];
        case lane_operation::square_root:
            return hn::Div(hn::Sub(a[n], sum_of_squares(result, n, 1)), column(of.behind + lane)[0]);
        case lane_operation::primitive:
            return over(sum_of_products(b, column(of.derivative + lane), n - 1, 0, n - 1), at);
        case lane_operation::exponential: return over(sum_in_turns(b, result, n - 1, 0, n - 1), at);
        case lane_operation::slope:
        case lane_operation::sine_cosine:
        case lane_operation::hyperbolic_sine_cosine:
        case lane_operation::logarithm:
        case lane_operation::tangent:
        case lane_operation::hyperbolic_tangent:
        case lane_operation::power:
        case lane_operation::other: break;
    }
    return hn::Zero(d);  // excluded by run_step
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
    const two_sums sums =
        sums_with_both<false>(column(of.b + lane), column(of.behind + lane), column(of.result + lane), at.n - 1);
    store(over(sums.of_b, at), of.result + lane, at.n);
    store(over(hn::Neg(sums.of_c), at), of.behind + lane, at.n);
}

HWY_INLINE void run_hyperbolic_sine_cosine(const lane_step& of, std::size_t lane, const degree& at) {
    const two_sums sums =
        sums_with_both<true>(column(of.b + lane), column(of.behind + lane), column(of.result + lane), at.n - 1);
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
    const vector rising = hn::Mul(sum_of_products(column(of.b + lane), result, n - 1, 0, n - 1), hn::Set(d, of.factor));
    const vector falling = sum_of_products(a, column(of.behind + lane), n - 1, 1, n - 1);
    const vector next = hn::Div(hn::Sub(rising, falling), hn::Mul(a[0], degree));
    store(next, of.result + lane, n);
    store(hn::Mul(next, degree), of.behind + lane, n - 1);
}

HWY_INLINE void run_step(const lane_step& of, const degree& at, const std::function<void(int, int)>& otherwise) {
    if (of.kind == lane_operation::other) {
        otherwise(of.index, at.n);
        return;
    }
    for (std::size_t lane = 0; lane < batch_lanes; lane += vector_lanes) {
        switch (of.kind) {
            case lane_operation::slope: run_slope(of, lane, at); break;
            case lane_operation::sine_cosine: run_sine_cosine(of, lane, at); break;
            case lane_operation::hyperbolic_sine_cosine: run_hyperbolic_sine_cosine(of, lane, at); break;
            case lane_operation::logarithm: run_logarithm(of, lane, at); break;
            case lane_operation::tangent: run_tangent(of, lane, at, false); break;
            case lane_operation::hyperbolic_tangent: run_tangent(of, lane, at, true); break;
            case lane_operation::power: run_power(of, lane, at); break;
            case lane_operation::sum:
            case lane_operation::difference:
            case lane_operation::multiple:
            case lane_operation::lane_multiple:
            case lane_operation::product:
            case lane_operation::square:
            case lane_operation::quotient:
            case lane_operation::lane_quotient:
            case lane_operation::copy:
            case lane_operation::square_root:
            case lane_operation::primitive:
            case lane_operation::exponential: store(algebraic(of, lane, at), of.result + lane, at.n); break;
            case lane_operation::other: break;
        }
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
