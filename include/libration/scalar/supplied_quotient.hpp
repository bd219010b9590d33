// A program's choice of how mpfr divides long sequences. mpfr does not need FLINT; a program that links it may use
// FLINT's quotients of whole sequences, whose last digits are different.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration {

/// q with sum_k b_k q_{n-k} = a_n for n below the shorter length, which is nonzero, every q_n to within 2^48 epsilon of
/// the largest of them; std::nullopt if that is not proved.
using mpfr_quotient = std::optional<std::vector<mpfr>> (*)(const std::vector<mpfr>& a, const std::vector<mpfr>& b);

/// Makes mpfr divide whole sequences by a quotient of the program's choice, for example quotient_by_flint of
/// scalar/ball/quotient.hpp, in all threads until the end of the scope: created at the top of main(), before there are
/// threads. Nothing else makes that choice; without one, coefficients are computed one after the other. A nullptr
/// revokes it.
class whole_quotient_scope {
public:
    explicit whole_quotient_scope(mpfr_quotient by) : previous_(std::exchange(chosen(), by)) {}
    whole_quotient_scope(const whole_quotient_scope&) = delete;
    whole_quotient_scope& operator=(const whole_quotient_scope&) = delete;
    ~whole_quotient_scope() { chosen() = previous_; }

private:
    friend mpfr_quotient supplied_quotient();
    static mpfr_quotient& chosen() {
        static mpfr_quotient by = nullptr;
        return by;
    }

    mpfr_quotient previous_;
};

/// The current choice; nullptr without one.
inline mpfr_quotient supplied_quotient() { return whole_quotient_scope::chosen(); }

}  // namespace libration
