#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* A statement shows equations, starts and a condition as they are typed. They say what they
   seem to say, because each name has one meaning: names of the variable and of unknowns are
   not functions, not pi, and have no primes, which are derivatives; definitions are _1, _2,
   .., names of nothing else. Equations and the condition contain the variable and the
   unknowns, definitions also those before them, starts only pi. */

static void add_unknown(Problem* p, const char* name) {
    long k = p->names.count;
    p->names.name[k] = (Name){.name = name, .own = unknown((int)k)};
    ++p->names.count;
}

static void check_name(const Problem* p, const char* name) {
    int defined =
        name[0] == '_' && name[1] != 0 && strspn(name + 1, "0123456789") == strlen(name + 1);
    int good = *name != 0 && name_length(name) == strlen(name) && strchr(name, '\'') == NULL;
    form(good && !defined && !is_reserved(name), "'%s' cannot be a name", clipped(name));
    int known = strcmp(p->variable, name) == 0;
    for (long i = 0; i < p->equations; ++i)
        known = known || strcmp(p->equation[i].name, name) == 0;
    form(!known, "two meanings of the name '%s'", clipped(name));
}

static Equation equation_of(char* text) {
    char* sides[2] = {NULL, NULL};
    long n = split(text, " = ", sides, 2);
    size_t length = strlen(sides[0]);
    size_t own = length;
    while (own > 0 && sides[0][own - 1] == '\'')
        --own;
    form(n == 2 && own < length, "an unclear equation");
    return (Equation){sides[0], sides[1], copied(sides[0], own), (long)(length - own)};
}

static void read_equations(Reader* r, Problem* p) {
    long count, starts, varied;
    char** text = all(r, "equation", MOST_UNKNOWNS, &count);
    p->equation = take((size_t)count * sizeof *p->equation + 1);
    for (long i = 0; i < count; ++i) {
        Equation e = equation_of(text[i]);
        check_name(p, e.name);
        form(p->own + e.order <= MOST_UNKNOWNS, "there are too many unknowns");
        p->own += e.order;
        for (long k = 0; k < e.order; ++k)
            add_unknown(p, copied(e.left, strlen(e.name) + (size_t)k));
        p->equation[p->equations] = e;
        ++p->equations;
    }
    p->start = all(r, "start", MOST_UNKNOWNS, &starts);
    form(starts == p->own, "not one start for each unknown");
    char** vary = all(r, "vary", 1, &varied);
    p->vary = varied > 0 ? vary[0] : NULL;
    const Name* found = varied > 0 ? find_name(p->names, p->vary) : NULL;
    form(varied == 0 || (found != NULL && found > p->names.name),
         "the line 'vary' has no unknown");
    p->given = p->own;
    for (long i = 1; varied > 0 && i <= p->own; ++i) {
        char* name;
        gmp_asprintf(&name, "d(%s)", p->names.name[i].name);
        add_unknown(p, name);
        p->given = 2 * p->own;
    }
}

static void read_definitions(Reader* r, Problem* p) {
    long conditions;
    p->definition = all(r, "define", MOST_DEFINITIONS, &p->defined);
    int good = 1;
    for (long i = 0; i < p->defined; ++i) {
        char name[32];
        char* sides[2] = {NULL, NULL};
        snprintf(name, sizeof name, "_%ld", i + 1);
        long n = split(p->definition[i], " = ", sides, 2);
        good = good && n == 2 && strcmp(sides[0], name) == 0;
        p->definition[i] = sides[1];
    }
    form(good, "the definitions are not of _1, _2, ..");
    char** condition = all(r, "condition", 1, &conditions);
    p->condition = conditions > 0 ? condition[0] : NULL;
    long* both = integers(r, "bits", 2, MOST_INTEGER);
    p->bits = both[0];
    p->start_bits = both[1];
    bits = p->bits;
    good = 16 <= p->bits && p->bits <= p->start_bits && p->start_bits <= MOST_BITS;
    form(good, "the bits are out of range");
}

/* The fractions of these lines, with their exponents, are not too long together. */
static void check_ends(char* const* text, long count) {
    long size = 0;
    for (long i = 0; i < count; ++i) {
        size += (long)strlen(text[i]);
        for (const char* s = text[i]; (s = strchr(s, 'e')) != NULL;) {
            ++s;
            const char* digits = s + (*s == '-' || *s == '+');
            size_t n = strspn(digits, "0123456789");
            if (n > 0) {
                n = n < 5 ? n : 5;
                size += atol(copied(digits, n));
                s = digits + n;
            }
        }
    }
    form(size <= MOST_ENDS, "the fractions are too long");
}

static void read_zeros(Reader* r, Problem* p) {
    char** text = all(r, "zero", MOST_ZEROS, &p->zeros);
    check_ends(text, p->zeros);
    int good = 1;
    p->zero = take((size_t)p->zeros * sizeof *p->zero + 1);
    for (long k = 0; k < p->zeros; ++k)
        good = split(text[k], " ", p->zero[k], 4) == 2 && good;
    form(good, "an unclear zero");
    form((p->condition == NULL) == (p->zeros == 0), "a condition or zeros alone");
    p->ends = take((size_t)(2 * p->zeros + 1) * sizeof *p->ends);
    p->ends[0] = p->t0;
    for (long k = 0; k < 2 * p->zeros; ++k)
        p->ends[k + 1] = fraction(p->zero[k / 2][k % 2]);
    Q way = minus(p->ends[2 * p->zeros], p->t0);
    for (long k = 0; k < 2 * p->zeros; ++k)
        good = good && mpq_sgn(minus(p->ends[k + 1], p->ends[k])) * mpq_sgn(way) >= 0;
    need(good, "the zeros are not in the order of the steps");
}

long zero_of(const Problem* p, const char* time) {
    char name[32];
    long k = *time == '#' ? strtol(time + 1, NULL, 10) : 0;
    snprintf(name, sizeof name, "#%ld", k);
    return k > 0 && k <= p->zeros && strcmp(name, time) == 0 ? k : 0;
}

/* The times of FIRST:LAST, or of TIME. */
static void read_times(const Problem* p, Claim* c) {
    long k = zero_of(p, c->field[0]);
    if (k > 0) {
        c->first = p->ends[2 * k - 1];
        c->last = p->ends[2 * k];
        return;
    }
    char* colon = strchr(c->field[0], ':');
    char* last = strrchr(c->field[0], ':');
    size_t length = strlen(c->field[0]);
    c->first = fraction(copied(c->field[0], colon ? (size_t)(colon - c->field[0]) : length));
    c->last = colon ? fraction(last + 1) : c->first;
    Q way = times(minus(c->first, p->t0), minus(c->last, c->first));
    int of_root = colon == last && p->vary != NULL && mpq_sgn(way) >= 0;
    form(colon == NULL || of_root, "an unclear time");
}

static Claim claim_of(const Problem* p, char* text) {
    Claim c = {.place = 0};
    long n = split(text, " ", c.field, 4);
    const Name* y = n == 4 ? find_name(p->names, c.field[1]) : NULL;
    form(y != NULL && y > p->names.name, "an unclear claim");
    c.place = y - p->names.name;
    read_times(p, &c);
    c.low = fraction(c.field[2]);
    c.high = fraction(c.field[3]);
    return c;
}

static int same_or_later(const Problem* p, Q a, Q b) {
    return at_most(absolute(minus(a, p->t0)), absolute(minus(b, p->t0)));
}

static void read_claims(Reader* r, Problem* p) {
    char** text = all(r, "claim", MOST_CLAIMS, &p->claims);
    check_ends(text, p->claims);
    p->claim = take((size_t)p->claims * sizeof *p->claim + 1);
    for (long i = 0; i < p->claims; ++i)
        p->claim[i] = claim_of(p, text[i]);
    form(p->claims > 0, "there is no claim");
    int ordered = 1;
    int one_time = 1;
    char* once = memset(take((size_t)p->given + 1), 1, (size_t)p->given + 1);
    for (long i = 0; i < p->claims; ++i) {
        const Claim *c = &p->claim[i], *before = &p->claim[i > 0 ? i - 1 : 0];
        ordered = ordered && same_or_later(p, before->first, c->first);
        ordered = ordered && same_or_later(p, before->last, c->last);
        one_time = one_time && strcmp(before->field[0], c->field[0]) == 0 && once[c->place];
        once[c->place] = 0;
    }
    form(ordered, "the claims are not in the order of their times");
    form(p->vary == NULL || one_time, "derivatives at several times, or twice");
}

Problem* read_problem(Reader* r) {
    Problem* p = take(sizeof *p);
    *p = (Problem){.n = 0};
    form(strcmp(line(r, "libration-certificate"), "1") == 0, "not a certificate of version 1");
    p->note = all(r, "note", MOST_DEFINITIONS, &p->notes);
    p->variable = line(r, "variable");
    p->t0_text = line(r, "at");
    p->names.name = take((size_t)(2 * MOST_UNKNOWNS + MOST_DEFINITIONS + 1) * sizeof(Name));
    check_name(&(Problem){.variable = ""}, p->variable);
    add_unknown(p, p->variable);
    p->t0 = fraction(p->t0_text);
    p->names.name[0].start = exactly(p->t0);
    read_equations(r, p);
    read_definitions(r, p);
    read_zeros(r, p);
    read_claims(r, p);
    p->steps = *integers(r, "steps", 1, MOST_INTEGER);
    p->n = p->given + p->defined;
    form(p->n <= MOST_UNKNOWNS, "there are too many unknowns");
    make_polynomial_form(p);
    return p;
}
