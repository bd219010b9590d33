// What GMP, MPFR and FLINT end the process for, reported to a handler before.
//
// Below such a failure objects are half written: a number whose mantissa is being moved, a constant that FLINT keeps
// for the thread with its new value and its old precision. An exception through these C frames would leave them to
// destructors, which free some of them twice, and to the next proof, which would take half a constant for the whole.
// So nothing is unwound: a handler ends the process, or keeps the thread where it is.
#pragma once

namespace libration {

enum class failure_kind {
    no_memory,  ///< GMP, MPFR or FLINT did not get memory
    flint       ///< FLINT gave up: a message of its own went to stderr
};

/// Must not throw and allocates nothing. Where it returns, the process is aborted, as without it.
using failure_handler = void (*)(failure_kind kind);

/// Sets what is called, in the thread of the failure, before GMP or FLINT end the process; for all threads. FLINT's
/// abort function is replaced by one that calls the handler first. Memory still comes from where it came before: FLINT's
/// allocation functions are called by ours, GMP's are replaced only where they are its own, by such that differ from
/// them in nothing else. To be called before there are other threads, or from one at a time.
void set_failure_handler(failure_handler handler);

}  // namespace libration
