#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

long bits;

Q q(long n) {
    Q x = take(sizeof *x);
    mpq_init(x);
    mpq_set_si(x, n, 1);
    return x;
}

Q q_of(mpz_srcptr n) {
    Q x = q(0);
    mpz_set(mpq_numref(x), n);
    return x;
}

Q plus(Q a, Q b) {
    Q c = q(0);
    mpq_add(c, a, b);
    return c;
}

Q minus(Q a, Q b) {
    Q c = q(0);
    mpq_sub(c, a, b);
    return c;
}

Q times(Q a, Q b) {
    Q c = q(0);
    mpq_mul(c, a, b);
    return c;
}

Q over(Q a, Q b) {
    Q c = q(0);
    mpq_div(c, a, b);
    return c;
}

Q negative(Q a) { return minus(q(0), a); }

Q absolute(Q a) { return mpq_sgn(a) < 0 ? negative(a) : a; }

int at_most(Q a, Q b) { return mpq_cmp(a, b) <= 0; }

Q least(Q a, Q b) { return at_most(a, b) ? a : b; }

Q largest(Q a, Q b) { return at_most(a, b) ? b : a; }

Q shift(Q a, long k) {
    Q b = q(0);
    if (k < 0)
        mpq_div_2exp(b, a, (mp_bitcnt_t)-k);
    else
        mpq_mul_2exp(b, a, (mp_bitcnt_t)k);
    return b;
}

Q whole(Q a) {
    Q b = q(0);
    mpz_fdiv_q(mpq_numref(b), mpq_numref(a), mpq_denref(a));
    return b;
}

Q ceiling(Q a) { return negative(whole(negative(a))); }

Q up(Q a) { return shift(ceiling(shift(a, bits)), -bits); }

Q root_up(Q a) {
    if (mpq_sgn(a) <= 0)
        return q(0);
    Q b = shift(a, 2 * bits);
    mpz_sub_ui(mpq_numref(b), mpq_numref(b), 1);
    mpz_sqrt(mpq_numref(b), mpq_numref(b));
    return shift(plus(b, q(1)), -bits);
}

Q power(Q a, unsigned long n) {
    Q b = q(0);
    mpz_pow_ui(mpq_numref(b), mpq_numref(a), n);
    mpz_pow_ui(mpq_denref(b), mpq_denref(a), n);
    return b;
}

static long bit_length(mpz_srcptr n) {
    return mpz_sgn(n) == 0 ? 0 : (long)mpz_sizeinbase(n, 2);
}

long size_in_bits(Q a) {
    long above = bit_length(mpq_numref(a));
    long below = bit_length(mpq_denref(a));
    return above > below ? above : below;
}

Q limited(Q a) {
    form(size_in_bits(a) <= MOST_NUMBER, "a number is too large");
    return a;
}

Q integer_of(const char* digits, size_t length) {
    Q x = q(0);
    mpz_set_str(mpq_numref(x), copied(digits, length), 10);
    return x;
}

static size_t digits_at(const char* s) { return strspn(s, "0123456789"); }

/* The parts of a number such as -2/3, 25, -0.25 or 1.5e-7; 0 if the text is none. */
typedef struct {
    const char *whole, *below, *decimals;
    size_t n, n_below, n_decimals;
    long exponent;
} Parts;

static int parts_of(const char* s, Parts* found) {
    *found = (Parts){.whole = s + (*s == '-')};
    found->n = digits_at(found->whole);
    s = found->whole + found->n;
    if (found->n > 0 && *s == '/') {
        found->below = s + 1;
        found->n_below = digits_at(s + 1);
        return found->n_below > 0 && s[1 + found->n_below] == 0;
    }
    if (found->n > 0 && *s == '.') {
        found->decimals = s + 1;
        found->n_decimals = digits_at(s + 1);
        s += 1 + found->n_decimals;
        if (found->n_decimals == 0)
            return 0;
    }
    if (found->n > 0 && *s == 'e') {
        size_t sign = s[1] == '-' || s[1] == '+';
        size_t n = digits_at(s + 1 + sign);
        found->exponent = n > 0 && n <= 5 ? atol(s + 1) : 0;
        s += 1 + sign + n;
        if (n == 0 || n > 5)
            return 0;
    }
    return found->n > 0 && *s == 0;
}

Q fraction(const char* text) {
    Parts p;
    form(parts_of(text, &p), "'%s' is not a number", clipped(text));
    size_t digits = p.n + p.n_decimals > p.n_below ? p.n + p.n_decimals : p.n_below;
    form(digits <= MOST_DIGITS, "a number has too many digits");
    Q below = p.n_below > 0 ? integer_of(p.below, p.n_below) : q(1);
    form(mpq_sgn(below) > 0, "'%s' is not a number", clipped(text));
    Q x = integer_of(p.whole, p.n);
    if (p.n_decimals > 0) {
        Q decimals = integer_of(p.decimals, p.n_decimals);
        x = plus(times(x, power(q(10), p.n_decimals)), decimals);
    }
    long exponent = p.exponent - (long)p.n_decimals;
    Q ten = power(q(10), (unsigned long)labs(exponent));
    x = over(x, below);
    x = exponent < 0 ? over(x, ten) : times(x, ten);
    return *text == '-' ? negative(x) : x;
}
