#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

long step_number;

static void refuse(int status, const char* reason, va_list rest) {
    printf("Not proved: ");
    if (step_number > 0)
        printf("step %ld: ", step_number);
    vprintf(reason, rest);
    putchar('\n');
    exit(status);
}

__attribute__((format(printf, 2, 3))) void need(int condition, const char* reason, ...) {
    va_list rest;
    va_start(rest, reason);
    if (!condition)
        refuse(1, reason, rest);
    va_end(rest);
}

__attribute__((format(printf, 2, 3))) void form(int condition, const char* reason, ...) {
    va_list rest;
    va_start(rest, reason);
    if (!condition)
        refuse(2, reason, rest);
    va_end(rest);
}

const char* clipped(const char* text) {
    static char shown[64];
    if (strlen(text) <= 60)
        return text;
    memcpy(shown, text, 57);
    strcpy(shown + 57, "...");
    return shown;
}
