#include "check.h"

enum {
    PARTS = 8
};  // of a step, on each of which the rate of a block is bounded

/* At least a(x)/unit on each part of [-1, 1], by the value in its middle. */
static void above(List a, Q unit, Q part[PARTS]) {
    Q slope = over(norm(derivative(a)), q(PARTS));
    for (long k = 0; k < PARTS; ++k) {
        Q middle = over(q(2 * k + 1 - PARTS), q(PARTS));
        part[k] = up(over(plus(value(a, middle), slope), unit));
    }
}

/* At least the largest eigenvalue of ((a, m/2), (m/2, d)): (a + d + sqrt((a - d)^2 +
   m^2))/2. */
static Q eigenvalue(Q a, Q d, Q m) {
    Q difference = minus(a, d);
    Q root = root_up(plus(times(difference, difference), times(m, m)));
    return up(over(plus(plus(a, d), root), q(2)));
}

/* At least the largest eigenvalue of the symmetric part of the block of B at i. */
static Q rate(const List* B, long n, long i, long size, Q unit) {
    const List* b = B + i * n + i;
    Q a[PARTS], d[PARTS], high[PARTS], low[PARTS];
    above(b[0], unit, a);
    Q most = a[0];
    if (size == 1) {
        for (long k = 1; k < PARTS; ++k)
            most = largest(most, a[k]);
        return least(most, *bounds(b, 1, unit));
    }
    List mixed = add(b[1], b[n], q(1));
    above(b[n + 1], unit, d);
    above(mixed, unit, high);
    above(scaled(mixed, q(-1)), unit, low);
    for (long k = 0; k < PARTS; ++k) {
        Q m = largest(absolute(high[k]), absolute(low[k]));
        Q each = eigenvalue(a[k], d[k], m);
        most = k == 0 ? each : largest(most, each);
    }
    return most;
}

/* In the tube B = B0 + change, where B0 = U (J V - V') is known as polynomials, and the
   change, with that by N, is at most C - |B0|, C = N1 (|B0| + |U| change_of_J |V|). */
typedef struct {
    Q *C, *rates;
} Rates;

static Rates rates_of(const Step* s, const Field* f) {
    long n = s->n;
    List *H = take((size_t)(n * n) * sizeof *H), *B0 = take((size_t)(n * n) * sizeof *B0);
    for (long i = 0; i < n * n; ++i) {
        List JV = dot(f->J + i / n * n, 1, s->V + i % n, n, n);
        H[i] = add(JV, derivative(s->V[i]), negative(f->unit));
    }
    for (long i = 0; i < n * n; ++i)
        B0[i] = dot(s->U + i / n * n, 1, H + i % n, n, n);
    Q unit = shift(f->unit, s->ku + s->kv);
    Q* size_of_B0 = bounds(B0, n * n, unit);
    Q* C = products(f->change_of_J, f->size_of_V, n, n);
    C = products(bounds(s->U, n * n, shift(q(1), s->ku)), C, n, n);
    for (long i = 0; i < n * n; ++i)
        C[i] = plus(C[i], size_of_B0[i]);
    C = products(s->N1, C, n, n);
    Q* more = fractions(n * n);
    for (long i = 0; i < n * n; ++i)
        more[i] = minus(C[i], size_of_B0[i]);
    Rates r = {C, fractions(s->blocks)};
    for (long b = 0; b < s->blocks; ++b) {
        long i = s->at[b], j = s->at[b + 1];
        r.rates[b] = plus(rate(B0, n, i, j - i, unit), size_of(more, n, i, j, i, j));
    }
    return r;
}

/* (R1_b - R0_b)/2 >= sum_c A_bc r_c + D_b for the radii r at one end. */
static void check_end(const Step* s, const Field* f, const Rates* by, Q* r, const char* end) {
    for (long b = 0; b < s->blocks; ++b) {
        long i = s->at[b], j = s->at[b + 1];
        Q growth = size_of(f->defect, 1, i, j, 0, 1);
        for (long c = 0; c < s->blocks; ++c) {
            Q A = c == b ? by->rates[b] : size_of(by->C, s->n, i, j, s->at[c], s->at[c + 1]);
            growth = plus(growth, times(A, r[c]));
        }
        need(at_most(plus(growth, growth), minus(s->R1[b], s->R0[b])),
             "growth of the radius of block %ld at the %s end", b + 1, end);
    }
}

void check_growth(const Step* s, const Field* f) {
    Rates by = rates_of(s, f);
    check_end(s, f, &by, s->R0, "left");
    check_end(s, f, &by, s->R1, "right");
}
