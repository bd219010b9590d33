// Failures for which GMP, MPFR and FLINT end the process, reported to a handler first.
//
// At such a failure objects are half written: a number whose mantissa is being moved, a constant that FLINT stores for
// the thread with its new value and its old precision. An exception through these C frames would leave them to
// destructors, which would free some of them twice, and to the next proof, which would use a half-written constant.
// Therefore nothing is unwound: a handler ends the process, or keeps the thread where it is.
#pragma once

namespace libration {

enum class failure_kind {
    no_memory,  ///< GMP, MPFR or FLINT could not allocate memory
    flint       ///< FLINT aborted with a message on stderr
};

/// Must not throw and must not allocate. If it returns, the process is aborted, as without a handler.
using failure_handler = void (*)(failure_kind kind);

/// Sets the handler that is called, in the thread of the failure, before GMP or FLINT end the process; for all threads.
/// FLINT's abort function is replaced by one that calls the handler first. Memory comes from the same source as before:
/// FLINT's allocation functions are called by ours, GMP's are replaced, only if they are its own, by ones that differ
/// from them in nothing else. To be called before there are other threads, or from one at a time.
void set_failure_handler(failure_handler handler);

}  // namespace libration
