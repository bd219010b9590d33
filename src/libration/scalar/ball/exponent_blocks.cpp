#include "exponent_blocks.hpp"

#include <cstdlib>

namespace libration {

namespace {

bool is_moderate(const fmpz* exponent) {
    constexpr slong largest = slong{1} << 28U;
    return !COEFF_IS_MPZ(*exponent) && std::labs(*exponent) <= largest;
}

bool is_zero(const ball& x) { return arf_is_zero(arb_midref(x.handle())) != 0; }

// |midpoint| < 2^e.
long exponent_of(const ball& x) { return *ARF_EXPREF(arb_midref(x.handle())); }

// From the first to the last nonzero midpoint: the number of terms, and the increase of the exponents.
struct rise {
    long terms, height;
};

rise rise_of(const ball* a, int terms) {
    const ball* const first = std::find_if_not(a, a + terms, is_zero);
    if (first == a + terms) {
        return {0, 0};
    }
    const ball* last = a + terms - 1;
    while (is_zero(*last)) {
        --last;
    }
    return {last - first, exponent_of(*last) - exponent_of(*first)};
}

}  // namespace

bool has_moderate_exponents(const ball& x) {
    return arb_is_finite(x.handle()) != 0 && (is_zero(x) || is_moderate(ARF_EXPREF(arb_midref(x.handle())))) &&
           (mag_is_zero(arb_radref(x.handle())) != 0 || is_moderate(MAG_EXPREF(arb_radref(x.handle()))));
}

long common_slope(const ball* a, int a_terms, const ball* b, int b_terms) {
    const rise of_a = rise_of(a, a_terms);
    const rise of_b = rise_of(b, b_terms);
    const long terms = of_a.terms + of_b.terms;
    const long height = of_a.height + of_b.height;
    return terms == 0 ? 0 : (height + (height < 0 ? -terms : terms) / 2) / terms;
}

std::vector<exponent_block> blocks_of_midpoints(const ball* a, int terms, long scale, long height) {
    return blocks_of(terms, height, [&](int k) -> std::optional<exponent_block> {
        if (is_zero(a[k])) {
            return std::nullopt;
        }
        const long high = exponent_of(a[k]) - scale * k;
        return exponent_block{k, 1, high - static_cast<long>(arf_bits(arb_midref(a[k].handle()))), high};
    });
}

}  // namespace libration
