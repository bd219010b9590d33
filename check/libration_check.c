/* libration_check FILE: checks a certificate of values of a differential equation and prints the proved statement, as
   libration_check.py does. The format and the theorem are in docs/certificates.md. Integers and fractions only. Exit
   status: 0 if it is proved, 1 if a condition does not hold, 2 if the file is not a certificate of this format.

       gcc -O2 libration_check.c -lgmp -lz -o libration_check

   A polynomial in x on [-1, 1] is a List a of integers, with an exponent k that is kept apart:
       2^-k (a[0] + sum over j > 0 of 2 a[j] T_j(x)) = 2^-k (sum over |j| < n of a[|j|] z^j),   x = (z + 1/z)/2,
   so that the sum of all |a[|j|]| is a bound, and products are products of polynomials in z. */
#include <ctype.h>
#include <gmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { PARTS = 8 };  // of a step, on each of which the rate of a mode is bounded
enum { DEPTH = 900, DEGREE = 400, TERMS = 1000000, EXPONENT = 10000, SIZE = 1 << 26 };  // limits; the last one of bits
static const size_t MEMORY = (size_t)4 << 30;                                           // in bytes
static long step_number;

static void refuse(int status, const char* reason, va_list rest) {
    printf("Not proved: ");
    if (step_number > 0) printf("step %ld: ", step_number);
    vprintf(reason, rest);
    putchar('\n');
    exit(status);
}
#define REFUSAL(name, status)                                                                        \
    __attribute__((format(printf, 2, 3))) static void name(int condition, const char* reason, ...) { \
        va_list rest;                                                                                \
        va_start(rest, reason);                                                                      \
        if (!condition) refuse(status, reason, rest);                                                \
        va_end(rest);                                                                                \
    }
REFUSAL(need, 1)  // of a condition
REFUSAL(form, 2)  // of the format

// ------------------------------------------------------------------------------------------------------------ memory
// A number belongs to the region of the problem, of one of two steps, or of a sign, and is freed with it.
typedef struct Block {
    struct Block *before, *after;
    size_t size, unused;  // the latter for the alignment of what follows
} Block;
enum { PROBLEM, STEP, SIGN = 3, REGIONS };
static Block regions[REGIONS];
static int region = PROBLEM;
static size_t used;

static void* linked(Block* b, size_t size, Block* before, Block* after) {
    if (size <= MEMORY && used + size <= MEMORY)
        b = realloc(b, size + sizeof *b);
    else
        b = NULL;
    if (b == NULL) form(0, "the check needs more memory than there is, or than 4 GB");
    *b = (Block){before, after, size + sizeof *b, 0};
    before->after = after->before = b;
    used += b->size;
    return b + 1;
}
static void* take(size_t size) { return linked(NULL, size, &regions[region], regions[region].after); }
static void* resize(void* p, size_t old, size_t size) {
    Block *b = (Block*)p - 1, *before = b->before, *after = b->after;
    used -= old + sizeof *b;
    return linked(b, size, before, after);
}
static void drop(void* p, size_t size) {
    Block* b = (Block*)p - 1;
    used -= size + sizeof *b;
    b->before->after = b->after;
    b->after->before = b->before;
    free(b);
}
static void release(int r) {
    for (Block* b; (b = regions[r].after) != &regions[r];) drop(b + 1, b->size - sizeof *b);
}

// --------------------------------------------------------------------------------------------------------- fractions
typedef mpq_ptr Q;
static long bits, start_bits;  // bounds are multiples of 2^-bits; starts are enclosed to 2^-start_bits

static Q q(long n) {
    Q x = take(sizeof *x);
    mpq_init(x);
    mpq_set_si(x, n, 1);
    return x;
}
static Q q_of(mpz_srcptr n) {
    Q x = q(0);
    mpz_set(mpq_numref(x), n);
    return x;
}
#define OPERATION(name, function) \
    static Q name(Q a, Q b) {     \
        Q c = q(0);               \
        function(c, a, b);        \
        return c;                 \
    }
OPERATION(plus, mpq_add)
OPERATION(minus, mpq_sub)
OPERATION(times, mpq_mul)
OPERATION(over, mpq_div)
static int at_most(Q a, Q b) { return mpq_cmp(a, b) <= 0; }
static Q least(Q a, Q b) { return at_most(a, b) ? a : b; }
static Q largest(Q a, Q b) { return at_most(a, b) ? b : a; }
static Q negative(Q a) { return minus(q(0), a); }
static Q absolute(Q a) { return mpq_sgn(a) < 0 ? negative(a) : a; }
static Q shift(Q a, long k) {  // 2^k a
    form(labs(k) < SIZE, "a power of two is out of range");
    Q b = q(0);
    (k < 0 ? mpq_div_2exp : mpq_mul_2exp)(b, a, labs(k));
    return b;
}
static Q whole(Q a) {  // rounded down
    Q b = q(0);
    mpz_fdiv_q(mpq_numref(b), mpq_numref(a), mpq_denref(a));
    return b;
}
static Q ceiling(Q a) { return negative(whole(negative(a))); }
static Q up(Q a) { return shift(ceiling(shift(a, bits)), -bits); }
static Q root_up(Q a) {  // of a sum of squares of bounds
    if (mpq_sgn(a) <= 0) return q(0);
    Q b = shift(a, 2 * bits);
    mpz_sub_ui(mpq_numref(b), mpq_numref(b), 1);
    mpz_sqrt(mpq_numref(b), mpq_numref(b));
    return shift(plus(b, q(1)), -bits);
}
static Q of_size(Q a) {
    form(mpz_sizeinbase(mpq_numref(a), 2) < SIZE && mpz_sizeinbase(mpq_denref(a), 2) < SIZE, "a number is too large");
    return a;
}
static Q power(Q a, long n) {
    if (n == 0) return q(1);
    return of_size(n % 2 == 1 ? times(a, power(a, n - 1)) : power(times(a, a), n / 2));
}
static size_t digits(const char* s) { return strspn(s, "0123456789"); }
static Q digits_at(const char** s, const char* text) {  // passes the digits that are there
    size_t n = digits(*s);
    char* copy = memcpy(take(n + 1), *s, n);
    copy[n] = 0;
    form(n > 0, "'%s' is not a number", text);
    Q x = q(0);
    mpz_set_str(mpq_numref(x), copy, 10);
    *s += n;
    return x;
}
static Q fraction(const char* text) {  // such as -2/3, 25, -0.25, 1.5e-7
    const char* s = text + (*text == '-');
    Q x = digits_at(&s, text), y = q(1);
    long e = 0;
    if (*s == '/') {
        ++s;
        y = digits_at(&s, text);
    } else {
        if (*s == '.') {
            y = power(q(10), (long)digits(++s));
            x = plus(times(x, y), digits_at(&s, text));
        }
        if (*s == 'e') {
            const char* sign = s + 1;
            s += 1 + (*sign == '-' || *sign == '+');
            form(digits(s) <= 5, "'%s' is not a number", text);
            e = atol(sign);
            s += digits(s);
        }
    }
    form(*s == 0 && isdigit((unsigned char)s[-1]) && mpq_sgn(y) > 0, "'%s' is not a number", text);
    x = over(e < 0 ? x : times(x, power(q(10), e)), e < 0 ? times(y, power(q(10), -e)) : y);
    return *text == '-' ? negative(x) : x;
}

// ------------------------------------------------------------------------------------- polynomials in x on [-1, 1]
typedef struct {
    long n;
    mpz_ptr c;
} List;

static List list(long n) {
    List a = {n, take((size_t)n * sizeof *a.c)};
    for (long j = 0; j < n; ++j) mpz_init(a.c + j);
    return a;
}
static Q norm(List a) {  // at least |a(x)|
    Q x = q(0), first = a.n > 0 ? q_of(a.c) : x;
    for (long j = 0; j < a.n; ++j) (mpz_sgn(a.c + j) < 0 ? mpz_sub : mpz_add)(mpq_numref(x), mpq_numref(x), a.c + j);
    return minus(plus(x, x), absolute(first));
}
static Q value(List a, Q x) {  // by Clenshaw's recurrence b_j = a_j + 2 x b_(j+1) - b_(j+2), times powers of v, x = u/v
    Q b0 = q(0), b1 = b0, b2 = b0, v_to = q(1), u2 = q_of(mpq_numref(x)), v = q_of(mpq_denref(x)), vv = times(v, v);
    u2 = plus(u2, u2);
    for (long j = a.n - 1; j >= 0; --j) {
        Q b = minus(plus(times(q_of(a.c + j), v_to), times(u2, b0)), times(vv, b1));
        b2 = b1;
        b1 = b0;
        b0 = b;
        if (j > 0) v_to = times(v_to, v);
    }
    return over(minus(b0, times(vv, b2)), v_to);
}
static List derivative(List a) {
    List d = list(a.n > 0 ? a.n - 1 : 0);
    for (long j = d.n - 1; j >= 0; --j) {
        mpz_mul_ui(d.c + j, a.c + j + 1, 2 * (unsigned long)(j + 1));
        if (j + 2 < d.n) mpz_add(d.c + j, d.c + j, d.c + j + 2);
    }
    return d;
}
static List add(List a, List b, Q factor) {  // a + factor b, with an integer
    List c = list(a.n > b.n ? a.n : b.n);
    for (long j = 0; j < c.n; ++j) {
        if (j < a.n) mpz_set(c.c + j, a.c + j);
        if (j < b.n) mpz_addmul(c.c + j, b.c + j, mpq_numref(factor));
    }
    return c;
}
static const List nothing = {0, NULL};
static List scaled(List a, Q factor) { return add(nothing, a, factor); }

// The sum of u[i du] v[i dv], i < n.
static List dot(const List* u, long du, const List* v, long dv, long n) {
    long size = 0;
    for (long i = 0; i < n; ++i)
        if (u[i * du].n > 0 && v[i * dv].n > 0 && u[i * du].n + v[i * dv].n - 1 > size)
            size = u[i * du].n + v[i * dv].n - 1;
    List c = list(size);
    for (long i = 0; i < n; ++i) {
        List a = u[i * du], b = v[i * dv];
        for (long k = 1 - a.n; k < a.n; ++k)
            for (long j = k < b.n ? 0 : k - b.n + 1; j < k + b.n; ++j)
                mpz_addmul(c.c + j, a.c + labs(k), b.c + labs(j - k));
    }
    return c;
}

// ---------------------------------------------------------------------------------------------------------- formulas
typedef struct Tree {
    char kind;         // 0 number, x name, f function of a, [ both ends of an interval, + * / ^
    const char* name;  // of a name or function; "/" and "^" of these
    Q number;          // of a number; the exponent of ^
    struct Tree *a, *b;
    long depth;
} Tree;

// A polynomial in the variable (number 0) and the unknowns (1, 2, ...): different products v[0] <= v[1] <= .. with c != 0.
typedef struct {
    long n;
    int* v;
    Q c;
} Term;
typedef struct {
    long n;
    Term* t;
} Poly;
typedef struct {
    Q low, high;
} Interval;
typedef struct {
    const char* name;
    Poly own;
    Interval start;
} Name;
typedef struct {  // an added unknown, of the polynomial u
    const char* kind;
    Poly u, own;
    Q exponent;
} Added;
typedef struct {
    Name* name;
    Added* added;
    long names, addeds;
} Scope;

static Poly polynomial(const Tree* t, const Scope* s);
static const char *formula_text, *cursor;
static int nesting;

static char next(void) {
    while (*cursor == ' ') ++cursor;
    return *cursor;
}
static int skip(char c) { return next() == c ? (++cursor, 1) : 0; }
static void understood(int condition) { form(condition, "'%s' is not understood", formula_text); }
static Tree* node(char kind, const char* name, Tree* a, Tree* b) {
    Tree* t = take(sizeof *t);
    long x = a ? a->depth : 0, y = b ? b->depth : 0;
    *t = (Tree){kind, name, NULL, a, b, 1 + (x > y ? x : y)};
    form(t->depth <= DEPTH, "a formula is nested too deeply");
    return t;
}
static Tree* number(Q x) {
    Tree* t = node('0', NULL, NULL, NULL);
    t->number = x;
    return t;
}
static size_t name_length(const char* s) {  // of the name that s begins with
    size_t n = 0;
    if (!isalpha((unsigned char)*s) && *s != '_') return 0;
    while (isalnum((unsigned char)s[n]) || s[n] == '_') ++n;
    return n + strspn(s + n, "'");
}
static Tree* sum(void);
static Tree* atom(void) {
    Tree *t, *u;
    char c = next();
    size_t n = name_length(cursor);
    if (isdigit((unsigned char)c)) {
        t = number(digits_at(&cursor, formula_text));
        understood(c != '0' || mpq_sgn(t->number) == 0);
    } else if (n > 0) {
        char* name = memcpy(take(n + 1), cursor, n);
        name[n] = 0;
        cursor += n;
        if (!skip('(')) return node('x', name, NULL, NULL);
        t = node('f', name, sum(), NULL);
        understood(skip(')'));
    } else if (skip('[')) {
        t = sum();
        understood(skip(','));
        u = sum();
        t = node('[', "interval", t, u);
        understood(skip(']'));
    } else {
        understood(skip('('));
        t = sum();
        understood(skip(')'));
    }
    return t;
}
static Tree* signed_power(void) {
    form(++nesting <= DEPTH, "a formula is nested too deeply");
    Tree* t;
    if (skip('-')) {
        t = node('*', NULL, number(q(-1)), signed_power());
    } else {
        t = atom();
        if (skip('^')) {
            Poly p = polynomial(signed_power(), &(Scope){NULL, NULL, 0, 0});
            t = node('^', "^", t, NULL);
            t->number = p.n > 0 ? p.t[0].c : q(0);  // without names, it is a constant
        }
    }
    --nesting;
    return t;
}
static Tree* product(void) {
    Tree* t = signed_power();
    for (char c; (c = next()) == '*' || c == '/';) {
        ++cursor;
        t = node(c, c == '/' ? "/" : NULL, t, signed_power());
    }
    return t;
}
static Tree* sum(void) {
    Tree* t = product();
    for (char c; (c = next()) == '+' || c == '-';) {
        ++cursor;
        Tree* u = product();
        t = node('+', NULL, t, c == '-' ? node('*', NULL, number(q(-1)), u) : u);
    }
    return t;
}
static Tree* formula(const char* text) {
    formula_text = cursor = text;
    nesting = 0;
    Tree* t = sum();
    understood(next() == 0);
    return t;
}

static int compare(const void* x, const void* y) {
    const Term *a = x, *b = y;
    for (long i = 0; i < a->n && i < b->n; ++i)
        if (a->v[i] != b->v[i]) return a->v[i] < b->v[i] ? -1 : 1;
    return (a->n > b->n) - (a->n < b->n);
}
static Poly collected(Poly p) {  // equal products added
    qsort(p.t, p.n, sizeof *p.t, compare);
    long n = 0;
    for (long i = 0; i < p.n; ++i) {
        if (n > 0 && compare(&p.t[n - 1], &p.t[i]) == 0)
            p.t[n - 1].c = plus(p.t[n - 1].c, p.t[i].c);
        else
            p.t[n++] = p.t[i];
        if (mpq_sgn(p.t[n - 1].c) == 0 && (i + 1 == p.n || compare(&p.t[n - 1], &p.t[i + 1]) != 0)) --n;
    }
    p.n = n;
    return p;
}
static Poly terms(long n) {
    form(n <= TERMS, "a polynomial is too large");
    return (Poly){n, take((size_t)n * sizeof(Term))};
}
static Poly constant(Q c) {
    Poly p = terms(1);
    p.t[0] = (Term){0, NULL, c};
    return collected(p);
}
static Poly variable(int k) {
    Poly p = constant(q(1));
    *(p.t[0].v = take(sizeof(int))) = k;
    p.t[0].n = 1;
    return p;
}
static int is_constant(Poly p) { return p.n == 1 && p.t[0].n == 0; }  // and not 0
static Poly poly_plus(Poly a, Poly b) {
    Poly p = terms(a.n + b.n);
    memcpy(p.t, a.t, a.n * sizeof *p.t);
    memcpy(p.t + a.n, b.t, b.n * sizeof *p.t);
    return collected(p);
}
static int ascending(const void* x, const void* y) { return *(const int*)x - *(const int*)y; }
static Poly poly_times(Poly a, Poly b) {
    form(b.n == 0 || a.n <= TERMS / b.n, "a polynomial is too large");
    Poly p = terms(a.n * b.n);
    for (long k = 0; k < p.n; ++k) {
        Term x = a.t[k / b.n], y = b.t[k % b.n];
        form(x.n <= DEGREE && y.n <= DEGREE, "a polynomial is too large");
        p.t[k] = (Term){x.n + y.n, take((x.n + y.n) * sizeof(int)), of_size(times(x.c, y.c))};
        for (long i = 0; i < x.n + y.n; ++i) p.t[k].v[i] = i < x.n ? x.v[i] : y.v[i - x.n];
        qsort(p.t[k].v, p.t[k].n, sizeof(int), ascending);
    }
    return collected(p);
}
static Poly poly_power(Poly a, Q n) {
    form(mpq_sgn(n) >= 0 && at_most(n, q(100)), "an exponent is out of range");
    Poly p = constant(q(1));
    for (unsigned long k = mpz_get_ui(mpq_numref(n)); k > 0; --k) p = poly_times(a, p);
    return p;
}
static Term without(Term t, long at) {  // one of its factors
    Term r = {t.n - 1, take(t.n * sizeof(int)), t.c};
    for (long i = 0; i < r.n; ++i) r.v[i] = t.v[i + (i >= at)];
    return r;
}
static Poly partial(Poly a, int k) {
    Poly p = terms(a.n);
    p.n = 0;
    for (long j = 0; j < a.n; ++j) {
        long count = 0, at = 0;
        for (long i = 0; i < a.t[j].n; ++i)
            if (a.t[j].v[i] == k) ++count, at = i;
        if (count == 0) continue;
        p.t[p.n] = without(a.t[j], at);
        p.t[p.n].c = times(a.t[j].c, q(count));
        ++p.n;
    }
    return collected(p);
}
static int same(Poly a, Poly b) {
    long j = 0;
    while (j < a.n && j < b.n && compare(&a.t[j], &b.t[j]) == 0 && mpq_equal(a.t[j].c, b.t[j].c)) ++j;
    return j == a.n && j == b.n;
}
static const Name* find_name(const Scope* s, const char* name) {
    for (long k = 0; k < s->names; ++k)
        if (strcmp(s->name[k].name, name) == 0) return &s->name[k];
    return NULL;
}
static Poly find(const Scope* s, const char* kind, Poly u, Q exponent) {
    for (long k = s->addeds - 1; k >= 0; --k) {
        const Added* a = &s->added[k];
        if (strcmp(a->kind, kind) == 0 && mpq_equal(a->exponent, exponent) && same(a->u, u)) return a->own;
    }
    form(0, "no added unknown is defined as the '%s' that an equation needs", kind);
    return u;
}
static Poly inverse(const Scope* s, Poly u) {
    return is_constant(u) ? constant(over(q(1), u.t[0].c)) : find(s, "/", u, q(-1));
}
static Poly poly_of_power(const Scope* s, Poly u, Q r) {
    mpz_ptr a = mpq_numref(r), b = mpq_denref(r);
    if (mpz_cmp_ui(b, 1) == 0) return mpz_sgn(a) < 0 ? poly_power(inverse(s, u), negative(r)) : poly_power(u, r);
    if (mpz_cmpabs_ui(a, 64) > 0 || mpz_cmp_ui(b, 6) > 0) return find(s, "^", u, r);
    Q k = largest(q(0), ceiling(r)), d = q_of(b);
    Poly w = find(s, "^", u, over(q(-1), d));
    return poly_times(poly_power(u, k), poly_power(w, times(minus(k, r), d)));
}
static Poly polynomial(const Tree* t, const Scope* s) {
    if (t->kind == '0') return constant(t->number);
    if (t->kind == 'x') {
        const Name* found = find_name(s, t->name);
        form(found != NULL, "unknown name '%s'", t->name);
        return found->own;
    }
    Poly u = polynomial(t->a, s);
    if (t->kind == '^') return poly_of_power(s, u, t->number);
    if (t->b == NULL || t->kind == '[') return find(s, t->name, u, q(-1));
    Poly v = polynomial(t->b, s);
    return t->kind == '+' ? poly_plus(u, v) : poly_times(u, t->kind == '/' ? inverse(s, v) : v);
}

// ---------------------------------------------------------------------------------------------- enclosures of starts
static Interval exactly(Q a) { return (Interval){a, a}; }
static Interval around(Q a, Q error) { return (Interval){minus(a, error), plus(a, error)}; }
/* exp, sin or cos by terms x^j/j!: each has an error below 2 e^|x| units, the argument one of e^|x|, the rest is below
   8 units. */
static Interval entire(Q x, char kind) {
    form(mpq_cmp(absolute(x), q(1000)) < 0, "a start has an argument that is too large");
    long size = mpz_get_si(mpq_numref(ceiling(absolute(x)))), b = start_bits + 2 * size + 40, j = 0;
    Q factor = whole(shift(x, b)), t = shift(q(1), b), total = q(0), most = plus(absolute(plus(x, x)), q(2));
    for (; j == 0 || mpz_cmpabs_ui(mpq_numref(t), 1) > 0 || mpq_cmp(q(j), most) < 0; ++j) {
        if (j > 0) t = whole(over(whole(shift(times(t, factor), -b)), q(j)));
        if (kind == 'e' || j % 2 == (kind == 's')) total = (kind == 'e' || j / 2 % 2 == 0 ? plus : minus)(total, t);
    }
    Interval r = around(total, times(q(2 * j + 10), power(q(3), size)));
    return (Interval){shift(r.low, -b), shift(r.high, -b)};
}
// The sum of sign^j z^(2j+1)/(2j+1), |z| <= 1/3, within 3 units a power, and the rest.
static Interval odd_series(Q z, int sign) {
    long b = start_bits + 40, j = 0;
    Q factor = whole(shift(z, b)), p = factor, total = q(0);
    for (; mpz_cmpabs_ui(mpq_numref(p), 1) > 0; ++j) {
        total = (sign > 0 || j % 2 == 0 ? plus : minus)(total, whole(over(p, q(2 * j + 1))));
        p = whole(shift(times(whole(shift(times(p, factor), -b)), factor), -b));
    }
    return around(shift(total, -b), shift(q(4 * j + 16), -b));
}
static Interval linear(Q a, Interval x, Q b, Interval y) {  // a x + b y
    Q c[] = {times(a, x.low), times(a, x.high), times(b, y.low), times(b, y.high)};
    return (Interval){plus(least(c[0], c[1]), least(c[2], c[3])), plus(largest(c[0], c[1]), largest(c[2], c[3]))};
}
static Interval logarithm(Q x) {  // log(2^k m) = 2 artanh((m - 1)/(m + 1)) + 2 k artanh(1/3), 1/2 <= m <= 2
    long k = (long)mpz_sizeinbase(mpq_numref(x), 2) - (long)mpz_sizeinbase(mpq_denref(x), 2);
    Q y = shift(q(1), k);
    return linear(q(2), odd_series(over(minus(x, y), plus(x, y)), 1), q(2 * k), odd_series(over(q(1), q(3)), 1));
}
static Interval pi(void) {
    return linear(q(16), odd_series(over(q(1), q(5)), -1), q(-4), odd_series(over(q(1), q(239)), -1));
}
static Interval of_four(Q a, Q b, Q c, Q d) {
    return (Interval){least(least(a, b), least(c, d)), largest(largest(a, b), largest(c, d))};
}
static Interval whole_power(Interval x, Q exponent) {
    form(at_most(exponent, q(EXPONENT)), "an exponent is out of range");
    long n = mpz_get_si(mpq_numref(exponent));
    Q a = power(x.low, n), b = power(x.high, n);
    int crosses = n % 2 == 0 && mpq_sgn(x.low) * mpq_sgn(x.high) <= 0;
    return (Interval){crosses ? q(0) : least(a, b), largest(a, b)};
}
static Interval enclosure(const Tree* t, const Scope* s) {
    const Name* found = t->kind == 'x' ? find_name(s, t->name) : NULL;
    if (t->kind == '0') return exactly(t->number);
    if (t->kind == 'x') {
        form(found != NULL || strcmp(t->name, "pi") == 0, "unknown name '%s'", t->name);
        return found ? found->start : pi();
    }
    Interval x = enclosure(t->a, s);
    Q a = x.low, b = x.high;
    if (t->b != NULL) {
        Interval y = enclosure(t->b, s);
        Q c = y.low, d = y.high;
        if (t->kind == '+') return (Interval){plus(a, c), plus(b, d)};
        if (t->kind == '[') return of_four(a, b, c, d);
        if (t->kind == '/') {
            need(mpq_sgn(c) > 0 || mpq_sgn(d) < 0, "a start divides by 0");
            Q e = over(q(1), d);
            d = over(q(1), c);
            c = e;
        }
        return of_four(times(a, c), times(a, d), times(b, c), times(b, d));
    }
    if (strcmp(t->name, "exp") == 0) return (Interval){entire(a, 'e').low, entire(b, 'e').high};
    if (strcmp(t->name, "sin") == 0 || strcmp(t->name, "cos") == 0) {  // |sin'|, |cos'| <= 1
        Interval y = entire(a, *t->name);
        return (Interval){minus(y.low, minus(b, a)), plus(y.high, minus(b, a))};
    }
    if (t->kind == '^' && mpz_cmp_ui(mpq_denref(t->number), 1) == 0 && mpq_sgn(t->number) >= 0)
        return whole_power(x, t->number);
    need(mpq_sgn(a) > 0 && (t->kind == '^' || strcmp(t->name, "log") == 0),
         "a start takes the '%s' of a number that is not positive", t->name);
    Interval y = {logarithm(a).low, logarithm(b).high};
    if (t->kind != '^') return y;
    y = linear(t->number, y, q(0), y);  // a^r = exp(r log a)
    return (Interval){entire(y.low, 'e').low, entire(y.high, 'e').high};
}

// -------------------------------------------------------------------------------------------------- lines of the file
static char** lines;
static long line_count, line_at;

static char* line(const char* word) {  // what follows the word of the next line
    form(line_at < line_count, "the file ends early");
    char* s = lines[line_at++];
    size_t n = strlen(word);
    form(strncmp(s, word, n) == 0 && (s[n] == ' ' || s[n] == 0), "line %ld: '%s' expected", line_at, word);
    return s[n] == 0 ? s + n : s + n + 1;
}
static char** all(const char* word, long* count) {  // the same of the lines that begin with the word
    size_t n = strlen(word);
    for (*count = 0; line_at + *count < line_count; ++*count) {
        const char* s = lines[line_at + *count];
        if (strncmp(s, word, n) != 0 || s[n] != ' ') break;
    }
    char** found = take((size_t)*count * sizeof *found);
    for (long i = 0; i < *count; ++i) found[i] = lines[line_at++] + n + 1;
    return found;
}
static long split(char* s, const char* separator, char** part, long most) {  // in place; the number of parts
    long n = 1;
    for (part[0] = s; (s = strstr(s, separator)) != NULL; ++n) {
        *s = 0;
        s += strlen(separator);
        if (n < most) part[n] = s;
    }
    return n;
}
typedef char* Row[4];
static Row* rows(const char* word, const char* separator, long parts, long* count) {
    char** found = all(word, count);
    Row* row = take((size_t)*count * sizeof *row);
    for (long i = 0; i < *count; ++i) form(split(found[i], separator, row[i], 4) == parts, "an unclear %s", word);
    return row;
}
static long* integers(const char* word, long count) {
    char *s = line(word), **part = take((size_t)count * sizeof *part);
    long *k = take((size_t)count * sizeof *k), n = split(s, " ", part, count), i = 0;
    for (; i < count && n == count; ++i) {
        size_t m = strlen(part[i]), sign = *part[i] == '-';
        if (m == sign || m > 5 + sign || digits(part[i] + sign) != m - sign) break;
        k[i] = atol(part[i]);
    }
    form(i == count, "line %ld: %ld integers of at most 5 digits expected", line_at, count);
    return k;
}
static List coefficients(void) {
    form(line_at < line_count, "the file ends early");
    char* s = lines[line_at++];
    long n = *s != 0;
    for (const char* t = s; *t != 0; ++t) n += *t == ' ';
    List a = list(n);
    for (long j = 0; j < n; ++j) {
        size_t sign = *s == '-', m = strspn(s + sign, "0123456789abcdef") + sign;
        form(m > sign && s[m] == (j + 1 < n ? ' ' : 0), "line %ld: bad coefficients", line_at);
        s[m] = 0;
        mpz_set_str(a.c + j, s, 16);
        s += m + 1;
    }
    return a;
}
static List* section(const char* word, long exponents, long** k, long count) {  // exponents, and lists of integers
    *k = integers(word, exponents);
    List* a = take((size_t)count * sizeof *a);
    for (long i = 0; i < count; ++i) a[i] = coefficients();
    return a;
}

// ---------------------------------------------------------------------------------------------- head of a certificate
typedef struct {
    char *variable, *condition, *vary, **start;
    Row *equation, *zero, *claim;
    long equations, states, n, functions, zeros, claims, steps, bits;  // n: of unknowns, with the added ones
    Q t0, *ends;                                                       // t0, and both times of each zero
    Scope scope;                                                       // the variable, the unknowns
    Poly* right;                                                       // y_(i+1)' = right[i], then g and g'
    Poly* by_start;                                                    // the derivatives of y_(i+1) by a start
    int zero_start, sign;
} Problem;

static Poly along(Poly u, const Poly* way, long n) {  // the derivative, from those of the n unknowns
    Poly r = terms(0);
    for (int k = 0; k < n; ++k) r = poly_plus(r, poly_times(partial(u, k + 1), way[k]));
    return r;
}
static Poly slope(const Problem* p, Poly u) {  // the derivative along the solution
    return poly_plus(partial(u, 0), along(u, p->right, p->n));
}
static void add_unknown(Problem* p, const char* name) {
    p->scope.name[p->scope.names] = (Name){.name = name, .own = variable((int)p->scope.names)};
    ++p->scope.names;
}
static void add_name(Problem* p, const char* text, size_t length) {
    char* name = memcpy(take(length + 1), text, length);
    name[length] = 0;
    form(length > 0 && name_length(name) == length, "'%s' is not a name", name);
    form(find_name(&p->scope, name) == NULL, "two meanings of the name '%s'", name);
    add_unknown(p, name);
}
static char* derivative_name(const char* of) {
    char* name;
    gmp_asprintf(&name, "d(%s)", of);
    return name;
}
static void add_derivatives(Problem* p) {  // of the unknowns by one of their starts
    int known = 0;
    for (long i = 1; i <= p->states; ++i) {
        const char* name = p->scope.name[i].name;
        int own = strcmp(name, p->vary) == 0;
        known = known || own;
        add_unknown(p, derivative_name(name));
        p->scope.name[p->states + i].start = (Interval){q(own), q(own)};
    }
    form(known, "no start of '%s'", p->vary);
}
static long given(const Problem* p) { return p->vary == NULL ? p->states : 2 * p->states; }
static Tree* defined_by(const Tree* t) {  // the argument of an added unknown
    int known = t->kind == '^' || (t->kind == '/' && t->a->kind == '0' && mpq_cmp_si(t->a->number, 1, 1) == 0);
    for (const char** f = (const char*[]){"exp", "log", "sin", "cos", NULL}; t->kind == 'f' && *f != NULL; ++f)
        known = known || strcmp(*f, t->name) == 0;
    form(known, "'%s' does not define a function", formula_text);
    return t->kind == '/' ? t->b : t->a;
}
static Poly rule_of(const Problem* p, const Added* a) {  // the derivative of an added unknown by its argument
    Q r = a->exponent;
    char* rule = "w";
    if (strcmp(a->kind, "log") == 0) rule = "1/u";
    if (strcmp(a->kind, "sin") == 0) rule = "cos(u)";
    if (strcmp(a->kind, "cos") == 0) rule = "-sin(u)";
    if (*a->kind == '/' || *a->kind == '^') {
        Q next = plus(q_of(mpq_denref(r)), q(1));
        if (mpz_cmp_si(mpq_numref(r), -1) == 0)
            gmp_asprintf(&rule, "(%Qd)*w^%Qd", r, next);
        else
            gmp_asprintf(&rule, "(%Qd)*w/u", r);
    }
    Name both[] = {{.name = "u", .own = a->u}, {.name = "w", .own = a->own}};
    return polynomial(formula(rule), &(Scope){both, p->scope.added, 2, p->scope.addeds});
}
static void make_polynomial_form(Problem* p, Row* define, long defined) {
    Scope* s = &p->scope;
    s->names = 1;
    for (long i = 0; i < p->states; ++i) s->name[1 + i].start = enclosure(formula(p->start[i]), &(Scope){.names = 0});
    s->names = 1 + given(p);
    for (long i = 0; i < defined; ++i, ++s->addeds, ++s->names) {
        Tree *t = formula(define[i][1]), *u = defined_by(t);
        Name* w = &s->name[s->names];
        s->added[i] = (Added){t->name, polynomial(u, s), w->own, t->kind == '^' ? t->number : q(-1)};
        w->start = enclosure(t, s);
    }
    for (long i = 0, k = 0; i < p->equations; ++i) {
        for (const char* prime = strchr(p->equation[i][0], '\'') + 1; *prime != 0; ++prime, ++k)
            p->right[k] = s->name[k + 2].own;
        p->right[k++] = polynomial(formula(p->equation[i][1]), s);
    }
    for (p->n = p->states; p->n < given(p); ++p->n) {
        p->right[p->n] = p->by_start[p->n] = terms(0);
        p->by_start[p->n - p->states] = s->name[p->n + 1].own;
    }
    for (const Added* a = s->added; a < s->added + defined; ++a, ++p->n) {
        Poly rule = rule_of(p, a);
        p->right[p->n] = poly_times(rule, slope(p, a->u));
        p->by_start[p->n] = p->vary == NULL ? terms(0) : poly_times(rule, along(a->u, p->by_start, p->n));
    }
    for (long i = p->states; i < given(p); ++i) p->right[i] = along(p->right[i - p->states], p->by_start, p->n);
    if (p->condition == NULL) return;
    Poly g = p->right[p->n] = polynomial(formula(p->condition), s);
    p->right[p->n + 1] = slope(p, g);
    p->functions = 2;
    Q total = q(0);
    int exact = 1;
    for (long j = 0; j < g.n; ++j) {
        Q x = g.t[j].c;
        for (long i = 0; i < g.t[j].n; ++i) {
            Interval start = s->name[g.t[j].v[i]].start;
            exact = exact && mpq_equal(start.low, start.high);
            x = times(x, start.low);
        }
        total = plus(total, x);
    }
    p->zero_start = exact && mpq_sgn(total) == 0;
}
static long zero_of(const Problem* p, const char* time) {  // the number of the zero #k, or 0
    char name[32];
    long k = *time == '#' ? strtol(time + 1, NULL, 10) : 0;
    snprintf(name, sizeof name, "#%ld", k);
    return k > 0 && k <= p->zeros && strcmp(name, time) == 0 ? k : 0;
}
static char* first_of(char* at) {  // of FIRST:LAST
    char *colon = strchr(at, ':'), *copy = take(strlen(at) + 1);
    strcpy(copy, at);
    if (colon != NULL) copy[colon - at] = 0;
    return copy;
}
static char* last_of(char* at) { return strchr(at, ':') == NULL ? at : strchr(at, ':') + 1; }
static void check_times(const Problem* p, char* at) {  // of a claim
    if (zero_of(p, at) > 0) return;
    Q first = fraction(first_of(at)), last = fraction(last_of(at));
    int ordered = mpq_sgn(times(minus(first, p->t0), minus(last, first))) >= 0;
    form(strchr(at, ':') == NULL || (p->vary != NULL && ordered), "an unclear time");
}
static Problem* read_problem(void) {
    Problem* p = take(sizeof *p);
    *p = (Problem){.n = 0};
    long starts, varied, defined, conditions, *both;
    form(strcmp(line("libration-certificate"), "1") == 0, "not a certificate of version 1");
    p->variable = line("variable");
    p->t0 = fraction(line("at"));
    p->equation = rows("equation", " = ", 2, &p->equations);
    for (long i = 0; i < p->equations; ++i) {
        const char *x = p->equation[i][0], *prime = strchr(x, '\'');
        form(prime != NULL && name_length(x) == strlen(x), "an unclear equation");
        p->states += (long)strlen(prime);
    }
    p->start = all("start", &starts);
    char** vary = all("vary", &varied);
    Row* define = rows("define", " = ", 2, &defined);
    form(starts == p->states, "there are %ld starts of %ld unknowns", starts, p->states);
    form(varied < 2, "there are derivatives by two starts");
    p->vary = varied > 0 ? vary[0] : NULL;
    p->right = take((size_t)(2 * starts + defined + 2) * sizeof *p->right);
    p->by_start = take((size_t)(2 * starts + defined) * sizeof *p->by_start);
    p->scope.name = take((size_t)(2 * starts + defined + 1) * sizeof(Name));
    p->scope.added = take((size_t)defined * sizeof(Added));
    add_name(p, p->variable, strlen(p->variable));
    for (long i = 0; i < p->equations; ++i)
        for (const char *x = p->equation[i][0], *end = strchr(x, '\''); *end != 0; ++end) add_name(p, x, end - x);
    if (p->vary != NULL) add_derivatives(p);
    for (long i = 0; i < defined; ++i) add_name(p, define[i][0], strlen(define[i][0]));
    p->scope.name[0].start = exactly(p->t0);
    char** condition = all("condition", &conditions);
    both = integers("bits", 2);
    p->bits = bits = both[0];
    start_bits = both[1];
    form(16 <= bits && bits <= start_bits, "the numbers of bits are out of range");
    p->zero = rows("zero", " ", 2, &p->zeros);
    form(conditions == (p->zeros > 0), "there are zeros without a condition, or two conditions");
    p->condition = conditions > 0 ? condition[0] : NULL;
    p->ends = take((size_t)(2 * p->zeros + 1) * sizeof *p->ends);
    p->ends[0] = p->t0;
    for (long k = 0; k < 2 * p->zeros; ++k) p->ends[k + 1] = fraction(p->zero[k / 2][k % 2]);
    p->claim = rows("claim", " ", 4, &p->claims);
    form(p->claims > 0, "there is no claim");
    for (long i = 0; i < p->claims; ++i) {
        const Name* y = find_name(&p->scope, p->claim[i][1]);
        form(y != NULL && y > p->scope.name && y <= p->scope.name + given(p), "an unclear claim");
        check_times(p, p->claim[i][0]);
    }
    p->steps = *integers("steps", 1);
    make_polynomial_form(p, define, defined);
    return p;
}

// ----------------------------------------------------------------------------------------------- matrices of bounds
// A set of states is centre + frame c, |c_b| <= radii_b in the blocks b of the columns at[b] .. at[b+1] - 1.
typedef struct {
    long n, blocks, *at;
    Q *centre, *frame, *radii;
} Set;
static Q* fractions(long n) { return take((size_t)n * sizeof(Q)); }
static Q size_of(Q* a, long width, long i0, long i1, long j0, long j1) {  // at least the norm of a block
    Q x = q(0);
    for (long i = i0; i < i1; ++i)
        for (long j = j0; j < j1; ++j) x = plus(x, times(a[i * width + j], a[i * width + j]));
    return root_up(x);
}
static Q row_times(Q* row, const long* at, long blocks, Q* radii) {  // of blocks of a row
    Q x = q(0);
    for (long b = 0; b < blocks; ++b) x = plus(x, times(size_of(row, 0, 0, 1, at[b], at[b + 1]), radii[b]));
    return x;
}
static Q* products(Q* a, Q* b, long n, long columns) {  // n rows, n columns of a
    Q* c = fractions(n * columns);
    for (long i = 0; i < n; ++i)
        for (long j = 0; j < columns; ++j) {
            Q x = q(0);
            for (long l = 0; l < n; ++l) x = plus(x, times(a[i * n + l], b[l * columns + j]));
            c[i * columns + j] = up(x);
        }
    return c;
}

// ------------------------------------------------------------------------------------------------------------- a step
typedef struct {  // polynomials of the scaled unknowns and their frame, brought to one exponent each
    Problem* problem;
    Q begin, length;
    long n, blocks, *at, *scale, kp, kv, ku;
    List *p, *V, *U;
    Q *R0, *R1, *N1;  // |V^-1| <= N1 |U|
    struct {          // g and g' along p in integers, a bound of the derivative, and of the change in the tube
        List a;
        Q slope, reach;
    } function[2];
} Step;

static Q bound(List a, long k) { return up(shift(norm(a), -k)); }  // of |2^-k a(x)|
static Q* bounds(const List* a, long count, Q unit) {              // of |a(x)/unit|
    Q* b = fractions(count);
    for (long i = 0; i < count; ++i) b[i] = up(over(norm(a[i]), unit));
    return b;
}
static List* matrix(const char* word, long n, int by_rows, long* most) {
    long *k, i;
    List* a = section(word, n, &k, n * n);
    for (*most = 0, i = 0; i < n; ++i) *most = k[i] > *most ? k[i] : *most;
    for (i = 0; i < n * n; ++i) a[i] = scaled(a[i], shift(q(1), *most - k[by_rows ? i / n : i % n]));
    return a;
}
static Step* read_step(Problem* p, Q begin) {
    Step* s = take(sizeof *s);
    *s = (Step){.problem = p, .begin = begin, .n = p->n};
    long *k, i;
    List h = *section("step", 1, &k, 1);
    form(h.n == 1 && mpz_sgn(h.c) != 0, "the length is not one integer that is not 0");
    s->length = shift(q_of(h.c), -*k);
    s->scale = integers("scale", s->n);
    s->at = take((size_t)(s->n + 1) * sizeof *s->at);
    s->at[0] = 0;
    for (const char* size = line("blocks"); *size != 0; size += size[1] == ' ' ? 2 : 1, ++s->blocks) {
        form(s->blocks < s->n && (*size == '1' || *size == '2') && (size[1] == 0 || (size[1] == ' ' && size[2] != 0)),
             "the blocks are not of 1 and 2 columns");
        s->at[s->blocks + 1] = s->at[s->blocks] + *size - '0';
    }
    form(s->at[s->blocks] == s->n, "the blocks are not of 1 and 2 columns");
    s->p = section("p", 1, &k, s->n);
    s->kp = *k;
    s->V = matrix("V", s->n, 0, &s->kv);
    s->U = matrix("U", s->n, 1, &s->ku);
    List* r = section("radii", s->blocks, &k, 2);
    Q** R[] = {&s->R0, &s->R1};
    for (long end = 0; end < 2; ++end) {
        *R[end] = fractions(s->blocks);
        form(r[end].n == s->blocks, "the radii are not numbers >= 0");
        for (i = 0; i < s->blocks; ++i) {
            form(mpz_sgn(r[end].c + i) >= 0, "the radii are not numbers >= 0");
            (*R[end])[i] = up(shift(q_of(r[end].c + i), -k[i]));
        }
    }
    return s;
}
static Set set_at(const Step* s, Q x) {
    long n = s->n;
    Set r = {n, s->blocks, s->at, fractions(n), fractions(n * n), fractions(s->blocks)};
    for (long i = 0; i < n; ++i) r.centre[i] = shift(value(s->p[i], x), s->scale[i] - s->kp);
    for (long i = 0; i < n * n; ++i) r.frame[i] = shift(value(s->V[i], x), s->scale[i / n] - s->kv);
    for (long b = 0; b < s->blocks; ++b)
        r.radii[b] = up(plus(s->R0[b], over(times(minus(s->R1[b], s->R0[b]), plus(x, q(1))), q(2))));
    return r;
}
static Q sum_of(Q* row, long n) {
    Q x = q(0);
    for (long j = 0; j < n; ++j) x = plus(x, row[j]);
    return x;
}
static void check_frame(Step* s) {  // sets N1
    long n = s->n;
    List* Z = take((size_t)(n * n) * sizeof *Z);
    List one = list(1);
    mpz_set_si(one.c, -1);
    for (long i = 0; i < n * n; ++i) {
        Z[i] = dot(s->U + i / n * n, 1, s->V + i % n, n, n);
        if (i / n == i % n) Z[i] = add(Z[i], one, shift(q(1), s->ku + s->kv));
    }
    Q *z = bounds(Z, n * n, shift(q(1), s->ku + s->kv)), *zz = products(z, z, n, n), most = q(0);
    s->N1 = fractions(n * n);
    for (long i = 0; i < n; ++i) most = largest(most, sum_of(z + i * n, n));
    need(at_most(plus(most, most), q(1)), "frame: U is not nearly the inverse of V");
    for (long i = 0; i < n; ++i) {
        Q row = up(over(sum_of(zz + i * n, n), minus(q(1), most)));
        for (long j = 0; j < n; ++j) s->N1[i * n + j] = plus(plus(z[i * n + j], row), q(i == j));
    }
}
static void check_joint(const Step* s, const Set* old) {  // the set in which the step begins is in its tube
    long n = s->n;
    Set here = set_at(s, q(-1));
    Q *frame = fractions(n * n), *gap = fractions(n), *U = fractions(n * n);
    for (long i = 0; i < n * n; ++i) U[i] = shift(value(s->U[i], q(-1)), -s->ku);
    for (long i = 0; i < n; ++i)
        for (long j = 0; j <= n; ++j) {  // column n: the centres
            Q x = q(0);
            for (long l = 0; l < n; ++l) {
                Q y = j < n ? old->frame[l * n + j] : minus(old->centre[l], here.centre[l]);
                x = plus(x, times(U[i * n + l], shift(y, -s->scale[l])));
            }
            *(j < n ? &frame[i * n + j] : &gap[i]) = up(absolute(x));
        }
    Q *turned = products(s->N1, frame, n, n), *moved = products(s->N1, gap, n, 1);
    for (long b = 0; b < s->blocks; ++b) {
        Q total = size_of(moved, 1, s->at[b], s->at[b + 1], 0, 1);
        for (long c = 0; c < old->blocks; ++c) {
            Q size = size_of(turned, n, s->at[b], s->at[b + 1], old->at[c], old->at[c + 1]);
            total = plus(total, times(size, old->radii[c]));
        }
        need(at_most(total, s->R0[b]), "start or joint: radius of block %ld", b + 1);
    }
}

typedef struct {  // J = f_y(p) in integers, times 1/unit; bounds of its change in the tube, of V, and of V^-1 (p' - f)
    List* J;
    Q *change_of_J, *V, *defect, unit;
} Field;
typedef struct Product {  // of polynomials of which v has the numbers
    long n;
    const int* v;
    List value;
    struct Product* before;
} Product;
typedef struct {  // c times the product of v, in equation i
    long i;
    Term t;
} Scaled;

static List product_of(Product** known, const List* p, const int* v, long n) {
    for (Product* x = *known; x != NULL; x = x->before)
        if (x->n == n && (n == 0 || memcmp(x->v, v, (size_t)n * sizeof *v) == 0)) return x->value;
    Product* made = take(sizeof *made);
    *made = (Product){n, v, list(1), NULL};
    if (n == 0) mpz_set_ui(made->value.c, 1);
    if (n > 0) {
        List first = product_of(known, p, v, n - 1);
        made->value = dot(&first, 1, p + v[n - 1], 1, 1);
    }
    made->before = *known;
    *known = made;
    return made->value;
}
/* The terms of the equations in scaled unknowns and q times the time; and these as polynomials with the exponent kp. */
static Scaled* scaled_terms(const Step* s, long* count, List* p, long* kp) {
    const Problem* problem = s->problem;
    Q time[] = {plus(s->begin, over(s->length, q(2))), over(s->length, q(4))}, denominator = q(1);
    long most = *count = 0;
    for (long i = 0; i < s->n + problem->functions; ++i) most += problem->right[i].n;
    Scaled* term = take((size_t)most * sizeof *term);
    for (long i = 0; i < s->n + problem->functions; ++i)
        for (long j = 0; j < problem->right[i].n; ++j) {
            term[*count] = (Scaled){i, problem->right[i].t[j]};
            if (term[*count].t.n > 0 && term[*count].t.v[0] == 0)
                mpz_lcm(mpq_numref(denominator), mpq_denref(time[0]), mpq_denref(time[1]));
            ++*count;
        }
    *kp = (long)mpz_sizeinbase(mpq_numref(denominator), 2);
    if (*kp < s->kp) *kp = s->kp;
    p[0] = list(2);
    for (long j = 0; j < 2; ++j) mpz_set(p[0].c + j, mpq_numref(shift(whole(times(time[j], denominator)), *kp)));
    for (long i = 0; i < s->n; ++i) p[i + 1] = scaled(s->p[i], shift(q(1), *kp - s->kp));
    for (Scaled* x = term; x < term + *count; ++x) {
        Q half = over(s->length, q(2));
        Q c = times(x->t.c, x->i < s->n ? shift(half, -s->scale[x->i]) : x->i == s->n ? q(1) : half);
        long e = 0;
        for (long l = 0; l < x->t.n; ++l) {
            if (x->t.v[l] == 0)
                c = over(c, denominator);
            else
                e += s->scale[x->t.v[l] - 1];
        }
        x->t.c = shift(c, e);
    }
    return term;
}
static Q change(Term t, Q* reach, Q* rho) {  // in the tube, of |c| times a product
    Q larger = q(1), smaller = q(1);
    for (long l = 0; l < t.n; ++l) {
        larger = times(larger, plus(reach[t.v[l]], rho[t.v[l]]));
        smaller = times(smaller, reach[t.v[l]]);
    }
    return up(times(absolute(t.c), minus(larger, smaller)));
}
static void tube_bounds(const Step* s, const List* p, long kp, Field* f, Q* reach, Q* rho) {
    Q* radii = fractions(s->blocks);
    for (long b = 0; b < s->blocks; ++b) radii[b] = largest(s->R0[b], s->R1[b]);
    f->V = bounds(s->V, s->n * s->n, shift(q(1), s->kv));
    rho[0] = q(0);
    for (long i = 0; i <= s->n; ++i) reach[i] = bound(p[i], kp);
    for (long i = 0; i < s->n; ++i) rho[i + 1] = up(row_times(f->V + i * s->n, s->at, s->blocks, radii));
}
static Field field(Step* s) {
    long n = s->n, kp, count, most = 1;
    List *p = take((size_t)(n + 1) * sizeof *p), *d = take((size_t)(n + 2) * sizeof *d);
    Field f = {take((size_t)(n * n) * sizeof(List)), fractions(n * n), NULL, fractions(n), q(1)};
    Scaled* term = scaled_terms(s, &count, p, &kp);
    Q common = q(1), *reach = fractions(n + 1), *rho = fractions(n + 1), change_of[] = {up(shift(q(1), -bits)), q(0)};
    Product* known = NULL;
    for (long k = 0; k < count; ++k) {
        mpz_lcm(mpq_numref(common), mpq_numref(common), mpq_denref(term[k].t.c));
        if (term[k].t.n > most) most = term[k].t.n;
    }
    tube_bounds(s, p, kp, &f, reach, rho);
    change_of[1] = change_of[0];
    f.unit = shift(common, (most - 1) * kp);
    for (long i = 0; i < n * n; ++i) f.J[i] = nothing, f.change_of_J[i] = q(0);
    for (long i = 0; i < n + 2; ++i) d[i] = i < n ? scaled(derivative(p[i + 1]), f.unit) : nothing;
    for (const Scaled* x = term; x < term + count; ++x) {
        Term t = x->t;
        Q factor = shift(times(t.c, common), (most - t.n) * kp);
        d[x->i] = add(d[x->i], product_of(&known, p, t.v, t.n), negative(factor));
        if (x->i >= n) change_of[x->i - n] = plus(change_of[x->i - n], change(t, reach, rho));
        for (long l = 0; l < t.n && x->i < n; ++l) {
            if (t.v[l] == 0) continue;
            long entry = x->i * n + t.v[l] - 1;
            Term rest = without(t, l);
            f.J[entry] = add(f.J[entry], product_of(&known, p, rest.v, rest.n), factor);
            f.change_of_J[entry] = plus(f.change_of_J[entry], change(rest, reach, rho));
        }
    }
    Q unit = shift(f.unit, kp), defect_unit = shift(unit, s->ku);
    for (long k = 0; k < 2; ++k) {
        s->function[k].a = scaled(d[n + k], q(-1));
        s->function[k].slope = norm(derivative(d[n + k]));
        s->function[k].reach = times(change_of[k], unit);
    }
    for (long i = 0; i < n; ++i) {
        List row = dot(s->U + i * n, 1, d, 1, n);
        f.defect[i] = *bounds(&row, 1, defect_unit);
    }
    f.defect = products(s->N1, f.defect, n, 1);
    return f;
}

static void above(List a, Q unit, Q part[PARTS]) {  // at least a(x)/unit on each part of [-1, 1]
    Q slope = over(norm(derivative(a)), q(PARTS));
    for (long k = 0; k < PARTS; ++k)
        part[k] = up(over(plus(value(a, over(q(2 * k + 1 - PARTS), q(PARTS))), slope), unit));
}
static Q rate(const List* B, long n, long i, long size, Q unit) {  // at least the largest eigenvalue, symmetric part
    Q a[PARTS], d[PARTS], c[2][PARTS], most;
    const List* b = B + i * n + i;
    above(b[0], unit, a);
    if (size == 2) {
        List mixed = add(b[1], b[n], q(1));
        above(b[n + 1], unit, d);
        above(mixed, unit, c[0]);
        above(scaled(mixed, q(-1)), unit, c[1]);
    }
    for (long k = 0; k < PARTS; ++k) {
        if (size == 2) {
            Q m = largest(absolute(c[0][k]), absolute(c[1][k])), e = minus(a[k], d[k]);
            Q root = root_up(plus(times(e, e), times(m, m)));
            a[k] = up(over(plus(plus(a[k], d[k]), root), q(2)));
        }
        most = k == 0 ? a[0] : largest(most, a[k]);
    }
    return size == 2 ? most : least(most, *bounds(b, 1, unit));
}
static void check_growth(const Step* s, const Field* f) {
    long n = s->n;
    List *H = take((size_t)(n * n) * sizeof *H), *B = take((size_t)(n * n) * sizeof *B);
    for (long i = 0; i < n * n; ++i)
        H[i] = add(dot(f->J + i / n * n, 1, s->V + i % n, n, n), derivative(s->V[i]), negative(f->unit));
    for (long i = 0; i < n * n; ++i) B[i] = dot(s->U + i / n * n, 1, H + i % n, n, n);
    Q unit = shift(f->unit, s->ku + s->kv), *bound_of_B = bounds(B, n * n, unit), *more = fractions(n * n);
    Q* C = products(bounds(s->U, n * n, shift(q(1), s->ku)), products(f->change_of_J, f->V, n, n), n, n);
    Q* rates = fractions(s->blocks);
    for (long i = 0; i < n * n; ++i) C[i] = plus(C[i], bound_of_B[i]);
    C = products(s->N1, C, n, n);
    for (long i = 0; i < n * n; ++i) more[i] = minus(C[i], bound_of_B[i]);  // |V^-1 (g_Y V - V') - B| in the tube
    for (long b = 0; b < s->blocks; ++b) {
        long i = s->at[b], j = s->at[b + 1];
        rates[b] = plus(rate(B, n, i, j - i, unit), size_of(more, n, i, j, i, j));
    }
    for (int end = 0; end < 2; ++end)
        for (long b = 0; b < s->blocks; ++b) {
            long i = s->at[b], j = s->at[b + 1];
            Q growth = size_of(f->defect, 1, i, j, 0, 1), *r = end == 0 ? s->R0 : s->R1;
            for (long c = 0; c < s->blocks; ++c) {
                Q A = c == b ? rates[b] : size_of(C, n, i, j, s->at[c], s->at[c + 1]);
                growth = plus(growth, times(A, r[c]));
            }
            need(at_most(plus(growth, growth), minus(s->R1[b], s->R0[b])),
                 "growth of the radius of block %ld at the %s end", b + 1, end == 0 ? "left" : "right");
        }
}

// ---------------------------------------------------------------------------------------------- claims and zeros
static Q place(const Step* s, Q time) {  // as a value of x
    return minus(over(times(q(2), minus(time, s->begin)), s->length), q(1));
}
static int check_claim(const Step* s, Row claim) {  // true if its last time is in the step: its interval has the tube
    const Problem* p = s->problem;
    long k = zero_of(p, claim[0]), n = s->n;
    Q first = place(s, k > 0 ? p->ends[2 * k - 1] : fraction(first_of(claim[0])));
    Q last = place(s, k > 0 ? p->ends[2 * k] : fraction(last_of(claim[0])));
    Q u = largest(first, q(-1)), v = least(last, q(1)), two = q(2), d = over(minus(v, u), two);
    if (!at_most(u, v)) return 0;
    long i = find_name(&p->scope, claim[1]) - p->scope.name - 1, e = s->scale[i];
    Set set = set_at(s, over(plus(u, v), two));
    Q *row = fractions(n), centre = set.centre[i];
    for (long j = 0; j < n; ++j) {
        Q more = shift(times(norm(derivative(s->V[i * n + j])), d), e - s->kv);
        row[j] = up(plus(absolute(set.frame[i * n + j]), more));
    }
    for (long b = 0; b < s->blocks; ++b)
        set.radii[b] = plus(set.radii[b], up(over(times(absolute(minus(s->R1[b], s->R0[b])), d), two)));
    Q reach = plus(row_times(row, s->at, s->blocks, set.radii), shift(times(norm(derivative(s->p[i])), d), e - s->kp));
    need(at_most(fraction(claim[2]), minus(centre, reach)) && at_most(plus(centre, reach), fraction(claim[3])),
         "the value of %s at %s is not proved to be in its interval", claim[1], claim[0]);
    return at_most(last, q(1));
}
/* The sign on [u, v] of the condition, k = 0, or of its derivative, if the middle and a bound of the slope prove it, or
   0. */
static int sure(const Step* s, int k, Q u, Q v) {
    int before = region;
    region = SIGN;
    Q y = value(s->function[k].a, over(plus(u, v), q(2)));
    Q reach = plus(over(times(s->function[k].slope, minus(v, u)), q(2)), s->function[k].reach);
    int sign = at_most(absolute(y), reach) ? 0 : mpq_sgn(y);
    region = before;
    release(SIGN);
    return sign;
}
// The sign of the condition on [u, v], but for a zero at the start, by halves; 0 if it is not proved.
static int sign_on(const Step* s, Q u, Q v, long depth) {
    int way = sure(s, 1, u, v), sign;
    int starts = s->problem->zero_start && mpq_equal(s->begin, s->problem->t0) && mpq_cmp_si(u, -1, 1) == 0;
    int left = starts ? way : sure(s, 0, u, u);
    if (left == sure(s, 0, v, v) && (way != 0 || sure(s, 0, u, v) != 0)) return left;
    if (at_most(times(s->function[0].slope, minus(v, u)), s->function[0].reach) || depth == DEPTH) return 0;
    Q middle = over(plus(u, v), q(2));
    sign = sign_on(s, u, middle, depth + 1);
    return sign != 0 && sign == sign_on(s, middle, v, depth + 1) ? sign : 0;
}
static int check_zeros(const Step* s) {  // true if the last one is before the end of the step
    Problem* p = s->problem;
    long last = 2 * p->zeros;
    Q end = place(s, p->ends[0]);
    for (long k = 0; k < last; ++k)
        need(at_most(place(s, p->ends[k]), place(s, p->ends[k + 1])), "the zeros are not in the order of the steps");
    for (long k = 0; k <= last; ++k) {
        Q u = largest(end, q(-1)), v;
        end = place(s, p->ends[k < last ? k + 1 : last]);
        v = least(end, q(1));
        if (!at_most(u, v)) continue;
        int sign = k % 2 == 1 ? sure(s, 1, u, v) : sign_on(s, u, v, 0);
        if ((k + 1) / 2 % 2 == 1) sign = -sign;
        need(sign != 0 && (p->sign == 0 || p->sign == sign), "the sign of the condition in its interval %ld", k + 1);
        p->sign = sign;
    }
    return at_most(end, q(1));
}

// --------------------------------------------------------------------------------------------------- certificates
static Set start_of(const Problem* p) {
    long n = p->n;
    Set r = {n, n, take((size_t)(n + 1) * sizeof(long)), fractions(n), fractions(n * n), fractions(n)};
    for (long i = 0; i < n * n; ++i) r.frame[i] = q(i / n == i % n);
    for (long i = 0; i <= n; ++i) r.at[i] = i;
    for (long i = 0; i < n; ++i) {
        Interval y = p->scope.name[i + 1].start;
        r.centre[i] = over(plus(y.low, y.high), q(2));
        r.radii[i] = up(over(minus(y.high, y.low), q(2)));
    }
    return r;
}
static Problem* check_one(char* text) {  // a certificate that is proved
    region = PROBLEM;
    step_number = line_at = 0;
    line_count = 1;
    for (const char* s = text; *s != 0; ++s) line_count += *s == '\n';
    lines = take((size_t)line_count * sizeof *lines);
    split(text, "\n", lines, line_count);
    Problem* p = read_problem();
    Set state = start_of(p);
    Q time = p->t0;
    int zeros = p->condition == NULL,
        *found = memset(take((size_t)p->claims * sizeof(int)), 0, p->claims * sizeof(int));
    long missing = p->claims;
    while (++step_number <= p->steps) {
        region = STEP + (int)(step_number % 2);
        release(region);  // the step before the last one
        Step* s = read_step(p, time);
        check_frame(s);
        check_joint(s, &state);
        Field f = field(s);
        check_growth(s, &f);
        for (long i = 0; i < p->claims; ++i)
            if (!found[i] && check_claim(s, p->claim[i])) found[i] = 1, --missing;
        zeros = zeros || check_zeros(s);
        time = plus(time, s->length);
        state = set_at(s, q(1));
    }
    step_number = 0;
    form(line_at + 2 == line_count && strcmp(lines[line_at], "end") == 0 && lines[line_at + 1][0] == 0,
         "the steps do not end with 'end'");
    need(zeros && missing == 0, "no step contains the time of a claim or a zero");
    region = PROBLEM;
    return p;
}
// The equations with their starts, on an interval that contains the initial time and all these times.
static void print_head(const Problem* p, char** times, long count) {
    char *t0 = mpq_get_str(NULL, 10, p->t0), *first = t0, *last = t0;
    Q low = p->t0, high = low;
    for (long k = 0; k < count; ++k) {
        Q time = fraction(times[k]);
        if (mpq_cmp(time, low) < 0) low = time, first = times[k];
        if (mpq_cmp(time, high) >= 0) high = time, last = times[k];
    }
    printf("solution of\n");
    for (long i = 0; i < p->equations; ++i)
        printf("%s%s = %s", i > 0 ? ",  " : "    ", p->equation[i][0], p->equation[i][1]);
    for (long i = 0; i < p->states; ++i)
        printf("%s%s(%s) = %s", i > 0 ? ",  " : ",\n    ", p->scope.name[i + 1].name, t0, p->start[i]);
    printf("\nexists on [%s, %s], and\n", first, last);
}
static void print_statement(const Problem* p) {
    char** times = take((size_t)(2 * p->zeros + p->claims) * sizeof *times);
    long count = 0;
    for (; count < 2 * p->zeros; ++count) times[count] = p->zero[count / 2][count % 2];
    for (long i = 0; i < p->claims; ++i)
        if (zero_of(p, p->claim[i][0]) == 0) times[count++] = p->claim[i][0];
    need(p->vary == NULL, "derivatives without a root");
    printf("Proved:\nThe ");
    print_head(p, times, count);
    if (p->condition != NULL) {
        gmp_printf("%s = 0 from %Qd, excluded, to %s only at ", p->condition, p->t0, p->zero[p->zeros - 1][1]);
        for (long k = 1; k <= p->zeros; ++k) printf("#%ld%s", k, k < p->zeros ? ", " : ", and\n");
    }
    for (long k = 0; k < p->zeros; ++k) {
        int order = at_most(p->ends[2 * k + 1], p->ends[2 * k + 2]);
        printf("    #%ld lies in [%s, %s],\n", k + 1, p->zero[k][!order], p->zero[k][order]);
    }
    for (long i = 0; i < p->claims; ++i) {
        char** c = p->claim[i];
        printf("    %s(%s) lies in [%s, %s]%s\n", c[1], c[0], c[2], c[3], i + 1 < p->claims ? "," : ".");
    }
}

// ------------------------------------------------------------------------------------------------------------- roots
/* F(u) = 0 for one u in a box, m in the middle, r at most half of its widths, since |C F(m)| + |1 - C F'| r < r. The
   values F are those of the first certificate; each column of F' is that of a certificate for all starts in the box, with
   the derivatives by one of them; if the time is an unknown, the last column has the derivatives y' by it. */
typedef struct {
    char **field, *name, *goal;
} Goal;
typedef struct {
    char *name, *middle, *low, *high;
    Q radius;
} Unknown;
typedef struct {
    Problem** problem;  // the first is of one start
    long problems, goals, unknowns, *moved;
    char *middle, *ends;  // times
    Goal* goal;
    Unknown* unknown;
    Interval *F, *columns;  // column j from columns[j * goals] on
} Root;

static int same_texts(const char* a, const char* b) { return strcmp(a, b) == 0; }
static int of_one_problem(const Problem* a, const Problem* b) {
    int equal = same_texts(a->variable, b->variable) && mpq_equal(a->t0, b->t0) && a->equations == b->equations;
    for (long i = 0; i < a->equations && equal; ++i)
        equal = same_texts(a->equation[i][0], b->equation[i][0]) && same_texts(a->equation[i][1], b->equation[i][1]);
    return equal;
}
static char* time_of_claims(Problem* const* first, long count) {
    char* time = first[0]->claim[0][0];
    for (Problem* const* p = first; p < first + count; ++p)
        for (long i = 0; i < (*p)->claims; ++i) form(same_texts(time, (*p)->claim[i][0]), "claims at different times");
    return time;
}
static Interval claimed(const Problem* p, const char* name) {
    for (long i = p->claims - 1; i >= 0; --i)
        if (same_texts(p->claim[i][1], name)) return (Interval){fraction(p->claim[i][2]), fraction(p->claim[i][3])};
    form(0, "no claim about '%s'", name);
    return exactly(q(0));
}
static void check_problems(Root* r) {  // which starts are moved
    const Problem *point = r->problem[0], *near = r->problem[1];
    int equal = 1, match = point->vary == NULL;
    for (long k = 1; k < r->problems; ++k) equal = equal && of_one_problem(point, r->problem[k]);
    equal = equal && (strchr(r->ends, ':') != NULL || mpq_equal(fraction(r->middle), fraction(r->ends)));
    need(equal, "certificates that are not of one problem");
    r->moved = take((size_t)point->states * sizeof *r->moved);
    for (long i = 0; i < point->states; ++i) {
        if (!same_texts(point->start[i], near->start[i])) r->moved[r->unknowns++] = i;
        for (long k = 1; k < r->problems; ++k) match = match && same_texts(r->problem[k]->start[i], near->start[i]);
    }
    match = match && r->unknowns == r->problems - 1;
    for (long k = 0; k < r->unknowns && match; ++k) {
        const char* vary = r->problem[k + 1]->vary;
        match = vary != NULL && same_texts(vary, point->scope.name[r->moved[k] + 1].name);
    }
    need(match, "starts that do not match");
}
static void read_goals(Root* r, char* text) {
    long lines_of_text = 1, most = 1;
    for (const char* s = text; *s != 0; ++s) lines_of_text += *s == '\n', most += *s == ' ' || *s == '\n';
    char** each = take((size_t)lines_of_text * sizeof *each);
    r->goals = split(text, "\n", each, lines_of_text) - 1;
    r->goal = take((size_t)lines_of_text * sizeof *r->goal);
    long unknowns = r->unknowns + (strchr(r->ends, ':') != NULL);
    form(*each[r->goals] == 0 && r->goals == unknowns, "no such roots");
    for (long i = 0; i < r->goals; ++i) {
        char** field = take((size_t)most * sizeof *field);
        long fields = split(each[i], " ", field, most);
        form(fields == unknowns + 3 && same_texts(field[0], "root"), "no such roots");
        r->goal[i] = (Goal){field + 3, field[1], field[2]};
    }
}
// The value at the end less that at the start, or less a number; of certificate k > 0 its derivative.
static Interval gap(const Root* r, long k, const Goal* goal) {
    const Problem* p = r->problem[k];
    const char* name = k > 0 ? derivative_name(goal->name) : goal->name;
    Interval x = claimed(p, name);
    if (same_texts(goal->goal, "start")) return linear(q(1), x, q(-1), find_name(&p->scope, name)->start);
    Q number = k > 0 ? q(0) : fraction(goal->goal);
    return (Interval){minus(x.low, number), minus(x.high, number)};
}
static Interval rate_of(const Problem* near, const char* name) {  // y' from the claims
    long n = near->claims;
    Name* known = take((size_t)n * sizeof *known);
    for (long i = 0; i < n; ++i)
        known[i] = (Name){.name = near->claim[i][1], .start = claimed(near, near->claim[i][1])};
    start_bits = near->bits;
    Interval found;
    const char* primed = NULL;
    for (long i = 0; i < near->equations; ++i) {
        Interval x = enclosure(formula(near->equation[i][1]), &(Scope){.name = known, .names = n});
        size_t length = strlen(name);
        if (strncmp(near->equation[i][0], name, length) != 0 || !same_texts(near->equation[i][0] + length, "'"))
            continue;
        primed = near->equation[i][0];
        found = x;
    }
    if (primed != NULL) return found;
    char* text;
    gmp_asprintf(&text, "%s'", name);
    return claimed(near, text);
}
static void read_unknowns(Root* r) {
    const Problem *point = r->problem[0], *near = r->problem[1];
    long moved = r->unknowns;
    r->unknown = take((size_t)(moved + 1) * sizeof *r->unknown);
    for (long k = 0; k < moved; ++k) {
        Unknown* u = &r->unknown[k];
        char *text = near->start[r->moved[k]], *ends[2] = {NULL, NULL}, *copy = take(strlen(text) + 1);
        gmp_asprintf(&u->name, "%s(%Qd)", point->scope.name[r->moved[k] + 1].name, point->t0);
        u->middle = point->start[r->moved[k]];
        strcpy(copy, text + 1);
        copy[strlen(copy) - 1] = 0;
        form(split(copy, ", ", ends, 2) == 2, "no interval of starts");
        u->low = ends[0];
        u->high = ends[1];
    }
    if (strchr(r->ends, ':') != NULL) {
        char *a = first_of(r->ends), *b = last_of(r->ends);
        int order = at_most(fraction(a), fraction(b));
        r->unknown[r->unknowns++] = (Unknown){point->variable, r->middle, order ? a : b, order ? b : a, NULL};
        for (long i = 0; i < r->goals; ++i) r->columns[moved * r->goals + i] = rate_of(near, r->goal[i].name);
    }
    for (Unknown* u = r->unknown; u < r->unknown + r->unknowns; ++u) {
        Q middle = fraction(u->middle);
        u->radius = largest(q(0), least(minus(middle, fraction(u->low)), minus(fraction(u->high), middle)));
    }
}
static Q distance(Q* c, const Interval* x, long n, int y) {  // at least |sum c_i x_i - y|
    Interval total = exactly(q(-y));
    for (long i = 0; i < n; ++i) total = linear(q(1), total, c[i], x[i]);
    return largest(absolute(total.low), absolute(total.high));
}
static void check_contraction(const Root* r) {
    long n = r->goals;
    Q* C = fractions(n * n);
    for (long i = 0; i < n * n; ++i) C[i] = fraction(r->goal[i / n].field[i % n]);
    for (long i = 0; i < n; ++i) {
        Q total = distance(C + i * n, r->F, n, 0);
        for (long j = 0; j < n; ++j)
            total = plus(total, times(distance(C + i * n, r->columns + j * n, n, i == j), r->unknown[j].radius));
        need(mpq_cmp(total, r->unknown[i].radius) < 0, "the condition for a root in %s", r->unknown[i].name);
    }
}
static void print_root(const Root* r) {
    const Problem *point = r->problem[0], *near = r->problem[1];
    char *times[] = {first_of(r->ends), last_of(r->ends)}, *time = strchr(r->ends, ':') ? point->variable : r->middle;
    printf("Proved:\nFor exactly one choice of ");
    for (long k = 0; k < r->unknowns; ++k) {
        const Unknown* u = &r->unknown[k];
        printf("%s%s in [%s, %s]", k > 0 ? ", " : "", u->name, u->low, u->high);
    }
    printf(" the ");
    print_head(near, times, 2);
    for (long i = 0; i < r->goals; ++i) {
        const Goal* g = &r->goal[i];
        printf("%s    %s(%s) = ", i > 0 ? ",\n" : "", g->name, time);
        if (same_texts(g->goal, "start"))
            gmp_printf("%s(%Qd)", g->name, point->t0);
        else
            printf("%s", g->goal);
    }
    printf(".\n");
}
static void check_root(Root* r, char* rest) {
    r->middle = time_of_claims(r->problem, 1);
    r->ends = time_of_claims(r->problem + 1, r->problems - 1);
    check_problems(r);
    read_goals(r, rest);
    r->F = take((size_t)(r->goals + 1) * sizeof *r->F);
    r->columns = take((size_t)((r->unknowns + 1) * r->goals + 1) * sizeof *r->columns);
    for (long i = 0; i < r->goals; ++i)
        for (long k = 0; k < r->problems; ++k)
            *(k == 0 ? &r->F[i] : &r->columns[(k - 1) * r->goals + i]) = gap(r, k, &r->goal[i]);
    read_unknowns(r);
    check_contraction(r);
    print_root(r);
}
static void check(char* text) {
    char *end = "\nend\n", *at = text, *next;
    long n = 0;
    for (char* s = text; (s = strstr(s, end)) != NULL; s += strlen(end)) ++n;
    if (n < 2) {
        print_statement(check_one(text));
        return;
    }
    Root r = {.problem = take((size_t)n * sizeof *r.problem), .problems = n};
    for (long k = 0; k < n; ++k, at = next + strlen(end)) {
        next = strstr(at, end);
        size_t size = next + strlen(end) - at;
        char* part = memcpy(take(size + 1), at, size);
        part[size] = 0;
        r.problem[k] = check_one(part);
    }
    check_root(&r, at);
}
static char* decompressed(FILE* file) {
    static unsigned char input[1 << 16];
    size_t size = 1 << 20, length = 0;
    char* text = take(size);
    z_stream z = {0};
    form(inflateInit(&z) == Z_OK, "zlib cannot be used");
    for (int state = Z_OK; state != Z_STREAM_END;) {
        if (z.avail_in == 0) {
            z.next_in = input;
            z.avail_in = (uInt)fread(input, 1, sizeof input, file);
            form(z.avail_in > 0, "the file is not the whole of a text compressed by zlib");
        }
        if (length + 1 == size) {
            text = resize(text, size, 2 * size);
            size *= 2;
        }
        z.next_out = (unsigned char*)text + length;
        z.avail_out = (uInt)(size - 1 - length < 1 << 20 ? size - 1 - length : 1 << 20);
        uInt room = z.avail_out;
        state = inflate(&z, Z_NO_FLUSH);
        form(state == Z_OK || state == Z_STREAM_END, "the file is not a text compressed by zlib");
        length += room - z.avail_out;
    }
    inflateEnd(&z);
    text[length] = 0;
    for (const char* s = text; s < text + length; ++s) form(*s > 0, "the text has characters that are not of ASCII");
    return text;
}

int main(int arguments, char** argument) {
    for (int r = 0; r < REGIONS; ++r) regions[r].before = regions[r].after = &regions[r];
    mp_set_memory_functions(take, resize, drop);
    form(arguments == 2, "usage: libration_check FILE");
    FILE* file = fopen(argument[1], "rb");
    form(file != NULL, "'%s' cannot be read", argument[1]);
    check(decompressed(file));
    fclose(file);
    return 0;
}
