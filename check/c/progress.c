#include "check.h"

/* A value in the tube at x is within sum_b |V_ib(x)| r_b(x) of p_i(x). On an interval [u, v]
   of x, values, |V_ib| and r_b differ from those in the middle by at most (v - u)/2 times a
   bound of their derivatives.

   A function has on [u, v] the sign of its value in the middle if that is larger than (v -
   u)/2 times a bound of the slope, plus the change in the tube; it has that of both ends if
   these are equal and its derivative has a sign. A condition with different signs before and
   behind an interval, where its derivative has a sign, has one zero there. */

/* A time as a value of x. */
static Q place(const Step* s, Q time) {
    return minus(over(times(q(2), minus(time, s->begin)), s->length), q(1));
}

/* On [u, v] the tube is in the interval of the claim. */
static void check_claim(const Step* s, const Claim* c, Q u, Q v) {
    long n = s->n;
    long i = c->place - 1;
    long e = s->scale[i];
    Q half = over(minus(v, u), q(2));
    Q x = over(plus(u, v), q(2));
    Q centre = shift(value(s->p[i], x), e - s->kp);
    Q reach = shift(times(norm(derivative(s->p[i])), half), e - s->kp);
    Q* row = fractions(n);
    for (long j = 0; j < n; ++j) {
        List entry = s->V[i * n + j];
        Q more = times(norm(derivative(entry)), half);
        row[j] = up(shift(plus(absolute(value(entry, x)), more), e - s->kv));
    }
    Q* radii = fractions(s->blocks);
    for (long b = 0; b < s->blocks; ++b) {
        Q more = over(times(absolute(minus(s->R1[b], s->R0[b])), half), q(2));
        radii[b] = plus(radius_at(s, b, x), up(more));
    }
    reach = plus(reach, row_times(row, s->at, s->blocks, radii));
    int within = at_most(c->low, minus(centre, reach)) && at_most(plus(centre, reach), c->high);
    need(within, "the value of %s at %s is not proved to be in its interval", c->field[1],
         c->field[0]);
}

/* The sign on [u, v] of the condition, k = 0, or of its derivative, k = 1; 0 if it is not
   proved. */
static int sure(const Step* s, int k, Q u, Q v) {
    int before = region;
    region = SIGN;
    Q y = value(s->function[k].a, over(plus(u, v), q(2)));
    Q slope = over(times(s->function[k].slope, minus(v, u)), q(2));
    Q reach = plus(slope, s->function[k].reach);
    int sign = at_most(absolute(y), reach) ? 0 : mpq_sgn(y);
    region = before;
    release(SIGN);
    return sign;
}

/* The sign of the condition on a part, or 0. Where the condition is 0 at the initial time,
   the sign of its derivative is that behind it. */
static int sign_on_part(const Step* s, Q u, Q v) {
    const Problem* p = s->problem;
    int starts = p->zero_start && mpq_equal(s->begin, p->t0) && mpq_cmp_si(u, -1, 1) == 0;
    int way = sure(s, 1, u, v);
    int left = starts ? way : sure(s, 0, u, u);
    int known = left == sure(s, 0, v, v) && (way != 0 || sure(s, 0, u, v) != 0);
    return known ? left : 2;  // 2: halves are needed
}

/* The sign of the condition on [u, v], by halves; 0 if it is not proved. */
static int sign_on(const Step* s, Q u, Q v) {
    Q left[MOST_PARTS + 1], right[MOST_PARTS + 1];
    long parts = 1;
    int sign = 0;
    left[0] = u;
    right[0] = v;
    for (long k = 0; k < MOST_PARTS && parts > 0; ++k) {
        --parts;
        u = left[parts];
        v = right[parts];
        int found = sign_on_part(s, u, v);
        if (found == 2) {
            if (at_most(times(s->function[0].slope, minus(v, u)), s->function[0].reach))
                return 0;
            Q middle = over(plus(u, v), q(2));
            left[parts] = middle;
            right[parts] = v;
            left[parts + 1] = u;
            right[parts + 1] = middle;
            parts += 2;
        } else if (found == 0 || sign == -found) {
            return 0;
        } else {
            sign = found;
        }
    }
    return parts == 0 ? sign : 0;
}

static void check_claims(Progress* done, const Step* s) {
    const Problem* p = s->problem;
    for (long k = done->claims; k < p->claims; ++k) {
        Q last = place(s, p->claim[k].last);
        Q u = largest(place(s, p->claim[k].first), q(-1));
        Q v = least(last, q(1));
        if (!at_most(u, v))
            break;
        check_claim(s, &p->claim[k], u, v);
        done->claims += at_most(last, q(1));
    }
}

/* A sign of the condition, or of its derivative where a zero is; these alternate. */
static void check_interval(Progress* done, const Step* s, Q u, Q v) {
    long k = done->interval;
    int sign = k % 2 == 1 ? sure(s, 1, u, v) : sign_on(s, u, v);
    sign = (k + 1) / 2 % 2 == 1 ? -sign : sign;
    int alternate = sign != 0 && (done->sign == 0 || done->sign == sign);
    need(alternate, "the sign of the condition in its interval %ld", k + 1);
    done->sign = sign;
}

/* Interval 0 is before the first zero, 1 has it, 2 is behind it, and so on; the last one is
   one time. */
static void check_intervals(Progress* done, const Step* s) {
    const Problem* p = s->problem;
    long ends = 2 * p->zeros;
    while (p->zeros > 0 && done->interval <= ends) {
        long next = done->interval < ends ? done->interval + 1 : ends;
        Q last = place(s, p->ends[next]);
        Q u = largest(place(s, p->ends[done->interval]), q(-1));
        Q v = least(last, q(1));
        if (!at_most(u, v))
            break;
        check_interval(done, s, u, v);
        if (!at_most(last, q(1)))
            break;
        ++done->interval;
    }
}

void check_progress(Progress* done, const Step* s) {
    const Problem* p = s->problem;
    Q way = minus(p->ends[2 * p->zeros], p->t0);
    need(mpq_sgn(way) * mpq_sgn(s->length) >= 0, "the zeros are not in the order of the steps");
    check_claims(done, s);
    check_intervals(done, s);
}

int is_complete(const Progress* done, const Problem* p) {
    long intervals = p->zeros > 0 ? 2 * p->zeros + 1 : 0;
    return done->claims == p->claims && done->interval == intervals;
}
