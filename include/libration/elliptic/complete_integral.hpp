// The complete elliptic integral of the first kind, K(k) = int_0^{pi/2} dphi / sqrt(1 - k^2 sin^2 phi).
#pragma once

#include "libration/elliptic/landen.hpp"

namespace libration::elliptic {

/// K from an existing chain: K = pi / (2 agm(1, k')) [DLMF 19.8.5].
template <scalar T>
T complete_integral(const landen_chain<T>& chain) {
    return pi<T>() / (chain.mean() * 2);
}

/// K(k), 0 <= k < 1: a few units in the last place for every k' > 0, O(log digits + log log 1/k') square roots.
/// K'(k) is complete_integral(m.swapped()). Throws error at k = 1, where K is infinite.
template <scalar T>
T complete_integral(const modulus<T>& m) {
    return complete_integral(landen_chain<T>(m));
}

}  // namespace libration::elliptic
