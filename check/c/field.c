#include <stdlib.h>
#include <string.h>

#include "check.h"

typedef struct Product {  // of the polynomials of which v has the numbers
    long n;
    const int* v;
    List value;
    struct Product* before;
} Product;

typedef struct {  // c times the product of v, in equation i
    long i;
    Term t;
} Scaled;

typedef struct {  // the equations in the scaled unknowns
    Scaled* term;
    long count, k, most;  // k: exponent of the factors; most: factors of a term
    List* factor;         // the time, times an integer, and the unknowns along p
    Q common;             // denominator of the coefficients
} Scaling;

static int contains_time(const Problem* p, long equations) {
    for (long i = 1; i <= equations; ++i) {
        for (long j = 0; j < p->right[i].n; ++j)
            if (p->right[i].t[j].n > 0 && p->right[i].t[j].v[0] == 0)
                return 1;
    }
    return 0;
}

/* The time is s + h/2 + (h/4) 2 T_1, a list of integers times 1/denominator. Sets the
   factors and their exponent. */
static Q scale_factors(const Step* s, Scaling* of) {
    Q half = over(s->length, q(2));
    Q time[] = {plus(s->begin, half), over(half, q(2))};
    Q denominator = q(1);
    int timed = contains_time(s->problem, s->n + s->problem->functions);
    if (timed)
        mpz_lcm(mpq_numref(denominator), mpq_denref(time[0]), mpq_denref(time[1]));
    of->k = size_in_bits(denominator);
    of->k = of->k < s->kp ? s->kp : of->k;
    form(of->k <= 2 * MOST_EXPONENT, "a step is too large");
    of->factor = take((size_t)(s->n + 1) * sizeof *of->factor);
    of->factor[0] = list(timed ? 2 : 0);
    for (long j = 0; j < of->factor[0].n; ++j) {
        Q x = shift(times(time[j], denominator), of->k);
        mpz_set(of->factor[0].c + j, mpq_numref(x));
    }
    for (long i = 0; i < s->n; ++i)
        of->factor[i + 1] = scaled(s->p[i], shift(q(1), of->k - s->kp));
    return denominator;
}

/* A term of equation i in the scaled unknowns; of g without a factor, and of g' times h/2. */
static Term scaled_term(const Step* s, long i, Term t, Q denominator) {
    Q half = over(s->length, q(2));
    long e = i < s->n ? -s->scale[i] : 0;
    t.c = i == s->n ? t.c : times(t.c, half);
    for (long l = 0; l < t.n; ++l)
        if (t.v[l] == 0)
            t.c = over(t.c, denominator);
        else
            e += s->scale[t.v[l] - 1];
    form(labs(e) <= MOST_SHIFT, "a step is too large");
    t.c = shift(t.c, e);
    return t;
}

/* The bits of all products and sums of products. */
static void check_size(const Step* s, const Scaling* of) {
    long longest = 0;
    long operations = 0;
    Q most = q(1);
    for (long i = 0; i <= s->n; ++i) {
        List a = of->factor[i];
        longest = a.n > longest ? a.n : longest;
        for (long j = 0; j < a.n; ++j)
            if (mpz_cmpabs(a.c + j, mpq_numref(most)) > 0)
                most = absolute(q_of(a.c + j));
    }
    for (const Scaled* x = of->term; x < of->term + of->count; ++x)
        for (long l = 0; l < x->t.n; ++l)
            operations += l > 0 && x->t.v[l] == x->t.v[l - 1] ? 1 : 2;
    long each = of->most * (size_in_bits(most) + of->k) + size_in_bits(of->common);
    Q total = times(times(q(operations), q(of->most * longest)), q(each));
    form(at_most(total, q(MOST_STEP)), "a step is too large");
}

static Scaling scale_equations(const Step* s) {
    const Problem* p = s->problem;
    long equations = s->n + p->functions;
    Scaling of = {.most = 1, .common = q(1)};
    Q denominator = scale_factors(s, &of);
    for (long i = 1; i <= equations; ++i)
        of.count += p->right[i].n;
    of.term = take((size_t)of.count * sizeof *of.term + 1);
    of.count = 0;
    for (long i = 0; i < equations; ++i) {
        for (long j = 0; j < p->right[i + 1].n; ++j) {
            Term t = scaled_term(s, i, p->right[i + 1].t[j], denominator);
            of.term[of.count] = (Scaled){i, t};
            ++of.count;
            of.most = t.n > of.most ? t.n : of.most;
            mpz_lcm(mpq_numref(of.common), mpq_numref(of.common), mpq_denref(t.c));
            form(size_in_bits(of.common) <= MOST_COMMON, "a step is too large");
        }
    }
    check_size(s, &of);
    return of;
}

static List product_of(Product** known, const List* factor, const int* v, long n) {
    for (Product* x = *known; x != NULL; x = x->before)
        if (x->n == n && (n == 0 || memcmp(x->v, v, (size_t)n * sizeof *v) == 0))
            return x->value;
    List product = list(1);
    if (n == 0) {
        mpz_set_ui(product.c, 1);
    } else {
        List first = product_of(known, factor, v, n - 1);
        product = dot(&first, 1, factor + v[n - 1], 1, 1);
    }
    Product* made = take(sizeof *made);
    *made = (Product){n, v, product, *known};
    *known = made;
    return product;
}

/* The change of |c| times a product in the tube, where |Y_i - p_i| <= rho_i and |p_i| <=
   reach_i. */
static Q change(Term t, Q* reach, Q* rho) {
    Q larger = q(1);
    Q smaller = q(1);
    for (long l = 0; l < t.n; ++l) {
        larger = times(larger, plus(reach[t.v[l]], rho[t.v[l]]));
        smaller = times(smaller, reach[t.v[l]]);
    }
    return up(times(absolute(t.c), minus(larger, smaller)));
}

static void tube_bounds(const Step* s, const Scaling* of, Field* f, Q* reach, Q* rho) {
    Q* radii = fractions(s->blocks);
    for (long b = 0; b < s->blocks; ++b)
        radii[b] = largest(s->R0[b], s->R1[b]);
    f->size_of_V = bounds(s->V, s->n * s->n, shift(q(1), s->kv));
    rho[0] = q(0);
    for (long i = 0; i <= s->n; ++i)
        reach[i] = bound(of->factor[i], of->k);
    for (long i = 0; i < s->n; ++i)
        rho[i + 1] = up(row_times(f->size_of_V + i * s->n, s->at, s->blocks, radii));
}

/* Adds the derivatives of a term by its different unknowns to J, and the bounds of their
   changes. */
static void add_derivatives(Field* f, const Scaled* x, const Scaling* of, Product** known,
                            Q factor, Q* reach, Q* rho) {
    Term t = x->t;
    for (long l = 0; l < t.n;) {
        long at = l;
        while (l < t.n && t.v[l] == t.v[at])
            ++l;
        if (t.v[at] == 0)
            continue;
        long entry = x->i * f->n + t.v[at] - 1;
        Q count = q(l - at);
        Term rest = without(t, at);
        List product = product_of(known, of->factor, rest.v, rest.n);
        f->J[entry] = add(f->J[entry], product, times(count, factor));
        Q more = times(count, change(rest, reach, rho));
        f->change_of_J[entry] = plus(f->change_of_J[entry], more);
    }
}

static void set_functions(Step* s, const List* minus_g, Q* changes, Q unit) {
    for (long k = 0; k < 2; ++k) {
        s->function[k].a = scaled(minus_g[k], q(-1));
        s->function[k].slope = norm(derivative(minus_g[k]));
        s->function[k].reach = times(changes[k], unit);
    }
}

Field field(Step* s) {
    long n = s->n;
    Scaling of = scale_equations(s);
    Field f = {
        .n = n, .J = take((size_t)(n * n) * sizeof(List)), .change_of_J = fractions(n * n)};
    Q *reach = fractions(n + 1), *rho = fractions(n + 1);
    tube_bounds(s, &of, &f, reach, rho);
    f.unit = shift(of.common, (of.most - 1) * of.k);
    for (long i = 0; i < n * n; ++i) {
        f.J[i] = nothing;
        f.change_of_J[i] = q(0);
    }
    List* d = take((size_t)(n + 2) * sizeof *d);  // p' - g
    for (long i = 0; i < n + 2; ++i)
        d[i] = i < n ? scaled(derivative(of.factor[i + 1]), f.unit) : nothing;
    Q one_unit = up(shift(q(1), -bits));
    Q changes[] = {one_unit, one_unit};
    Product* known = NULL;
    for (const Scaled* x = of.term; x < of.term + of.count; ++x) {
        Q factor = shift(times(x->t.c, of.common), (of.most - x->t.n) * of.k);
        List product = product_of(&known, of.factor, x->t.v, x->t.n);
        d[x->i] = add(d[x->i], product, negative(factor));
        if (x->i >= n)
            changes[x->i - n] = plus(changes[x->i - n], change(x->t, reach, rho));
        else
            add_derivatives(&f, x, &of, &known, factor, reach, rho);
    }
    Q unit = shift(f.unit, of.k);
    set_functions(s, d + n, changes, unit);
    f.defect = fractions(n);
    for (long i = 0; i < n; ++i) {
        List row = dot(s->U + i * n, 1, d, 1, n);
        f.defect[i] = *bounds(&row, 1, shift(unit, s->ku));
    }
    f.defect = products(s->N1, f.defect, n, 1);
    return f;
}
