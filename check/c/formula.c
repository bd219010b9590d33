#include <ctype.h>
#include <string.h>

#include "check.h"

static const char *text, *cursor;  // of the formula that is read
static long nesting, operations, functions;

static Tree* sum(void);

static void understood(int condition) {
    form(condition, "'%s' is not understood", clipped(text));
}

size_t name_length(const char* s) {
    size_t n = 0;
    if (!isalpha((unsigned char)*s) && *s != '_')
        return 0;
    while (isalnum((unsigned char)s[n]) || s[n] == '_')
        ++n;
    return n + strspn(s + n, "'");
}

int is_function(const char* name) {
    const char* known[] = {"exp", "log", "sin", "cos"};
    int found = 0;
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i)
        found = found || strcmp(known[i], name) == 0;
    return found;
}

int is_reserved(const char* name) {
    return is_function(name) || strcmp(name, "sqrt") == 0 || strcmp(name, "pi") == 0;
}

/* The text consists of integers, names, operators, parentheses and spaces. */
static void check_tokens(void) {
    for (const char* s = text; *s != 0;) {
        size_t n = name_length(s);
        understood(n > 0 || strchr("0123456789+-*/^() ", *s) != NULL);
        s += n > 0 ? n : 1;
    }
}

static char next(void) {
    while (*cursor == ' ')
        ++cursor;
    return *cursor;
}

/* Passes the next character if it is one of these. */
static char skip(const char* characters) {
    char c = next();
    if (c == 0 || strchr(characters, c) == NULL)
        return 0;
    ++cursor;
    operations += strchr("+-*/^", c) != NULL;
    return c;
}

static Tree* node(char kind, const char* name) {
    Tree* t = take(sizeof *t);
    *t = (Tree){.kind = kind, .name = name};
    return t;
}

static void add_part(Tree* t, char sign, Tree* part) {
    size_t n = (size_t)t->parts;
    if (n == 0) {
        t->part = take(sizeof *t->part);
        t->sign = take(1);
    } else if ((n & (n - 1)) == 0) {  // a power of two, the size
        t->part = resize(t->part, n * sizeof *t->part, 2 * n * sizeof *t->part);
        t->sign = resize(t->sign, n, 2 * n);
    }
    t->part[n] = part;
    t->sign[n] = sign;
    ++t->parts;
}

static Tree* integer(void) {
    size_t n = strspn(cursor, "0123456789");
    understood(*cursor != '0' || n == 1);
    form(n <= MOST_DIGITS, "a number has too many digits");
    Tree* t = node('0', NULL);
    t->number = integer_of(cursor, n);
    cursor += n;
    return t;
}

static Tree* atom(void) {
    char c = next();
    size_t n = name_length(cursor);
    if (isdigit((unsigned char)c))
        return integer();
    understood(n > 0 || c == '(');
    const char* name = copied(cursor, n);
    cursor += n;
    if (!skip("("))
        return node('x', name);
    Tree* inside = sum();
    understood(skip(")"));
    if (n == 0)
        return inside;
    ++operations;
    ++functions;
    Tree* t = node('f', name);
    add_part(t, 0, inside);
    return t;
}

/* A number, without names. */
static Q exponent(const Tree* t) {
    Poly p = polynomial(&(Algebra){0, 0, NULL}, t, (Names){NULL, 0});
    Q found = p.n > 0 ? p.t[0].c : q(0);
    form(size_in_bits(found) <= 1000, "an exponent is out of range");
    return found;
}

static Tree* signed_power(void) {
    Tree* t;
    ++nesting;
    form(nesting <= MOST_NESTING, "a formula is nested too deeply");
    if (skip("-")) {
        t = node('+', NULL);
        add_part(t, '-', signed_power());
    } else {
        t = atom();
        if (skip("^")) {
            ++functions;
            Tree* base = t;
            t = node('^', "^");
            t->number = exponent(signed_power());
            add_part(t, 0, base);
        }
    }
    --nesting;
    return t;
}

/* Parts that are connected by operators, or the only part. */
static Tree* chain(char kind, const char* signs, Tree* (*part)(void)) {
    Tree* t = node(kind, NULL);
    Tree* first = part();
    add_part(t, *signs, first);
    for (char sign; (sign = skip(signs)) != 0;)
        add_part(t, sign, part());
    return t->parts == 1 ? first : t;
}

static Tree* product(void) { return chain('*', "*/", signed_power); }

static Tree* sum(void) { return chain('+', "+-", product); }

Formula parsed(const char* formula) {
    form(strlen(formula) <= MOST_FORMULA, "a formula is too long");
    text = formula;
    cursor = formula;
    nesting = 0;
    operations = 0;
    functions = 0;
    check_tokens();
    Tree* t = sum();
    understood(next() == 0);
    return (Formula){t, operations, functions};
}
