#include "libration/approximant/conformal_map.hpp"

#include <cstddef>

#include "libration/scalar/inner_product.hpp"

namespace libration {

namespace {

// a_n unit^n.
std::vector<mpfr> in_unit(std::span<const mpfr> a, const mpfr& unit) {
    std::vector<mpfr> scaled;
    mpfr power(1);
    for (const mpfr& each : a) {
        scaled.push_back(each * power);
        power *= unit;
    }
    return scaled;
}

}  // namespace

std::vector<mpfr> in_cut_variable(std::span<const mpfr> a, const mpfr& R) {
    const std::vector<mpfr> b = in_unit(a, mpfr(R * 4));
    std::vector<mpfr> c(b.size(), mpfr(0));
    for (std::size_t n = 0; n < b.size(); ++n) {
        if (n == 0) {
            c[0] = b[0];
            continue;
        }
        integer binomial(1);  // of m + n - 1 over 2n - 1 = m + n - 1 over m - n
        for (std::size_t m = n; m < b.size(); ++m) {
            add_product(c[m], b[n], mpfr(binomial));
            binomial = binomial * (m + n) / (m - n + 1);
        }
    }
    return c;
}

mpfr cut_variable(const mpfr& x, const mpfr& R) {
    const mpfr root = sqrt(mpfr(x / R + 1));
    return (root - 1) / (root + 1);
}

}  // namespace libration
