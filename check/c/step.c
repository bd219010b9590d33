#include <stdlib.h>
#include <string.h>

#include "check.h"

Q* fractions(long n) { return take((size_t)n * sizeof(Q)); }

Q size_of(Q* a, long width, long i0, long i1, long j0, long j1) {
    Q x = q(0);
    for (long i = i0; i < i1; ++i)
        for (long j = j0; j < j1; ++j)
            x = plus(x, times(a[i * width + j], a[i * width + j]));
    return root_up(x);
}

Q row_times(Q* row, const long* at, long blocks, Q* radii) {
    Q x = q(0);
    for (long b = 0; b < blocks; ++b)
        x = plus(x, times(size_of(row, 0, 0, 1, at[b], at[b + 1]), radii[b]));
    return x;
}

Q* products(Q* a, Q* b, long n, long columns) {
    Q* c = fractions(n * columns);
    for (long i = 0; i < n; ++i) {
        for (long j = 0; j < columns; ++j) {
            Q x = q(0);
            for (long l = 0; l < n; ++l)
                x = plus(x, times(a[i * n + l], b[l * columns + j]));
            c[i * columns + j] = up(x);
        }
    }
    return c;
}

Q bound(List a, long k) { return up(shift(norm(a), -k)); }

Q* bounds(const List* a, long count, Q unit) {
    Q* b = fractions(count);
    for (long i = 0; i < count; ++i)
        b[i] = up(over(norm(a[i]), unit));
    return b;
}

/* A matrix with one exponent, the largest one, from one with an exponent for each row or
   column. */
static List* matrix(Reader* r, const char* word, long n, int by_rows, long* most) {
    long* k;
    List* a = section(r, word, n, &k, n * n);
    *most = 0;
    for (long i = 0; i < n; ++i)
        *most = k[i] > *most ? k[i] : *most;
    for (long i = 0; i < n * n; ++i) {
        long own = k[by_rows ? i / n : i % n];
        a[i] = scaled(a[i], shift(q(1), *most - own));
    }
    return a;
}

static void read_blocks(Reader* r, Step* s) {
    char** part = take((size_t)s->n * sizeof *part);
    s->blocks = split(line(r, "blocks"), " ", part, s->n);
    s->at = take((size_t)(s->n + 1) * sizeof *s->at);
    s->at[0] = 0;
    int good = s->blocks <= s->n;
    for (long b = 0; good && b < s->blocks; ++b) {
        good = strcmp(part[b], "1") == 0 || strcmp(part[b], "2") == 0;
        s->at[b + 1] = s->at[b] + (good ? *part[b] - '0' : 0);
    }
    good = good && s->at[s->blocks] == s->n;
    form(good, "the blocks are not of 1 and 2 columns");
}

static void read_radii(Reader* r, Step* s) {
    long* k;
    List* lists = section(r, "radii", s->blocks, &k, 2);
    int good = 1;
    for (long end = 0; end < 2; ++end) {
        good = good && lists[end].n == s->blocks;
        for (long b = 0; good && b < s->blocks; ++b)
            good = mpz_sgn(lists[end].c + b) >= 0;
    }
    form(good, "the radii are not numbers >= 0");
    s->R0 = fractions(s->blocks);
    s->R1 = fractions(s->blocks);
    for (long b = 0; b < s->blocks; ++b) {
        s->R0[b] = up(shift(q_of(lists[0].c + b), -k[b]));
        s->R1[b] = up(shift(q_of(lists[1].c + b), -k[b]));
    }
}

Step* read_step(Reader* r, Problem* p, Q begin) {
    Step* s = take(sizeof *s);
    *s = (Step){.problem = p, .begin = begin, .n = p->n};
    long* k;
    List length = *section(r, "step", 1, &k, 1);
    form(length.n == 1 && mpz_sgn(length.c) != 0, "the length is not one integer, not 0");
    s->length = shift(q_of(length.c), -*k);
    s->scale = integers(r, "scale", s->n, MOST_INTEGER);
    read_blocks(r, s);
    s->p = section(r, "p", 1, &k, s->n);
    s->kp = *k;
    s->V = matrix(r, "V", s->n, 0, &s->kv);
    s->U = matrix(r, "U", s->n, 1, &s->ku);
    read_radii(r, s);
    return s;
}

Q radius_at(const Step* s, long b, Q x) {
    Q way = times(minus(s->R1[b], s->R0[b]), plus(x, q(1)));
    return up(plus(s->R0[b], over(way, q(2))));
}

Set set_at(const Step* s, Q x) {
    long n = s->n;
    Set r = {n, s->blocks, s->at, fractions(n), fractions(n * n), fractions(s->blocks)};
    for (long i = 0; i < n; ++i)
        r.centre[i] = shift(value(s->p[i], x), s->scale[i] - s->kp);
    for (long i = 0; i < n * n; ++i)
        r.frame[i] = shift(value(s->V[i], x), s->scale[i / n] - s->kv);
    for (long b = 0; b < s->blocks; ++b)
        r.radii[b] = radius_at(s, b, x);
    return r;
}
