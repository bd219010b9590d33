// Fewer digits for the higher coefficients of a series, which contribute less to its values.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "libration/scalar/precision_scope.hpp"

namespace libration::ode {

/// Until the end of the scope what follows from coefficient n of an expansion (taylor_expansion, in this thread) has a
/// working precision of at most digits[n] decimal digits, at least 1 each; beyond the last n, of as many as there. Empty:
/// all have those of the thread. Scopes nest: the inner one counts.
class coefficient_digits {
public:
    explicit coefficient_digits(std::vector<long> digits)
        : digits_(std::move(digits)), outer_(std::exchange(now(), this)) {}
    coefficient_digits(const coefficient_digits&) = delete;
    coefficient_digits& operator=(const coefficient_digits&) = delete;
    ~coefficient_digits() { now() = outer_; }

    /// The digits in force, or null.
    static const std::vector<long>* in_force() {
        return now() == nullptr || now()->digits_.empty() ? nullptr : &now()->digits_;
    }

private:
    static const coefficient_digits*& now() {
        thread_local const coefficient_digits* innermost = nullptr;
        return innermost;
    }

    std::vector<long> digits_;
    const coefficient_digits* outer_;
};

/// The working precision of what follows from coefficient n >= 0, until its end.
class coefficient_scope {
public:
    explicit coefficient_scope(int n) {
        if (const auto* const digits = coefficient_digits::in_force()) {
            const auto place = std::min(static_cast<std::size_t>(n), digits->size() - 1);
            scope_.emplace(std::min(working_digits(), (*digits)[place]));
        }
    }

private:
    std::optional<precision_scope> scope_;
};

}  // namespace libration::ode
