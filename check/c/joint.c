#include "check.h"

static Q sum_of(Q* row, long n) {
    Q x = q(0);
    for (long j = 0; j < n; ++j)
        x = plus(x, row[j]);
    return x;
}

/* V^-1 = (1 + N) U with |1 + N| <= N1, by Neumann's series for V^-1 = (1 + Z)^-1 U, Z = U V
   - 1, with bounds z of |Z| of the largest row sum q <= 1/2: |N_ij| <= z_ij + (row sum i of
   z^2)/(1 - q). */
void check_frame(Step* s) {
    long n = s->n;
    long k = s->ku + s->kv;
    List* Z = take((size_t)(n * n) * sizeof *Z);
    List one = list(1);
    mpz_set_si(one.c, -1);
    for (long i = 0; i < n * n; ++i) {
        Z[i] = dot(s->U + i / n * n, 1, s->V + i % n, n, n);
        if (i / n == i % n)
            Z[i] = add(Z[i], one, shift(q(1), k));
    }
    Q* z = bounds(Z, n * n, shift(q(1), k));
    Q* zz = products(z, z, n, n);
    Q most = q(0);
    for (long i = 0; i < n; ++i)
        most = largest(most, sum_of(z + i * n, n));
    need(at_most(plus(most, most), q(1)), "frame: U is not nearly the inverse of V");
    s->N1 = fractions(n * n);
    for (long i = 0; i < n; ++i) {
        Q rest = up(over(sum_of(zz + i * n, n), minus(q(1), most)));
        for (long j = 0; j < n; ++j)
            s->N1[i * n + j] = plus(plus(z[i * n + j], rest), q(i == j));
    }
}

/* The set in which the step begins is in the tube at x = -1. */
void check_joint(const Step* s, const Set* old) {
    long n = s->n;
    Q left = q(-1);
    Q *frame = fractions(n * n), *gap = fractions(n), *U = fractions(n * n),
      *between = fractions(n);
    for (long i = 0; i < n * n; ++i)
        U[i] = shift(value(s->U[i], left), -s->ku);
    for (long i = 0; i < n; ++i) {
        Q centre = shift(value(s->p[i], left), -s->kp);
        between[i] = minus(shift(old->centre[i], -s->scale[i]), centre);
    }
    for (long i = 0; i < n; ++i) {
        Q moved = q(0);
        for (long l = 0; l < n; ++l)
            moved = plus(moved, times(U[i * n + l], between[l]));
        gap[i] = up(absolute(moved));
        for (long j = 0; j < n; ++j) {
            Q turned = q(0);
            for (long l = 0; l < n; ++l) {
                Q entry = shift(old->frame[l * n + j], -s->scale[l]);
                turned = plus(turned, times(U[i * n + l], entry));
            }
            frame[i * n + j] = up(absolute(turned));
        }
    }
    frame = products(s->N1, frame, n, n);
    gap = products(s->N1, gap, n, 1);
    for (long b = 0; b < s->blocks; ++b) {
        Q total = size_of(gap, 1, s->at[b], s->at[b + 1], 0, 1);
        for (long c = 0; c < old->blocks; ++c) {
            Q size = size_of(frame, n, s->at[b], s->at[b + 1], old->at[c], old->at[c + 1]);
            total = plus(total, times(size, old->radii[c]));
        }
        need(at_most(total, s->R0[b]), "start or joint: radius of block %ld", b + 1);
    }
}
