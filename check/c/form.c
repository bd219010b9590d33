#include <stdio.h>
#include <string.h>

#include "check.h"

/* Quotients, powers that are not whole, and functions are added unknowns w of u, a
   polynomial. Then the equations are polynomials; that of w is u' times dw/du, which is a
   polynomial in w and further added unknowns. As long as the solution of this system exists,
   it is that of the equations. */

/* The formulas of a start, one or two. */
static long formulas_of_start(char* text, Formula* found) {
    size_t n = strlen(text);
    char* ends[2] = {text, NULL};
    long count = 1;
    if (n > 1 && text[0] == '[' && text[n - 1] == ']') {
        count = split(copied(text + 1, n - 2), ", ", ends, 2);
        form(count == 2, "'%s' is not understood", clipped(text));
    }
    for (long i = 0; i < count; ++i)
        found[i] = parsed(ends[i]);
    return count;
}

static void enclose_starts(Problem* p) {
    Formula(*parts)[2] = take((size_t)p->own * sizeof *parts + 1);
    long* count = take((size_t)p->own * sizeof *count + 1);
    long functions = 0;
    int has_pi = 0;
    for (long i = 0; i < p->own; ++i) {
        long operations = 0;
        count[i] = formulas_of_start(p->start[i], parts[i]);
        for (long k = 0; k < count[i]; ++k) {
            operations += parts[i][k].operations;
            functions += parts[i][k].functions;
        }
        form(operations <= MOST_OPERATIONS && functions <= MOST_OPERATIONS,
             "the starts have too many operations");
        has_pi = has_pi || strstr(p->start[i], "pi") != NULL;
    }
    Name pi = {.name = "pi"};
    if (has_pi)
        pi.start = pi_interval(p->start_bits);
    for (long i = 0; i < p->own; ++i) {
        Interval x = enclosure(parts[i][0].tree, (Names){&pi, has_pi}, p->start_bits);
        if (count[i] == 2) {
            Interval y = enclosure(parts[i][1].tree, (Names){&pi, has_pi}, p->start_bits);
            x = (Interval){least(x.low, y.low), largest(x.high, y.high)};
        }
        p->names.name[1 + i].start = x;
    }
}

/* Kind, argument and exponent of an added unknown. */
static const Tree* argument_of(const Tree* t, Added* a) {
    int divides =
        t->kind == '*' && t->parts == 2 && t->sign[1] == '/' && t->part[0]->kind == '0';
    divides = divides && mpq_cmp_si(t->part[0]->number, 1, 1) == 0;
    int known = t->kind == '^' || divides || (t->kind == 'f' && is_function(t->name));
    form(known, "a definition is not that of a function");
    a->kind = divides ? "/" : t->name;
    a->exponent = t->kind == '^' ? t->number : q(-1);
    return t->part[divides ? 1 : 0];
}

/* dw/du of an added unknown w of u. */
static Poly slope_of(Algebra* by, const Added* a) {
    Q minus_one = q(-1);
    if (strcmp(a->kind, "exp") == 0)
        return a->own;
    if (strcmp(a->kind, "log") == 0)
        return poly_times(by, constant(q(1)), inverse_of(by, a->u));
    if (strcmp(a->kind, "sin") == 0)
        return function_of(by, "cos", a->u, minus_one);
    if (strcmp(a->kind, "cos") == 0) {
        Poly sine = function_of(by, "sin", a->u, minus_one);
        return joined(&sine, &minus_one, 1);
    }
    Poly slope;
    if (mpz_cmp_si(mpq_numref(a->exponent), -1) ==
        0) {  // (1/u)' = -w^2, (u^(-1/b))' = -(1/b) w^(b+1)
        Q next = plus(q_of(mpq_denref(a->exponent)), q(1));
        form(at_most(next, q(MOST_POWER)), "an exponent is out of range");
        slope = poly_power(by, a->own, mpz_get_si(mpq_numref(next)));
    } else {
        slope = poly_times(by, a->own, inverse_of(by, a->u));
    }
    return joined(&slope, &a->exponent, 1);
}

/* The scope of definitions: the variable, the unknowns, and the definitions before. */
static void read_added(Problem* p, Algebra* by, Names* scope) {
    for (long i = 0; i < p->defined; ++i) {
        char name[32];
        snprintf(name, sizeof name, "_%ld", i + 1);
        Added* a = &by->added[i];
        Name* w = &p->names.name[1 + p->given + i];
        *w =
            (Name){.name = copied(name, strlen(name)), .own = unknown((int)(1 + p->given + i))};
        Tree* t = parsed(p->definition[i]).tree;
        const Tree* argument = argument_of(t, a);
        a->u = polynomial(by, argument, *scope);
        a->own = w->own;
        ++by->count;
        w->start = enclosure(t, *scope, p->start_bits);
        scope->name[scope->count] = *w;
        ++scope->count;
    }
}

static void read_right_sides(Problem* p, Algebra* by) {
    long k = 1;
    for (long i = 0; i < p->equations; ++i) {
        const Equation* e = &p->equation[i];
        for (long j = 1; j < e->order; ++j, ++k)
            p->right[k] = p->names.name[k + 1].own;
        Tree* t = parsed(e->right).tree;
        p->right[k] = polynomial(by, t, (Names){p->names.name, 1 + p->own});
        ++k;
    }
}

/* The derivatives of added unknowns, and of those by the start of `vary`. */
static void differentiate(Problem* p, Algebra* by) {
    Poly* by_start = take((size_t)(p->n + 1) * sizeof *by_start);
    for (long k = 0; k <= p->n; ++k) {
        int own = p->vary != NULL && 1 <= k && k <= p->own;
        by_start[k] = own ? p->names.name[p->own + k].own : nothing_at_all();
    }
    for (long i = 0; i < p->defined; ++i) {
        const Added* a = &by->added[i];
        long k = 1 + p->given + i;
        Poly slope = slope_of(by, a);
        p->right[k] = poly_times(by, slope, along(by, a->u, p->right, k));
        by_start[k] = poly_times(by, slope, along(by, a->u, by_start, k));
    }
    for (long k = p->own + 1; k <= p->given; ++k)
        p->right[k] = along(by, p->right[k - p->own], by_start, p->n + 1);
}

static int vanishes_at_start(const Problem* p, Poly g) {
    Q total = q(0);
    for (long j = 0; j < g.n; ++j) {
        Q x = g.t[j].c;
        for (long i = 0; i < g.t[j].n; ++i) {
            Interval start = p->names.name[g.t[j].v[i]].start;
            if (!mpq_equal(start.low, start.high))
                return 0;
            x = times(x, start.low);
        }
        total = plus(total, x);
    }
    return mpq_sgn(total) == 0;
}

void make_polynomial_form(Problem* p) {
    Algebra by = {0, 0, take((size_t)p->defined * sizeof(Added) + 1)};
    Names scope = {take((size_t)(p->n + 1) * sizeof(Name)), 1 + p->own};
    p->right = take((size_t)(p->n + 3) * sizeof *p->right);
    p->right[0] = constant(q(1));
    for (long k = 1; k <= p->n; ++k)
        p->right[k] = nothing_at_all();
    enclose_starts(p);
    memcpy(scope.name, p->names.name, (size_t)scope.count * sizeof(Name));
    for (long k = p->own + 1; k <= p->given; ++k) {
        long own = strcmp(p->names.name[k - p->own].name, p->vary) == 0;
        p->names.name[k].start = exactly(q(own));
    }
    read_added(p, &by, &scope);
    read_right_sides(p, &by);
    differentiate(p, &by);
    p->names.count = 1 + p->n;
    if (p->condition != NULL) {
        Tree* t = parsed(p->condition).tree;
        Poly g = polynomial(&by, t, (Names){p->names.name, 1 + p->own});
        p->functions = 2;
        p->right[p->n + 1] = g;
        p->right[p->n + 2] = along(&by, g, p->right, p->n + 1);
        p->zero_start = vanishes_at_start(p, g);
    }
}
