#include <string.h>

#include "check.h"

/* If each step begins in the tube of the step before, and the first one in the box of the
   initial values, the solution exists up to the end of the last step, and is in the tubes. */

/* The box of the enclosures of the initial values. */
static Set start_of(const Problem* p) {
    long n = p->n;
    long* at = take((size_t)(n + 1) * sizeof *at);
    Set r = {n, n, at, fractions(n), fractions(n * n), fractions(n)};
    for (long i = 0; i < n * n; ++i)
        r.frame[i] = q(i / n == i % n);
    for (long i = 0; i <= n; ++i)
        at[i] = i;
    for (long i = 0; i < n; ++i) {
        Interval y = p->names.name[i + 1].start;
        r.centre[i] = over(plus(y.low, y.high), q(2));
        r.radii[i] = up(over(minus(y.high, y.low), q(2)));
    }
    return r;
}

Problem* check_one(char* text) {
    region = PROBLEM;
    step_number = 0;
    Reader r = reader_of(text);
    Problem* p = read_problem(&r);
    Set state = start_of(p);
    Q time = p->t0;
    int direction = 0;
    Progress done = {0, 0, 0};
    while (++step_number <= p->steps) {
        region = STEP + (int)(step_number % 2);
        release(region);  // the step before the last one
        Step* s = read_step(&r, p, time);
        form(direction * mpq_sgn(s->length) >= 0, "a step in the other direction");
        direction = mpq_sgn(s->length);
        check_frame(s);
        check_joint(s, &state);
        Field f = field(s);
        check_growth(s, &f);
        check_progress(&done, s);
        time = plus(time, s->length);
        state = set_at(s, q(1));
    }
    step_number = 0;
    int ends =
        r.at + 2 == r.count && strcmp(r.line[r.at], "end") == 0 && r.line[r.at + 1][0] == 0;
    form(ends, "the steps do not end with 'end'");
    need(is_complete(&done, p), "no step contains the time of a claim or a zero");
    region = PROBLEM;
    return p;
}
