// The modulus k of an elliptic integral or function together with the complementary modulus k', k^2 + k'^2 = 1.
//
// Convention, everywhere in this library: functions take the modulus k, never the parameter m = k^2, and always as this
// pair, because near k = 1 all information is in k' (at k' = 1e-30, k is 1 in any usual precision) and near k = 0 all
// of it is in k.
#pragma once

#include <stdexcept>
#include <utility>

#include "libration/scalar/scalar.hpp"

namespace libration::elliptic {

/// k and k', both to full relative precision, 0 <= k, k' <= 1.
template <scalar T>
struct modulus {
    T k;
    T complement;  ///< k'
    /// Which of the two was given: the other one is computed from it if more digits are needed.
    enum class source { modulus, complement } given = source::modulus;

    /// From k: k' = sqrt((1-k)(1+k)); correct to a unit in the last place unless the rounding of k loses the digits
    /// that k' needs.
    static modulus from_modulus(const T& k) {
        using std::sqrt;
        return {k, sqrt((1 - k) * (1 + k)), source::modulus};
    }
    /// From k': k = sqrt((1-k')(1+k')).
    static modulus from_complement(const T& complement) {
        using std::sqrt;
        return {sqrt((1 - complement) * (1 + complement)), complement, source::complement};
    }
    /// From both, if both are known, for example k = 1e-20 with k' = 1. The smaller one determines the modulus.
    static modulus from_both(const T& k, const T& complement) {
        const bool k_tells = binary_exponent(k) < binary_exponent(complement);
        return {k, complement, k_tells ? source::modulus : source::complement};
    }

    /// The modulus with k and k' exchanged.
    modulus swapped() const { return {complement, k, given == source::modulus ? source::complement : source::modulus}; }
};

/// The same modulus in the wide arithmetic of T at the current working precision: the given one of the pair exactly,
/// the other from it.
template <scalar T>
modulus<wide_t<T>> wide_modulus(const modulus<T>& m) {
    using W = wide_t<T>;
    if (m.given == modulus<T>::source::modulus) {
        return modulus<W>::from_modulus(widen(m.k));
    }
    return modulus<W>::from_complement(widen(m.complement));
}

}  // namespace libration::elliptic
