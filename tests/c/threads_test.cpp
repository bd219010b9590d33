// Threads of different precisions, on the same handles: each gets the digits that it gets alone.

#include <catch2/catch.hpp>
#include <string>
#include <thread>
#include <vector>

#include "c/called.hpp"

namespace c_threads_test {

using namespace c_test;

// Several digits from several calls, as one text; also where a call fails.
std::string answers(const libration_motion* swing, const libration_problem* problem, long digits) {
    std::string all;
    libration_number* number = nullptr;
    libration_table* table = nullptr;
    for (const int rigour : {LIBRATION_ROUNDED, LIBRATION_PROVED}) {
        all += libration_motion_theta(swing, "1e6", digits, rigour, &number) == LIBRATION_OK
                   ? libration_number_decimal(number)
                   : "failed";
        libration_number_free(number);
        all += libration_problem_coefficients(problem, nullptr, nullptr, 9, 9, digits, rigour, &table) == LIBRATION_OK
                   ? libration_table_text(table, 0, 1)
                   : "failed";
        libration_table_free(table);
    }
    all += libration_motion_theta(swing, "no time", digits, LIBRATION_PROVED, &number) == LIBRATION_ARGUMENT
               ? libration_error_message()
               : "no error";
    return all;
}

TEST_CASE("threads of other precisions change no digit", "[c]") {
    const auto swing = motion_of("theta0 = 2.5; omega0 = -0.3");
    const auto problem = problem_of("blasius");
    const std::vector<long> precisions{15, 300, 40, 150, 25, 80};
    std::vector<std::string> alone;
    for (const long digits : precisions) {
        alone.push_back(answers(swing.get(), problem.get(), digits));
        REQUIRE(alone.back().find("failed") == std::string::npos);
    }
    std::vector<std::string> together(precisions.size());
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < precisions.size(); ++i) {
        threads.emplace_back([&, i] { together[i] = answers(swing.get(), problem.get(), precisions[i]); });
    }
    for (std::thread& each : threads) {
        each.join();
    }
    CHECK(together == alone);
}

}  // namespace c_threads_test
