// Products of integer polynomials compared with products of GMP's integers, with the implementation as argument: for
// operands near the bound of the transform, FLINT's product fails the same tests up to version 3.6.0.
#include "libration/scalar/ball/product_guard.hpp"

#include <flint/fmpz_poly.h>

#include <catch2/catch.hpp>
#include <future>
#include <string>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/scalar/ball/product_check.hpp"
#include "libration/scalar/ball/product_self_test.hpp"

namespace scalar_ball_product_guard_test {

using namespace libration;
using namespace libration::tests;

namespace {

// Every product of integer polynomials in this test program is checked: the scope lasts as long as the process.
const product_check_scope in_all_tests;

using polynomial = std::vector<integer>;

integer_vector for_flint(const polynomial& a) {
    integer_vector result(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        fmpz_set_mpz(&result[k], a[k].backend().data());
    }
    return result;
}

polynomial from_flint(const integer_vector& a) {
    polynomial result(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        fmpz_get_mpz(result[k].backend().data(), &a[k]);
    }
    return result;
}

// sum_{first <= k < last} a_k 2^(width (k - first)).
integer packed(const polynomial& a, std::size_t first, std::size_t last, unsigned long width) {
    if (last - first == 1) {
        return a[first];
    }
    const std::size_t middle = first + (last - first) / 2;
    const integer high = packed(a, middle, last, width);
    return packed(a, first, middle, width) + (high << (width * (middle - first)));
}

// The coefficients, each below 2^(width-1) in size.
void unpack(const integer& all, unsigned long width, std::size_t terms, polynomial& into) {
    if (terms == 1) {
        into.push_back(all);
        return;
    }
    const std::size_t left = terms / 2;
    integer low;
    mpz_fdiv_r_2exp(low.backend().data(), all.backend().data(), width * left);
    if (mpz_tstbit(low.backend().data(), width * left - 1) != 0) {
        low -= integer(1) << (width * left);
    }
    const integer high = (all - low) >> (width * left);
    unpack(low, width, left, into);
    unpack(high, width, terms - left, into);
}

unsigned long bits_of(const polynomial& a) {
    unsigned long bits = 1;
    for (const integer& each : a) {
        bits = std::max<unsigned long>(bits, mpz_sizeinbase(each.backend().data(), 2));
    }
    return bits;
}

// Kronecker substitution with mpz_mul alone.
polynomial by_gmp(const polynomial& a, const polynomial& b, std::size_t count) {
    const unsigned long width = bits_of(a) + bits_of(b) + 2 + mpz_sizeinbase(integer(a.size()).backend().data(), 2);
    const integer product = packed(a, 0, a.size(), width) * packed(b, 0, b.size(), width);
    polynomial c;
    unpack(product, width, a.size() + b.size() - 1, c);
    c.resize(count);
    return c;
}

struct operands {
    std::string named;
    polynomial a, b;
    std::size_t count;
    bool square = false;
};

polynomial product_of(integer_product by, const operands& of) {
    const integer_vector a = for_flint(of.a);
    const integer_vector b = for_flint(of.b);
    integer_vector c(of.count);
    const auto terms = [](const polynomial& p) { return static_cast<slong>(p.size()); };
    by(c.data(), a.data(), terms(of.a), (of.square ? a : b).data(), terms(of.b), static_cast<slong>(of.count));
    return from_flint(c);
}

bool is_right(integer_product by, const operands& of) { return product_of(by, of) == by_gmp(of.a, of.b, of.count); }

// Signs: all of them +, all -, the first half + and the second -, or random.
void set_signs(polynomial& a, int pattern, corner_numbers& next) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (pattern == 1 || (pattern == 2 && k >= a.size() / 2) || (pattern == 3 && next.one_in(2))) {
            a[k] = -a[k];
        }
    }
}

// All of one kind: ones, ones with a hole, runs, one bit, or a mixture.
polynomial corner_polynomial(corner_numbers& next, std::size_t terms, long bits) {
    polynomial a(terms);
    const integer alike = next.positive(bits);
    const bool mixed = next.one_in(3);
    const bool sparse = next.one_in(4);
    for (integer& each : a) {
        each = sparse && next.one_in(2) ? integer(0) : mixed ? next.positive(next.length(bits)) : alike;
    }
    set_signs(a, static_cast<int>(next.below(4)), next);
    return a;
}

operands corner_operands(corner_numbers& next, long most_terms, long most_bits) {
    operands of;
    of.a = corner_polynomial(next, static_cast<std::size_t>(next.between(2, most_terms)), next.length(most_bits));
    of.b = corner_polynomial(next, static_cast<std::size_t>(next.between(2, most_terms)), next.length(most_bits));
    if (next.one_in(4)) {
        of.b = of.a;
        of.square = true;
        of.b.resize(static_cast<std::size_t>(next.between(1, static_cast<long>(of.b.size()))));
    }
    of.count = static_cast<std::size_t>(next.between(1, static_cast<long>(of.a.size() + of.b.size()) + 3));
    of.named = std::to_string(of.a.size()) + " by " + std::to_string(of.b.size()) + " terms, " +
               std::to_string(bits_of(of.a)) + " by " + std::to_string(bits_of(of.b)) + " bits, " +
               std::to_string(of.count) + " asked";
    return of;
}

// All ones, the shorter of 2^l terms, s + t + l + 1 a multiple of 64, and signs so that a coefficient of the largest
// size is negative: as near to the bound of the transform as integers can be.
operands aimed_operands(corner_numbers& next, long most_log, long most_bits) {
    const bool square = next.one_in(4);
    const long log = square ? 2 * next.between(1, (most_log - 1) / 2) + 1 : next.between(3, most_log);
    const std::size_t terms = std::size_t{1} << static_cast<unsigned>(log);
    long s = next.between(250, most_bits);
    long t = next.between(250, most_bits);
    while ((s + t + log + 1) % 64 != 0 || (square && s != t)) {
        t = square ? ++s : t + 1;
    }
    operands of;
    of.square = square;
    of.a.assign(terms, corner_numbers::ones(s));
    of.b.assign(terms, corner_numbers::ones(t));
    const int pattern = square || next.one_in(2) ? 2 : 1;
    set_signs(of.b, pattern, next);
    if (pattern == 2) {
        set_signs(of.a, pattern, next);
    } else {
        of.a.resize(terms + next.below(terms), of.a.front());
    }
    of.count = static_cast<std::size_t>(next.between(static_cast<long>(terms), static_cast<long>(of.a.size())));
    of.named = std::to_string(of.a.size()) + " by " + std::to_string(terms) + " terms, " + std::to_string(s) + " by " +
               std::to_string(t) + " bits, " + std::to_string(of.count) + " asked";
    return of;
}

int wrong_ones(integer_product by, corner_numbers& next, int products, long most_log, long most_bits) {
    int wrong = 0;
    for (int i = 0; i < products; ++i) {
        wrong += is_right(by, aimed_operands(next, most_log, most_bits)) ? 0 : 1;
    }
    return wrong;
}

void require_right(integer_product by, corner_numbers& next, int products, long most_terms, long most_bits) {
    for (int i = 0; i < products; ++i) {
        const operands of = corner_operands(next, most_terms, most_bits);
        INFO(of.named);
        CHECK(is_right(by, of));
    }
}

}  // namespace

TEST_CASE("products of integer polynomials are right in corner cases", "[integer_product][ball]") {
    corner_numbers next(20261125);
    require_right(guarded_product, next, 300, 24, 700);
    require_right(guarded_product, next, 100, 300, 1500);
    require_right(guarded_product, next, 5, 2048, 3000);
}

TEST_CASE("products of integer polynomials are right in corner cases of any size", "[.long][integer_product]") {
    corner_numbers next(20261126);
    require_right(guarded_product, next, 20'000, 200, 2000);
    require_right(guarded_product, next, 200, 2048, 20'000);
    CHECK(wrong_ones(guarded_product, next, 3000, 8, 2500) == 0);
    CHECK(wrong_ones(guarded_product, next, 30, 11, 20'000) == 0);
}

TEST_CASE("products at the bound of the transform are right", "[integer_product][ball]") {
    corner_numbers next(2790);
    CHECK(wrong_ones(guarded_product, next, 250, 6, 1500) == 0);
    CHECK(wrong_ones(guarded_product, next, 10, 9, 4000) == 0);
}

TEST_CASE("the product of FLINT up to 3.6.0 is wrong at the bound of the transform", "[integer_product][ball]") {
    if (flint_products().transform_is_right) {
        SUCCEED("this FLINT passes its self-test");
        return;
    }
    const integer_product default_one = [](fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms,
                                           slong count) {
        checked_product(_fmpz_poly_mullow, c, a, a_terms, b, b_terms, count);
    };
    corner_numbers next(2790);
    int refused = 0;
    int missed = 0;
    for (int i = 0; i < 250; ++i) {
        const operands of = aimed_operands(next, 6, 1500);
        try {
            missed += is_right(default_one, of) ? 0 : 1;
        } catch (const product_mismatch&) {
            ++refused;
        }
    }
    CHECK(missed == 0);
    CHECK(refused > 0);
}

TEST_CASE("products near the bound of the transform are recognized", "[integer_product][ball]") {
    const auto near = [](long terms, long s, long t, int pattern) {
        corner_numbers next(1);
        polynomial a(static_cast<std::size_t>(terms), corner_numbers::ones(s));
        polynomial b(static_cast<std::size_t>(terms + 3), corner_numbers::ones(t));
        set_signs(a, pattern, next);
        return near_transform_bound(for_flint(a).data(), terms, for_flint(b).data(), terms + 3) &&
               near_transform_bound(for_flint(b).data(), terms + 3, for_flint(a).data(), terms);
    };
    for (const int pattern : {1, 2}) {
        CHECK(near(32, 285, 285, pattern));  // 285 + 285 + 5 + 1 = 9 * 64
        CHECK(near(17, 285, 285, pattern));
        CHECK_FALSE(near(16, 285, 285, pattern));
        CHECK_FALSE(near(33, 285, 285, pattern));
        CHECK_FALSE(near(32, 285, 286, pattern));
    }
    CHECK_FALSE(near(32, 285, 285, 0));
}

TEST_CASE("residues modulo 2^61 - 1 are those of GMP", "[integer_product][ball]") {
    corner_numbers next(61);
    for (int i = 0; i < 1000; ++i) {
        const integer n = next.whole(next.length(500));
        const integer p = corner_numbers::ones(61);
        CHECK(residue(for_flint({n})[0]) == integer(((n % p) + p) % p).convert_to<unsigned long>());
    }
}

TEST_CASE("a wrong coefficient is found modulo 2^61 - 1", "[integer_product][ball]") {
    corner_numbers next(7);
    for (int i = 0; i < 200; ++i) {
        const operands of = corner_operands(next, 40, 400);
        const integer_vector a = for_flint(of.a);
        const integer_vector b = for_flint(of.b);
        polynomial c = by_gmp(of.a, of.b, of.count);
        const auto check = [&] {
            require_product(for_flint(c).data(), a.data(), static_cast<slong>(of.a.size()), b.data(),
                            static_cast<slong>(of.b.size()), static_cast<slong>(of.count));
        };
        INFO(of.named);
        CHECK_NOTHROW(check());
        integer& changed = c[next.below(c.size())];
        const unsigned long bound = 64 * (1 + next.below(20));
        changed += next.one_in(2) ? integer(1) : integer((integer(1) << bound) + 1);  // as a wrong sign modulo 2^N + 1
        CHECK_THROWS_AS(check(), product_mismatch);
    }
}

TEST_CASE("products are checked in all tests, in all threads", "[integer_product][ball]") {
    const auto checked = [] { return std::async(std::launch::async, products_are_checked).get(); };
    CHECK(checked());
    { const product_check_scope inner; }
    CHECK(checked());
}

TEST_CASE("the self-test accepts a right product and refuses a wrong one", "[integer_product][ball]") {
    CHECK(flint_products().guarded_is_right);
    CHECK_NOTHROW(require_flint_products());
    CHECK(multiplies_ones(guarded_product, 32, 285, 285));
    const integer_product wrong_at_one = [](fmpz* c, const fmpz* a, slong a_terms, const fmpz* b, slong b_terms,
                                            slong count) {
        guarded_product(c, a, a_terms, b, b_terms, count);
        fmpz_neg(&c[count - 1], &c[count - 1]);
    };
    CHECK_FALSE(multiplies_ones(wrong_at_one, 32, 285, 285));
}

}  // namespace scalar_ball_product_guard_test
