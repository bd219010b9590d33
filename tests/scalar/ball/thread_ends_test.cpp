// thread_local objects are destroyed with their thread, the last one first, also those beyond the entries of
// thread_ends.cpp and those that are made meanwhile.
#include <catch2/catch.hpp>
#include <thread>
#include <utility>
#include <vector>

namespace scalar_ball_thread_ends_test {

namespace {

// The numbers of the objects in the order of their destruction.
std::vector<int>& destroyed() {
    static std::vector<int> all;
    return all;
}

struct noted {
    int number;
    explicit noted(int n) : number(n) {}
    noted(const noted&) = delete;
    noted& operator=(const noted&) = delete;
    ~noted() { destroyed().push_back(number); }
};

template <int N>
void make() {
    thread_local const noted one(N);
    static_cast<void>(one);
}

template <int... N>
void make_all(std::integer_sequence<int, N...> /*numbers*/) {
    (make<N>(), ...);
}

struct late {
    ~late() { make<1000>(); }
};

}  // namespace

TEST_CASE("objects of a thread end with it, the last one first", "[scalar][ball]") {
    destroyed().clear();
    std::thread([] { make_all(std::make_integer_sequence<int, 8>()); }).join();
    CHECK(destroyed() == std::vector<int>{7, 6, 5, 4, 3, 2, 1, 0});
    destroyed().clear();
    std::thread([] { make_all(std::make_integer_sequence<int, 200>()); }).join();
    CHECK(destroyed().size() == 200);
}

TEST_CASE("an object made by a destructor ends with the thread, too", "[scalar][ball]") {
    destroyed().clear();
    std::thread([] {
        thread_local const late last;
        static_cast<void>(last);
    }).join();
    CHECK(destroyed() == std::vector<int>{1000});
}

}  // namespace scalar_ball_thread_ends_test
