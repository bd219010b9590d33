// Jacobi's zeta function and the mean of dn^2, from the chain of moduli of the arithmetic-geometric mean.
//
// With phi_0 = am(u, k), tan(phi_{n+1} - phi_n) = (b_n/a_n) tan phi_n, c_0 = k and c_{n+1} = (a_n - b_n)/2 = c_n^2/(4
// a_{n+1}), where a_0 = 1 [DLMF 22.20.5, 19.8.6; Abramowitz and Stegun 17.6]:
//   Z(u) = integral of dn^2 from 0 to u - u E(k)/K(k) = sum_{n>=1} c_n sin phi_n,
//   E(k)/K(k) = 1 - sum_{n>=0} 2^(n-1) c_n^2.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "libration/elliptic/landen.hpp"

namespace libration::elliptic {

/// The zeta function of one modulus. Constructed from a chain: O(levels). The sums end with the chain, where c_n^2 is
/// below epsilon; errors of a few epsilon of c_1 in Z, of k^2 in the mean of cn^2, each relative to its maximum.
template <rounding_scalar T>
class jacobi_zeta {
public:
    explicit jacobi_zeta(landen_chain<T> chain) : chain_(std::move(chain)) {
        using std::ldexp;
        const auto count = static_cast<std::size_t>(chain_.levels()) + 1;
        c_.reserve(count);
        c_.push_back(chain_.top().k);
        for (int n = 1; n <= chain_.levels(); ++n) {
            c_.push_back(c_.back() * c_.back() / (chain_.a(n) * 4));
            rest_ += ldexp(T(c_.back() * c_.back()), n - 1);
        }
    }

    /// Z where (sin am u, cos am u) = (sine, cosine). Cost: a square root, a division and a few products per level.
    T operator()(T sine, T cosine) const {
        using std::sqrt;
        T sum(0);
        for (int n = 0; n < chain_.levels(); ++n) {
            const T x = chain_.a(n) * cosine;
            const T y = chain_.b(n) * sine;
            const T scale = 1 / sqrt(x * x + y * y);
            const T next = (x * sine + y * cosine) * scale;
            cosine = (x * cosine - y * sine) * scale;
            sine = next;
            sum += c_[static_cast<std::size_t>(n) + 1] * sine;
        }
        return sum;
    }

    /// The mean of dn^2 over a period, E(k)/K(k), and that of k^2 cn^2 = dn^2 - k'^2.
    T mean_of_dn_squared() const { return 1 - c_.front() * c_.front() / 2 - rest_; }
    T mean_of_cn_squared() const { return c_.front() * c_.front() / 2 - rest_; }

private:
    landen_chain<T> chain_;
    std::vector<T> c_;
    T rest_ = T(0);  ///< sum over n >= 1 of 2^(n-1) c_n^2
};

}  // namespace libration::elliptic
