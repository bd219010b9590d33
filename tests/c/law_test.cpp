// The law of all coefficients in the C interface, against closed forms.
#include <catch2/catch.hpp>
#include <string>

#include "c/called.hpp"

namespace c_test {

namespace {

law law_of(const std::string& text, const char* show = nullptr, const char* within = nullptr) {
    const auto of = problem_of(text);
    return made<law>([&](auto** to) { return libration_law_new(of.get(), show, within, nullptr, nullptr, to); });
}

std::string coefficient_of(const law& of, long n, long digits) {
    return digits_of(made<number>([&](auto** to) { return libration_law_coefficient(of.get(), n, digits, to); }));
}

}  // namespace

// The law of a linear equation computes its constants anew for more digits, when the context of the call that made it may
// not exist any more. (1 - t)^(1/3) (1 - 2t/3) by mpmath.
TEST_CASE("the callback of a law is called only while it is made", "[c]") {
    int calls = 0;
    const auto problem = problem_of("3*(1-t)*(3-2*t)*y' = (8*t-9)*y; y(0) = 1");
    const auto count = [](double, void* context) {
        ++*static_cast<int*>(context);
        return 0;
    };
    const auto of =
        made<law>([&](auto** to) { return libration_law_new(problem.get(), "y", nullptr, count, &calls, to); });
    CHECK(calls > 0);
    calls = 0;
    CHECK(coefficient_of(of, 500, 100).starts_with("-0.0000205749501270046042648639784096820564846899"));
    CHECK(calls == 0);
}

// 1/(7/3 - t): a_n = (3/7)^(n+1), by mpmath.
TEST_CASE("a law gives any coefficient and the ratios", "[c]") {
    const auto of = law_of("y' = y^2; y(0) = 3/7");
    CHECK(libration_law_first(of.get()) == 0);
    CHECK(libration_law_stride(of.get()) == 1);
    CHECK(libration_law_rho(of.get()) > 7.0 / 3);
    CHECK(coefficient_of(of, 5000, 20) == "5.5988230478910357309e-1841");
    const auto ratio = made<number>([&](auto** to) { return libration_law_ratio(of.get(), 5000, 20, to); });
    CHECK(digits_of(ratio) == "0.42857142857142857143");
    CHECK(libration_number_rigour(ratio.get()) == LIBRATION_PROVED);
    const auto singular = made<table>([&](auto** to) { return libration_law_singularities(of.get(), 20, to); });
    CHECK(libration_table_rows(singular.get()) == 1);
    CHECK(cell(singular, 0, 0) == "2.3333333333333333333");
    CHECK(cell(singular, 0, 3) == "simple pole");
    CHECK(cell(singular, 0, 4) == "-1");
    CHECK(cell(singular, 0, 5) == "-1.0000000000000000000");
    const auto words = made<table>([&](auto** to) { return libration_law_words(of.get(), to); });
    CHECK(cell(words, 0, 0) == "law");
    CHECK(cell(words, 2, 1).find("these are all singularities") != std::string::npos);
}

TEST_CASE("a law that is not proved, and arguments that are none", "[c]") {
    const auto sine = problem_of("y'' = -y; y(0) = 0; y'(0) = 1");
    libration_law* none = nullptr;
    CHECK(libration_law_new(sine.get(), nullptr, nullptr, nullptr, nullptr, &none) == LIBRATION_UNDECIDED);
    CHECK(std::string(libration_error_reason()).find("entire") != std::string::npos);
    CHECK(libration_law_new(sine.get(), "z", nullptr, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_law_new(sine.get(), nullptr, "-1", nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(libration_law_new(nullptr, nullptr, nullptr, nullptr, nullptr, &none) == LIBRATION_ARGUMENT);
    const auto stop = [](double, void*) { return 1; };
    const auto abel = problem_of("y' = y^3 + t; y(0) = 1");
    CHECK(libration_law_new(abel.get(), nullptr, nullptr, stop, nullptr, &none) == LIBRATION_CANCELLED);
    CHECK(none == nullptr);
    const auto even = law_of("y' = -2*t*y^2; y(0) = 1");
    CHECK(libration_law_stride(even.get()) == 2);
    CHECK(libration_law_residue(even.get()) == 0);
    CHECK(coefficient_of(even, 4001, 20) == "0");
    libration_number* ratio = nullptr;
    CHECK(libration_law_ratio(even.get(), 4001, 20, &ratio) == LIBRATION_ARGUMENT);
    CHECK(libration_law_coefficient(even.get(), -1, 20, &ratio) == LIBRATION_ARGUMENT);
    CHECK(libration_law_coefficient(nullptr, 1, 20, &ratio) == LIBRATION_ARGUMENT);
    CHECK(libration_law_first(nullptr) == 0);
    CHECK(ratio == nullptr);
}

}  // namespace c_test
