#include "libration/scalar/dispatch.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <typeinfo>

#include "scalars.hpp"

namespace scalar_dispatch_test {

using namespace libration;
using Catch::Contains;

namespace {

const std::type_info* chosen_type(const std::string& name) {
    return with_scalar(read_scalar(name), 0, []<class T>() { return &typeid(T); });
}

}  // namespace

TEST_CASE("a name gives the scalar and its name again", "[scalar][dispatch]") {
    for (const std::string name : {"double", "long-double", "quad", "mpfr:1", "mpfr:50", "mpfr:100000"}) {
        CHECK(read_scalar(name).name() == name);
    }
    CHECK(*chosen_type("double") == typeid(double));
    CHECK(*chosen_type("long-double") == typeid(long double));
    CHECK(*chosen_type("quad") == typeid(quad));
    CHECK(*chosen_type("mpfr:50") == typeid(mpfr));
    CHECK(read_scalar("mpfr:77").digits == 77);
    CHECK(read_scalar("double").digits == 17);  // digits that distinguish all doubles [IEEE 754]
    CHECK(read_scalar("quad").digits == 36);
}

TEST_CASE("mpfr is called with its digits and the guard, and the precision is put back", "[scalar][dispatch]") {
    const int before = digits<mpfr>();
    const auto bits = [](long asked, long guard) {
        return with_scalar({scalar_kind::arbitrary, asked}, guard, []<class T>() { return digits<T>(); });
    };
    const auto scoped = [](long asked) {
        const precision_scope scope(asked);
        return digits<mpfr>();
    };
    CHECK(bits(50, 0) == scoped(50));
    CHECK(bits(50, 13) == scoped(63));
    CHECK(digits<mpfr>() == before);
}

TEST_CASE("with_scalar passes on what the function returns", "[scalar][dispatch]") {
    int calls = 0;
    with_scalar(read_scalar("quad"), 0, [&]<class T>() { calls += digits<T>(); });
    CHECK(calls == 113);
    CHECK_THROWS_AS(with_scalar(read_scalar("double"), 0, []<class T>() { throw std::domain_error("x"); }),
                    std::domain_error);
}

TEST_CASE("a ball is read where proofs are offered, and is no scalar that rounds", "[scalar][dispatch]") {
    const scalar_spec ball = read_scalar("ball:50", arithmetics::proved_too);
    CHECK(ball.kind == scalar_kind::proved);
    CHECK(ball.digits == 50);
    CHECK(ball.name() == "ball:50");
    CHECK_THROWS_AS(with_scalar(ball, 0, []<class T>() { return digits<T>(); }), std::logic_error);
}

TEST_CASE("a bad scalar is refused with what is wrong", "[scalar][dispatch]") {
    for (const auto* name : {"", "float", "Double", "double ", "mpfr", "mpfr50", "MPFR:50"}) {
        INFO(name);
        CHECK_THROWS_WITH(read_scalar(name), Contains("is not a scalar"));
    }
    CHECK_THROWS_WITH(read_scalar("mpfr:0"), Contains("is less than one"));
    CHECK_THROWS_WITH(read_scalar("mpfr:"), Contains("whole number"));
    CHECK_THROWS_WITH(read_scalar("ball:50"), Contains("not supported here"));
    CHECK_THROWS_WITH(read_scalar("ball", arithmetics::proved_too), Contains("is not a scalar"));
    CHECK_THROWS_WITH(read_scalar("ball:0", arithmetics::proved_too), Contains("is less than one"));
    CHECK_THROWS_AS(read_scalar("float"), libration::error);
}

TEST_CASE("digits are a whole number from 1 to the most that a run may ask for", "[scalar][dispatch]") {
    CHECK(read_digits("1") == 1);
    CHECK(read_digits("100000") == most_digits);
    for (const auto* text : {"", "abc", "1.5", "5x", " 5", "5 ", "1e3", "+5"}) {
        INFO(text);
        CHECK_THROWS_WITH(read_digits(text), Contains("whole number"));
    }
    CHECK_THROWS_WITH(read_digits("0"), Contains("less than one"));
    CHECK_THROWS_WITH(read_digits("-3"), Contains("less than one"));
    CHECK_THROWS_WITH(read_digits("100001"), Contains("more than 100000"));
    CHECK_THROWS_WITH(read_digits("99999999999999999999999"), Contains("more than 100000"));
}

}  // namespace scalar_dispatch_test
