// Threads for computing proofs, such that a failure inside FLINT does not end the process.
//
// Such a failure (failure.hpp) leaves the thread in which it happens with half-written constants, and objects whose
// destructors must not run. A proof is therefore computed in a thread separate from its caller's: each calling thread
// has its own proof thread, which computes while the caller waits, and which after a failure reports it, sleeps forever
// and is replaced. Nothing is unwound and nothing freed: the memory of the failed proof remains in use until the
// process ends.
#pragma once

#include <memory>

namespace libration {

/// A non-owning reference to a function object for the duration of a call.
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

/// How a call in a proof thread ended: normally, by a failure inside GMP or FLINT, or without being started.
enum class call_ending { finished, no_memory, flint_failure, no_thread };

/// Computes work() in the proof thread of this thread, with the default floating-point environment, whatever the caller
/// has set, and with its own precision and exponent range of MPFR. work must not throw; it returns whether the thread
/// may be used again. A call within a call, from a callback, gets a separate thread, and so does a child process, which
/// inherits no threads from its parent. Sets the failure handler. A round trip costs some microseconds.
call_ending in_proof_thread(const call_view<bool>& work) noexcept;

/// From work(): calls `question` in the thread that waits for it. It must not throw. In any other thread a plain call.
void in_calling_thread(const call_view<void>& question);

}  // namespace libration
