#include <stdio.h>
#include <string.h>

#include "check.h"

/* Newton's method. Let F(u) be the differences of both sides of the conditions at the end, m
   a vector, r > 0, and C a matrix. If, for the values F(m) and F' of all u with |u_j - m_j|
   <= r_j,

       |C F(m)|_i + sum_j |(1 - C F')_ij| r_j < r_i   for every i,

   then F = 0 for exactly one of these u. F(m) is in the intervals of the first certificate;
   column j of F' is in those of certificate j + 1, derivatives by the start of unknown j; if
   the time is an unknown, the last column has the derivatives by it. */
typedef struct {
    char** field;  // root NAME GOAL C_1 .. C_n
    long fields;
} Goal;
typedef struct {
    char *name, *middle, *low, *high;
    Q radius;
} Unknown;
typedef struct {
    Problem** problem;                              // the first is of one start
    long problems, goals, unknowns, moved, *place;  // place: of the starts that are moved
    char *middle, *ends;                            // times
    Goal* goal;
    Unknown* unknown;
    Interval *F, *columns;  // column j from columns[j * goals] on
} Root;

static int same_texts(const char* a, const char* b) { return strcmp(a, b) == 0; }

static int with_time(const Root* r) { return strchr(r->ends, ':') != NULL; }

static void read_goals(Root* r, char* rest) {
    long count = 1;
    long most = 1;
    for (const char* s = rest; *s != 0; ++s) {
        count += *s == '\n';
        most += *s == ' ' || *s == '\n';
    }
    char** each = take((size_t)count * sizeof *each);
    char** field = take((size_t)(most + count) * sizeof *field);
    split(rest, "\n", each, count);
    r->goals = count - 1;
    form(*each[r->goals] == 0, "the conditions do not end with a line");
    r->goal = take((size_t)count * sizeof *r->goal);
    for (long i = 0; i < r->goals; ++i) {
        long fields = split(each[i], " ", field, most);
        r->goal[i] = (Goal){field, fields};
        field += fields;
    }
}

static char* time_of_claims(Problem* const* first, long count) {
    char* time = first[0]->claim[0].field[0];
    for (Problem* const* p = first; p < first + count; ++p)
        for (long i = 0; i < (*p)->claims; ++i)
            form(same_texts(time, (*p)->claim[i].field[0]), "claims at different times");
    return time;
}

static int of_one_problem(const Problem* a, const Problem* b) {
    int same = same_texts(a->variable, b->variable) && mpq_equal(a->t0, b->t0);
    same = same && a->equations == b->equations;
    for (long i = 0; same && i < a->equations; ++i) {
        same = same_texts(a->equation[i].left, b->equation[i].left) &&
               same_texts(a->equation[i].right, b->equation[i].right);
    }
    return same;
}

/* The certificates are of one problem; the starts that differ are those of `vary`. */
static void check_problems(Root* r) {
    const Problem *point = r->problem[0], *near = r->problem[1];
    int same = 1;
    for (long k = 1; k < r->problems; ++k)
        same = same && of_one_problem(point, r->problem[k]);
    same = same && (with_time(r) || mpq_equal(fraction(r->middle), fraction(r->ends)));
    need(same, "certificates that are not of one problem");
    r->place = take((size_t)point->own * sizeof *r->place + 1);
    int match = point->vary == NULL;
    for (long i = 0; i < point->own; ++i) {
        if (!same_texts(point->start[i], near->start[i])) {
            r->place[r->moved] = i;
            ++r->moved;
        }
        for (long k = 1; k < r->problems; ++k)
            match = match && same_texts(r->problem[k]->start[i], near->start[i]);
    }
    match = match && r->moved == r->problems - 1;
    for (long k = 0; match && k < r->moved; ++k) {
        const char* vary = r->problem[k + 1]->vary;
        match = vary != NULL && same_texts(vary, point->names.name[r->place[k] + 1].name);
    }
    need(match, "starts that do not match");
}

static void read_unknowns(Root* r) {
    const Problem *point = r->problem[0], *near = r->problem[1];
    for (long i = 0, k = 0; i < point->own; ++i) {
        const int moved = k < r->moved && r->place[k] == i;
        form(moved == (*near->start[i] == '['), "no interval of starts");
        k += moved;
    }
    r->unknown = take((size_t)(r->moved + 1) * sizeof *r->unknown);
    for (long k = 0; k < r->moved; ++k) {
        Unknown* u = &r->unknown[k];
        char *text = near->start[r->place[k]], *ends[2] = {NULL, NULL};
        size_t length = strlen(text);
        form(*text == '[' && strstr(text, ", ") != NULL, "no interval of starts");
        split(copied(text + 1, length - 2), ", ", ends, 2);
        gmp_asprintf(&u->name, "%s(%s)", point->names.name[r->place[k] + 1].name,
                     point->t0_text);
        u->middle = point->start[r->place[k]];
        u->low = ends[0];
        u->high = ends[1];
    }
    r->unknowns = r->moved;
    if (with_time(r)) {
        char* colon = strchr(r->ends, ':');
        char* a = copied(r->ends, (size_t)(colon - r->ends));
        char* b = colon + 1;
        int order = at_most(fraction(a), fraction(b));
        r->unknown[r->unknowns] =
            (Unknown){point->variable, r->middle, order ? a : b, order ? b : a, NULL};
        ++r->unknowns;
    }
}

static long place_of(const Problem* p,
                     const char* name) {  // of an unknown of the equations, or 0
    const Name* found = find_name((Names){p->names.name, 1 + p->own}, name);
    return found == NULL ? 0 : found - p->names.name;
}

static void check_goals(const Root* r) {
    int good = r->goals == r->unknowns;
    for (long i = 0; good && i < r->goals; ++i) {
        const Goal* g = &r->goal[i];
        good = g->fields == r->unknowns + 3 && same_texts(g->field[0], "root");
        good = good && place_of(r->problem[0], g->field[1]) > 0;
    }
    form(good, "not one condition for each unknown");
}

static Interval claimed(const Problem* p, const char* name) {
    for (long i = p->claims - 1; i >= 0; --i)
        if (same_texts(p->claim[i].field[1], name))
            return (Interval){p->claim[i].low, p->claim[i].high};
    form(0, "no claim about '%s'", clipped(name));
    return exactly(q(0));
}

static Interval less(Interval x, Interval y) {
    return (Interval){minus(x.low, y.high), minus(x.high, y.low)};
}

/* The derivative of an unknown by the time, from the unknowns with claims. */
static Interval rate_of(const Problem* near, const char* name) {
    char* primed;
    gmp_asprintf(&primed, "%s'", name);
    for (long i = 0; i < near->equations; ++i) {
        if (!same_texts(near->equation[i].left, primed))
            continue;
        Names known = {take((size_t)near->claims * sizeof(Name)), 0};
        for (long k = near->claims - 1; k >= 0; --k) {
            const char* claim = near->claim[k].field[1];
            if (place_of(near, claim) > 0) {
                known.name[known.count] = (Name){.name = claim, .start = claimed(near, claim)};
                ++known.count;
            }
        }
        return enclosure(parsed(near->equation[i].right).tree, known, near->bits);
    }
    return claimed(near, primed);
}

/* F and the columns of its derivative as intervals. */
static void find_values(Root* r) {
    const Problem* point = r->problem[0];
    r->F = take((size_t)r->goals * sizeof *r->F + 1);
    r->columns = take((size_t)(r->unknowns * r->goals) * sizeof *r->columns + 1);
    for (long i = 0; i < r->goals; ++i) {
        char *name = r->goal[i].field[1], *goal = r->goal[i].field[2], *by_start;
        long place = place_of(point, name);
        int starts = same_texts(goal, "start");
        Interval at_goal = starts ? point->names.name[place].start : exactly(fraction(goal));
        r->F[i] = less(claimed(point, name), at_goal);
        gmp_asprintf(&by_start, "d(%s)", name);
        for (long k = 0; k < r->moved; ++k) {
            int own = starts && r->place[k] + 1 == place;
            Interval x = claimed(r->problem[k + 1], by_start);
            r->columns[k * r->goals + i] = less(x, exactly(q(own)));
        }
    }
    for (long i = 0; with_time(r) && i < r->goals; ++i)
        r->columns[r->moved * r->goals + i] = rate_of(r->problem[1], r->goal[i].field[1]);
}

/* At least |sum c_i x_i - y|. */
static Q distance(Q* c, const Interval* x, long n, int y) {
    Interval total = exactly(q(-y));
    for (long i = 0; i < n; ++i)
        total = linear(q(1), total, c[i], x[i]);
    return largest(absolute(total.low), absolute(total.high));
}

static void check_contraction(const Root* r) {
    long n = r->goals;
    Q* C = fractions(n);
    for (Unknown* u = r->unknown; u < r->unknown + r->unknowns; ++u) {
        Q middle = fraction(u->middle);
        Q low = fraction(u->low);
        Q high = fraction(u->high);
        u->radius = largest(q(0), least(minus(middle, low), minus(high, middle)));
    }
    for (long i = 0; i < n; ++i) {
        for (long j = 0; j < n; ++j)
            C[j] = fraction(r->goal[i].field[3 + j]);
        Q total = distance(C, r->F, n, 0);
        for (long j = 0; j < n; ++j) {
            Q apart = distance(C, r->columns + j * n, n, i == j);
            total = plus(total, times(apart, r->unknown[j].radius));
        }
        int contracts = mpq_cmp(total, r->unknown[i].radius) < 0;
        need(contracts, "the condition for a root in %s", r->unknown[i].name);
    }
}

static void print_root(const Root* r) {
    const Problem *point = r->problem[0], *near = r->problem[1];
    char* colon = strchr(r->ends, ':');
    size_t length = colon ? (size_t)(colon - r->ends) : strlen(r->ends);
    char* times[] = {copied(r->ends, length), colon ? colon + 1 : r->ends};
    printf("Proved:\nFor exactly one choice of ");
    for (long k = 0; k < r->unknowns; ++k) {
        const Unknown* u = &r->unknown[k];
        printf("%s%s in [%s, %s]", k > 0 ? ", " : "", u->name, u->low, u->high);
    }
    printf(" the ");
    print_head(near, times, 2);
    for (long i = 0; i < r->goals; ++i) {
        char *name = r->goal[i].field[1], *goal = r->goal[i].field[2];
        printf("%s    %s(%s) = ", i > 0 ? ",\n" : "", name,
               colon ? point->variable : r->middle);
        if (same_texts(goal, "start"))
            printf("%s(%s)", name, point->t0_text);
        else
            printf("%s", goal);
    }
    printf(".\nThe variable is %s.\n", point->variable);
    print_notes(point);
}

void check_root(Problem** problem, long problems, char* rest) {
    Root r = {.problem = problem, .problems = problems};
    read_goals(&r, rest);
    r.middle = time_of_claims(problem, 1);
    r.ends = time_of_claims(problem + 1, problems - 1);
    check_problems(&r);
    read_unknowns(&r);
    check_goals(&r);
    find_values(&r);
    check_contraction(&r);
    print_root(&r);
}
