// Threads in which proofs are computed that a failure below FLINT shall not end the process for.
//
// Such a failure (failure.hpp) leaves the thread in which it happens with half-written constants, and objects whose
// destructors must not run. So a proof is computed in another thread than its caller's: each calling thread has a proof
// thread of its own, which computes while the caller waits, and which after a failure reports it, sleeps for ever and is
// replaced. Nothing is unwound and nothing freed: the memory that the failed proof held stays in use until the process
// ends.
#pragma once

#include <memory>

namespace libration {

/// A function object for the time of a call.
template <class Result>
class call_view {
public:
    template <class Function>
    call_view(const Function& function)  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)
        : function_(&function), call_([](const void* of) -> Result { return (*static_cast<const Function*>(of))(); }) {}
    Result operator()() const { return call_(function_); }

private:
    const void* function_;
    Result (*call_)(const void*);
};

/// How a call in a proof thread ended: by itself, by a failure below GMP or FLINT, or not even begun.
enum class call_ending { finished, no_memory, flint_failure, no_thread };

/// Computes work() in the proof thread of this thread, with the usual floating-point environment, whatever the caller has
/// set, and with a precision and an exponent range of MPFR of its own. work must not throw; it returns whether the thread
/// may compute again. A call within a call, from a question, gets a thread of its own, and so does a child process, which
/// has none of its parent. Sets the handler of failures. A round trip costs some microseconds.
call_ending in_proof_thread(const call_view<bool>& work) noexcept;

/// From work(): calls `question` in the thread that waits for it. It must not throw. In any other thread a plain call.
void in_calling_thread(const call_view<void>& question);

}  // namespace libration
