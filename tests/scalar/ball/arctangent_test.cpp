#include "libration/scalar/ball/arctangent.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <thread>
#include <vector>

#include "corner_numbers.hpp"

namespace scalar_ball_arctangent_test {

using namespace libration;

namespace {

// Arb's value, of a quotient that is rounded at 64 bits more.
ball by_arb(const ball& y, const ball& x, slong bits) {
    ball result;
    arb_div(result.handle(), y.handle(), x.handle(), bits + 64);
    arb_atan(result.handle(), result.handle(), bits + 64);
    return result;
}

ball pi_of(slong bits) {
    ball result;
    arb_const_pi(result.handle(), bits);
    return result;
}

// Fractions n/d with |n/d| <= 1, rounded to this many bits; half of them corner cases with d a power of 2.
class random_balls {
public:
    explicit random_balls(slong bits) : bits_(bits) {}
    ball operator()() {
        const ball result = corners_.half([&] { return corner(); }, [&] { return quotient(); });
        return corners_.one_in(2) ? result : -result;
    }

private:
    ball corner() {
        const long length = corners_.length(std::max<long>(bits_, 3));
        const precision_scope exactly(decimal_digits(length + 64));
        return ldexp(from_rational<ball>(rational(corners_.positive(length))), -length);
    }
    ball quotient() {
        ball result(corners_.between(0, std::numeric_limits<long>::max() / 2));
        arb_div_ui(result.handle(), result.handle(), (1UL << 62U) | corners_.below(1UL << 62U), bits_);
        return result;
    }

    slong bits_;
    tests::corner_numbers corners_{11};
};

bool is_narrow(const ball& x, slong bits) { return arb_rel_accuracy_bits(x.handle()) >= bits; }

// sum v_j arg p_j.
ball sum_of_angles(const angle_relation& relation, slong bits) {
    ball sum;
    for (std::size_t j = 0; j < gaussian_count; ++j) {
        const ball angle = by_arb(ball(gaussian_primes[j][1]), ball(gaussian_primes[j][0]), bits);
        arb_addmul_si(sum.handle(), angle.handle(), relation.v[j], bits);
    }
    return sum;
}

template <std::size_t N>
void check_relations(const std::array<angle_relation, N>& relations, int scale) {
    const ball half = ldexp(ball(1), -1);
    for (std::size_t i = 0; i < N; ++i) {
        INFO("row " << i << " of scale " << scale);
        const ball units = ldexp(sum_of_angles(relations[i], 300), scale);
        CHECK(certainly_less(abs(units - ball(relations[i].size)), half));
        if (i > 0) {
            // Within sqrt(2) of powers of 4.
            CHECK(relations[i - 1].size / relations[i].size >= 2);
            CHECK(relations[i - 1].size / relations[i].size < 8);
        }
    }
}

}  // namespace

TEST_CASE("relations between Gaussian primes are as small as the table says", "[scalar][ball_arctangent]") {
    CHECK(turned_point::angles_are_known());
    const precision_scope scope(90);
    check_relations(coarse_relations, coarse_scale);
    check_relations(fine_relations, fine_scale);
    // The fine relations continue where the coarse ones end.
    const long end = coarse_relations.back().size;
    const long begin = fine_relations.front().size >> static_cast<unsigned>(fine_scale - coarse_scale);
    CHECK((end / begin >= 2 && end / begin < 8));
}

TEST_CASE("the short series encloses the arctangent of small balls", "[scalar][ball_arctangent]") {
    for (const slong bits : {32, 64, 200, 1000, 4000}) {
        const precision_scope scope(decimal_digits(bits));
        random_balls next(bits + 100);
        for (const int k : {1, 2, 9, 20, 43, 70, 300, 9000}) {
            const ball r = ldexp(next(), -k - 1);
            const ball value = small_arctangent(r, bits).value();
            INFO(bits << " bits, 2^-" << k);
            CHECK(overlaps(value, by_arb(r, ball(1), bits)));
            // Four roundings and the rest.
            CHECK(is_narrow(value, bits - 4));
        }
        CHECK(contains_zero(small_arctangent(ball(0), bits).value()));
    }
}

TEST_CASE("the angle by Gaussian primes is Arb's", "[scalar][ball_arctangent]") {
    for (const slong bits : {64, 128, 500, 1399, 1400, 3333, 4607, 4640, 6100, 20000}) {
        const precision_scope scope(decimal_digits(bits));
        random_balls next(bits + 64);
        int served = 0;
        for (int i = 0; i < (bits > 10000 ? 5 : 60); ++i) {
            const ball y = next();
            const ball x = next();
            INFO(bits << " bits, " << i);
            const ball value = arctangent_of_quotient(y, x, bits);
            CHECK(overlaps(value, by_arb(y, x, bits)));
            // One rounding, which Arb's radius contains too, and another of the quotient.
            CHECK(is_narrow(value, bits - 3));
            if (const auto angle = angle_by_primes(y, x, bits)) {
                ++served;
                CHECK(overlaps(*angle, by_arb(y, x, bits)));
                CHECK(is_narrow(*angle, bits - 2));
            }
        }
        CHECK(served > 0);
    }
}

TEST_CASE("Gaussian primes give Machin's formula and the angles of a regular polygon", "[scalar][ball_arctangent]") {
    for (const slong bits : {1300, 5000, 20000}) {
        const precision_scope scope(decimal_digits(bits));
        const ball fifth = *angle_by_primes(ball(1), ball(5), bits);
        const ball small = *angle_by_primes(ball(1), ball(239), bits);
        CHECK(contains(ldexp(fifth * 4 - small, 2), pi_of(bits + 64)));
        // tan(pi/12) = 2 - sqrt 3, tan(pi/8) = sqrt 2 - 1.
        CHECK(overlaps(*angle_by_primes(2 - sqrt(ball(3)), ball(1), bits) * 12, pi<ball>()));
        CHECK(overlaps(*angle_by_primes(sqrt(ball(2)) - 1, ball(-1), bits) * 8, -pi<ball>()));
    }
}

TEST_CASE("the angle by Gaussian primes holds for wide and special balls", "[scalar][ball_arctangent]") {
    const slong bits = 2000;
    const precision_scope scope(decimal_digits(bits));
    random_balls next(bits);
    for (const int k : {1, 5, 14, 15, 16, 17, 18, 30, 100, 1000, 1990}) {
        ball y = next();
        arb_add_error_2exp_si(y.handle(), -k);
        const ball x = next();
        const ball value = arctangent_of_quotient(y, x, bits);
        INFO("known to 2^-" << k);
        // Both ends, and a radius within twice that of Arb.
        CHECK(overlaps(value, by_arb(lower_bound(y), x, bits)));
        CHECK(overlaps(value, by_arb(upper_bound(y), x, bits)));
        CHECK(certainly_less(radius_of(value), radius_of(by_arb(y, x, bits)) * 2 + epsilon<ball>()));
    }
    const ball huge = ldexp(ball(3), 100'000);
    const ball quarter = ldexp(pi<ball>(), -2);
    CHECK(contains_zero(arctangent_of_quotient(ball(0), ball(7), bits)));
    CHECK(overlaps(arctangent_of_quotient(ball(1), ball(1), bits), quarter));
    CHECK(overlaps(arctangent_of_quotient(ball(-1), ball(1), bits), -quarter));
    CHECK(overlaps(arctangent_of_quotient(huge, ball(1), bits), quarter * 2));
    CHECK(overlaps(arctangent_of_quotient(huge, huge * 2, bits), by_arb(ball(1), ball(2), bits)));
    CHECK(overlaps(arctangent_of_quotient(ball(1), huge, bits), by_arb(ball(1), huge, bits)));
    CHECK_FALSE(angle_by_primes(ball(1), ball(0), bits).has_value());
    CHECK_FALSE(is_finite(arctangent_of_quotient(ball(1), ball(0), bits)));
}

TEST_CASE("the angle of a point is that of all quadrants", "[scalar][ball_arctangent]") {
    for (const slong bits : {500, 1400, 7000}) {
        const precision_scope scope(decimal_digits(bits));
        random_balls next(bits + 64);
        for (int i = 0; i < 60; ++i) {
            const ball y = next();
            const ball x = next();
            ball expected;
            arb_atan2(expected.handle(), y.handle(), x.handle(), bits + 64);
            INFO(bits << " bits, " << i);
            const ball value = angle_of_point(y, x, bits);
            CHECK(overlaps(value, expected));
            CHECK(is_narrow(value, bits - 3));
        }
        CHECK(overlaps(angle_of_point(ball(0), ball(-1), bits), pi<ball>()));
        CHECK(overlaps(angle_of_point(ball(-1), ball(0), bits), -ldexp(pi<ball>(), -1)));
        ball around;
        arb_add_error_2exp_si(around.handle(), -100);
        CHECK(contains(angle_of_point(around, ball(-1), bits), ball(3)));
        CHECK(contains(angle_of_point(around, ball(-1), bits), ball(-3)));
    }
}

TEST_CASE("threads with precisions of their own take angles by Gaussian primes", "[scalar][ball_arctangent]") {
    std::vector<int> right(4);
    std::vector<std::thread> threads;
    threads.reserve(right.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
        threads.emplace_back([i, &right] {
            const slong bits = 1500 + 2000 * static_cast<slong>(i);
            const precision_scope scope(decimal_digits(bits));
            random_balls next(bits);
            for (int n = 0; n < 20; ++n) {
                const ball y = next();
                right[i] += overlaps(arctangent_of_quotient(y, ball(2), bits), by_arb(y, ball(2), bits)) ? 1 : 0;
            }
        });
    }
    for (auto& thread : threads) {
        thread.join();
    }
    CHECK(right == std::vector<int>(4, 20));
}

}  // namespace scalar_ball_arctangent_test
