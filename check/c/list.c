#include <stdlib.h>

#include "check.h"

const List nothing = {0, NULL};

List list(long n) {
    List a = {n, take((size_t)n * sizeof *a.c)};
    for (long j = 0; j < n; ++j)
        mpz_init(a.c + j);
    return a;
}

Q norm(List a) {
    Q x = q(0);
    if (a.n == 0)
        return x;
    mpz_ptr total = mpq_numref(x);
    for (long j = 0; j < a.n; ++j)
        if (mpz_sgn(a.c + j) < 0)
            mpz_sub(total, total, a.c + j);
        else
            mpz_add(total, total, a.c + j);
    return minus(plus(x, x), absolute(q_of(a.c)));
}

/* By Clenshaw's recurrence b_j = a_j + 2 x b_(j+1) - b_(j+2); for x = u/v times powers of v. */
Q value(List a, Q x) {
    Q b0 = q(0);
    Q b1 = b0;
    Q b2 = b0;
    Q v = q_of(mpq_denref(x));
    Q vv = times(v, v);
    Q twice_u = q_of(mpq_numref(x));
    Q v_power = q(1);
    twice_u = plus(twice_u, twice_u);
    for (long j = a.n - 1; j >= 0; --j) {
        Q b = plus(times(q_of(a.c + j), v_power), times(twice_u, b0));
        b = minus(b, times(vv, b1));
        b2 = b1;
        b1 = b0;
        b0 = b;
        if (j > 0)
            v_power = times(v_power, v);
    }
    return over(minus(b0, times(vv, b2)), v_power);
}

/* T_k' = 2 k (T_(k-1) + T_(k-3) + ..), T_0 counted by half. */
List derivative(List a) {
    List d = list(a.n > 0 ? a.n - 1 : 0);
    for (long j = d.n - 1; j >= 0; --j) {
        mpz_mul_ui(d.c + j, a.c + j + 1, 2 * (unsigned long)(j + 1));
        if (j + 2 < d.n)
            mpz_add(d.c + j, d.c + j, d.c + j + 2);
    }
    return d;
}

List add(List a, List b, Q factor) {
    List c = list(a.n > b.n ? a.n : b.n);
    for (long j = 0; j < c.n; ++j) {
        if (j < a.n)
            mpz_set(c.c + j, a.c + j);
        if (j < b.n)
            mpz_addmul(c.c + j, b.c + j, mpq_numref(factor));
    }
    return c;
}

List scaled(List a, Q factor) { return add(nothing, a, factor); }

/* Adds the product of a and b, polynomials in z with all powers, to c: the coefficients of
   z^0, z^1, .. */
static void add_product(List c, List a, List b) {
    for (long k = 1 - a.n; k < a.n; ++k) {
        long first = k < b.n ? 0 : k - b.n + 1;
        for (long j = first; j < k + b.n; ++j)
            mpz_addmul(c.c + j, a.c + labs(k), b.c + labs(j - k));
    }
}

List dot(const List* u, long du, const List* v, long dv, long n) {
    long size = 0;
    for (long i = 0; i < n; ++i) {
        List a = u[i * du];
        List b = v[i * dv];
        if (a.n > 0 && b.n > 0 && a.n + b.n - 1 > size)
            size = a.n + b.n - 1;
    }
    List c = list(size);
    for (long i = 0; i < n; ++i)
        add_product(c, u[i * du], v[i * dv]);
    return c;
}
