#include <stdio.h>

#include "check.h"

/* The equations with their starts, on an interval that contains the initial time and all
   these times. */
void print_head(const Problem* p, char** times, long count) {
    char *first = p->t0_text, *last = first;
    Q low = p->t0, high = low;
    for (long k = 0; k < count; ++k) {
        Q time = fraction(times[k]);
        if (mpq_cmp(time, low) < 0) {
            low = time;
            first = times[k];
        }
        if (mpq_cmp(time, high) >= 0) {
            high = time;
            last = times[k];
        }
    }
    printf("solution of\n    ");
    for (long i = 0; i < p->equations; ++i)
        printf("%s%s = %s", i > 0 ? ",  " : "", p->equation[i].left, p->equation[i].right);
    printf(",\n    ");
    for (long i = 0; i < p->own; ++i) {
        const char* name = p->names.name[i + 1].name;
        printf("%s%s(%s) = %s", i > 0 ? ",  " : "", name, p->t0_text, p->start[i]);
    }
    printf("\nexists on [%s, %s], and\n", first, last);
}

static void print_zeros(const Problem* p) {
    char* last = p->zero[p->zeros - 1][1];
    printf("%s = 0 from %s, excluded, to %s only at ", p->condition, p->t0_text, last);
    for (long k = 1; k <= p->zeros; ++k)
        printf("#%ld%s", k, k < p->zeros ? ", " : ", and\n");
    for (long k = 0; k < p->zeros; ++k) {
        int order = at_most(p->ends[2 * k + 1], p->ends[2 * k + 2]);
        printf("    #%ld lies in [%s, %s],\n", k + 1, p->zero[k][!order], p->zero[k][order]);
    }
}

void print_notes(const Problem* p) {
    for (long i = 0; i < p->notes; ++i)
        printf("Not checked: %s\n", p->note[i]);
}

void print_statement(const Problem* p) {
    char** times = take((size_t)(2 * p->zeros + p->claims) * sizeof *times);
    long count = 0;
    for (; count < 2 * p->zeros; ++count)
        times[count] = p->zero[count / 2][count % 2];
    for (long i = 0; i < p->claims; ++i) {
        if (*p->claim[i].field[0] != '#') {
            times[count] = p->claim[i].field[0];
            ++count;
        }
    }
    need(p->vary == NULL, "derivatives without a root");
    printf("Proved:\nThe ");
    print_head(p, times, count);
    if (p->condition != NULL)
        print_zeros(p);
    for (long i = 0; i < p->claims; ++i) {
        char* const* c = p->claim[i].field;
        const char* end = i + 1 < p->claims ? "," : ".";
        printf("    %s(%s) lies in [%s, %s]%s\n", c[1], c[0], c[2], c[3], end);
    }
    printf("The variable is %s.\n", p->variable);
    print_notes(p);
}
