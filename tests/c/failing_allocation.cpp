#include "failing_allocation.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the allocation of glibc
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)
}

namespace failing_allocation {

std::atomic<long> left{-1};
std::atomic<bool> failed{false};
bool all_behind = false;

namespace {

int tells = -1;

long number_in(const char* name) {
    const char* const text = std::getenv(name);
    return text == nullptr ? -1 : std::atol(text);
}

[[gnu::constructor]] void begin() {
    tells = static_cast<int>(number_in("LIBRATION_FAILURE_TO"));
    left = number_in("LIBRATION_FAILS_AT");
}

bool fails() {
    if (left.load(std::memory_order_relaxed) < 0 || left.fetch_sub(1) != 0) {
        return false;
    }
    if (tells >= 0 && !failed) {
        static_cast<void>(!write(tells, "", 1));
    }
    failed = true;
    errno = ENOMEM;
    if (all_behind) {
        left = 0;
    }
    return true;
}

}  // namespace

}  // namespace failing_allocation

using failing_allocation::fails;

extern "C" void* malloc(std::size_t size) noexcept { return fails() ? nullptr : __libc_malloc(size); }
extern "C" void* calloc(std::size_t count, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_calloc(count, size);
}
extern "C" void* realloc(void* memory, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_realloc(memory, size);
}
