// Memory that fails inside a call, in processes of their own (failing_memory.cpp): the same question asked again is
// answered alike or refused, and nothing crashes. Arb's constants are half written where it does not get memory, so
// that a thread which asks again after such a failure prints proved digits that are false from the first one on.

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>
#include <vector>

namespace c_memory_failure_test {

#ifdef LIBRATION_FAILING_MEMORY  // not with sanitizers, which have an allocation of their own

// What the program prints of these questions.
std::string sweep(const std::string& words) {
    std::FILE* const pipe = popen((std::string(LIBRATION_FAILING_MEMORY) + " " + words + " 2>/dev/null").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string printed;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) {
        printed += part.data();
    }
    const int status = pclose(pipe);
    INFO(words << "\n" << printed);
    CHECK(status == 0);
    // FLINT says on stdout that it gets no memory; here nothing does.
    CHECK(printed.find("Exception") == std::string::npos);
    return printed;
}

TEST_CASE("after memory that failed the same question has the same answer or none", "[c][memory]") {
    for (const std::string question : {"'theta0 = 2.5; omega0 = 0'", "'energy = 3'"}) {
        sweep("one " + question + " 1500 6000 40 499 8");
        sweep("all " + question + " 1500 6000 40 499 8");
        sweep("cold " + question + " 1500 6000 40 499 8");
        sweep("limit " + question + " 1500 60000 0 2000000 2");
    }
    sweep("one \"y'' = -sin(y); y(0) = 2; y'(0) = 0\" 60 120 300 9001 8");
}

const std::vector<std::string> small_questions{
    "\"y'' = -sin(y); y(0) = 2; y'(0) = 0\"", "\"bounds|x' = -x^3; x(0) = [0.9, 1.1]\"",
    "\"radius|x' = 1 + x^2; x(0) = 0\"", "\"find|y' = k*y; y(0) = 1; k = 1|k|y(1) = 2\""};

// Of the program, whose allocations before main are refused, too.
const std::vector<std::string> commands{
    "reference --problem lorenz --time 1/2 --digits 6", "reference --energy 1 --time 2 --digits 10",
    "reference --problem \"x' = -x^3; x(0) = [0.9,1.1]\" --time 1 --parts 2",
    "radius --problem \"x' = 1 + x^2; x(0) = 0\" --prove --digits 5",
    "find --problem \"y' = k*y; y(0) = 1; k = 1\" --unknown k --such-that \"y(1) = 2\" --digits 6"};

std::string of_command(const std::string& range, const std::string& command) {
    return "command " LIBRATION_FAILING_ALLOCATION " " + range + " " LIBRATION_COMMAND " " + command;
}

TEST_CASE("no refused allocation ends a thread or a command by a crash", "[c][memory]") {
    // The beginning of a process, where threads begin and constants are made, and a part of the rest.
    sweep("cold " + small_questions.front() + " 10 12 0 1 60");
    for (const std::string& question : small_questions) {
        sweep("cold " + question + " 6 8 60 1009 12");
    }
    sweep(of_command("0 41 12", commands.front()));
    for (const std::string& command : commands) {
        sweep(of_command("500 2003 12", command));
    }
}

TEST_CASE("no allocation of small questions and commands is refused with a crash or a false value",
          "[.long][c][memory]") {
    for (const std::string& question : small_questions) {
        sweep("cold " + question + " 6 8 0 1 1000000");
        sweep("all " + question + " 6 8 0 7 1000000");
    }
    for (const std::string& command : commands) {
        sweep(of_command("0 1 1000000", command));
    }
}

TEST_CASE("no failing allocation and no limit of memory makes an answer false", "[.long][c][memory]") {
    for (const std::string question :
         {"'theta0 = 2.5; omega0 = 0'", "'energy = 3'", "'theta0 = 3pi/4; omega0 = 1/3'", "'gap = 1e-30'"}) {
        sweep("one " + question + " 300 1000 0 1 1000000");
        sweep("cold " + question + " 300 1000 20 1 1000000");  // before 20 glibc cannot begin a thread
        sweep("one " + question + " 1500 60000 0 97 1000000");
        sweep("all " + question + " 1500 60000 0 197 1000000");
        sweep("limit " + question + " 1500 60000 0 200000 90");
    }
    sweep("one \"y'' = -sin(y); y(0) = 2; y'(0) = 0\" 60 120 0 997 1000000");
    sweep("one lorenz 20 40 0 9973 1000000");
}

#endif

}  // namespace c_memory_failure_test
