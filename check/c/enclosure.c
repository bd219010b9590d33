#include <string.h>

#include "check.h"

/* Values of formulas as pairs (lower, upper), by interval arithmetic. The functions are sums
   of their series in integers, times 2^-b. */
static long precision;  // bits behind the point

Interval exactly(Q a) { return (Interval){a, a}; }

static Interval around(Q a, Q error) { return (Interval){minus(a, error), plus(a, error)}; }

Interval linear(Q a, Interval x, Q b, Interval y) {
    Q ax = times(a, x.low), az = times(a, x.high);
    Q by = times(b, y.low), bz = times(b, y.high);
    return (Interval){plus(least(ax, az), least(by, bz)),
                      plus(largest(ax, az), largest(by, bz))};
}

/* exp, sin or cos, by terms x^j/j!: each has an error below 2 e^|x| units, the argument one
   of e^|x|, and the rest is below 8. */
static Interval entire(Q x, char kind) {
    form(mpq_cmp(absolute(x), q(MOST_ARGUMENT)) < 0,
         "a start has an argument that is too large");
    long size = mpz_get_si(mpq_numref(ceiling(absolute(x))));
    long b = precision + 2 * size + 40;
    Q factor = whole(shift(x, b));
    Q t = shift(q(1), b);
    Q total = q(0);
    Q least_count = plus(absolute(plus(x, x)), q(2));
    long j = 0;
    while (j == 0 || mpz_cmpabs_ui(mpq_numref(t), 1) > 0 || mpq_cmp(q(j), least_count) < 0) {
        if (j > 0)
            t = whole(over(whole(shift(times(t, factor), -b)), q(j)));
        if (kind == 'e')
            total = plus(total, t);
        else if (j % 2 == (kind == 's'))
            total = j / 2 % 2 == 0 ? plus(total, t) : minus(total, t);
        ++j;
    }
    Interval r = around(total, times(q(2 * j + 10), power(q(3), (unsigned long)size)));
    return (Interval){shift(r.low, -b), shift(r.high, -b)};
}

/* The sum of sign^j z^(2j+1)/(2j+1), |z| <= 1/3, within 3 units a power, and the rest. */
static Interval odd_series(Q z, int sign) {
    long b = precision + 40;
    Q factor = whole(shift(z, b));
    Q p = factor;
    Q total = q(0);
    long j = 0;
    while (mpz_cmpabs_ui(mpq_numref(p), 1) > 0) {
        Q term = whole(over(p, q(2 * j + 1)));
        total = sign > 0 || j % 2 == 0 ? plus(total, term) : minus(total, term);
        p = whole(shift(times(p, factor), -b));
        p = whole(shift(times(p, factor), -b));
        ++j;
    }
    return around(shift(total, -b), shift(q(4 * j + 16), -b));
}

/* log(2^k m) = 2 artanh((m - 1)/(m + 1)) + 2 k artanh(1/3), 1/2 <= m <= 2. */
static Interval log_at(Q x) {
    long k = (long)mpz_sizeinbase(mpq_numref(x), 2) - (long)mpz_sizeinbase(mpq_denref(x), 2);
    Q y = shift(q(1), k);
    Interval a = odd_series(over(minus(x, y), plus(x, y)), 1);
    return linear(q(2), a, q(2 * k), odd_series(over(q(1), q(3)), 1));
}

/* 16 arctan(1/5) - 4 arctan(1/239). */
Interval pi_interval(long behind_point) {
    precision = behind_point;
    Interval a = odd_series(over(q(1), q(5)), -1);
    return linear(q(16), a, q(-4), odd_series(over(q(1), q(239)), -1));
}

static Interval logarithm(Interval x) {
    need(mpq_sgn(x.low) > 0, "a start has log or ^ of a number that is not positive");
    return (Interval){log_at(x.low).low, log_at(x.high).high};
}

/* exp, sin or cos, without the numbers that are needed for it. */
static Interval entire_alone(Q x, char kind) {
    int before = region;
    region = SIGN;
    Interval found = entire(x, kind);
    region = before;
    found = (Interval){plus(found.low, q(0)), plus(found.high, q(0))};
    release(SIGN);
    return found;
}

static Interval function_of_interval(const char* name, Interval x) {
    form(is_function(name), "unknown function '%s'", clipped(name));
    if (*name == 'l')
        return logarithm(x);
    Interval y = entire_alone(x.low, *name);
    if (*name == 'e')  // exp increases
        return (Interval){y.low, entire_alone(x.high, *name).high};
    Q width = minus(x.high, x.low);  // |sin'|, |cos'| <= 1
    return (Interval){minus(y.low, width), plus(y.high, width)};
}

static Interval whole_power(Interval x, Q exponent) {
    form(at_most(exponent, q(MOST_START_POWER)), "an exponent is out of range");
    long n = mpz_get_si(mpq_numref(exponent));
    long low = size_in_bits(x.low);
    long high = size_in_bits(x.high);
    form(((low > high ? low : high) - 1) * n <= MOST_NUMBER, "a number is too large");
    Q a = power(x.low, (unsigned long)n);
    Q b = power(x.high, (unsigned long)n);
    int crosses = n % 2 == 0 && mpq_sgn(x.low) <= 0 && mpq_sgn(x.high) >= 0;
    return (Interval){crosses ? q(0) : least(a, b), largest(a, b)};
}

static Interval power_of_interval(Interval x, Q r) {
    if (mpz_cmp_ui(mpq_denref(r), 1) == 0 && mpq_sgn(r) >= 0)
        return whole_power(x, r);
    Interval y = linear(r, logarithm(x), q(0), exactly(q(0)));  // x^r = exp(r log x)
    return (Interval){entire_alone(y.low, 'e').low, entire_alone(y.high, 'e').high};
}

static Interval inverse(Interval x) {
    need(mpq_sgn(x.low) > 0 || mpq_sgn(x.high) < 0, "a start divides by 0");
    return (Interval){over(q(1), x.high), over(q(1), x.low)};
}

static Interval product(Interval x, Interval y) {
    Q a = limited(times(x.low, y.low)), b = limited(times(x.low, y.high));
    Q c = limited(times(x.high, y.low)), d = limited(times(x.high, y.high));
    return (Interval){least(least(a, b), least(c, d)), largest(largest(a, b), largest(c, d))};
}

static Interval value_of(const Tree* t, Names names);

static Interval sum_of(const Tree* t, Names names) {
    Interval* part = take((size_t)t->parts * sizeof *part);
    Interval total = exactly(q(0));
    for (long i = 0; i < t->parts; ++i)
        part[i] = value_of(t->part[i], names);
    for (long i = 0; i < t->parts; ++i) {
        int less = t->sign[i] == '-';
        total.low =
            limited(less ? minus(total.low, part[i].high) : plus(total.low, part[i].low));
        total.high =
            limited(less ? minus(total.high, part[i].low) : plus(total.high, part[i].high));
    }
    return total;
}

static Interval value_of(const Tree* t, Names names) {
    if (t->kind == '0')
        return exactly(t->number);
    if (t->kind == 'x') {
        const Name* found = find_name(names, t->name);
        form(found != NULL, "unknown name '%s'", clipped(t->name));
        return found->start;
    }
    if (t->kind == '+')
        return sum_of(t, names);
    Interval x = value_of(t->part[0], names);
    if (t->kind == '*') {
        for (long i = 1; i < t->parts; ++i) {
            Interval y = value_of(t->part[i], names);
            x = product(x, t->sign[i] == '/' ? inverse(y) : y);
        }
        return x;
    }
    return t->kind == '^' ? power_of_interval(x, t->number) : function_of_interval(t->name, x);
}

Interval enclosure(const Tree* t, Names names, long behind_point) {
    precision = behind_point;
    return value_of(t, names);
}
