#include "libration/scalar/ball/failure.hpp"

#include <flint/flint.h>
#include <gmp.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>

// GMP exports it and declares it in no header for users.
extern "C" void* __gmp_default_allocate(std::size_t size);  // NOLINT(bugprone-reserved-identifier)

namespace libration {

namespace {

// How many scopes this thread is in.
int& depth() {
    thread_local int scopes = 0;
    return scopes;
}

// In the words of FLINT, of whose handlers clang makes a type of their own.
FLINT_NORETURN void throw_failure() {
    if (depth() == 0) {
        std::abort();
    }
    throw flint_failure();
}

void* checked(void* memory) {
    if (memory == nullptr) {
        if (depth() == 0) {
            std::fputs("GNU MP: Cannot allocate memory\n", stderr);
            std::abort();
        }
        throw std::bad_alloc();
    }
    return memory;
}

void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t /*before*/, std::size_t size) { return checked(std::realloc(memory, size)); }

// Allocation that a program has set itself stays.
void set_handlers() {
    flint_set_abort(throw_failure);
    void* (*allocation)(std::size_t) = nullptr;
    mp_get_memory_functions(&allocation, nullptr, nullptr);
    if (allocation == __gmp_default_allocate) {
        mp_set_memory_functions(allocate, reallocate, nullptr);
    }
}

}  // namespace

failure_scope::failure_scope() {
    static std::once_flag once;
    std::call_once(once, set_handlers);
    ++depth();
}

failure_scope::~failure_scope() { --depth(); }

}  // namespace libration
