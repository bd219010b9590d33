#include "libration/expansion/fast_product.hpp"

#include <algorithm>
#include <vector>

#include "libration/scalar/ball/polynomial.hpp"

namespace libration::ode {

namespace {

// The length at which both methods take the same time (bench/equations compares them): term by term costs as many
// products as terms, a product in blocks a relative effort that decreases with the size of the numbers.
int least_length_at(slong bits) { return bits < 512 ? 64 : 32; }

// The same numbers with so many bits, in `room` if one of them has clearly more.
const ball* rounded(const ball* a, int terms, slong bits, std::vector<ball>& room) {
    const slong most = bits + bits / 8 + 64;
    if (std::none_of(a, a + terms, [&](const ball& each) { return arb_bits(each.handle()) > most; })) {
        return a;
    }
    room.resize(static_cast<std::size_t>(terms));
    for (int k = 0; k < terms; ++k) {
        arb_set_round(room[static_cast<std::size_t>(k)].handle(), a[k].handle(), bits + 32);
    }
    return room.data();
}

class product_of_balls final : public series::block_product<ball> {
public:
    void add_middle(ball* sums, int count, const ball* a, int length, const ball* b, int terms) const override {
        const slong bits = ball::working_bits();
        std::vector<ball> left, right;
        const ball* const first = rounded(a, length, bits, left);
        const ball* const second = a == b && length == terms ? first : rounded(b, terms, bits, right);
        const auto c = leading_product(first, length, second, terms, length + count, bits);
        for (int i = 0; i < count; ++i) {
            sums[i] += c[static_cast<std::size_t>(length) + static_cast<std::size_t>(i)];
        }
    }
    int least_length() const override { return least_length_at(ball::working_bits()); }
};

// Multiplies exact balls with enough extra bits to make the rounding of the product negligible.
class product_of_mpfr final : public series::block_product<mpfr> {
public:
    void add_middle(mpfr* sums, int count, const mpfr* a, int length, const mpfr* b, int terms) const override {
        const std::vector<ball> left(a, a + length);
        const std::vector<ball> right(b, b + terms);
        const auto c =
            leading_product(left.data(), length, right.data(), terms, length + count, ball::working_bits() + 32);
        mpfr term;
        for (int i = 0; i < count; ++i) {
            arf_get_mpfr(handle(term),
                         arb_midref(c[static_cast<std::size_t>(length) + static_cast<std::size_t>(i)].handle()),
                         MPFR_RNDN);
            sums[i] += term;
        }
    }
    int least_length() const override { return least_length_at(ball::working_bits()); }
};

}  // namespace

template <>
const series::block_product<ball>* fast_product<ball>() {
    static const product_of_balls result;
    return &result;
}

template <>
const series::block_product<mpfr>* fast_product<mpfr>() {
    static const product_of_mpfr result;
    return &result;
}

}  // namespace libration::ode
