// One solution for several questions in the C interface: the answers are those of the problem, and closed forms.
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "c/called.hpp"
#include "interface/owned_handles.hpp"

namespace c_test {

namespace {

using owned_solution = libration::owned::solution;

owned_solution kept_solution_of(const std::string& text) {
    const auto of = problem_of(text);
    return made<owned_solution>([&](auto** to) { return libration_solution_new(of.get(), to); });
}

// The problem may be freed before.
table states_of_kept(const owned_solution& of, const char* times, long digits) {
    return made<table>([&](auto** to) {
        return libration_solution_states(of.get(), times, digits, LIBRATION_PROVED, nullptr, nullptr, to);
    });
}

}  // namespace

TEST_CASE("one solution answers several questions from its steps", "[c]") {
    const auto of = kept_solution_of("x' = 1 + x^2; x(0) = 0");
    CHECK(libration_solution_steps(of.get()) == 0);
    CHECK(cell(states_of_kept(of, "pi/4, -pi/6", 20), 1, 1) == "-0.57735026918962576451");
    const auto steps = libration_solution_steps(of.get());
    CHECK(steps > 0);
    CHECK(cell(states_of_kept(of, "pi/6, pi/4", 20), 0, 1) == "0.57735026918962576451");
    CHECK(libration_solution_steps(of.get()) == steps);
    const auto events = made<table>([&](auto** to) {
        return libration_solution_events(of.get(), "x = sqrt(3)/3", nullptr, 1, 20, nullptr, nullptr, to);
    });
    CHECK(cell(events, 0, 0) == "0.52359877559829887308");  // pi/6
    CHECK(libration_solution_steps(of.get()) == steps);
    const auto series = made<table>([&](auto** to) {
        return libration_solution_coefficients(of.get(), "pi/4", nullptr, 0, 1, 10, LIBRATION_PROVED, to);
    });
    CHECK(cell(series, 1, 1) == "2.000000000");
}

TEST_CASE("events of a solution in one direction, before a time, from the start and backwards", "[c]") {
    const auto of = kept_solution_of("x'' = -x; x(0) = 0; x'(0) = 1");
    const auto times = [&](const char* settings, long count) {
        libration_table* handle = nullptr;
        static_cast<void>(libration_solution_events(of.get(), "x = 0", settings, count, 10, nullptr, nullptr, &handle));
        const table found(handle);
        std::vector<std::string> all;
        for (std::size_t row = 0; row < libration_table_rows(handle); ++row) {
            all.push_back(cell(found, row, 0));
        }
        return all;
    };
    CHECK(times("crossing = up", 2) == std::vector<std::string>{"6.283185307", "12.56637061"});
    CHECK(times("crossing = down; from_start = yes", 1) == std::vector<std::string>{"3.141592654"});
    CHECK(times("from_start = yes", 2) == std::vector<std::string>{"0", "3.141592654"});
    CHECK(times("before = 7", 3) == std::vector<std::string>{"3.141592654", "6.283185307"});
    CHECK(times("before = -4", 2) == std::vector<std::string>{"-3.141592654"});
    libration_table* no_table = nullptr;
    CHECK(libration_solution_events(of.get(), "x = 3/2", "horizon = 3", 1, 10, nullptr, nullptr, &no_table) ==
          LIBRATION_UNDECIDED);
    libration_table_free(no_table);
    CHECK_THAT(libration_error_message(), Catch::Contains("is not found within 3 steps"));
}

TEST_CASE("a solution writes the certificates of its states and events", "[c]") {
    const auto of = kept_solution_of("x' = -x; x(0) = 1");
    const auto path = (std::filesystem::temp_directory_path() / "libration_solution.cert").string();
    const auto states = made<table>([&](auto** to) {
        return libration_solution_certificate(of.get(), "1", 12, path.c_str(), nullptr, nullptr, to);
    });
    CHECK(cell(states, 0, 1) == "0.367879441171");
    CHECK(std::filesystem::file_size(path) > 0);
    const auto events = made<table>([&](auto** to) {
        return libration_solution_event_certificate(of.get(), "x = 1/2", 1, 12, path.c_str(), nullptr, nullptr, to);
    });
    CHECK(cell(events, 0, 0) == "0.693147180560");
    std::filesystem::remove(path);
}

TEST_CASE("a solution refuses what its problem refuses", "[c]") {
    libration_solution* none = nullptr;
    CHECK(libration_solution_new(nullptr, &none) == LIBRATION_ARGUMENT);
    CHECK(none == nullptr);
    libration_table* no_table = nullptr;
    CHECK(libration_solution_states(nullptr, "1", 20, LIBRATION_PROVED, nullptr, nullptr, &no_table) ==
          LIBRATION_ARGUMENT);
    CHECK_THAT(libration_error_message(), Catch::Contains("solution is NULL"));
    CHECK(libration_solution_steps(nullptr) == 0);
    const auto of = kept_solution_of("x' = x^2; x(0) = 1");
    const auto events = [&](const char* settings, long count) {
        return libration_solution_events(of.get(), "x = 2", settings, count, 20, nullptr, nullptr, &no_table);
    };
    CHECK(events(nullptr, 0) == LIBRATION_ARGUMENT);
    for (const char* const wrong : {"crossing = left", "before = x", "from_start = 1", "horizon = 0", "after = 3"}) {
        INFO(wrong);
        CHECK(events(wrong, 1) == LIBRATION_ARGUMENT);
    }
    CHECK(libration_solution_states(of.get(), "2", 20, LIBRATION_PROVED, nullptr, nullptr, &no_table) ==
          LIBRATION_UNDECIDED);  // beyond the pole
    libration_table_free(no_table);
    CHECK(cell(states_of_kept(of, "1/2", 20), 0, 1) == "2.0000000000000000000");
}

TEST_CASE("a call that is cancelled leaves the steps, and the next one continues", "[c]") {
    const auto of = kept_solution_of("x'' = -x^3; x(0) = 1; x'(0) = 0");
    int calls = 0;
    const libration_watch stop_at_third = [](double, void* count) { return ++*static_cast<int*>(count) >= 3 ? 1 : 0; };
    libration_table* no_table = nullptr;
    REQUIRE(libration_solution_states(of.get(), "100", 20, LIBRATION_PROVED, stop_at_third, &calls, &no_table) ==
            LIBRATION_CANCELLED);
    const auto steps = libration_solution_steps(of.get());
    CHECK(steps > 0);
    const auto alone = problem_of("x'' = -x^3; x(0) = 1; x'(0) = 0");
    const auto expected = made<table>([&](auto** to) {
        return libration_problem_states(alone.get(), "100", 20, LIBRATION_PROVED, nullptr, nullptr, to);
    });
    CHECK(cell(states_of_kept(of, "100", 20), 0, 1) == cell(expected, 0, 1));
}

TEST_CASE("threads ask one solution one after the other", "[c]") {
    const auto of = kept_solution_of("x' = 1 + x^2; x(0) = 0");
    std::vector<std::string> found(4);
    std::vector<std::thread> threads;
    for (auto& each : found) {
        threads.emplace_back([&] { each = cell(states_of_kept(of, "pi/4", 20), 0, 1); });
    }
    for (auto& each : threads) {
        each.join();
    }
    for (const auto& each : found) {
        CHECK(each == "1.0000000000000000000");
    }
}

}  // namespace c_test
