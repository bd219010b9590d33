// The destructors of thread_local objects, of this library and of the headers that it uses, registered without memory:
// glibc allocates an entry for each and ends the process if it cannot.
#include <pthread.h>

#include <array>
#include <cstddef>
#include <cstdlib>

#ifdef __GLIBC__

// Declared by the C++ ABI for compilers, and by glibc.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
int __cxa_thread_atexit_impl(void (*destroy)(void*), void* object, void* library);
[[gnu::visibility("hidden")]] int __cxa_thread_atexit(void (*destroy)(void*), void* object, void* library);
}

namespace libration {

namespace {

struct thread_end {
    void (*destroy)(void*);
    void* object;
};

constexpr std::size_t most_ends = 64;  // this library has about ten
// Without a destructor, so that they are not registered themselves.
thread_local std::array<thread_end, most_ends> ends_of_thread;
thread_local std::size_t number_of_ends = 0;

// The last one first. A destructor may register others.
void end_thread() {
    while (number_of_ends > 0) {
        const thread_end last = ends_of_thread[--number_of_ends];
        last.destroy(last.object);
    }
}

extern "C" void end_of_thread(void* /*value*/) { end_thread(); }

// The destructor of a key is called at the end of each thread that has set a value, except the one that ends the process.
// If atexit gets no memory the objects of that thread are left to the system.
bool calls_at_end() {
    static pthread_key_t key;
    static const bool made = [] {
        static_cast<void>(std::atexit(end_thread));
        return pthread_key_create(&key, end_of_thread) == 0;
    }();
    return made && pthread_setspecific(key, &number_of_ends) == 0;
}

}  // namespace

}  // namespace libration

int __cxa_thread_atexit(void (*destroy)(void*), void* object, void* library) {
    using namespace libration;
    if (number_of_ends == most_ends || (number_of_ends == 0 && !calls_at_end())) {
        return __cxa_thread_atexit_impl(destroy, object, library);
    }
    ends_of_thread[number_of_ends++] = {destroy, object};
    return 0;
}
// NOLINTEND(bugprone-reserved-identifier)

#endif
