// The elementary functions of series, one coefficient at a time, as needed for solving a differential equation: each
// new coefficient of the unknown is passed to the functions of it, whose new coefficients determine the next one [paper
// (eCoeffs)].
//
//     NAME_kernel(inputs, auxiliary arrays, result, n)
//
// sets coefficient n of its result and of its auxiliary arrays, for n = 0, 1, 2, ..., from the inputs up to n and its
// own arrays below n. The arrays are owned by the caller, all of them with space for index n: nothing is copied, and a
// caller with several functions of f passes the same f and the same slope f' of slope_kernel() to all of them. A value
// at the centre that only the function itself provides, such as exp f_0, is result[0] before the call with n = 0: the
// kernels therefore work over every field, including fractions and complex numbers, and an initial value may be known
// more accurately than its argument.
//
// Each is the differential equation of its function: e' = f' e; s' = c f', c' = -s f'; f l' = f'; f p' = r f' p; t' =
// (1 + t^2) f'; (1 + f^2) a' = f'; h' = (1 - h^2) f'. Cost O(n) for coefficient n, O(N^2) for all up to N; divided by
// the stride if an input is known to have only every second or third coefficient (progression), in which case the
// caller skips the n where the result has none. The last argument determines how the sums are formed: term by term, or
// in blocks by fast products of whole sequences (blocked_sums.hpp), which then has to be the same object for all n.
#pragma once

#include "libration/series/convolution.hpp"

namespace libration::series {

/// The sums of the kernels, term by term.
struct term_by_term {
    /// sum_{k=first}^{last} a_k b_{n-k}; in all of these the indices that are not read need not be known yet.
    template <ring R>
    R convolution(const R* a, const R* b, int n, int first, int last, progression of_a) const {
        return series::convolution(a, b, n, first, last, of_a);
    }
    /// sum_{k=0}^{n} a_k b_{n-k}.
    template <ring R>
    R product(const R* a, const R* b, int n, progression of_a) const {
        return product_coefficient(a, b, n, of_a);
    }
    /// sum_{k=first}^{n-first} a_k a_{n-k}.
    template <ring R>
    R pairs(const R* a, int n, int first, progression of_a) const {
        return sum_of_pairs(a, n, first, of_a);
    }
};

/// The slope f', one degree behind f: f'_{n-1} = n f_n.
template <ring R>
void slope_kernel(const R* f, R* slope, int n) {
    if (n > 0) {
        slope[n - 1] = f[n] * n;
    }
}

/// p = a b: p_n = sum_{k=0}^{n} a_k b_{n-k}.
template <ring R, class Sums = term_by_term>
void product_kernel(const R* a, const R* b, R* p, int n, progression of_a = parity::any, Sums&& sums = {}) {
    p[n] = sums.product(a, b, n, of_a);
}

/// p = a^2, half of the products.
template <ring R, class Sums = term_by_term>
void square_kernel(const R* a, R* p, int n, progression of_a = parity::any, Sums&& sums = {}) {
    p[n] = sums.pairs(a, n, 0, of_a);
}

/// q = a / b, b_0 nonzero: b_0 q_n = a_n - sum_{k=1}^{n} b_k q_{n-k}.
template <field R, class Sums = term_by_term>
void quotient_kernel(const R* a, const R* b, R* q, int n, progression of_b = parity::any, Sums&& sums = {}) {
    q[n] = (a[n] - sums.convolution(b, q, n, 1, n, of_b)) / b[0];
}

/// r = sqrt f from r_0, of either sign, and 2 r_0: 2 r_0 r_n = f_n - sum_{k=1}^{n-1} r_k r_{n-k}, half the
/// multiplications of a product; half of those if f is even, and n too. f_0 is not read.
template <field R, class Sums = term_by_term>
void square_root_kernel(const R* f, const R& twice_first, R* r, int n, progression of_f = parity::any,
                        Sums&& sums = {}) {
    if (n > 0) {
        r[n] = (f[n] - sums.pairs(r, n, 1, of_f)) / twice_first;
    }
}

/// e = exp f from e_0: n e_n = sum_{k=1}^{n} k f_k e_{n-k}.
template <field R, class Sums = term_by_term>
void exponential_kernel(const R* slope, R* e, int n, progression of_slope = parity::any, Sums&& sums = {}) {
    if (n > 0) {
        e[n] = sums.product(slope, e, n - 1, of_slope) / n;
    }
}

/// s = sin f and c = cos f from s_0 and c_0: n s_n = sum_{k=1}^{n} k f_k c_{n-k}, n c_n = -sum_{k=1}^{n} k f_k s_{n-k}
/// [paper (cosseriesrec), (sinseriesrec), whose labels are exchanged there]. A parity of f' saves half of the products.
template <field R, class Sums = term_by_term>
void sine_cosine_kernel(const R* slope, R* s, R* c, int n, progression of_slope = parity::any, Sums&& sums = {}) {
    if (n > 0) {
        s[n] = sums.product(slope, c, n - 1, of_slope) / n;
        c[n] = -sums.product(slope, s, n - 1, of_slope) / n;
    }
}

/// s = sinh f, c = cosh f from s_0 and c_0: n s_n = sum_{k=1}^{n} k f_k c_{n-k}, n c_n = sum_{k=1}^{n} k f_k s_{n-k}.
template <field R, class Sums = term_by_term>
void hyperbolic_sine_cosine_kernel(const R* slope, R* s, R* c, int n, progression of_slope = parity::any,
                                   Sums&& sums = {}) {
    if (n > 0) {
        s[n] = sums.product(slope, c, n - 1, of_slope) / n;
        c[n] = sums.product(slope, s, n - 1, of_slope) / n;
    }
}

/// l = log f from l_0, storing l': n f_0 l_n = n f_n - sum_{k=1}^{n-1} k l_k f_{n-k}, f_0 nonzero.
template <field R, class Sums = term_by_term>
void logarithm_kernel(const R* f, R* slope_l, R* l, int n, progression of_slope = parity::any, Sums&& sums = {}) {
    if (n > 0) {
        slope_l[n - 1] = (f[n] * n - sums.convolution(slope_l, f, n - 1, 0, n - 2, of_slope)) / f[0];
        l[n] = slope_l[n - 1] / n;
    }
}

/// p = f^r from p_0 for a constant r, storing p': n f_0 p_n = sum_{k=1}^{n} (r k - (n - k)) f_k p_{n-k}, f_0 nonzero.
template <field R, class Sums = term_by_term>
void power_kernel(const R* f, const R* slope, const R& r, R* slope_p, R* p, int n, progression of_f = parity::any,
                  Sums&& sums = {}) {
    if (n > 0) {
        const R rising = sums.product(slope, p, n - 1, degrees_of_slope(of_f)) * r;
        const R falling = sums.convolution(f, slope_p, n - 1, 1, n - 1, of_f);
        p[n] = (rising - falling) / (f[0] * n);
        slope_p[n - 1] = p[n] * n;
    }
}

/// t = tan f from t_0, storing q = 1 + t^2: n t_n = sum_{k=1}^{n} k f_k q_{n-k}. t has the degrees of f.
template <field R, class Sums = term_by_term>
void tangent_kernel(const R* slope, R* q, R* t, int n, progression of_f = parity::any, Sums&& sums = {}) {
    if (n > 0) {
        t[n] = sums.product(slope, q, n - 1, degrees_of_slope(of_f)) / n;
    }
    q[n] = sums.pairs(t, n, 0, of_f) + R(n == 0 ? 1 : 0);
}

/// h = tanh f from h_0, storing q = 1 - h^2: n h_n = sum_{k=1}^{n} k f_k q_{n-k}.
template <field R, class Sums = term_by_term>
void hyperbolic_tangent_kernel(const R* slope, R* q, R* h, int n, progression of_f = parity::any, Sums&& sums = {}) {
    if (n > 0) {
        h[n] = sums.product(slope, q, n - 1, degrees_of_slope(of_f)) / n;
    }
    q[n] = R(n == 0 ? 1 : 0) - sums.pairs(h, n, 0, of_f);
}

/// a = atan f from a_0, storing q = 1 + f^2 and a': n q_0 a_n = n f_n - sum_{k=1}^{n-1} q_k (n - k) a_{n-k}, q_0
/// nonzero.
template <field R, class Sums = term_by_term>
void arctangent_kernel(const R* f, const R* slope, R* q, R* slope_a, R* a, int n, progression of_f = parity::any,
                       Sums&& sums = {}) {
    q[n] = sums.pairs(f, n, 0, of_f) + R(n == 0 ? 1 : 0);
    if (n > 0) {
        quotient_kernel(slope, q, slope_a, n - 1, progression(of_f.stride, 0), sums);
        a[n] = slope_a[n - 1] / n;
    }
}

/// a = asin f from a_0, storing c = cos a from c_0 = sqrt(1 - f_0^2), nonzero, and a': c a' = f', c' = -f a'.
template <field R, class Sums = term_by_term>
void arcsine_kernel(const R* f, const R* slope, R* c, R* slope_a, R* a, int n, progression of_f = parity::any,
                    Sums&& sums = {}) {
    if (n > 0) {
        quotient_kernel(slope, c, slope_a, n - 1, progression(of_f.stride, 0), sums);
        a[n] = slope_a[n - 1] / n;
        c[n] = -sums.product(f, slope_a, n - 1, of_f) / n;
    }
}

}  // namespace libration::series
