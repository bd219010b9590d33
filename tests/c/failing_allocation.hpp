// An allocation that fails once, or from then on: malloc, calloc and realloc of the program that contains this, or into
// which it is preloaded (failing_memory.cpp).
#pragma once

#include <atomic>

namespace failing_allocation {

// Allocations until one fails; below 0 all succeed. A program into which this is preloaded begins with
// LIBRATION_FAILS_AT, and writes a byte to the file descriptor LIBRATION_FAILURE_TO when one has failed.
extern std::atomic<long> left;
extern std::atomic<bool> failed;
// Whether all behind it fail, too.
extern bool all_behind;

}  // namespace failing_allocation
