#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "check.h"

/* A certificate, or several and the conditions of a root. */
static void check(char* text) {
    const char* end = "\nend\n";
    char *at = text, *next;
    long n = 0;
    for (char* s = text; (s = strstr(s, end)) != NULL; s += strlen(end))
        ++n;
    if (n < 2) {
        print_statement(check_one(text));
        return;
    }
    form(n <= MOST_UNKNOWNS, "there are too many certificates");
    Problem** problem = take((size_t)n * sizeof *problem);
    for (long k = 0; k < n; ++k) {
        next = strstr(at, end) + strlen(end);
        problem[k] = check_one(copied(at, (size_t)(next - at)));
        at = next;
    }
    check_root(problem, n, at);
}

/* Reads more of the file if nothing is left; 0 at its end. */
static int has_input(z_stream* z, FILE* file) {
    static unsigned char input[1 << 16];
    if (z->avail_in == 0) {
        z->next_in = input;
        z->avail_in = (uInt)fread(input, 1, sizeof input, file);
        if (ferror(file)) {
            printf("cannot read the file\n");
            exit(2);
        }
    }
    return z->avail_in > 0;
}

/* The text of a certificate, of which the file is the compression. */
static char* decompressed(FILE* file) {
    size_t size = 1 << 20;
    size_t length = 0;
    char* text = take(size);
    z_stream z = {0};
    form(inflateInit(&z) == Z_OK, "zlib cannot be used");
    for (int state = Z_OK; state != Z_STREAM_END;) {
        form(length <= MOST_TEXT, "the text is too long");
        form(has_input(&z, file), "the file is not the whole of a text compressed by zlib");
        if (length + 1 == size) {
            text = resize(text, size, 2 * size);
            size *= 2;
        }
        size_t room = size - 1 - length;
        z.next_out = (unsigned char*)text + length;
        z.avail_out = (uInt)(room < 1 << 20 ? room : 1 << 20);
        room = z.avail_out;
        state = inflate(&z, Z_NO_FLUSH);
        form(state == Z_OK || state == Z_STREAM_END,
             "the file is not a text compressed by zlib");
        length += room - z.avail_out;
    }
    form(length <= MOST_TEXT, "the text is too long");
    form(!has_input(&z, file), "something follows the compressed text");
    inflateEnd(&z);
    text[length] = 0;
    for (const char* s = text; s < text + length; ++s) {
        form(*s == '\n' || (' ' <= *s && *s <= '~'),
             "a character of the text is not printable ASCII");
    }
    return text;
}

int main(int arguments, char** argument) {
    begin_memory();
    if (arguments != 2) {
        printf("usage: libration_check FILE\n");
        return 2;
    }
    FILE* file = fopen(argument[1], "rb");
    if (file == NULL) {
        printf("cannot read the file\n");
        return 2;
    }
    check(decompressed(file));
    fclose(file);
    return 0;
}
