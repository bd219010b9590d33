#include <stdlib.h>

#include "check.h"

typedef struct Block {
    struct Block *before, *after;
    size_t size, unused;  // the latter for the alignment of what follows
} Block;

static const size_t MEMORY = (size_t)4 << 30;  // in bytes
static Block regions[REGIONS];
static size_t used;
int region = PROBLEM;

static void* linked(Block* b, size_t size, Block* before, Block* after) {
    if (size <= MEMORY && used + size <= MEMORY)
        b = realloc(b, size + sizeof *b);
    else
        b = NULL;
    form(b != NULL, "the check needs more memory than there is, or than 4 GB");
    *b = (Block){before, after, size + sizeof *b, 0};
    before->after = b;
    after->before = b;
    used += b->size;
    return b + 1;
}

void* take(size_t size) { return linked(NULL, size, &regions[region], regions[region].after); }

void* resize(void* p, size_t old, size_t size) {
    Block* b = (Block*)p - 1;
    used -= old + sizeof *b;
    return linked(b, size, b->before, b->after);
}

static void drop(void* p, size_t size) {
    Block* b = (Block*)p - 1;
    used -= size + sizeof *b;
    b->before->after = b->after;
    b->after->before = b->before;
    free(b);
}

void release(int which) {
    while (regions[which].after != &regions[which]) {
        Block* b = regions[which].after;
        drop(b + 1, b->size - sizeof *b);
    }
}

void begin_memory(void) {
    for (int r = 0; r < REGIONS; ++r) {
        regions[r].before = &regions[r];
        regions[r].after = &regions[r];
    }
    mp_set_memory_functions(take, resize, drop);
}
