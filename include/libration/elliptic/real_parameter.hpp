// The parameter m = k^2 of elliptic functions as any real number, together with 1 - m.
#pragma once

#include <utility>

#include "libration/elliptic/exact_functions.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::elliptic {

/// m and 1 - m, exactly. Outside [0, 1] the functions are reduced to those with a parameter inside:
///   m < 0  to -m/(1-m), with arguments times sqrt(1-m)    [DLMF 22.17.6-8]
///   m > 1  to 1/m, with arguments times sqrt(m)           [DLMF 22.17.2-4]
class real_parameter {
public:
    enum class range { negative, zero, within, one, above };

    /// k >= 0; throws error of the kind argument for a negative one, of the kind undecided if no precision determines
    /// on which side of 0 or 1 a formula is; so do the others.
    static real_parameter from_modulus(const exact& k);
    static real_parameter from_parameter(const exact& m) { return {m, exactly(1) - m, false}; }
    static real_parameter from_complement(const exact& m1) { return {exactly(1) - m1, m1, true}; }
    /// m = sin^2 alpha of the modular angle alpha [Abramowitz 17.2].
    static real_parameter from_modular_angle(const exact& alpha);

    const exact& m() const { return m_; }
    const exact& complement() const { return complement_; }
    /// The position of m relative to 0 and 1.
    range where() const { return where_; }
    /// The same for 0 <= m <= 1. Throws error of the kind argument otherwise.
    exact_parameter within() const;
    /// k and k' of the parameter within (0, 1) to which the functions are reduced.
    modulus<ball> reduced() const;
    /// The factor by which arguments are multiplied.
    ball stretch() const;

private:
    real_parameter(exact m, exact complement, bool from_complement);

    exact m_;
    exact complement_;
    bool from_complement_;
    range where_;
};

}  // namespace libration::elliptic
