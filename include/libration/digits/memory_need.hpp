// Memory that a request will need, checked before anything is computed.
#pragma once

#include <concepts>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration {

/// A request that was rejected because it needs more memory than is available; what() states how much.
class memory_shortage : public std::bad_alloc {
public:
    explicit memory_shortage(std::string message) : message_(std::move(message)) {}
    const char* what() const noexcept override { return message_.c_str(); }

private:
    std::string message_;
};

/// The bytes that this process can still allocate: the minimum of what its limits of address space and data leave, what
/// its control group leaves, and what the machine has, with swap. Returns std::nullopt if the system reports none of
/// them. Some 50 microseconds.
std::optional<double> available_memory();

/// Throws memory_shortage, "order 100000000 needs at least 24.3 GB of memory, and 20.1 GB are available: reduce it",
/// if `least` bytes are more than the available ones. `least` is a lower bound on the memory that will be allocated, so
/// that an error is never premature. Below 64 MB, which every request may need, the system is not queried.
void require_memory(const std::string& quantity, double least);

/// A lower bound on the bytes that a number occupies in the working precision: a digit of mpfr takes more than 2/5 of a
/// byte.
template <class R>
long bytes_of() {
    const bool at_run_time = std::same_as<R, mpfr> || std::same_as<R, complex_number<mpfr>>;
    return static_cast<long>(sizeof(R)) + (at_run_time ? 2 * working_digits() / 5 : 0);
}

}  // namespace libration
