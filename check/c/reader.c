#include <stdlib.h>
#include <string.h>

#include "check.h"

char* copied(const char* s, size_t length) {
    char* copy = memcpy(take(length + 1), s, length);
    copy[length] = 0;
    return copy;
}

long split(char* s, const char* separator, char** part, long most) {
    long n = 1;
    part[0] = s;
    for (; (s = strstr(s, separator)) != NULL; ++n) {
        *s = 0;
        s += strlen(separator);
        if (n < most)
            part[n] = s;
    }
    return n;
}

Reader reader_of(char* text) {
    Reader r = {NULL, 1, 0};
    for (const char* s = text; *s != 0; ++s)
        r.count += *s == '\n';
    r.line = take((size_t)r.count * sizeof *r.line);
    split(text, "\n", r.line, r.count);
    return r;
}

static char* next(Reader* r) {
    form(r->at < r->count, "the file ends early");
    return r->line[r->at++];
}

static int begins_with(const char* s, const char* word) {
    return strncmp(s, word, strlen(word)) == 0;
}

char* line(Reader* r, const char* word) {
    char* s = next(r);
    char end = begins_with(s, word) ? s[strlen(word)] : 'x';
    form(end == ' ' || end == 0, "line %ld: '%s' expected", r->at, word);
    return s + strlen(word) + (end == ' ');
}

char** all(Reader* r, const char* word, long most, long* count) {
    size_t n = strlen(word);
    *count = 0;
    while (r->at + *count < r->count) {
        const char* s = r->line[r->at + *count];
        if (!begins_with(s, word) || s[n] != ' ')
            break;
        ++*count;
    }
    form(*count <= most, "there are more than %ld lines '%s'", most, word);
    char** found = take((size_t)*count * sizeof *found + 1);
    for (long i = 0; i < *count; ++i)
        found[i] = next(r) + n + 1;
    return found;
}

static int is_integer(const char* s) {
    size_t sign = *s == '-';
    size_t n = strspn(s + sign, "0123456789");
    return n > 0 && n <= 5 && s[sign + n] == 0;
}

long* integers(Reader* r, const char* word, long count, long largest) {
    char* s = line(r, word);
    char** part = take((size_t)count * sizeof *part);
    long* k = take((size_t)count * sizeof *k);
    int good = split(s, " ", part, count) == count;
    for (long i = 0; good && i < count; ++i)
        good = is_integer(part[i]);
    form(good, "line %ld: %ld integers of at most 5 digits expected", r->at, count);
    for (long i = 0; i < count; ++i) {
        k[i] = atol(part[i]);
        good = good && labs(k[i]) <= largest;
    }
    form(good, "line %ld: out of range", r->at);
    return k;
}

/* A list of integers in hexadecimal digits. */
static List coefficients(Reader* r) {
    char* s = next(r);
    long n = *s != 0;
    for (const char* t = s; *t != 0; ++t)
        n += *t == ' ';
    List a = list(n);
    for (long j = 0; j < n; ++j) {
        size_t sign = *s == '-';
        size_t m = strspn(s + sign, "0123456789abcdef") + sign;
        form(m > sign && s[m] == (j + 1 < n ? ' ' : 0), "line %ld: bad coefficients", r->at);
        s[m] = 0;
        mpz_set_str(a.c + j, s, 16);
        s += m + 1;
    }
    return a;
}

List* section(Reader* r, const char* word, long exponents, long** k, long lists) {
    *k = integers(r, word, exponents, MOST_EXPONENT);
    List* a = take((size_t)lists * sizeof *a);
    for (long i = 0; i < lists; ++i)
        a[i] = coefficients(r);
    return a;
}
