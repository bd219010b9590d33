#include "libration/scalar/ball/product_check.hpp"

#include <flint/ulong_extras.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace libration {

namespace {

constexpr ulong prime = product_check_prime;

ulong product(ulong x, ulong y) {
    static const ulong inverse = n_preinvert_limb(prime);
    return n_mulmod2_preinv(x, y, prime, inverse);
}

std::atomic<int>& open_scopes() {
    static std::atomic<int> count = 0;
    return count;
}

// The finalizer of splitmix64 on a counter: different points in each product, the same in each run.
ulong next_point() {
    static std::atomic<std::uint64_t> counter = 0;
    std::uint64_t x = (counter.fetch_add(1, std::memory_order_relaxed) + 1) * 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<ulong>(x ^ (x >> 31U)) % prime;
}

// sums[m] = sum_{j < m} b_j x^j.
std::vector<ulong> partial_sums(const fmpz* b, slong terms, ulong x) {
    std::vector<ulong> sums{0};
    sums.reserve(static_cast<std::size_t>(terms) + 1);
    ulong power = 1;
    for (slong j = 0; j < terms; ++j) {
        sums.push_back(n_addmod(sums.back(), product(residue(b[j]), power), prime));
        power = product(power, x);
    }
    return sums;
}

}  // namespace

product_check_scope::product_check_scope() { ++open_scopes(); }
product_check_scope::~product_check_scope() { --open_scopes(); }

bool products_are_checked() { return open_scopes().load(std::memory_order_relaxed) > 0; }

ulong residue(const fmpz& n) { return fmpz_fdiv_ui(&n, prime); }

void require_product(const fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms, slong count) {
    const ulong x = next_point();
    const auto of_b = partial_sums(b, b_terms < count ? b_terms : count, x);
    const auto of_c = partial_sums(c, count, x);
    ulong expected = 0;
    ulong power = 1;
    for (slong k = 0; k < a_terms && k < count; ++k) {
        const auto below = static_cast<std::size_t>(count - k < b_terms ? count - k : b_terms);
        expected = n_addmod(expected, product(product(residue(a[k]), power), of_b[below]), prime);
        power = product(power, x);
    }
    if (expected != of_c.back()) {
        throw product_mismatch();
    }
}

}  // namespace libration
