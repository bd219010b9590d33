// The arithmetic-geometric mean and its chain of moduli: the descending Landen transformation, which is the basis of
// the complete integral, the Jacobi functions and the incomplete integral [DLMF 19.8(i), 19.8(ii), 22.7(i)].
#pragma once

#include <vector>

#include "libration/elliptic/modulus.hpp"
#include "libration/scalar/error.hpp"

namespace libration::elliptic {

/// a_0 = 1, b_0 = k'; a_{n+1} = (a_n + b_n)/2, b_{n+1} = sqrt(a_n b_n). The modulus of level n is
/// k_n = sqrt(1 - (b_n/a_n)^2), k_{n+1} = (a_n - b_n)/(a_n + b_n); it is small after few levels.
///
/// The number of levels depends only on the precision and the size of k': log2 log2 (1/k') levels bring b/a above 1/2,
/// and then k_{n+1} < k_n^2/2 falls quadratically below 2^-(digits/2 + 3), so that k_N^2 is below epsilon/32. A chain
/// that is stopped earlier is equally rigorous: values computed from it enclose the effect of the omitted levels.
template <scalar T>
class landen_chain {
public:
    /// Throws error if k' = 0: the chain does not end and K is infinite.
    explicit landen_chain(const modulus<T>& m) : landen_chain(m, levels_for(m.complement)) {}
    /// With this number of levels, at least 0; k' > 0.
    landen_chain(const modulus<T>& m, int levels) : modulus_(m) {
        using std::sqrt;
        a_.reserve(static_cast<std::size_t>(levels) + 1);
        b_.reserve(static_cast<std::size_t>(levels) + 1);
        a_.push_back(T(1));
        b_.push_back(m.complement);
        for (int n = 0; n < levels; ++n) {
            const T mean = (a_.back() + b_.back()) / 2;
            b_.push_back(sqrt(a_.back() * b_.back()));
            a_.push_back(mean);
        }
    }

    int levels() const { return static_cast<int>(a_.size()) - 1; }
    const T& a(int n) const { return a_[static_cast<std::size_t>(n)]; }
    const T& b(int n) const { return b_[static_cast<std::size_t>(n)]; }
    const modulus<T>& top() const { return modulus_; }

    /// agm(1, k'), which is in [b_N, a_N].
    T mean() const {
        const T difference = a_.back() - b_.back();
        return enclose(T(b_.back() + difference / 2), T(difference / 2));
    }

    /// k_N^2 at the last level, an upper bound on the error of everything computed there: (a^2 - b^2)/a^2.
    T last_parameter() const { return (a_.back() - b_.back()) * (a_.back() + b_.back()) / (a_.back() * a_.back()); }

private:
    static int levels_for(const T& complement) {
        const long exponent = binary_exponent(complement);
        if (exponent == exponent_of_zero) {
            throw error(error_kind::argument, "complementary modulus", "0", "makes K(1) infinite");
        }
        return doublings(1 - exponent) + doublings(digits<T>() / 2 + 4) + 1;
    }

    modulus<T> modulus_;
    std::vector<T> a_;
    std::vector<T> b_;
};

}  // namespace libration::elliptic
