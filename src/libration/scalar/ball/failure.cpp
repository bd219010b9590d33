#include "libration/scalar/ball/failure.hpp"

#include <flint/flint.h>
#include <gmp.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

// Exported by GMP but not declared in any public header.
extern "C" void* __gmp_default_allocate(std::size_t size);  // NOLINT(bugprone-reserved-identifier)

namespace libration {

namespace {

std::atomic<failure_handler> handler_in_force{nullptr};

void call_handler(failure_kind kind) {
    if (const failure_handler handler = handler_in_force.load()) {
        handler(kind);
    }
}

// Declared as in FLINT, for whose handlers clang has a separate type.
FLINT_NORETURN void abort_of_flint() {
    call_handler(failure_kind::flint);
    std::abort();
}

// GMP would end the process if it gets no memory; FLINT gets the nullptr, reports it and aborts.
void* checked_for_gmp(void* memory) {
    if (memory == nullptr) {
        call_handler(failure_kind::no_memory);
        std::fputs("GNU MP: Cannot allocate memory\n", stderr);
        std::abort();
    }
    return memory;
}
void* gmp_allocate(std::size_t size) { return checked_for_gmp(std::malloc(size)); }
void* gmp_reallocate(void* memory, std::size_t /*before*/, std::size_t size) {
    return checked_for_gmp(std::realloc(memory, size));
}

// The FLINT functions called by ours.
struct flint_functions {
    void* (*allocate)(std::size_t) = nullptr;
    void* (*callocate)(std::size_t, std::size_t) = nullptr;
    void* (*reallocate)(void*, std::size_t) = nullptr;
    void (*free)(void*) = nullptr;
};
flint_functions flint_before;

void* checked_for_flint(void* memory) {
    if (memory == nullptr) {
        call_handler(failure_kind::no_memory);
    }
    return memory;
}
void* flint_allocate(std::size_t size) { return checked_for_flint(flint_before.allocate(size)); }
void* flint_callocate(std::size_t count, std::size_t size) {
    return checked_for_flint(flint_before.callocate(count, size));
}
void* flint_reallocate(void* memory, std::size_t size) {
    return checked_for_flint(flint_before.reallocate(memory, size));
}

void set_allocation_of_flint() {
    flint_functions now;
    __flint_get_memory_functions(&now.allocate, &now.callocate, &now.reallocate, &now.free);
    if (now.allocate != flint_allocate) {
        flint_before = now;
        __flint_set_memory_functions(flint_allocate, flint_callocate, flint_reallocate, now.free);
    }
}

void set_allocation_of_gmp() {
    void* (*allocation)(std::size_t) = nullptr;
    mp_get_memory_functions(&allocation, nullptr, nullptr);
    if (allocation == __gmp_default_allocate) {
        mp_set_memory_functions(gmp_allocate, gmp_reallocate, nullptr);
    }
}

}  // namespace

void set_failure_handler(failure_handler handler) {
    handler_in_force = handler;
    flint_set_abort(abort_of_flint);
    set_allocation_of_flint();
    set_allocation_of_gmp();
}

}  // namespace libration
