// What FLINT and GMP end the process for, as exceptions: for a library whose host must go on.
#pragma once

#include <stdexcept>

namespace libration {

/// FLINT gave up: a message of its own went to stderr.
class flint_failure : public std::runtime_error {
public:
    flint_failure() : std::runtime_error("FLINT gave up; its message is on stderr") {}
};

/// In this thread, until the end of the scope, flint_abort throws flint_failure, and std::bad_alloc stands for memory
/// that FLINT or GMP does not get. Scopes nest. The handler of FLINT is set for the whole process with the first scope;
/// outside of one it aborts, as without it. GMP's functions are replaced only where they are its own, by such that
/// differ from them in nothing else. The exceptions pass C frames, which have tables for that on the usual platforms;
/// what those frames held is not freed.
class failure_scope {
public:
    failure_scope();
    failure_scope(const failure_scope&) = delete;
    failure_scope& operator=(const failure_scope&) = delete;
    ~failure_scope();
};

}  // namespace libration
