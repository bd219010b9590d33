// What the C interface says of bad arguments.

#include <catch2/catch.hpp>
#include <string>

#include "c/called.hpp"

namespace c_error_test {

using namespace c_test;

// The code of a motion's text, which has to be refused.
int refused_motion(const char* given) {
    libration_motion* motion = nullptr;
    const int code = libration_motion_new(given, &motion);
    CHECK(motion == nullptr);
    return code;
}

TEST_CASE("errors have a code, a quantity, a value and a reason", "[c]") {
    CHECK(refused_motion("energy = -1") == LIBRATION_ARGUMENT);
    CHECK(libration_error_message() == std::string("energy '-1' is negative"));
    CHECK(libration_error_subject() == std::string("energy"));
    CHECK(libration_error_value() == std::string("-1"));
    CHECK(libration_error_reason() == std::string("is negative"));
    CHECK(refused_motion("energy = much") == LIBRATION_ARGUMENT);
    CHECK(libration_error_value() == std::string("much"));
    CHECK(refused_motion("theta0 = 3; energy = 0.5") == LIBRATION_ARGUMENT);
    CHECK(libration_error_message() == std::string("theta0 '3' is not reached with this energy"));
    CHECK(refused_motion("theta = 3; energy = 0.5") == LIBRATION_ARGUMENT);
    CHECK(libration_error_value() == std::string("theta"));
    CHECK(refused_motion("energy") == LIBRATION_ARGUMENT);
    CHECK(refused_motion("energy = 1; energy = 1") == LIBRATION_ARGUMENT);
    CHECK(refused_motion("") == LIBRATION_ARGUMENT);
    CHECK(refused_motion(nullptr) == LIBRATION_ARGUMENT);
    CHECK(libration_error_message() == std::string("motion is NULL"));
}

TEST_CASE("problems say what is wrong with them", "[c]") {
    libration_problem* problem = nullptr;
    CHECK(libration_problem_new("lorentz", nullptr, &problem) == LIBRATION_ARGUMENT);
    CHECK(libration_error_value() == std::string("lorentz"));
    CHECK(libration_problem_new("x' = ; x(0) = 1", nullptr, &problem) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_new("lorenz", "q = 1", &problem) == LIBRATION_ARGUMENT);
    CHECK(problem == nullptr);
    const auto tangent = problem_of("x' = 1 + x^2; x(0) = 0");
    libration_table* table = nullptr;
    // Beyond the pole: no value is made up.
    CHECK(libration_problem_states(tangent.get(), "2", 20, LIBRATION_PROVED, nullptr, nullptr, &table) ==
          LIBRATION_UNDECIDED);
    CHECK(std::string(libration_error_reason()).find("proved to exist up to 1.5707") != std::string::npos);
    CHECK(libration_problem_states(tangent.get(), "1,,2", 20, LIBRATION_PROVED, nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_states(tangent.get(), "1", 0, LIBRATION_PROVED, nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_states(tangent.get(), "1", 20, 7, nullptr, nullptr, &table) == LIBRATION_ARGUMENT);
    CHECK(libration_problem_coefficients(tangent.get(), "i", nullptr, 0, 3, 20, LIBRATION_PROVED, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_coefficients(tangent.get(), nullptr, nullptr, 3, 2, 20, LIBRATION_PROVED, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_verify(tangent.get(), "y", "1", "1", nullptr, nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_verify(tangent.get(), "x", "1,2", "1", nullptr, nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_verify(tangent.get(), "x", "1", "1", "tolerance = 0", nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(table == nullptr);
}

TEST_CASE("NULL is refused everywhere", "[c]") {
    const auto swing = motion_of("energy = 1");
    libration_number* number = nullptr;
    libration_table* table = nullptr;
    libration_sampler* sampler = nullptr;
    double value = 0;
    CHECK(libration_motion_new("energy = 1", nullptr) == LIBRATION_ARGUMENT);
    CHECK(libration_motion_theta(nullptr, "1", 20, LIBRATION_PROVED, &number) == LIBRATION_ARGUMENT);
    CHECK(libration_motion_theta(swing.get(), nullptr, 20, LIBRATION_PROVED, &number) == LIBRATION_ARGUMENT);
    CHECK(libration_motion_theta(swing.get(), "1", 20, LIBRATION_PROVED, nullptr) == LIBRATION_ARGUMENT);
    CHECK(libration_motion_states(swing.get(), nullptr, 20, LIBRATION_PROVED, nullptr, nullptr, &table) ==
          LIBRATION_ARGUMENT);
    CHECK(libration_problem_radius(nullptr, 20, 20, &table) == LIBRATION_ARGUMENT);
    CHECK(libration_sampler_new(nullptr, &sampler) == LIBRATION_ARGUMENT);
    CHECK(libration_sampler_at(nullptr, 1, &value, &value, &value) == LIBRATION_ARGUMENT);
    const auto fast = made<c_test::sampler>([&](auto** to) { return libration_sampler_new(swing.get(), to); });
    CHECK(libration_sampler_at(fast.get(), 1, &value, nullptr, &value) == LIBRATION_ARGUMENT);
    CHECK(libration_number_double(nullptr, &value) == LIBRATION_ARGUMENT);
    CHECK(libration_exact_text("1", 1, nullptr, 100) == LIBRATION_ARGUMENT);
    CHECK(libration_number_decimal(nullptr) == std::string());
    CHECK(libration_table_rows(nullptr) == 0);
    CHECK(libration_table_text(nullptr, 0, 0) == std::string());
    CHECK(libration_table_number(nullptr, 0, 0) == nullptr);
    libration_number_free(nullptr);
    libration_table_free(nullptr);
    libration_motion_free(nullptr);
    libration_problem_free(nullptr);
    libration_sampler_free(nullptr);
}

TEST_CASE("buffers that are too small are refused with what they need", "[c]") {
    char text[4];
    CHECK(libration_exact_text("12345", 3, text, sizeof text) == LIBRATION_RANGE);
    CHECK(std::string(libration_error_reason()).find("10 characters") != std::string::npos);  // 12345*2^3 and the 0
    CHECK(libration_exact_text("12.5", 3, text, sizeof text) == LIBRATION_ARGUMENT);
}

TEST_CASE("a proved number as it was written down has a digit", "[c]") {
    libration_number* number = nullptr;
    CHECK(libration_number_of("1.115", "1.96e100", LIBRATION_PROVED, &number) == LIBRATION_ARGUMENT);
    CHECK(libration_error_message() ==
          std::string("uncertainty '1.96e100' is larger than the number: no digit of it is proved"));
    CHECK(libration_number_of("-1.115", "1.116", LIBRATION_PROVED, &number) == LIBRATION_ARGUMENT);
    CHECK(number == nullptr);
    // 0 with a bound is a statement, and of other rigour a bound may be as large as it is.
    made<c_test::number>([](auto** to) { return libration_number_of("0", "1e-60", LIBRATION_PROVED, to); });
    made<c_test::number>([](auto** to) { return libration_number_of("1.115", "1.96e100", LIBRATION_HEURISTIC, to); });
    made<c_test::number>([](auto** to) { return libration_number_of("1.115", "0.001", LIBRATION_PROVED, to); });
}

}  // namespace c_error_test
