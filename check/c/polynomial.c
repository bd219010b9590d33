#include <stdlib.h>
#include <string.h>

#include "check.h"

static int order_of_products(const Term* a, const Term* b) {
    for (long i = 0; i < a->n && i < b->n; ++i)
        if (a->v[i] != b->v[i])
            return a->v[i] < b->v[i] ? -1 : 1;
    return (a->n > b->n) - (a->n < b->n);
}

/* Equal products stay in the order in which they are added. */
static int order_of_terms(const void* x, const void* y) {
    const Term *a = x, *b = y;
    int order = order_of_products(a, b);
    return order != 0 ? order : (a->place > b->place) - (a->place < b->place);
}

static Poly terms(long n) { return (Poly){n, take((size_t)n * sizeof(Term))}; }

Poly collected(Poly p) {
    for (long i = 0; i < p.n; ++i) {
        p.t[i].place = i;
        limited(p.t[i].c);
    }
    qsort(p.t, (size_t)p.n, sizeof *p.t, order_of_terms);
    long n = 0;
    for (long i = 0; i < p.n;) {
        Term total = p.t[i];
        for (++i; i < p.n && order_of_products(&total, &p.t[i]) == 0; ++i)
            total.c = limited(plus(total.c, p.t[i].c));
        if (mpq_sgn(total.c) != 0) {
            p.t[n] = total;
            ++n;
        }
    }
    p.n = n;
    return p;
}

Poly nothing_at_all(void) { return terms(0); }

Poly constant(Q c) {
    Poly p = terms(mpq_sgn(c) != 0);
    if (p.n > 0)
        p.t[0] = (Term){.c = c};
    return p;
}

Poly unknown(int k) {
    Poly p = constant(q(1));
    p.t[0].n = 1;
    p.t[0].v = take(sizeof(int));
    p.t[0].v[0] = k;
    return p;
}

Poly joined(const Poly* p, const Q* factor, long n) {
    long count = 0;
    for (long i = 0; i < n; ++i)
        count += p[i].n;
    Poly all = terms(count);
    all.n = 0;
    for (long i = 0; i < n; ++i) {
        for (long j = 0; j < p[i].n; ++j) {
            all.t[all.n] = p[i].t[j];
            all.t[all.n].c = times(factor[i], p[i].t[j].c);
            ++all.n;
        }
    }
    return collected(all);
}

static long degree(Poly a) {
    long most = 0;
    for (long i = 0; i < a.n; ++i)
        most = a.t[i].n > most ? a.t[i].n : most;
    return most;
}

static int ascending(const void* x, const void* y) {
    const int *a = x, *b = y;
    return (*a > *b) - (*a < *b);
}

static Term product_of_terms(Term a, Term b) {
    Term c = {.n = a.n + b.n, .c = times(a.c, b.c)};
    c.v = take((size_t)c.n * sizeof *c.v);
    for (long i = 0; i < c.n; ++i)
        c.v[i] = i < a.n ? a.v[i] : b.v[i - a.n];
    qsort(c.v, (size_t)c.n, sizeof *c.v, ascending);
    return c;
}

Poly poly_times(Algebra* by, Poly a, Poly b) {
    by->products += a.n * b.n;
    form(by->products <= MOST_PRODUCTS, "the polynomials have too many terms");
    form(degree(a) + degree(b) <= MOST_FACTORS, "a term has too many factors");
    Poly p = terms(a.n * b.n);
    for (long k = 0; k < p.n; ++k)
        p.t[k] = product_of_terms(a.t[k / b.n], b.t[k % b.n]);
    return collected(p);
}

Poly poly_power(Algebra* by, Poly u, long n) {
    Poly p = constant(q(1));
    for (long k = 0; k < n; ++k)
        p = poly_times(by, u, p);
    return p;
}

/* u^n for a whole number n >= 0. */
static Poly whole_power(Algebra* by, Poly u, Q n) {
    form(at_most(n, q(MOST_POWER)), "an exponent is out of range");
    return poly_power(by, u, mpz_get_si(mpq_numref(n)));
}

Term without(Term t, long at) {
    Term r = {.n = t.n - 1, .v = take((size_t)t.n * sizeof(int)), .c = t.c};
    for (long i = 0; i < r.n; ++i)
        r.v[i] = t.v[i < at ? i : i + 1];
    return r;
}

/* The partial derivative by unknown k. */
static Poly partial(Poly a, int k) {
    Poly p = terms(a.n);
    p.n = 0;
    for (long j = 0; j < a.n; ++j) {
        long count = 0;
        long at = 0;
        for (long i = 0; i < a.t[j].n; ++i) {
            if (a.t[j].v[i] == k) {
                ++count;
                at = i;
            }
        }
        if (count > 0) {
            p.t[p.n] = without(a.t[j], at);
            p.t[p.n].c = times(a.t[j].c, q(count));
            ++p.n;
        }
    }
    return p;
}

Poly along(Algebra* by, Poly u, const Poly* way, long n) {
    char* occurs = memset(take((size_t)n + 1), 0, (size_t)n + 1);
    for (long j = 0; j < u.n; ++j)
        for (long i = 0; i < u.t[j].n; ++i)
            occurs[u.t[j].v[i]] = 1;
    Poly* part = take((size_t)n * sizeof *part + 1);
    Q* factor = take((size_t)n * sizeof *factor + 1);
    long parts = 0;
    for (long k = 0; k < n; ++k) {
        if (occurs[k] && way[k].n > 0) {
            part[parts] = poly_times(by, partial(u, (int)k), way[k]);
            factor[parts] = q(1);
            ++parts;
        }
    }
    return joined(part, factor, parts);
}

const Name* find_name(Names names, const char* name) {
    for (long k = 0; k < names.count; ++k)
        if (strcmp(names.name[k].name, name) == 0)
            return &names.name[k];
    return NULL;
}

static int is_same(Poly a, Poly b) {
    int same = a.n == b.n;
    for (long j = 0; same && j < a.n; ++j)
        same = order_of_products(&a.t[j], &b.t[j]) == 0 && mpq_equal(a.t[j].c, b.t[j].c);
    return same;
}

Poly function_of(const Algebra* by, const char* kind, Poly u, Q exponent) {
    for (long k = by->count - 1; k >= 0; --k) {
        const Added* a = &by->added[k];
        if (strcmp(a->kind, kind) == 0 && mpq_equal(a->exponent, exponent) && is_same(a->u, u))
            return a->own;
    }
    form(0, "no definition is the '%s' that a formula needs", clipped(kind));
    return u;
}

Poly inverse_of(const Algebra* by, Poly u) {
    if (u.n == 1 && u.t[0].n == 0)
        return constant(over(q(1), u.t[0].c));
    return function_of(by, "/", u, q(-1));
}

/* u^r by a whole power, by w = u^(-1/b) for r = a/b, or by an added unknown. */
static Poly power_of(Algebra* by, Poly u, Q r) {
    mpz_ptr a = mpq_numref(r);
    mpz_ptr b = mpq_denref(r);
    if (mpz_cmp_ui(b, 1) == 0) {
        return mpz_sgn(a) < 0 ? whole_power(by, inverse_of(by, u), negative(r))
                              : whole_power(by, u, r);
    }
    if (mpz_cmpabs_ui(a, 64) > 0 || mpz_cmp_ui(b, 6) > 0)
        return function_of(by, "^", u, r);
    Q k = largest(q(0), ceiling(r));
    Q d = q_of(b);
    Poly w = function_of(by, "^", u, over(q(-1), d));
    Poly first = whole_power(by, u, k);
    return poly_times(by, first, whole_power(by, w, times(minus(k, r), d)));
}

static Poly sum_of(Algebra* by, const Tree* t, Names names) {
    Poly* part = take((size_t)t->parts * sizeof *part);
    Q* factor = take((size_t)t->parts * sizeof *factor);
    for (long i = 0; i < t->parts; ++i) {
        part[i] = polynomial(by, t->part[i], names);
        factor[i] = q(t->sign[i] == '-' ? -1 : 1);
    }
    return joined(part, factor, t->parts);
}

static Poly product_of(Algebra* by, const Tree* t, Names names) {
    Poly p = polynomial(by, t->part[0], names);
    for (long i = 1; i < t->parts; ++i) {
        Poly u = polynomial(by, t->part[i], names);
        p = poly_times(by, p, t->sign[i] == '/' ? inverse_of(by, u) : u);
    }
    return p;
}

Poly polynomial(Algebra* by, const Tree* t, Names names) {
    if (t->kind == '0')
        return constant(t->number);
    if (t->kind == 'x') {
        const Name* found = find_name(names, t->name);
        form(found != NULL, "unknown name '%s'", clipped(t->name));
        return found->own;
    }
    if (t->kind == '+')
        return sum_of(by, t, names);
    if (t->kind == '*')
        return product_of(by, t, names);
    Poly u = polynomial(by, t->part[0], names);
    return t->kind == '^' ? power_of(by, u, t->number) : function_of(by, t->name, u, q(-1));
}
