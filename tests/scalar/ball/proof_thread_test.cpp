// A thread in which FLINT failed is not used again.
#include "libration/scalar/ball/proof_thread.hpp"

#include <flint/flint.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cfenv>
#include <cstdint>
#include <thread>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace scalar_ball_proof_thread_test {

using namespace libration;

namespace {

// The thread in which the next proof is computed.
std::thread::id next_thread() {
    std::thread::id found;
    REQUIRE(in_proof_thread([&] {
                found = std::this_thread::get_id();
                return true;
            }) == call_ending::finished);
    return found;
}

}  // namespace

TEST_CASE("a thread computes one proof after the other, in another thread than the caller", "[scalar][ball]") {
    const auto first = next_thread();
    CHECK(first != std::this_thread::get_id());
    CHECK(next_thread() == first);
    std::thread([&] { CHECK(next_thread() != first); }).join();
}

TEST_CASE("after a failure of FLINT another thread computes", "[scalar][ball]") {
    auto before = next_thread();
    const auto check_other = [&] {
        const auto now = next_thread();
        CHECK(now != before);
        before = now;
    };
    CHECK(in_proof_thread([]() -> bool { flint_abort(); }) == call_ending::flint_failure);
    check_other();
#if !defined(__SANITIZE_ADDRESS__)  // which ends the process for such sizes
    CHECK(in_proof_thread([] { return flint_malloc(SIZE_MAX / 4) != nullptr; }) == call_ending::no_memory);
    check_other();
    CHECK(in_proof_thread([] { return flint_calloc(SIZE_MAX / 16, 4) != nullptr; }) == call_ending::no_memory);
    check_other();
#endif
    CHECK(in_proof_thread([] { return false; }) == call_ending::finished);
    check_other();
}

TEST_CASE("questions are answered in the thread that waits", "[scalar][ball]") {
    const auto caller = std::this_thread::get_id();
    std::thread::id computing;
    std::thread::id asked;
    std::thread::id within;
    int answers = 0;
    REQUIRE(in_proof_thread([&] {
                computing = std::this_thread::get_id();
                for (int i = 0; i < 100; ++i) {
                    in_calling_thread([&] {
                        asked = std::this_thread::get_id();
                        ++answers;
                    });
                }
                in_calling_thread([&] { within = next_thread(); });
                return true;
            }) == call_ending::finished);
    CHECK(asked == caller);
    CHECK(answers == 100);
    CHECK(within != computing);
    CHECK(within != caller);
    in_calling_thread([&] { asked = std::thread::id(); });
    CHECK(asked == std::thread::id());
}

TEST_CASE("a proof has the usual floating-point environment, and the caller keeps its own", "[scalar][ball]") {
    std::fesetround(FE_UPWARD);
    const precision_scope caller(33);
    int rounding = -1;
    next_thread();
    std::thread([&] {  // its proof thread starts with this environment
        std::fesetround(FE_DOWNWARD);
        in_proof_thread([&] {
            rounding = std::fegetround();
            mpfr::thread_default_precision(77);
            return true;
        });
        CHECK(std::fegetround() == FE_DOWNWARD);
    })
        .join();
    CHECK(rounding == FE_TONEAREST);
    CHECK(std::fegetround() == FE_UPWARD);
    CHECK(working_digits() == 33);
    std::fesetround(FE_TONEAREST);
}

TEST_CASE("a child process has proof threads of its own", "[scalar][ball]") {
    next_thread();
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(20);
        bool computed = false;
        in_proof_thread([&] { return computed = true; });
        ::_exit(computed ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

}  // namespace scalar_ball_proof_thread_test
