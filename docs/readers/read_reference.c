/* Reads results/reference_problems/NAME.txt: cc read_reference.c -lmpfr -lgmp; ./a.out < NAME.txt */
#include <mpfr.h>
#include <stdio.h>
#include <string.h>

int main(void) {
    static char line[1 << 16];
    mpfr_t x;
    mpfr_init2(x, 200); /* 60 digits: more than the values have; strtod() would keep 16 */
    while (fgets(line, sizeof line, stdin)) {
        if (line[0] == '#') { /* the last comment names the columns */
            continue;
        }
        for (char* word = strtok(line, " \n"); word; word = strtok(NULL, " \n")) {
            mpfr_set_str(x, word, 10, MPFR_RNDN);
            mpfr_printf("%.49Re ", x);
        }
        putchar('\n');
    }
    mpfr_clear(x);
    return 0;
}
